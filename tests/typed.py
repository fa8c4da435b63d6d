"""What a program that is checked with mypy --strict may hand to kern: answers
of kern, and arrays of numpy.

    MYPYPATH=examples/python mypy --strict tests/typed.py

SPDX-License-Identifier: MIT
"""

from typing import Optional

import numpy

import kern


def proofs(wall: kern.Structure) -> float:
    """Returns the error of the proofs of a margin: its forces as they come and
    as an array, and its motion."""
    margin = wall.measure()
    if margin.forces is None or margin.motion is None:
        return 0.0
    forces = numpy.asarray(margin.forces)
    return max(wall.check_forces(margin.forces, margin.holds),
               wall.check_forces(forces, margin.holds),
               wall.check_motion(margin.motion, margin.fails))


def arrays(wall: kern.Structure) -> Optional[kern.Factor]:
    """Returns the least load of a pattern; asks for many frictions."""
    box = numpy.array([(0, 0), (1, 0), (1, 1), (0, 1)])
    kern.many(wall, mu=numpy.linspace(0.2, 0.8, 7))
    kern.many(wall, mu=[0.2, 0.8], stones=[kern.Block("a", box)] * 2)
    kern.lp_solve(numpy.eye(2), numpy.ones(2), cost=numpy.ones(2))
    left: Optional[kern.Factor] = wall.load_factor(kern.Side.LEFT)
    pattern = numpy.zeros((len(wall), 3))
    return left and wall.least_load(pattern)


print(proofs(kern.example()), arrays(kern.example()))
