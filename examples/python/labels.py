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
import json
import math
import multiprocessing
import random
import sys

import kern

PART = 250  # towers of one size, which kern.many() answers at once


def finite(value):
    """Returns a number that JSON can write: None for nan and infinity."""
    return float(value) if math.isfinite(value) else None


def part(task):
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
    lines = []
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


def shared(tasks, on):
    """Returns what part() returns for each of the tasks, in their order."""
    if on == "pool":
        with multiprocessing.Pool() as pool:
            return pool.map(part, tasks)
    if on == "dask":
        import dask
        return dask.compute(*map(dask.delayed(part), tasks))
    if on == "ray":
        import ray
        return ray.get([ray.remote(part).remote(task) for task in tasks])
    return map(part, tasks)


def main():
    ask = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    ask.add_argument("count", type=int, nargs="?", default=1000)
    ask.add_argument("--seed", type=int, default=1)
    ask.add_argument("--on", choices=("pool", "dask", "ray"))
    told = ask.parse_args()
    tasks = [("%d %d" % (told.seed, first), min(PART, told.count - first))
             for first in range(0, told.count, PART)]
    for lines in shared(tasks, told.on):
        sys.stdout.write("".join(line + "\n" for line in lines))


if __name__ == "__main__":
    main()
