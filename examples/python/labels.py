"""Writes labelled structures as JSON lines: towers that were drawn by chance,
with verdict, margin and load factors, all of them proven.

    python3 examples/python/labels.py 1000 >towers.jsonl
    python3 examples/python/labels.py 100000 --seed 3 --on pool >more.jsonl

--on says what shares the work: nothing, the processes of a `pool`, `dask` or
`ray`, where these are installed. The lines are the same for all of them, since
every part of the work has a seed of its own.

SPDX-License-Identifier: MIT
"""

import argparse
import importlib
import json
import math
import multiprocessing
import random
import sys
from typing import Any, Iterable, List, Optional, Tuple, cast

import kern

PART = 250  # towers of one size, which kern.many() answers at once


def finite(value: float) -> Optional[float]:
    """Returns a number that JSON can write: None for nan and infinity."""
    return float(value) if math.isfinite(value) else None


def part(task: Tuple[str, int]) -> List[str]:
    """Returns the lines of one part of the work: (seed, how many towers)."""
    seed, count = task
    draw = random.Random(seed)
    wall = [kern.Block("ground", [(-4, -1), (4, -1), (4, 0), (-4, 0)],
                       fixed=True)]
    top = 0.0
    for i in range(draw.randint(2, 6)):
        wide, high = draw.uniform(0.5, 2), draw.uniform(0.2, 1)
        wall.append(kern.Block("s%d" % i, [
            (-wide / 2, top), (wide / 2, top), (wide / 2, top + high),
            (-wide / 2, top + high)], density=2400))
        top += high
    poses = [[(0, 0, 0)] + [(draw.gauss(0, 0.15), 0, 0) for _ in wall[1:]]
             for _ in range(count)]
    mu = [round(draw.uniform(0.2, 0.8), 3) for _ in range(count)]
    out = kern.many(kern.Structure(wall), poses=poses, mu=mu, loads=True,
                    threads=1)
    lines: List[str] = []
    for i in range(count):
        blocks = {b.name: b.copy().move(*pose).vertices.tolist()
                  for b, pose in zip(wall, poses[i])}
        left, right = out.loads[i]
        lines.append(json.dumps({
            "blocks": blocks, "fixed": ["ground"], "mu": mu[i],
            "status": kern.Status(out.status[i]).name,
            "margin": finite(out.margin[i]), "level": int(out.level[i]),
            "load_left": finite(left), "load_right": finite(right)}))
    return lines


def shared(tasks: List[Tuple[str, int]],
           on: Optional[str]) -> Iterable[List[str]]:
    """Returns the lines of each of the tasks, in the order of the tasks."""
    done: Any
    if on == "pool":
        with multiprocessing.Pool() as pool:
            return pool.map(part, tasks)
    if on == "dask":
        dask: Any = importlib.import_module("dask")
        done = dask.compute(*map(dask.delayed(part), tasks))
    elif on == "ray":
        ray: Any = importlib.import_module("ray")
        remote = ray.remote(part)
        done = ray.get([remote.remote(task) for task in tasks])
    else:
        done = map(part, tasks)
    return cast(Iterable[List[str]], done)


def main() -> None:
    """Writes as many lines as are asked for to the standard output."""
    ask = argparse.ArgumentParser(description="Writes labelled structures as "
                                  "JSON lines.")
    ask.add_argument("count", type=int, nargs="?", default=1000)
    ask.add_argument("--seed", type=int, default=1)
    ask.add_argument("--on", choices=("pool", "dask", "ray"))
    told = ask.parse_args()
    if told.count < 0:
        ask.error("count: a number not below 0 is expected, read %d"
                  % told.count)
    if told.on in ("dask", "ray"):
        try:
            importlib.import_module(told.on)
        except ImportError as error:
            ask.error("--on %s: %s" % (told.on, error))
    tasks = [("%d %d" % (told.seed, first), min(PART, told.count - first))
             for first in range(0, told.count, PART)]
    for lines in shared(tasks, told.on):
        sys.stdout.write("".join(line + "\n" for line in lines))


if __name__ == "__main__":
    main()
