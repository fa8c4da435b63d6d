"""An environment of gymnasium: lay stones on one another, as high and as safely
as you can. The reward is proven: forces hold the structure at that margin.

    python3 examples/python/env.py            steps a second, by chance

    >>> env = Stacking()
    >>> skyline, info = env.reset(seed=1)
    >>> seen, reward, terminated, truncated, info = env.step(env.PLACES // 2)
    >>> bool(info["stands"]), terminated, truncated
    (True, False, False)

Works without gymnasium, too, with a small stand-in for its base class and
spaces. The same seed and actions give the same episode.

SPDX-License-Identifier: MIT
"""

import random
import sys
import time

import kern

try:
    import gymnasium
    import numpy
    Base, Box, Discrete = (gymnasium.Env, gymnasium.spaces.Box,
                           gymnasium.spaces.Discrete)
except ImportError:
    gymnasium = numpy = None

    class Base:
        """What of gymnasium.Env is used: a generator that reset() seeds."""
        np_random = random.Random()

        def reset(self, *, seed=None, options=None):
            if seed is not None:
                self.np_random = random.Random(seed)

        def close(self):
            pass

    class Discrete:
        """The numbers from 0 to n - 1."""

        def __init__(self, n):
            self.n, self.draw = n, random.Random()

        def seed(self, seed=None):
            self.draw.seed(seed)

        def sample(self):
            return self.draw.randrange(self.n)

        def contains(self, x):
            return isinstance(x, int) and 0 <= x < self.n

    class Box:
        """So many numbers between two."""

        def __init__(self, low, high, shape):
            self.low, self.high, self.shape = low, high, shape

        def contains(self, x):
            return len(x) == self.shape[0] and all(
                self.low <= value <= self.high for value in x)


class Stacking(Base):
    """Lays boxes of random size on a plate, one after the other.

    Action: the place of the next stone, from 0 at the left end of the plate to
    PLACES - 1 at the right; it comes down until it rests on something.
    Observation: the height of the skyline in PLACES columns, width and height of
    the next stone, the margin so far [m].
    Reward: the height that the stone gains, and its share of the margin that
    PROVEN stands for; -1 where the structure falls, which ends the episode, as
    STONES stones do."""
    metadata = {"render_modes": ["svg"]}
    render_mode = None
    PLACES, STONES, HALF, PROVEN = 24, 12, 1.5, 0.25

    def __init__(self, render_mode=None):
        self.render_mode = render_mode
        self.action_space = Discrete(self.PLACES)
        self.observation_space = Box(0.0, 20.0, (self.PLACES + 3,))
        self.column = [self.HALF * (2 * i + 1 - self.PLACES) / self.PLACES
                       for i in range(self.PLACES)]
        self.plan = kern.Plan([kern.Block("plate", [
            (-self.HALF, -1), (self.HALF, -1), (self.HALF, 0), (-self.HALF, 0)],
            fixed=True)], options=kern.Options(mu=0.6))

    def _draw(self):
        """Draws the size of the next stone."""
        self.wide = self.np_random.uniform(0.4, 1.0)
        self.high = self.np_random.uniform(0.15, 0.35)

    def _seen(self):
        """Returns the observation."""
        seen = [*self.skyline, self.wide, self.high, self.margin]
        return seen if numpy is None else numpy.array(seen, numpy.float32)

    def reset(self, *, seed=None, options=None):
        super().reset(seed=seed)
        while len(self.plan) > 1:
            self.plan.remove(-1)
        self.laid, self.skyline, self.margin = [], [0.0] * self.PLACES, 0.0
        self._draw()
        return self._seen(), {"stands": True, "margin": 0.0}

    def step(self, action):
        # The stone comes down on the highest of what is below it.
        x = self.column[int(action)]
        left, right = x - self.wide / 2, x + self.wide / 2
        y = max([0.0] + [top for a, b, top in self.laid
                         if a < right and left < b])
        top = y + self.high
        before = max(self.skyline)
        self.plan.add(kern.Block("s%d" % len(self.laid), [
            (left, y), (right, y), (right, top), (left, top)]))
        self.laid.append((left, right, top))

        # Forces prove the margin `holds`, a motion proves the fall.
        margin = self.plan.measure()
        self.margin = min(margin.holds, self.PROVEN) if margin else 0.0
        for i, at in enumerate(self.column):
            if left <= at <= right:
                self.skyline[i] = top
        reward = -1.0
        if margin:
            reward = max(0.0, top - before) + self.margin / self.PROVEN
        self._draw()
        done = not margin or len(self.laid) == self.STONES
        return self._seen(), reward, done, False, {
            "stands": margin.stands, "margin": margin.margin}

    def render(self):
        return self.plan.svg() if self.render_mode == "svg" else None


def main(steps=20000):
    env = Stacking()
    env.reset(seed=1)
    env.action_space.seed(1)
    actions = [int(env.action_space.sample()) for _ in range(steps)]
    begin, episodes, total = time.process_time(), 0, 0.0
    for action in actions:
        _, reward, terminated, _, _ = env.step(action)
        total += reward
        if terminated:
            episodes += 1
            env.reset()
    spent = time.process_time() - begin
    print("%d steps, %d episodes, mean reward %.3f, %.0f steps a second" % (
        steps, episodes, total / steps, steps / spent))


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
