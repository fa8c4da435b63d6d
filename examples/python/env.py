"""An environment of gymnasium: lay stones on one another, as high and as safely
as you can. The reward is proven: forces hold the structure at that margin.

    python3 examples/python/env.py            steps a second, by chance

    >>> env = Stacking()
    >>> skyline, info = env.reset(seed=1)
    >>> seen, reward, terminated, truncated, info = env.step(env.PLACES // 2)
    >>> bool(info["stands"]), terminated, truncated
    (True, False, False)

Works without gymnasium, too, with a small stand-in for its base class and
spaces. The same seed and actions give the same episode. gymnasium.make() and
make_vec() take the environment after

    gymnasium.register("kern/Stacking-v0", entry_point="env:Stacking")

SPDX-License-Identifier: MIT
"""

import importlib
import random
import sys
import time
from typing import Any, Dict, List, Optional, Tuple

import kern

try:
    numpy: Any = importlib.import_module("numpy")
    gymnasium: Any = importlib.import_module("gymnasium")
except ImportError:
    gymnasium = None


class _Base:
    """Stands in for gymnasium.Env: it has a generator that reset() seeds."""
    np_random: Any = random.Random()

    def reset(self, *, seed: Optional[int] = None,
              options: Optional[Dict[str, Any]] = None) -> Any:
        """Seeds the generator, if there is a seed."""
        if seed is not None:
            self.np_random = random.Random(seed)

    def close(self) -> None:
        """Does nothing."""


class _Discrete:
    """Stands in for gymnasium.spaces.Discrete: the numbers from 0 to n - 1."""

    def __init__(self, n: int) -> None:
        self.n, self._draw = n, random.Random()

    def seed(self, seed: Optional[int] = None) -> None:
        """Seeds sample()."""
        self._draw.seed(seed)

    def sample(self) -> int:
        """Returns one of the numbers, each as often as the others."""
        return self._draw.randrange(self.n)

    def contains(self, x: object) -> bool:
        """Returns whether x is one of the numbers."""
        return isinstance(x, int) and 0 <= x < self.n


class _Box:
    """Stands in for gymnasium.spaces.Box: numbers between two bounds."""

    def __init__(self, low: float, high: float, shape: Tuple[int]) -> None:
        self.low, self.high, self.shape = low, high, shape

    def contains(self, x: List[float]) -> bool:
        """Returns whether x has as many numbers, all within the bounds."""
        return len(x) == self.shape[0] and all(
            self.low <= value <= self.high for value in x)


_Env: Any = gymnasium.Env if gymnasium else _Base
_spaces: Any = gymnasium.spaces if gymnasium else None


class Stacking(_Env):  # type: ignore
    """Lays boxes of random size on a plate, one after the other.

    Action: the place of the next stone, from 0 at the left end of the plate to
    PLACES - 1 at the right; it comes down until it rests on something.
    Observation: the height of the skyline in PLACES columns, width and height of
    the next stone, the margin so far [m].
    Reward: the height that the stone gains, and its share of the margin that
    PROVEN stands for; -1 where the structure falls, which ends the episode, as
    STONES stones do."""
    metadata = {"render_modes": ["svg"], "render_fps": 1}
    render_mode: Optional[str] = None
    PLACES, STONES, HALF, PROVEN = 24, 12, 1.5, 0.25

    def __init__(self, render_mode: Optional[str] = None) -> None:
        self.render_mode = render_mode
        self.action_space: Any = (_spaces.Discrete if _spaces else _Discrete)(
            self.PLACES)
        self.observation_space: Any = (_spaces.Box if _spaces else _Box)(
            0.0, 20.0, (self.PLACES + 3,))
        self.column = [self.HALF * (2 * i + 1 - self.PLACES) / self.PLACES
                       for i in range(self.PLACES)]
        self.plan = kern.Plan([kern.Block("plate", [
            (-self.HALF, -1), (self.HALF, -1), (self.HALF, 0), (-self.HALF, 0)],
            fixed=True)], options=kern.Options(mu=0.6))

    def _draw(self) -> None:
        """Draws the size of the next stone."""
        self.wide: float = self.np_random.uniform(0.4, 1.0)
        self.high: float = self.np_random.uniform(0.15, 0.35)

    def _seen(self) -> Any:
        """Returns the observation."""
        seen = [*self.skyline, self.wide, self.high, self.margin]
        return seen if gymnasium is None else numpy.array(seen, numpy.float32)

    def reset(self, *, seed: Optional[int] = None,
              options: Optional[Dict[str, Any]] = None
              ) -> Tuple[Any, Dict[str, Any]]:
        """Takes all stones away. Returns the observation and what is known."""
        _Env.reset(self, seed=seed)
        while len(self.plan) > 1:
            self.plan.remove(-1)
        self.laid: List[Tuple[float, float, float]] = []
        self.skyline, self.margin = [0.0] * self.PLACES, 0.0
        self._draw()
        return self._seen(), {"stands": True, "margin": 0.0}

    def step(self, action: Any) -> Tuple[Any, float, bool, bool,
                                         Dict[str, Any]]:
        """Lays the next stone at a place. Returns observation, reward, whether
        the episode has ended, False, and verdict and margin."""
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

    def render(self) -> Optional[str]:
        """Returns a picture as SVG, or None in other modes."""
        return self.plan.svg() if self.render_mode == "svg" else None


def main(steps: int = 20000) -> None:
    """Prints how many steps of random actions it makes in a second."""
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
