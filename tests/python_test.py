"""Tests of examples/python/kern.py; the first argument is the program kern.

    cc -O2 -ffp-contract=off -o kern examples/kern.c -lm
    python3 tests/python_test.py ./kern           with numpy, if there is one
    python3 -S tests/python_test.py ./kern        without
    python3 tests/python_test.py ./kern --time    what Python adds to a call
"""

import concurrent.futures
import copy
import json
import math
import multiprocessing
import os
import pathlib
import pickle
import random
import re
import subprocess
import sys
import tempfile
import time
import timeit
import unittest
import warnings
import xml.dom.minidom

ROOT = pathlib.Path(__file__).resolve().parent.parent
MODULE = ROOT / "examples" / "python"
sys.path.insert(0, str(MODULE))
import kern  # noqa: E402
from kern import Block, Options, Plan, Status, Structure  # noqa: E402

FILES = sorted((ROOT / "examples" / "structures").glob("*.kern"))
PLAIN = [f for f in FILES if not re.search("^(fill|earth|axle)", f.read_text(),
                                         re.M)]  # drawn alone they are the same
BOX = [(0, 0), (1, 0), (1, 1), (0, 1)]
PROGRAM = ""


def ground():
    return Block("ground", [(-3, -1), (4, -1), (4, 0), (-3, 0)], fixed=True)


def two(x):
    """A box on a box, moved to the right by x: its margin is 0.5 - x."""
    return [ground(), Block("low", BOX), Block("top", BOX).move(x, 1)]


def margin_or_error(i):
    """For a process of a pool: every hundredth from 50 on is a bow tie."""
    if i % 100 != 50:
        return Structure(two(0.0001 * i)).measure()
    try:
        return Structure([ground(), Block("bow tie %d" % i,
                                          [(0, 0), (1, 1), (2, 0), (0, 1)])])
    except kern.KernError as error:
        return error


def finite(value):
    return value if value is not None and math.isfinite(value) else None


class Program(unittest.TestCase):
    def test_same_numbers(self):
        """All digits of all numbers are those of the program."""
        run = subprocess.run([PROGRAM, "--json", "--forces", "--mechanism",
                              *map(str, FILES)], stdout=subprocess.PIPE)
        rows = [json.loads(line) for line in run.stdout.splitlines()]
        self.assertGreaterEqual(len(rows), 10)
        for row, path in zip(rows, FILES):
            with self.subTest(path.stem):
                s = kern.read(path)
                v, m = s.verdict(), s.measure()
                self.assertEqual(v.stands, row["status"] == "stands")
                self.assertEqual(
                    (m.level, m.margin, m.epsilon, m.saturated),
                    tuple(row[key] for key in ("level", "margin", "epsilon",
                                               "saturated")))
                if not v:
                    self.assertEqual(finite(s.deficit()), row["deficit"])
                for side, word in ((kern.LEFT, "left"), (kern.RIGHT, "right")):
                    self.assertEqual(finite(s.load_factor(side)),
                                     row["load_" + word])
                    tilt = finite(s.tilt(side))  # there atan of the load
                    self.assertEqual(tilt is None, row["tilt_" + word] is None)
                    if tilt is not None:
                        self.assertAlmostEqual(tilt, row["tilt_" + word],
                                               delta=1e-15)
                self.same_forces(s, v and s.forces(), row)
                self.same_motion(s, m.motion if v else v.motion, row)

    def same_forces(self, s, forces, row):
        self.assertEqual(len(s.contacts), len(row["contacts"]))
        for k, (c, want) in enumerate(zip(s.contacts, row["contacts"])):
            self.assertEqual((*c.p, *c.n, c.mu), tuple(
                want[key] for key in ("x", "y", "nx", "ny", "mu")))
            if row["status"] == "stands":
                self.assertEqual((forces[k, 0], forces[k, 1]),
                                 (want["normal"], want["tangential"]))

    def same_motion(self, s, motion, row):
        free = [i for i, b in enumerate(s.blocks) if not b.fixed]
        self.assertEqual(motion is None, row["motion"] is None)
        for i, want in zip(free, row["motion"] or ()):
            self.assertEqual(motion.tolist()[i],
                             [want[key] for key in ("vx", "vy", "spin")])

    def test_readme(self):
        """The example of the README runs: it measures, draws, ranks places."""
        code, = re.findall(r"```python\n(.*?)```",
                           (ROOT / "README.md").read_text(), re.S)
        with tempfile.TemporaryDirectory() as folder:
            out = subprocess.run(
                [sys.executable, "-S", "-c", code], cwd=folder,
                env={**os.environ, "PYTHONPATH": str(MODULE)},
                stdout=subprocess.PIPE, check=True).stdout.decode()
            xml.dom.minidom.parse(os.path.join(folder, "mine.svg"))
        first, *ranked = out.splitlines()
        found = re.fullmatch(r"Verdict\(stands=True\) Margin\(stands=True, "
                             r"margin=(.*), level=.*, saturated=.*\) (.*)",
                             first)
        self.assertAlmostEqual(float(found.group(1)), 1.7 - 1.7 * 3.4 / 6.6, 6)
        self.assertAlmostEqual(float(found.group(2)), 0.4, 6)
        chance = [float(line.split()[2]) for line in ranked]
        self.assertGreater(len(chance), 20)
        self.assertGreaterEqual(chance[0], 0.9)

    @staticmethod
    def shapes(text):
        """What is drawn above the caption."""
        return [line for line in text.splitlines() if "<text" not in line]

    def test_pictures(self):
        """They are those of the program, but for the caption."""
        for path in PLAIN:
            s = kern.read(path)
            with tempfile.TemporaryDirectory() as folder:
                program = pathlib.Path(folder, "p.svg")
                subprocess.run([PROGRAM, "--svg", program, path],
                               stdout=subprocess.DEVNULL)
                self.assertEqual(self.shapes(program.read_text()),
                                 self.shapes(s.svg()))
                self.assertTrue(s._repr_svg_().startswith("<svg"))
            for text in (s._repr_svg_(), s.svg(mechanism=True, profile=True)):
                page = xml.dom.minidom.parseString(text.encode())
                self.assertGreaterEqual(
                    len(page.getElementsByTagName("path")), len(s.blocks))


class Rest(unittest.TestCase):
    def test_rest(self):
        """A stone comes to rest where it stands; a plan grows by copies."""
        plan = Plan(two(0)[:2])
        for i in range(40):
            stone = Block("s%d" % i, two(0)[2].vertices.tolist())
            at = plan.rest(stone, 0.4 + 0.01 * (i % 20), 0.02 * i)
            self.assertIsNotNone(at)
            if plan.try_(at):
                plan.add(at)
        self.assertGreater(len(plan.blocks), 20)
        fresh = Plan([b.copy() for b in plan.blocks])
        self.assertEqual(plan.measure().margin, fresh.measure().margin)
        with self.assertRaises(kern.KernError):
            plan.rest(stone, float("nan"))
        for turn in (math.inf, math.nan):
            with self.assertRaisesRegex(ValueError, "turn"):
                plan.rest(stone, 0.5, turn)

    def test_places(self):
        """In any order the same places, the best first."""
        plan, stone = Plan(two(0)[:2]), two(0)[2]
        xs = [0.1 * i for i in range(12)]
        found = plan.places(stone, xs, (0, 0.3))
        back = plan.places(stone, xs[::-1], (0.3, 0))
        self.assertGreater(len(found), 5)
        self.assertEqual([(p.x, p.turn) for p in found],
                         [(p.x, p.turn) for p in back])
        self.assertGreaterEqual(found[0].stays, min(0.9, found[-1].stays))


class Calls(unittest.TestCase):
    def test_every_function(self):
        """All public functions of the header are called."""
        header = (ROOT / "kern.h").read_text().split("#endif /* KERN_H */")[0]
        module = (MODULE / "kern.py").read_text()
        names = set(re.findall(r"^KERN_API [^;(]*?(kern_\w+)\(", header, re.M))
        self.assertGreater(len(names), 25)
        missing = {name for name in names if '_declare("%s"' % name
                   not in module} - {"kern_work_of"}  # _Work() is the same
        self.assertEqual(missing, set())

    def test_proofs(self):
        """Forces and motions are proofs, and only where they belong."""
        s = Structure(two(0.2))
        v, m = s.verdict(), s.measure()
        self.assertLessEqual(s.check_forces(v.forces), 1)
        self.assertLessEqual(s.check_forces(m.forces, m.holds), 1)
        self.assertLessEqual(s.check_motion(m.motion, m.fails), 1)
        self.assertGreater(s.check_motion(m.motion), 1)
        self.assertIsNone(v.motion)
        v = s.verdict(0.4)
        self.assertFalse(v)
        self.assertIsNone(v.forces)
        self.assertLessEqual(s.check_motion(v.motion, 0.4), 1)

    def test_critical(self):
        """The upper box tips about its edge, alone."""
        s = Structure(two(0.2))
        c = s.critical()
        self.assertEqual(c.limits[c.contact], 1)
        self.assertEqual(c.meetings[c.contact], "hinges")
        self.assertEqual(len(c.groups), 1)
        self.assertIn(2, c.groups[0])
        self.assertIsNone(Structure(two(0.0)).critical())

    def test_raised(self):
        """Weight on weight is raised; a stone between two fixed walls that
        nothing presses against it hangs; what falls is neither."""
        s = Structure(two(0.2))
        r = s.raised(reserve=True)
        self.assertTrue(r)
        self.assertGreater(r.reserve, 0.01)
        self.assertLessEqual(s.check_raised(r), 1)
        walls = [Block("left", [(-1, 0), (0, 0), (0, 2), (-1, 2)], fixed=True),
                 Block("right", [(1, 0), (2, 0), (2, 2), (1, 2)], fixed=True),
                 Block("stone", BOX).move(0, 0.5)]
        s = Structure(walls)
        self.assertTrue(s.verdict())
        r = s.raised()
        self.assertEqual((bool(r), r.raising), (False, kern.Raising.HANGS))
        self.assertLessEqual(s.check_raised(r), 1)
        r = Plan(two(0)[:2]).try_raised(two(0.2)[2], reserve=True)
        self.assertTrue(r)
        self.assertIsNone(r.motion)
        r = Structure(two(0.7)).raised()
        self.assertEqual((bool(r), r.stands, r.raising), (False, False, None))

    def test_let_go(self):
        """A box on a box stays, one past its edge moves by a motion that is
        proven, a stone that rests on nothing moves, and a limit of work is a
        reason."""
        s = Structure(two(0.2))
        r = s.let_go()
        self.assertEqual((r.stays, r.how, r.why), (
            True, kern.Raising.RAISED, kern.End.SHOWN))
        self.assertTrue(r)
        self.assertLessEqual(s.check_raised(r), 1)
        self.assertEqual(len(r.forces), len(s.contacts))
        self.assertEqual(Plan(two(0.2)).let_go(), r)
        self.assertEqual(pickle.loads(pickle.dumps(r)), r)
        s = Structure(two(0.7))
        r = s.let_go()
        self.assertEqual((r.stays, r.how, r.why, r.forces), (
            False, kern.Raising.NOT_SHOWN, kern.End.NONE, None))
        self.assertFalse(r)
        self.assertLessEqual(s.check_motion(r.motion), 1)
        walls = [Block("left", [(-1, 0), (0, 0), (0, 2), (-1, 2)], fixed=True),
                 Block("right", [(1, 0), (2, 0), (2, 2), (1, 2)], fixed=True),
                 Block("stone", BOX).move(0, 0.5)]
        s = Structure(walls)
        r = s.let_go()
        self.assertEqual((r.stays, r.how), (False, kern.Raising.HANGS))
        self.assertLessEqual(s.check_raised(r), 1)
        r = Structure(two(0.2), options=Options(limit=1)).let_go()
        self.assertEqual((r.stays, r.why, r.forces, r.motion), (
            None, kern.End.WORK, None, None))

    def test_why_a_search_ended(self):
        """A plain load factor has no search, a raised one says why it ended."""
        s = Structure(two(0.2))
        self.assertEqual(s.raised().why, kern.End.SHOWN)
        self.assertEqual(s.load_factor(kern.RIGHT).why, kern.End.NONE)
        factor = s.raised_load(kern.RIGHT)
        self.assertIn(factor.why, (kern.End.SHOWN, kern.End.LOST))
        self.assertEqual(pickle.loads(pickle.dumps(factor)).why, factor.why)
        self.assertEqual(Plan(two(0)[:2]).try_raised(two(0.2)[2]).why,
                         kern.End.SHOWN)

    def test_least_load(self):
        """A box of 1 kg whose centre is .25 past the edge below needs its own
        weight at its far corner, which is .25 on the other side; a box that
        stands needs nothing, and a pull upwards there holds nothing. The least
        factor at which it is proven to stand is just above the exact one."""
        b = two(0.75)
        b[2].mass = 1
        s = Structure(b)
        load = [("top", (0, -1), (0.75, 2))]
        least = s.live_least(load)
        self.assertTrue(0 <= least - 9.81 <= 2e-6 * (1 + 9.81), least)
        self.assertEqual((len(least.forces), len(least.motion)),
                         (len(s.contacts), 3))
        pattern = [(0, 0, 0), (0, 0, 0), (0, -1, 0.5)]
        self.assertEqual(s.least_load(pattern), least)
        s.lives = load
        self.assertEqual(s.live_least(), least)
        self.assertIsNone(s.live_least([("top", (0, 1), (0.75, 2))]))
        self.assertEqual(s.live(load), math.inf)  # above the end of the contact
        ladder = kern.read(ROOT / "examples" / "structures" / "ladder.kern")
        self.assertAlmostEqual(ladder.live_least(), 61.752, delta=1e-3)
        most = ladder.live()  # foot and top slide up the wall
        wall = 1100 / (2 * math.sqrt(3) - 0.2 * 2)
        self.assertAlmostEqual(most, wall + 0.3 * (800 + 0.2 * wall), delta=1e-3)
        self.assertEqual(len(most.forces), 2)
        least = Structure(two(0.2)).live_least(load)
        self.assertEqual((least, least.motion), (0, None))

    def test_stays(self):
        """A stone in the middle stays, one that a push of .003 g tips hardly, and
        less the nearer to its edge; what falls has the chance 0."""
        chance = [Structure(two(x)).stays("top")
                  for x in (0.1, 0.4, 0.49, 0.498, 0.4995)]
        self.assertEqual(chance, sorted(chance, reverse=True))
        self.assertGreater(chance[0], 0.9)
        self.assertLess(chance[-1], 0.5)
        self.assertIsNone(Structure(two(0.7)).stays("top"))

    def test_stays_on_a_plan(self):
        """A plan says of a stone that is not laid yet what a structure says of
        it, overlaps and falls included, and is then as it was."""
        *below, top = two(0.2)
        plan = Plan(below)
        before = plan.measure()
        self.assertEqual(plan.try_stays(top),
                         Structure([*below, top]).stays("top"))
        self.assertIsNone(plan.try_stays(top.copy().move(0.6, 0)))
        self.assertIsNone(plan.try_stays(top.copy().move(0, -0.5)))
        self.assertEqual(len(plan.blocks), len(below))
        self.assertEqual(plan.measure(), before)

    def test_numbers_that_are_none(self):
        """What is no number is a TypeError that names the question."""
        with self.assertRaisesRegex(TypeError, r"verdict\(\): a number"):
            Structure(two(0.1)).verdict("x")

    def test_in_place(self):
        """What is written to the vertices counts after update()."""
        s = Structure(two(0.2))
        for i in range(4):
            s.blocks[2].vertices[i, 0] += 0.1
        with self.assertRaisesRegex(kern.KernError, "'top': .* call update"):
            s.touch("top")
        s.update()
        self.assertAlmostEqual(s.measure().margin, 0.2, 6)
        s.blocks[2].vertices = [(x, y + 1) for x, y in BOX]
        s.update()
        self.assertAlmostEqual(s.measure().margin, 0.5, 6)

    def test_centre_follows(self):
        """The centroid moves with the vertices, of a structure read as well."""
        s = kern.read(FILES[-1])
        before = s.blocks[-1].body().centre
        for k in range(len(s.blocks[-1].vertices)):
            s.blocks[-1].vertices[k, 0] += 0.25
        self.assertAlmostEqual(s.blocks[-1].body().centre[0], before[0] + 0.25)
        com = Block("b", BOX, centre=(0.25, 0.5)).move(1, 2)
        self.assertEqual(com.body().centre, (1.25, 2.5))

    def test_numpy_is_not_copied(self):
        if kern.numpy is None:
            self.skipTest("no numpy")
        array = kern.numpy.array(BOX, dtype=float)
        block = Block("b", array)
        self.assertIs(block.vertices, array)
        array += (2, 3)
        self.assertEqual(block.body().centre, (2.5, 3.5))
        with self.assertRaises(ValueError):
            Block("b", array.reshape(2, 4))

    def test_loads(self):
        """A push at the foot leaves the sliding; at the head it tips."""
        b = two(0)[:2]
        b[1].push((3, 0), (0, 0.25))
        self.assertEqual(b[1].load, (3, 0, 0.75))
        s = Structure(b)
        self.assertTrue(s.verdict())
        pattern = [(0, 0, 0), (1, 0, 0)]
        self.assertAlmostEqual(s.load_factor(0, 0, pattern), 0.4 * 9.81 - 3, 5)
        with self.assertRaises(ValueError):
            s.load_factor(0, 0, pattern[:1])

    def test_live(self):
        """2 kg at g 10 tip about a corner 0.5 away under 5 N at a height of 2."""
        ground = Block("g", [(-3, -1), (3, -1), (3, 0), (-3, 0)], fixed=True)
        pier = Block("a", [(0, 0), (1, 0), (1, 2), (0, 2)], mass=2)
        s = Structure([ground, pier], options=kern.Options(mu=2),
                      gravity=(0, -10))
        load = [("a", (1, 0), (0.5, 2))]
        self.assertAlmostEqual(s.live(load), 5, 6)
        self.assertAlmostEqual(s.live(load).motion.tolist()[1][2], -0.5 ** 0.5,
                               6)
        self.assertLess(abs(s.live(load, raised=True) / 5 - 1), 0.004)
        self.assertLess(abs(s.raised_load(kern.RIGHT) / 0.5 - 1), 0.004)
        with self.assertRaises(ValueError):
            s.live([("b", (1, 0), (0, 0))])
        s.lives = load  # as a file brings them
        t = kern.parse(s.text())
        self.assertEqual(list(t.lives), load)
        self.assertEqual((t.live(), t.live(raised=True)),
                         (s.live(load), s.live(load, raised=True)))

    def test_given_contacts(self):
        made = kern.contact_make(0, 1, (0, 1), (0, 0), (1, 0), mu=0.3)
        s = Structure(two(0)[:2], contacts=kern.contact_travels(made))
        self.assertEqual(s.contacts, made)
        self.assertAlmostEqual(s.load_factor(kern.RIGHT), 0.3, 6)
        self.assertEqual(made[0].at(0.1), (0.1, 0.0))

    def test_touch_and_profile(self):
        s = Structure(two(0.2))
        self.assertEqual(s.touch("low") + s.touch("top"), s.contacts)
        p = s.profile()
        self.assertEqual(p.values[0], math.inf)
        self.assertAlmostEqual(p.least, s.measure().margin, 5)
        self.assertEqual(min(p.values), p.least)

    def test_bearing(self):
        """Two boxes need the shorter of their two beds."""
        self.assertAlmostEqual(Structure(two(0.2)).bearing(), 0.8)
        self.assertIsNone(Structure(two(0.7)).bearing())

    def test_forces(self):
        """A box stands on two equal forces without friction."""
        force = Structure(two(0)[:2]).forces()
        self.assertAlmostEqual(force[0, 0], force[1, 0])
        self.assertAlmostEqual(force[0, 1], 0)
        self.assertIsNone(Structure(two(0.7)).forces())

    def test_sensitivity(self):
        """A box farther to the right has as much less margin."""
        contacts, blocks = Structure(two(0.2)).sensitivity()
        self.assertEqual((len(contacts), len(blocks)), (4, 3))
        self.assertAlmostEqual(blocks[2].place[0], -1, 5)
        self.assertAlmostEqual(blocks[2].turn, 0, 5)

    def test_narrow(self):
        """On a slope of atan(0.3), friction 0.4 leaves 0.1 / 1.12 to lose."""
        s = Structure(two(0.2), options=Options(narrow=0.1))
        self.assertAlmostEqual(s.measure().margin, 0.3, 5)
        s = Structure(two(0)[:2], options=Options(narrow=4.0),
                      gravity=(0.3, -1.0))
        self.assertAlmostEqual(s.measure().margin, 0.1 / 1.12 / 4, 5)

    def test_near(self):
        high = two(0)
        high[2].move(0, 0.02)
        self.assertFalse(Structure(high).verdict())
        options = Options().near(Structure(high).mean_size)
        self.assertTrue(Structure(high, options=options).verdict())

    def test_plan(self):
        """A plan says what a structure says, beyond its first arrays too."""
        plan = Plan([ground()])
        stones = []
        for i in range(40):
            stone = Block("s%d" % i, BOX).move(0.005 * i, i)
            said = plan.try_(stone)
            plan.add(stone)
            stones.append(stone)
            self.assertEqual((said.stands, said.level),
                             (plan.measure().stands, plan.measure().level))
        want = Structure([ground(), *stones]).measure()
        self.assertAlmostEqual(plan.measure().margin, want.margin, 5)
        self.assertLessEqual(plan.check_forces(plan.verdict().forces), 1)
        plan.remove("s39")
        plan.remove(plan.blocks[-1].name)
        self.assertEqual(len(plan.blocks), 39)
        stone.move(0, -1)
        self.assertTrue(plan.bears(stone, 0.1))
        self.assertFalse(plan.bears(stone, 0.6))
        before = plan.measure()
        stone.move(0, 100)  # the plan has blocks of its own
        self.assertEqual(plan.measure().margin, before.margin)

    def test_proof_of_every_number(self):
        s = Structure(two(0.2))
        f = s.load_factor(kern.RIGHT)
        pattern = [(0, 0, 0)] + [(f * 9.81, 0, 0)] * 2
        loaded = Structure([Block(b.name, b.vertices, fixed=b.fixed, load=p)
                            for b, p in zip(s.blocks, pattern)])
        self.assertLessEqual(loaded.check_forces(f.forces), 2000)  # of 1e-9
        self.assertEqual(f.motion.shape, (3, 3))
        self.assertEqual(s.bearing().forces.shape, (4, 2))
        self.assertEqual(len(s.tilt(kern.LEFT).motion), 3)

    def test_shapes_from_elsewhere(self):
        """Closed rings, shapely's objects, arrays; equality."""
        class Ring:
            coords = [*BOX, BOX[0]]

        class Polygon:
            exterior = Ring()
        self.assertEqual(Block("b", Polygon()), Block("b", BOX))
        self.assertEqual(Block("b", [*BOX, BOX[0]]), Block("b", BOX))
        self.assertNotEqual(Block("b", BOX), Block("b", BOX, density=2))
        self.assertIn(Block("b", BOX), [Block("c", BOX), Block("b", BOX)])
        with self.assertRaisesRegex(ValueError, "'b': vertices"):
            Block("b", [(0, 0, 0), (1, 0, 0), (1, 1, 0)])

    def test_pickles(self):
        """Answers, errors, structures and plans go through a pipe."""
        s = Structure(two(0.2))
        plan = Plan(two(0.1))
        for value in (s.measure(), s.verdict(), s.raised(True), s.blocks[2],
                      s.load_factor(kern.LEFT), s.profile(), s.options):
            for again in (pickle.loads(pickle.dumps(value)),
                          copy.deepcopy(value)):
                self.assertEqual(again, value)
        again = pickle.loads(pickle.dumps(s))
        self.assertEqual(again.measure(), s.measure())
        self.assertEqual(again.measure().forces.tolist(),
                         s.measure().forces.tolist())
        self.assertEqual(copy.deepcopy(plan).measure().margin,
                         plan.measure().margin)

    def test_pickles_all_that_was_set(self):
        """Live loads of a file, and what a subclass or its user adds."""
        class Named(Structure):
            def __init__(self, site):
                super().__init__(two(0.2))
                self.site = site
        wall = kern.read(ROOT / "examples" / "structures" / "ladder.kern")
        again = pickle.loads(pickle.dumps(wall))
        self.assertEqual((again.live(), again.units),
                         (wall.live(), wall.units))
        self.assertEqual(copy.deepcopy(Named("here")).site, "here")
        plan = Plan(two(0.2))
        plan.site = "there"
        plan = pickle.loads(pickle.dumps(plan))
        self.assertEqual((plan.site, plan.measure()),
                         ("there", Plan(two(0.2)).measure()))

    def test_pool(self):
        """Ten bad structures of a thousand are ten exceptions, by name."""
        with multiprocessing.Pool(4) as pool:
            out = pool.map(margin_or_error, range(1000), 50)
        bad = [e for e in out if isinstance(e, kern.KernError)]
        self.assertEqual([e.blocks for e in bad],
                         [("bow tie %d" % i,) for i in range(50, 1000, 100)])
        self.assertEqual(len(out), 1000)

    def test_threads(self):
        """One structure in four threads: every answer as in one."""
        s = Structure(two(0.2))
        want = [s.measure().margin, s.bearing(), bool(s.verdict())]
        with concurrent.futures.ThreadPoolExecutor(4) as pool:
            for got in pool.map(lambda i: [s.measure().margin, s.bearing(),
                                           bool(s.verdict())], range(200)):
                self.assertEqual(got, want)

    def test_text(self):
        """What text() writes reads back with the same answers."""
        for path in FILES:
            s = kern.read(path)
            again = kern.parse(s.text())
            self.assertEqual([b.fixed for b in again.blocks],
                             [b.fixed for b in s.blocks])
            a, b = s.measure(), again.measure()
            self.assertEqual((a.stands, a.level), (b.stands, b.level), path)
            self.assertAlmostEqual(a.margin, b.margin, 9)
        odd = Structure([ground(), Block("a b#c", BOX)])
        self.assertEqual(kern.parse(odd.text()).blocks[1].name, "a_b_c")

    def test_linear_program(self):
        out = kern.lp_solve([[1.0, 1.0]], [-1.0])
        self.assertEqual(out.status, Status.LP_INFEASIBLE)
        with self.assertRaises(ValueError):
            kern.lp_solve([[1.0], [1.0, 2.0]], [1.0, 1.0])


def tower(n, seed):
    """A tower of three boxes, and n poses of all its blocks."""
    draw = random.Random(seed)
    wall = Structure([*two(0), Block("third", BOX, mass=2.0,
                                     centre=(0.4, 2.5)).move(0, 2)])
    poses = [[(0, 0, 0)] + [(draw.uniform(-.4, .4), 0, draw.uniform(-.001, .001))
                            for _ in wall.blocks[1:]] for _ in range(n)]
    return wall, poses


def margins_of(part):
    """For a process of a pool."""
    return [float(m) for m in kern.many(tower(0, 0)[0], poses=part).margin]


class ManyWalls(unittest.TestCase):
    def one_by_one(self, wall, pose):
        """What many() says of one structure, by the way of one."""
        blocks = [b.copy().move(*p) for b, p in zip(wall.blocks, pose)]
        try:
            s = Structure(blocks, options=wall.options)
        except kern.KernError as error:
            return int(error.status), None, -1, None, None
        m = s.measure()
        return (int(Status.STANDS if m else Status.FALLS), m.margin, m.level,
                [s.load_factor(side) or 0.0 for side in (kern.LEFT, kern.RIGHT)],
                None if m.motion is None else m.motion.tolist())

    def test_same_as_one_by_one(self):
        """Every answer has the bits of a structure that was made by itself."""
        wall, poses = tower(60, 1)
        poses[7][2] = (0.1, -0.3, 0)
        out = kern.many(wall, poses=poses, loads=True, mechanisms=True)
        seen = set()
        for i, pose in enumerate(poses):
            status, margin, level, loads, motion = self.one_by_one(wall, pose)
            seen.add(status)
            self.assertEqual((out.status[i], out.level[i]), (status, level))
            if margin is None:
                self.assertTrue(math.isnan(out.margin[i]))
                self.assertTrue(math.isnan(out.mechanisms[i][3][0]))
                continue
            self.assertEqual(out.margin[i], margin)
            self.assertEqual(list(out.loads[i]), loads)
            self.assertEqual(out.mechanisms[i].tolist(), motion)
        self.assertEqual(seen, {Status.STANDS, Status.FALLS, Status.OVERLAP})
        told = out.as_dict()
        json.dumps(told)
        self.assertEqual(told["loads"][0], list(out.loads[0]))
        self.assertEqual(len(told["mechanisms"][0]), len(wall.blocks))
        self.assertNotEqual(out, kern.many(wall, poses=poses[:2]))
        self.assertEqual((len(out), [bool(x) for x in out.stands]),
                         (60, [k == Status.STANDS for k in out.status]))

    def test_threads_and_processes(self):
        """Any number of threads, and processes, give the same bits."""
        wall, poses = tower(200, 2)
        want = list(kern.many(wall, poses=poses, threads=1).margin)
        for threads in (2, 3, 16, None):
            self.assertEqual(list(kern.many(
                wall, poses=poses, threads=threads).margin), want)
        with multiprocessing.Pool(2) as pool:
            parts = pool.map(margins_of, [poses[:70], poses[70:]])
        self.assertEqual(parts[0] + parts[1], want)

    def test_friction_and_stones(self):
        """A friction each; a stone each, named poses, a plan as the wall."""
        slope = Structure(two(0)[:2], gravity=(3, -10))
        self.assertEqual([bool(s) for s in kern.many(
            slope, mu=[0.2, 0.29, 0.31, 0.5]).stands], [False] * 2 + [True] * 2)
        stones = [Block("top", BOX).move(x, 1) for x in (0, 0.2, 0.7, 5)]
        out = kern.many(Plan(two(0)[:2]), stones=stones, mechanisms=True)
        self.assertEqual([Status(s).name for s in out.status],
                         ["STANDS", "STANDS", "FALLS", "FALLS"])
        self.assertEqual(out.margin[1], Structure(two(0.2)).measure().margin)
        self.assertEqual(len(out.mechanisms[2]), 3)
        named = kern.many(Structure(two(0)), poses={"top": [(0.2, 0, 0)]})
        self.assertAlmostEqual(named.margin[0], out.margin[1])
        self.assertIsNone(named.loads)

    def test_room(self):
        """Where contacts find no room there are more."""
        saw = [(x / 2 - 8, 0.2 * (x % 2)) for x in range(33)]
        wall = Structure([
            Block("ground", [(-8, -1), (8, -1), *saw[::-1]], fixed=True),
            Block("saw", [*saw, (8, 1), (-8, 1)])])
        self.assertGreater(len(wall.contacts), 48)
        out = kern.many(wall, mu=[0.4] * 3)
        self.assertEqual([float(m) for m in out.margin],
                         [wall.measure().margin] * 3)

    def test_refused(self):
        wall, poses = tower(3, 1)
        made = kern.contact_travels(kern.contact_make(0, 1, (0, 1), (0, 0),
                                                      (1, 0)))
        for words, call in (
                ("give poses, mu or stones", lambda: kern.many(wall)),
                ("'poses': 3, 'mu': 1", lambda: kern.many(
                    wall, poses=poses, mu=[0.4])),
                ("poses has 9 numbers, 12 are", lambda: kern.many(
                    wall, poses=[poses[0][:3]])),
                ("contacts are given", lambda: kern.many(
                    Structure(two(0)[:2], contacts=made), mu=[0.4])),
                ("'flat': ", lambda: kern.many(wall, stones=[
                    Block("flat", [(0, 0), (1, 0), (2, 0)])]))):
            with self.assertRaisesRegex(ValueError, words):
                call()
        out = kern.many(wall, poses={"low": [(math.nan, 0, 0)]})
        self.assertEqual(Status(out.status[0]), Status.BAD_NUMBER)
        out = kern.many(wall, mu=[-1, 0.4])
        self.assertEqual([Status(s) for s in out.status],
                         [Status.BAD_FRICTION, Status.STANDS])
        self.assertEqual(len(kern.many(wall, mu=[])), 0)
        with self.assertRaisesRegex(KeyError, "no block is named 'x'"):
            kern.many(wall, poses={"x": [(0, 0, 0)]})

    def test_labels(self):
        """The example writes the same lines in one process, in a pool and under
        Dask."""
        ways = [[], ["--on", "pool"]]
        if there("dask"):
            ways.append(["--on", "dask"])
        runs = [subprocess.run(
            [sys.executable, *(["-S"] if kern.numpy is None else []),
             str(MODULE / "labels.py"), "600", *more], check=True,
            stdout=subprocess.PIPE).stdout for more in ways]
        self.assertEqual(len(set(runs)), 1)
        rows = [json.loads(line) for line in runs[0].splitlines()]
        self.assertEqual(len(rows), 600)
        for row in rows[::97]:
            blocks = [Block(name, v, density=2400, fixed=name in row["fixed"])
                      for name, v in row["blocks"].items()]
            m = Structure(blocks, options=Options(mu=row["mu"])).measure()
            self.assertEqual(row["status"], "STANDS" if m else "FALLS")
            self.assertAlmostEqual(row["margin"], m.margin if m else 0, 6)


def there(module):
    """Whether a package is installed."""
    try:
        return __import__(module)
    except ImportError:
        return None


class Conventions(unittest.TestCase):
    def test_blocks_by_name(self):
        s = Structure(two(0.2))
        self.assertIs(s["top"], s.blocks[2])
        self.assertIs(s[-1], s[2])
        self.assertEqual([b.name for b in s], ["ground", "low", "top"])
        self.assertEqual(("top" in s, "x" in s, s[1] in s), (True, False, True))
        with self.assertRaisesRegex(KeyError, "no block is named 'x'"):
            s["x"]
        with self.assertRaises(IndexError):
            s[3]
        for call in (lambda: Structure(two(0), Options()),
                     lambda: Plan(two(0), Options())):
            with self.assertRaisesRegex(TypeError, "positional"):
                call()

    def test_sides(self):
        """A side is an enum, and its number."""
        s = Structure(two(0.2))
        self.assertEqual([side.name for side in kern.Side],
                         ["LEFT", "SHRINK", "RIGHT"])
        self.assertEqual(s.tilt(kern.Side.LEFT), s.tilt(-1))

    def test_answers_as_dicts(self):
        """Fields of answers are numbers; a table has no columns of bytes."""
        s = Structure(two(0.2))
        deep = Plan(two(0)[:2]).try_(Block("top", BOX).move(0, 0.5))
        for answer in (s.verdict(), s.measure(), s.let_go(), s.raised(),
                       s.profile(), s.critical(), s.contacts[0], deep,
                       s.blocks[1], *s.sensitivity()[0]):
            told = answer.as_dict()
            self.assertFalse([key for key in told if key[0] == "_"])
            json.dumps(told)
        self.assertIn("'low' and 'top'", deep.as_dict()["refused"])
        pandas = there("pandas")
        if pandas:
            table = pandas.DataFrame([s.measure(), deep])
            self.assertEqual(list(table)[:3], ["stands", "margin", "holds"])
            self.assertFalse([c for c in table if c[0] == "_"])

    def test_rows(self):
        """Arrays are iterated over, with numpy or without."""
        s = Structure(two(0.2))
        for x, y in s["top"].vertices:
            self.assertTrue(0.2 <= x <= 1.2 and 1 <= y <= 2)
        self.assertEqual(len([n for n, t in s.verdict().forces]), 4)
        self.assertEqual(len([n for n, t in s.forces()]), 4)
        self.assertEqual([len(row) for row in s.measure().motion], [3, 3, 3])
        rows = kern.Rows(memoryview(bytearray(32)).cast("d"), 2)
        rows[1] = (3, 4)
        rows[0, 1] = 2
        self.assertEqual((rows[1], rows[-1, 0], rows[:, 1], rows[0:1]),
                         ((3, 4), 3, [2, 4], [(0, 2)]))
        self.assertEqual(pickle.loads(pickle.dumps(rows)), rows)
        for bad in (lambda: rows[2], lambda: rows[0, 2]):
            with self.assertRaises(IndexError):
                bad()
        with self.assertRaises(ValueError):
            rows[0] = (1, 2, 3)
        with self.assertRaises(TypeError):
            rows.toreadonly()[0, 0] = 1

    def test_holes_and_parts(self):
        """Are refused by the name of the block."""
        class Ring:
            coords = BOX

        class Polygon:
            exterior = Ring()
            interiors = (Ring(), Ring())

        class MultiPolygon:
            geoms = (Ring(),) * 3

        class One:
            geoms = (Ring(),)
        with self.assertRaisesRegex(ValueError, "'a': the polygon has 2 holes"):
            Block("a", Polygon())
        with self.assertRaisesRegex(ValueError, "'a': a MultiPolygon of 3 parts"):
            Block("a", MultiPolygon())
        self.assertEqual(Block("a", One()), Block("a", BOX))
        shapely = there("shapely.geometry")
        if shapely:
            s, made = Structure(two(0.2)), shapely.geometry
            shape = s.to_shapely()
            self.assertEqual((shape.area, shape.is_valid), (9, True))
            union = __import__("shapely.ops").ops.unary_union(shape)
            self.assertEqual((union.geom_type, union.area), ("Polygon", 9))
            self.assertEqual(Block("top", s["top"].to_shapely()), s["top"])
            with self.assertRaisesRegex(ValueError, "has 1 hole,"):
                Block("a", s["low"].to_shapely().difference(
                    made.Point(0.5, 0.5).buffer(0.1)))
            with self.assertRaisesRegex(ValueError, "of 3 parts"):
                Block("a", shape)
            one = made.MultiPolygon([s["low"].to_shapely()])
            self.assertEqual(Block("low", one), s["low"])

    def test_moves_alone(self):
        """A block that moves leaves the array that it was made of, and other
        blocks of that array, where they are."""
        numpy = there("numpy")
        if not numpy:
            self.skipTest("no numpy")
        box = numpy.array(BOX, float)
        box.setflags(write=False)
        low, top = Block("low", box), Block("top", box).move(0.2, 1)
        self.assertEqual((low, top), (Block("low", BOX), two(0.2)[2]))
        self.assertEqual(box.tolist(), [list(p) for p in BOX])
        box = numpy.array(BOX, float) + (0, 1)
        s = Structure([*two(0)[:2], Block("top", box)])
        with self.assertRaises(kern.KernError):
            s.move("top", 0, -0.5)
        box += (0.2, 0)
        s.update()
        self.assertAlmostEqual(s.measure().margin, 0.3)

    def test_all_overlaps(self):
        """An error of overlaps names all pairs; it is pickled with them."""
        deep = [*two(0), Block("third", BOX).move(0, 1.5)]
        deep[1].move(0, -0.25)
        with self.assertRaises(kern.KernError) as caught:
            Structure(deep)
        error = caught.exception
        self.assertEqual([pair[:2] for pair in error.overlaps],
                         [("ground", "low"), ("top", "third")])
        self.assertIn("0.25 deep; 0.001 is allowed", str(error))
        self.assertRegex(str(error), r"; also 'top' and 'third' \(0.\d+ deep\)")
        again = pickle.loads(pickle.dumps(error))
        self.assertEqual((str(again), again.overlaps),
                         (str(error), error.overlaps))
        plan = Plan(two(0))
        with self.assertRaises(kern.KernError) as caught:
            plan.add(Block("x", [(0, 0.5), (1, 0.5), (1, 1.5), (0, 1.5)]))
        self.assertEqual([pair[:2] for pair in caught.exception.overlaps],
                         [("low", "x"), ("top", "x")])

    def test_interval(self):
        """Stands for certain, falls for certain, or neither."""
        for x, stands in ((0.1, True), (0.5, None), (0.8, False)):
            i = Structure(two(x), options=Options().measured(
                0.01, 0.01)).interval()
            self.assertEqual((i.surely_stands, i.surely_falls, i.certain),
                             (stands is True, stands is False,
                              stands is not None), x)

    def test_plot(self):
        class Axes:
            def __init__(self):
                self.calls = []

            def __getattr__(self, name):
                return lambda *a, **k: self.calls.append(name)
        axes = Axes()
        self.assertIs(Structure(two(0.2)).plot(axes), axes)
        self.assertEqual([axes.calls.count(name) for name in (
            "fill", "annotate", "plot", "set_title")], [3, 3, 2, 1])
        matplotlib = there("matplotlib")
        if matplotlib:
            matplotlib.use("svg")
            ax = Structure(two(0.7)).plot()
            self.assertEqual(len(ax.patches), 3)
            self.assertEqual(ax.get_title(), "structure: falls, deficit 0.2")
            ax.figure.clf()
            title = Plan([ground()]).plot().get_title()
            self.assertEqual(title, "plan: no block is free")

    def test_ground_alone(self):
        """An empty plan has a picture."""
        for plan in (Plan([ground()]), Plan()):
            self.assertIn("plan: no block is free", plan.svg())
        picture = Plan([ground()])._repr_svg_()
        self.assertIn(">ground</text>", picture)
        self.assertNotIn("nan", picture)

    def test_manual(self):
        """Everything public has a docstring that does not begin with a name of
        C, and help() has the chapters."""
        self.assertIn("Methods of a structure", kern.__doc__)
        self.assertEqual([name for name, thing in vars(kern).items()
                          if name[0] != "_" and name not in kern.__all__
                          and getattr(thing, "__module__", "") == "kern"], [])
        for name in set(kern.__all__) - {"Array"}:
            thing = getattr(kern, name)
            things = [(name, thing)] if callable(thing) else []
            if isinstance(thing, type):
                things += [("%s.%s" % (name, key), value)
                           for key, value in vars(thing).items()
                           if key[0] != "_" and (callable(value) or isinstance(
                               value, property))]
            for key, value in things:
                if isinstance(thing, type) and issubclass(thing, int):
                    continue
                self.assertTrue(value.__doc__, key)
                self.assertFalse(value.__doc__.startswith("kern_"), key)


class Environment(unittest.TestCase):
    def episodes(self, seed, actions):
        """Rewards and last observations of some episodes."""
        import env
        e, out = env.Stacking(), []
        e.reset(seed=seed)
        for action in actions:
            seen, reward, terminated, _, info = e.step(action)
            out.append((list(seen), reward, terminated, info))
            if terminated:
                e.reset()
        return e, out

    def test_same_episodes(self):
        """A seed and actions tell all that follows."""
        draw = random.Random(5)
        actions = [draw.randrange(24) for _ in range(200)]
        _, a = self.episodes(3, actions)
        self.assertEqual(a, self.episodes(3, actions)[1])
        self.assertNotEqual(a, self.episodes(4, actions)[1])
        ends = [terminated for _, _, terminated, _ in a]
        self.assertTrue(10 < sum(ends) < 150)

    def test_rewards_are_proven(self):
        """Forces prove the margin that is rewarded, a motion that it falls."""
        e, told = self.episodes(1, [12, 12])
        m = e.plan.measure()
        self.assertLessEqual(e.plan.check_forces(m.forces, m.holds), 1)
        gained = e.laid[1][2] - e.laid[0][2]
        self.assertAlmostEqual(told[1][1], gained + min(
            m.holds, e.PROVEN) / e.PROVEN)
        falls = 0
        for place in range(24):
            e, told = self.episodes(2, [12, place])
            if not told[1][3]["stands"]:
                falls += 1
                self.assertEqual(told[1][1:3], (-1, True))
        self.assertGreater(falls, 0)

    def test_checked(self):
        import doctest
        import env
        self.assertEqual(doctest.testmod(env).failed, 0)
        if env.gymnasium is None:
            self.skipTest("no gymnasium")
        from gymnasium.utils.env_checker import check_env
        check_env(env.Stacking(render_mode="svg"))


class BadInput(unittest.TestCase):
    def refuse(self, status, blocks, call):
        with self.assertRaises(kern.KernError) as caught:
            call()
        self.assertEqual((caught.exception.status, caught.exception.blocks),
                         (status, blocks))
        for name in blocks:
            self.assertIn("'%s'" % name, str(caught.exception))

    def test_refused_with_names(self):
        deep = two(0)
        deep[2].move(0, -0.25)
        flat = Block("flat", [(0, 0), (1, 0), (2, 0)])
        line = Block("line", [(0, 0), (1, 0)])
        nan = Block("nan", [(0, 0), (1, math.nan), (1, 1)])
        void = Block("void", [(0, 0), (1, 0), (1, 1)], density=0)
        heavy = [ground(), Block("heavy", BOX, mass=-1.0)]
        for status, blocks, call in (
                (Status.OVERLAP, ("low", "top"), lambda: Structure(deep)),
                (Status.NO_AREA, ("flat",), flat.body),
                (Status.FEW_VERTICES, ("line",), line.body),
                (Status.BAD_NUMBER, ("nan",), nan.body),
                (Status.BAD_MASS, ("void",), void.body),
                (Status.BAD_MASS, ("heavy",), Structure(heavy).verdict),
                (Status.NO_FREE, (), Structure([ground()]).verdict),
                (Status.BAD_OPTION, (), lambda: Structure(
                    two(0), options=Options(epsilon=-1)))):
            with self.subTest(status=status):
                self.refuse(status, blocks, call)
        plan = Plan(two(0)[:2])
        self.assertEqual((bool(plan.try_(deep[2])), plan.bears(deep[2], 0)),
                         (False, False))
        self.assertEqual(plan.try_(deep[2]).refused.blocks, ("low", "top"))
        self.refuse(Status.SAME_BLOCK, (),
                    lambda: kern.contact_make(1, 1, (0, 1), (0, 0)))

    def test_one_name_twice(self):
        """Is refused as in a file; where names are made they are not."""
        again = ("block 2: the name 'low' was given to block 1 already")
        twice = [*two(0.2)[:2], Block("low", BOX).move(0.2, 1)]
        for call in (lambda: Structure(twice), lambda: Plan(twice)):
            with self.assertRaisesRegex(ValueError, again):
                call()
        plan = Plan(twice[:2])
        self.assertAlmostEqual(plan.try_(twice[2]).margin, 0.3)
        with self.assertRaisesRegex(ValueError, again):
            plan.add(twice[2])
        self.assertEqual((len(plan), plan.measure().margin), (2, 0.5))
        s = Structure(two(0.2))
        s.blocks[2].name = "low"
        with self.assertRaisesRegex(ValueError, again):
            s.move("low", 0.1, 0)
        self.assertEqual(s.blocks[1].vertices.tolist(), [list(q) for q in BOX])
        with self.assertRaisesRegex(TypeError, "as its name, read 3"):
            Block(3, BOX)
        three = [ground(), *(Block(name, BOX).move(i, 0) for i, name in
                             enumerate(("a b", "a_b_2", "a#b")))]
        self.assertEqual([b.name for b in kern.parse(
            Structure(three).text()).blocks],
            ["ground", "a_b", "a_b_2", "a_b_3"])
        for b, name in zip(three[1:], ("s", "s_2", "s")):
            b.name = name
        self.assertEqual([b.name for b in kern.from_labelme(
            page(three)).blocks], ["ground", "s", "s_2", "s_3"])

    def test_ranges(self):
        """A number that cannot be meant is refused with the name of its
        option; in other units it can."""
        size = "a length up to the mean size of the blocks, 1, read"
        for name, value, words in (
                ("mu", -1, "takes a number not below zero, read -1"),
                ("gap", -1.0, "takes a number not below zero, read -1.0"),
                ("gap", math.nan, "takes a number not below zero, read nan"),
                ("angle", 0.5, "takes an angle in radians above 0 and below"),
                ("angle", 0, "takes an angle in radians above 0 and below"),
                ("epsilon", math.inf, "takes a number not below zero"),
                ("reserve", 0.2, "takes a share from 0 to 0.1, read 0.2"),
                ("limit", 2 ** 31 - 1, "takes a whole number from 1 to"),
                ("gap", 1e9, "takes %s 1000000000.0" % size),
                ("overlap", 1.5, "takes %s 1.5" % size),
                ("pose_error", 0.3, "takes a length up to a fifth of the mean")):
            with self.assertRaisesRegex(kern.KernError, "Options.%s %s" % (
                    name, words)):
                Structure(two(0), options=Options(**{name: value}))
        with self.assertRaisesRegex(kern.KernError, "epsilon takes a share up"):
            Structure(two(0), options=Options(epsilon=2, relative=True))
        with self.assertRaisesRegex(TypeError, "Options.mu takes a number not"):
            Structure(two(0), options=Options(mu="0.4"))
        with self.assertRaisesRegex(TypeError, "Options.limit takes a whole"):
            Structure(two(0), options=Options(limit=1e6))
        for e, theta in ((0, 0), (-1, 0), (.01, 10), (math.nan, 0)):
            with self.assertRaisesRegex(kern.KernError, "measured.. takes"):
                Options().measured(e, theta)
        wide = [Block(b.name, [(1000 * x, 1000 * y) for x, y in
                               b.vertices.tolist()], fixed=b.fixed)
                for b in two(0.2)]
        m = Structure(wide, options=Options(gap=1, epsilon=20)).measure()
        self.assertAlmostEqual(m.margin, 300, 3)
        self.assertEqual(m.level, 16)
        for scale, words in (({"pixel": 0}, "pixel is a length above 0"),
                             ({"tolerance": -1}, "tolerance a number of pix"),
                             ({"tolerance": 40}, "100 pixels in the mean, of")):
            with self.assertRaisesRegex(ValueError, words):
                kern.from_labelme(page(two(0.2)), **scale)

    def test_what_is_no_number(self):
        """Too few numbers, or words, are refused by name: nothing is filled up
        with zeros."""
        def a(**own):
            return lambda: Structure([ground(), Block("a", BOX, **own)])
        for words, call in (
                ("'a': load: 3 numbers are expected, read .1, 2.", a(
                    load=(1, 2))),
                ("'a': centre: 2 numbers are expected, read .1,.", a(
                    centre=(1,))),
                ("'a': mass: a number is expected, read '1'", a(mass="1")),
                ("'a': density: a number is expected, read '1'", a(
                    density="1")),
                ("gravity: 2 numbers are expected, read 9.81", lambda: Structure(
                    two(0), gravity=9.81)),
                ("gravity: 2 numbers are expected, read .9", lambda: Plan(
                    two(0), gravity=(9.81,))),
                ("options are Options", lambda: Structure(
                    two(0), options={"mu": 1}))):
            with self.assertRaisesRegex(TypeError, words):
                call()

    def test_one_clear_line(self):
        """What is handed in by mistake is named by what was expected and what
        was read: no AttributeError, nothing silently left out."""
        s, plan, stone = Structure(two(0.2)), Plan(two(0)[:2]), two(0.2)[2]
        read = "Block is expected, read "
        for words, call in (
                ("block 1: a %s1" % read, lambda: Structure([ground(), 1])),
                ("a %sNone" % read, lambda: plan.try_(None)),
                ("a %s3" % read, lambda: plan.add(3)),
                ("stones: a %sNone" % read, lambda: kern.many(
                    plan, stones=[None])),
                ("a Contact is expected, read 1", lambda: Structure(
                    two(0), contacts=[1])),
                ("numbers of two blocks, read 'low'", lambda: kern.contact_make(
                    "low", "top", (0, 1), (0, 0))),
                ("normal: 2 numbers are expected, read .0,.",
                 lambda: kern.contact_make(0, 1, (0,), (0, 0))),
                ("'top': force: 2 numbers are expected, read .3,.",
                 lambda: stone.copy().push((3,), (0, 1))),
                ("'top': move..: 3 numbers are", lambda: s.move("top", "1", 0)),
                ("'a': load: 3 numbers are expected, read None",
                 lambda: Block("a", BOX, load=None).body()),
                ("verdict..: a number is expected, read .1.",
                 lambda: s.verdict([1])),
                ("bears..: a number is expected, read None",
                 lambda: plan.bears(stone, None)),
                ("rest..: a number is expected, read 'x'",
                 lambda: plan.rest(stone, "x")),
                ("a pose: 3 numbers are expected, read .1, 2.",
                 lambda: plan.tries(stone, [(1, 2)])),
                ("name or the number of a block is expected, read 1.5",
                 lambda: s.stays(1.5)),
                ("live..: .NAME, FORCE, POINT. is expected, read .'top',.",
                 lambda: s.live([("top",)])),
                ("a load pattern: rows of 3 numbers are expected, read 'x'",
                 lambda: s.load_factor(0, 0, "x")),
                ("critical..: a Margin is expected, read 3",
                 lambda: s.critical(3)),
                ("a Raised or a LetGo is expected", lambda: s.check_raised(
                    s.verdict())),
                ("near..: a number is expected, read 'a'",
                 lambda: Options().near("a")),
                ("Options.lone: 2 numbers are expected", lambda: Structure(
                    two(0), options=Options(lone=(1,)))),
                ("tolerance: a number is expected, read 'x'",
                 lambda: kern.simplified(BOX, "x")),
                ("a str or bytes are expected, read None",
                 lambda: kern.parse(None)),
                ("many..: a Structure or a Plan is expected", lambda: kern.many(
                    s.blocks, mu=[0.4])),
                ("many..: mu: a list or an array is expected, read 0.4",
                 lambda: kern.many(s, mu=0.4)),
                ("many..: mu: numbers are expected.*'abc'",
                 lambda: kern.many(s, mu="abc")),
                ("many..: top: numbers are expected", lambda: kern.many(
                    s, poses={"top": ["a"]})),
                ("unexpected keyword argument 'pixle'",
                 lambda: kern.from_labelme(page(two(0)), pixle=0.01)),
                ("layers takes a dict of names and roles",
                 lambda: kern.from_labelme(page(two(0)), layers=["a=fill"])),
                ("pixel: a number is expected, read '1'",
                 lambda: kern.from_labelme(page(two(0)), pixel="1"))):
            with self.assertRaisesRegex(TypeError, words):
                call()
        for words, call in (
                ("a load pattern: row 0 is .1,. where 3 numbers are expected",
                 lambda: s.load_factor(0, 0, [(1,), (1, 2),
                                              (1, 2, 3, 4, 5, 6)])),
                ("a pattern takes the place of a side: pass SHRINK",
                 lambda: s.load_factor(kern.LEFT, 0, [(1, 0, 0)] * 3)),
                ("near.. takes a length above 0, read nan",
                 lambda: Options().near(math.nan)),
                ("'a': vertices .* too large", lambda: Block(
                    "a", [(0, 0), (10 ** 400, 0), (1, 1)]))):
            with self.assertRaisesRegex(ValueError, words):
                call()
        self.assertEqual(s.tilt(1.0), s.tilt(kern.RIGHT))

    def test_questions_without_an_answer(self):
        """Say what is missing: a side, gravity, a live load, an error."""
        s, still = Structure(two(0.2)), two(0.2)
        still[2].load = (0, -1, 0)
        still = Structure(still, gravity=(0, 0))
        for words, call in (
                ("load_factor..: a side is LEFT or RIGHT, read 0",
                 lambda: s.load_factor(0)),
                ("raised_load..: a side is LEFT or RIGHT, read 0",
                 lambda: s.raised_load(0)),
                ("tilt..: a side is LEFT or RIGHT, read 2", lambda: s.tilt(2)),
                ("profile..: a side is LEFT or RIGHT", lambda: s.profile(9)),
                ("errors of the poses", s.interval), ("errors of", s.certain),
                ("load_factor..: there is no gravity",
                 lambda: still.load_factor(kern.LEFT)),
                ("tilt..: there is no gravity", lambda: still.tilt(kern.LEFT)),
                ("reserve=True.: there is no gravity",
                 lambda: still.raised(reserve=True)),
                ("stays..: there is no gravity", lambda: still.stays("top")),
                ("no live load: live...NAME", s.live),
                ("no live load: live_least...NAME", s.live_least), ("'ground' is fixed", lambda: s.live(
                    [("ground", (0, -1), (0, 0))]))):
            with self.assertRaisesRegex(ValueError, words):
                call()
        self.assertTrue(still.raised())
        self.assertEqual(s.live([]), math.inf)
        with self.assertRaisesRegex(KeyError, "no block is named 'x'"):
            s.stays("x")
        if kern.numpy is not None:
            self.assertEqual(s.stays(kern.numpy.int64(2)), s.stays("top"))

    def test_plan_names(self):
        """A candidate may have the name of a block; an overlap that add()
        refuses is as deep as it is."""
        plan = Plan(two(0.2)[:2])
        for name in ("low", "top"):
            self.assertGreater(plan.try_stays(
                Block(name, BOX).move(0.2, 1)), 0.9)
        self.assertEqual([b.name for b in plan.blocks], ["ground", "low"])
        with self.assertRaises(kern.KernError) as caught:
            plan.add(Block("deep", BOX).move(0.01, 0.5))
        self.assertGreater(caught.exception.value, 0.4)
        self.assertEqual(caught.exception.blocks, ("low", "deep"))

    def test_one_label_is_a_word(self):
        """fixed="ground" is that label, not each that is in the word."""
        stones = page([ground(), Block("round", BOX)])
        s = kern.from_labelme(stones, fixed="ground")
        self.assertEqual([b.fixed for b in s.blocks], [True, False])

    def test_stale(self):
        """What has changed is not answered for; a refused update changes
        nothing, and update() again answers."""
        s = Structure(two(0.2))
        before = s.measure().margin
        s.blocks[2].move(0, -0.5)
        with self.assertRaises(kern.KernError):
            s.update()
        for ask in (s.verdict, s.measure, s.bearing, s.profile, s.critical,
                    s.sensitivity, s.svg, s.deficit, s.forces, s.raised,
                    s.let_go):
            self.refuse(Status.STALE, ("top",), ask)
        s.blocks[2].move(0, 0.5)
        self.assertAlmostEqual(s.measure().margin, before)
        del s.blocks[2]
        self.refuse(Status.STALE, (), s.profile)
        s.update()
        self.assertEqual(len(s.profile().values), 2)
        s.options.mu = 0.1
        self.refuse(Status.STALE, (), s.verdict)
        s.update()
        s.gravity = (0, -1)
        self.refuse(Status.STALE, (), s.verdict)

    def test_plan_keeps_its_blocks(self):
        plan = Plan(two(0.2))
        margin = plan.measure().margin
        with self.assertRaises((ValueError, TypeError)):
            plan.blocks[2].vertices[0, 1] -= 0.4
        with self.assertRaises(TypeError):
            plan.blocks[2].move(0, -0.4)
        with self.assertRaises(TypeError):
            plan.blocks[2].mass = 3
        plan.blocks.pop()
        self.refuse(Status.STALE, (), plan.profile)
        plan.update()
        self.assertEqual(plan.measure().margin, 0.5)
        plan.options.mu = -1.0
        with self.assertRaises(kern.KernError):
            plan.update()
        plan.options.mu = 0.4
        self.assertEqual((len(plan), plan.measure().margin), (2, 0.5))
        self.assertAlmostEqual(margin, 0.3)

    def test_misuse(self):
        """Thousands of random calls, updates and changes that nobody told:
        an answer or an exception of Python. Under a sanitizer every read and
        write is watched."""
        draw, answers = random.Random(3), 0
        refused = (ValueError, TypeError, IndexError, KeyError)
        for _ in range(60):
            s = (Structure if draw.random() < 0.5 else Plan)(
                two(0.2) + [Block("b%d" % i, BOX).move(i - 1, 2 + i % 2)
                            for i in range(draw.randint(0, 5))])
            extra = Block("extra", BOX)
            asks = [getattr(s, name) for name in (
                "verdict", "measure", "bearing", "deficit", "profile",
                "critical", "sensitivity", "raised", "forces", "let_go", "update",
                "update", "certain")]
            asks += [lambda: s.blocks[draw.randrange(9)].move(
                         draw.choice((0.1, 0, math.nan)), -0.1),
                     lambda: s.blocks.pop(draw.randrange(9)),
                     lambda: s.blocks.append(extra),
                     lambda: setattr(s.blocks[1], "vertices", BOX[:3]),
                     lambda: s.touch(draw.randrange(-9, 9)),
                     lambda: s.check_forces([(1, 0)] * draw.randrange(20)),
                     lambda: s.load_factor(draw.choice((-1, 1, 7))),
                     lambda: s.check_motion([(0, 1, 0)] * draw.randrange(9)),
                     lambda: setattr(s.options, "mu", draw.choice((.4, -1)))]
            if isinstance(s, Plan):
                asks += [lambda: s.add(extra), lambda: s.remove("extra"),
                         lambda: s.try_(extra.move(0.3, 0.4)),
                         lambda: s.bears(extra, 0.1),
                         lambda: s.try_raised(extra, True),
                         lambda: s.remove(draw.randrange(-9, 9))]
            for _ in range(60):
                try:
                    draw.choice(asks)()
                    answers += 1
                except refused:
                    pass
        self.assertGreater(answers, 500)

    def test_lengths(self):
        """Rows that C would read beyond their end are refused."""
        s = Structure(two(0.2))
        for ask in (lambda: s.check_forces([(1, 0)]),
                    lambda: s.check_motion([(0, -1, 0)]),
                    lambda: s.load_factor(0, 0, [(0, 0, 0)] * 2),
                    lambda: s.critical(Structure([*two(0.1), Block(
                        "c", BOX).move(0.3, 2)]).measure())):
            with self.assertRaises(ValueError):
                ask()
        for limit in (-1, 2 ** 31, 2 ** 40):
            self.refuse(Status.BAD_OPTION, (), lambda: Structure(
                two(0), options=Options(limit=limit)))
        with self.assertRaises(IndexError):
            s.touch(99)

    def test_limit(self):
        """What is proven by then is in the exception."""
        s = kern.read(ROOT / "examples" / "structures" / "arch.kern")
        s.options.limit = 20
        s.update()
        with self.assertRaises(kern.KernError) as caught:
            s.measure()
        self.assertEqual(caught.exception.status, Status.LIMIT)
        self.assertLessEqual(caught.exception.margin.holds,
                             caught.exception.margin.fails)

    def test_depth(self):
        deep = two(0)
        deep[2].move(0, -0.25)
        with self.assertRaises(kern.KernError) as caught:
            Structure(deep)
        self.assertGreater(caught.exception.value, 0.001)

    def test_text(self):
        with self.assertRaisesRegex(ValueError, "^x:2: block"):
            kern.parse("friction 0.4\nblock a * 0 0 1 0\n", "x")


def drawing(blocks, unit=6, layer=lambda b: "ground" if b.fixed else "0"):
    """The outlines of blocks as a drawing."""
    out = ["0", "SECTION", "2", "HEADER", "9", "$INSUNITS", "70", str(unit),
           "0", "ENDSEC", "0", "SECTION", "2", "ENTITIES"]
    for b in blocks:
        points = b.vertices.tolist()
        out += ["0", "LWPOLYLINE", "8", layer(b), "90", str(len(points)), "70",
                "1"]
        for x, y in points:
            out += ["10", repr(x), "20", repr(y)]
    return "\n".join([*out, "0", "ENDSEC", "0", "EOF", ""])


def page(blocks, scale=100.0, height=4000.0):
    """The outlines of blocks as a page of LabelMe."""
    return {"imageHeight": height, "shapes": [
        {"label": "ground" if b.fixed else b.name, "shape_type": "polygon",
         "points": [[2000 + scale * x, height - 500 - scale * y]
                    for x, y in b.vertices.tolist()]} for b in blocks]}


def groups(*pairs):
    """Groups of a drawing: codes and values in turn."""
    return "".join("%s\n%s\n" % (code, value) for code, value in zip(
        pairs[::2], pairs[1::2]))


def section(name, text):
    return "0\nSECTION\n2\n%s\n%s0\nENDSEC\n" % (name, text)


def lwpolyline(layer, points, *more):
    """A closed polyline of points (x, y) or (x, y, bulge)."""
    return groups(0, "LWPOLYLINE", 5, "2F", 100, "AcDbEntity", 8, layer, 100,
                  "AcDbPolyline", 90, len(points), 70, 1, *more) + "".join(
        groups(10, p[0], 20, p[1], *([42, p[2]] if len(p) > 2 else []))
        for p in points)


def old_polyline(layer, points, *more):
    """The same as of release 12."""
    return groups(0, "POLYLINE", 8, layer, 66, 1, 10, 0, 20, 0, 30, 0, 70, 1,
                  *more) + "".join(
        groups(0, "VERTEX", 8, layer, 10, p[0], 20, p[1], 30, 0,
               *([42, p[2]] if len(p) > 2 else [])) for p in points) + groups(
        0, "SEQEND", 8, layer)


def line(layer, p, q):
    return groups(0, "LINE", 8, layer, 10, p[0], 20, p[1], 30, 0, 11, q[0], 21,
                  q[1], 31, 0)


class Bridge:
    """A segmental ring of 8 m, 2.5 m high, of 21 stones of .6 m between two
    abutments, as people draw it: in mm."""
    SPAN, RISE, THICK, STONES = 8000., 2500., 600., 21
    RADIUS = (SPAN ** 2 / 4 + RISE ** 2) / (2 * RISE)
    HALF, DOWN = math.asin(SPAN / 2 / RADIUS), RISE - RADIUS

    def at(self, radius, k):
        angle = -self.HALF + 2 * self.HALF * k / self.STONES
        return (radius * math.sin(angle), self.DOWN + radius * math.cos(angle))

    def stone(self, k, bulge=0.0):
        r, t = self.RADIUS, self.RADIUS + self.THICK
        a, b, c, d = (self.at(r, k), self.at(t, k), self.at(t, k + 1),
                      self.at(r, k + 1))
        return [a, b, c, d] if not bulge else [
            (*a, 0), (*b, -bulge), (*c, 0), (*d, bulge)]

    def abutments(self, layer="ABUTMENT", make=lwpolyline):
        out = ""
        for side, k in ((-1, 0), (1, self.STONES)):
            x, y = self.at(self.RADIUS + self.THICK, k)
            i = self.at(self.RADIUS, k)
            out += make(layer, [i, (x, y), (side * 7000, y),
                                (side * 7000, -2000), (i[0], -2000)])
        return out

    def arcs(self):
        """Two arcs and the joints between them."""
        out, degrees = "", math.degrees(self.HALF)
        for r in (self.RADIUS, self.RADIUS + self.THICK):
            out += groups(0, "ARC", 8, "RING", 10, 0, 20, self.DOWN, 40, r, 50,
                          90 - degrees, 51, 90 + degrees)
        for k in range(self.STONES + 1):
            out += line("JOINTS", self.at(self.RADIUS, k),
                        self.at(self.RADIUS + self.THICK, k))
        return out

    def inserted(self):
        """One stone as a block, turned into its places; those of the left half
        are mirrored, and all lie in a block that is twice as large."""
        angle = math.degrees(self.HALF) / self.STONES
        r, t = self.RADIUS, self.RADIUS + self.THICK
        c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
        stone = [(r * c - 7, r * s), (t * c - 7, t * s), (t * c - 7, -t * s),
                 (r * c - 7, -r * s)]
        inner = "".join(groups(
            0, "INSERT", 8, "VOUSSOIRS", 2, "STONE", 10, 0, 20, 0,
            41, -.5 if k < 9 else .5, 42, .5, 50,
            (180 if k < 9 else 0) + 90 + angle * (20 - 2 * k) * (
                1)) for k in range(self.STONES))
        return (groups(0, "BLOCK", 2, "STONE", 70, 0, 10, -7, 20, 0)
                + lwpolyline("0", stone) + groups(0, "ENDBLK")
                + groups(0, "BLOCK", 2, "RING", 70, 0, 10, 50, 20, 60)
                + inner + groups(0, "ENDBLK"),
                groups(0, "INSERT", 8, "0", 2, "RING", 10, 100, 20,
                       self.DOWN + 120, 41, 2, 42, 2))


CLUTTER = (
    groups(0, "TEXT", 8, "TEXT", 10, 0, 20, -2500, 40, 200, 1, "Section A-A")
    + groups(0, "MTEXT", 8, "0", 10, 0, 20, 0, 1, "x") + groups(
        0, "DIMENSION", 8, "0", 2, "*D1", 10, 0, 20, 0, 70, 32)
    + line("CENTRE", (0, -3000), (0, 5000)) + lwpolyline("FRAME", [
        (-9000, -3500), (9000, -3500), (9000, 6000), (-9000, 6000)])
    + groups(0, "HATCH", 8, "HATCH", 10, 0, 20, 0, 30, 0, 2, "ANSI31")
    + groups(0, "VIEWPORT", 8, "0", 67, 1, 10, 0, 20, 0)
    + groups(0, "TEXT", 8, "0", 67, 1, 1, "in paper space")
    + line("0", (100, 100), (900, 120)) + lwpolyline(
        "STONES", [(0, 0), (9, 0), (9, 9)], 67, 1)
    + groups(0, "POINT", 8, "0", 10, 0, 20, 0))


def sheet(entities, blocks="", tables="", head="AC1032", end="\n"):
    """A drawing in mm."""
    text = section("HEADER", groups(9, "$ACADVER", 1, head, 9, "$INSUNITS", 70,
                                    4))
    text += section("CLASSES", "") + section("TABLES", tables)
    text += section("BLOCKS", blocks) + section("ENTITIES", entities)
    return (groups(999, "made by a test") + text + section("OBJECTS", "")
            + "0\nEOF\n").replace("\n", end)


class Drawings(unittest.TestCase):
    def margin(self, text, suffix=".dxf", **scale):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "s" + suffix)
            path.write_text(text)
            return kern.read(path, **scale)

    def test_same_margin(self):
        """A drawing of every example has its margin, whatever its unit."""
        for path in PLAIN:
            s = Structure([Block(b.name, b.vertices, fixed=b.fixed)
                           for b in kern.read(path).blocks])
            want = s.measure()
            for unit, metre in ((6, 1), (4, 0.001), (1, 0.0254)):
                got = self.margin(drawing(s.blocks, unit))
                m = got.measure()
                self.assertEqual((m.stands, len(got)), (want.stands, len(s)))
                if m.stands:
                    self.assertAlmostEqual(m.margin / metre, want.margin, 8)

    def test_lowest_and_old_form(self):
        """Without layers the lowest block is fixed; POLYLINE with VERTEX."""
        s = self.margin(drawing(two(0.2), layer=lambda b: "0"))
        self.assertEqual([b.fixed for b in s.blocks], [True, False, False])
        old = ("0\nSECTION\n2\nENTITIES\n"
               + "".join("0\nPOLYLINE\n8\nFIXED\n70\n1\n10\n0\n20\n0\n" + "".join(
                   "0\nVERTEX\n8\n0\n10\n%r\n20\n%r\n" % (x + dx, y + dy)
                   for x, y in BOX) + "0\nSEQEND\n"
                   for dx, dy in ((0, 0), (0.25, 1)))
               + "0\nENDSEC\n0\nEOF\n").replace("FIXED", "0", 2)
        self.assertAlmostEqual(self.margin(old).measure().margin, 0.25)

    def test_skipped_by_name(self):
        """What is no block is listed with its layer, line and count."""
        good = drawing([*two(0), Block("over", BOX).move(0, 2)])
        end = good.rindex("LWPOLYLINE")
        head, tail = good[:end], good[end:]
        last = head.count("\n") + 1
        for text, kind in (("INSERT", "undefined INSERT"),
                           ("SPLINE", "SPLINE"), ("MTEXT", "MTEXT"),
                           ("3DSOLID", "3DSOLID")):
            s = self.margin(head + text + tail[10:])
            self.assertEqual(s.skipped, [(kind, "0", last, 1)])
            self.assertEqual(len(s), 3)
        for old, new, kind in (("\n70\n1\n", "\n70\n0\n", "LWPOLYLINE"),
                               ("\n70\n1\n", "\n70\n1\n60\n1\n",
                                "invisible LWPOLYLINE"),
                               ("\n70\n1\n", "\n70\n1\n210\n0.6\n230\n.8\n",
                                "tilted LWPOLYLINE")):
            s = self.margin(head + tail.replace(old, new, 1))
            self.assertEqual(s.skipped, [(kind, "0", last, 1)])
        s = self.margin(head + tail.replace("\n70\n1\n",
                                            "\n70\n1\n67\n1\n", 1))
        self.assertEqual((s.skipped, len(s)), ([], 3))

    def test_refused_by_name(self):
        good = drawing(two(0))
        s = self.margin(good.replace("$INSUNITS\n70\n6", "$INSUNITS\n70\n77"))
        self.assertEqual((s.units, s.notes[0][:15]), (None, "$INSUNITS is 77"))
        for bad, word in (
                (good.replace("LWPOLYLINE", "MTEXT"),
                 "no closed outline: 0 lines, 3 texts skipped"),
                (good.replace("\n70\n1\n", "\n70\n0\n"),
                 "no closed outline: 3 lines, 0 texts skipped"),
                (good.replace("0\nEOF\n", ""), "without EOF"),
                (good.replace("\n10\n", "\n10\nx", 1), "number is expected"),
                ("AutoCAD Binary DXF\r\n\x1a" + good, "binary"),
                ("hello", "group code"), ("", "without EOF")):
            with self.assertRaisesRegex(ValueError, word):
                self.margin(bad)

    def test_lines(self):
        """Errors have the line of the drawing where their block begins."""
        deep = two(0)
        deep[2].move(0, -0.25)
        for blocks, at, words in ((deep, 2, "'b_2' and 'b_3' overlap, 0.25 "),
                                  (two(0)[:1], 0, "no block is free")):
            text = drawing(blocks)
            line = [i for i, word in enumerate(text.split("\n"), 1)
                    if word == "LWPOLYLINE"][at]
            with tempfile.TemporaryDirectory() as folder:
                path = pathlib.Path(folder, "s.dxf")
                path.write_text(text)
                run = subprocess.run(
                    [PROGRAM, str(path)], stdout=subprocess.PIPE,
                    stderr=subprocess.PIPE, universal_newlines=True)
                self.assertIn("s.dxf:%d: %s" % (line, words), run.stderr)
                with self.assertRaisesRegex(ValueError, "s.dxf:"):
                    kern.read(path)
                if blocks is not deep:  # an overlap is no fault of the reader
                    with self.assertRaisesRegex(ValueError, "s.dxf:%d: %s" % (
                            line, words)):
                        kern.read(path)

    def test_bridges(self):
        """As arcs and lines, bulges, straight polylines of two releases, or
        blocks that are inserted, turned and mirrored: the ring has its load
        factor, whatever is drawn around it."""
        b, bulge = Bridge(), math.tan(2 * Bridge.HALF / Bridge.STONES / 4)
        straight = [b.stone(k) for k in range(b.STONES)]
        blocks, ring = b.inserted()
        skew = b.at(b.RADIUS + b.THICK, 0)
        low = [(4000, 0), (-skew[0], skew[1]), (7000, skew[1]), (7000, -2000),
               (4000, -2000)]
        want = Structure([Block("v%d" % k, [(x / 1e3, y / 1e3) for x, y in p])
                          for k, p in enumerate(straight)] + [
            Block("g%d" % side, [(side * x / 1e3, y / 1e3) for x, y in low],
                  fixed=True) for side in (-1, 1)])
        factor = float(want.load_factor(kern.RIGHT))
        self.assertAlmostEqual(factor, 0.5462, 3)
        for name, text in (
                ("arcs", sheet(b.arcs() + b.abutments() + CLUTTER)),
                ("bulges", sheet("".join(
                    lwpolyline("VOUSSOIRS", b.stone(k, bulge))
                    for k in range(b.STONES)) + b.abutments() + CLUTTER)),
                ("straight", sheet(CLUTTER + b.abutments("Widerlager 2") + "".join(
                    lwpolyline("VOUSSOIRS", p) for p in straight))),
                ("old", sheet(b.abutments("GROUND", old_polyline) + "".join(
                    old_polyline("0", p) for p in straight) + CLUTTER,
                    head="AC1009", end="\r\n")),
                ("old bulges", sheet(b.abutments("Fixed", old_polyline)
                                     + "".join(old_polyline("0", b.stone(
                                         k, bulge)) for k in range(b.STONES)))),
                ("inserted", sheet(ring + b.abutments() + CLUTTER, blocks)),
                ("from below", sheet(b.abutments() + "".join(
                    lwpolyline("V", [(-x, y) for x, y in p], 210, 0, 220, 0,
                               230, -1) for p in straight)))):
            s = self.margin(text)
            self.assertEqual((len(s), s.units), (23, "m"), name)
            self.assertEqual(sum(c.fixed for c in s.blocks), 2, name)
            self.assertAlmostEqual(float(s.load_factor(kern.RIGHT)), factor,
                                   delta=0.002, msg=name)
            rows = {row[:2]: row[3] for row in s.skipped}
            if name in ("arcs", "bulges", "straight", "old", "inserted"):
                self.assertEqual(rows, {
                    ("TEXT", "TEXT"): 1, ("MTEXT", "0"): 1, ("HATCH", "HATCH"): 1,
                    ("DIMENSION", "0"): 1, ("LINE", "CENTRE"): 1,
                    ("LWPOLYLINE", "FRAME"): 1, ("LINE", "0"): 1,
                    ("POINT", "0"): 1}, name)
            else:
                self.assertEqual(rows, {}, name)

    def test_fill(self):
        """Fill is weight on the ring, not a stone; all of it is somewhere."""
        b = Bridge()
        top = b.RISE + b.THICK + 400
        crown = [b.at(b.RADIUS + b.THICK, k) for k in range(b.STONES + 1)]
        fill = [*crown, (7000, crown[-1][1]), (7000, top), (-7000, top),
                (-7000, crown[0][1])]
        ring = "".join(lwpolyline("VOUSSOIRS", b.stone(k))
                       for k in range(b.STONES)) + b.abutments()
        bare = self.margin(sheet(ring))
        with self.assertWarnsRegex(kern.DrawingWarning, "is no stone"):
            s = self.margin(sheet(ring + lwpolyline("Backfill", fill)))
        self.assertEqual(len(s), 23)
        weight = sum(c.body().mass for c in s.blocks if not c.fixed)
        stones = sum(c.body().mass for c in bare.blocks if not c.fixed)
        x, y = zip(*fill)
        area = abs(sum(x[i] * y[i - 1] - x[i - 1] * y[i]
                       for i in range(len(fill)))) / 2e6
        aside = 2 * (7 - crown[-1][0] / 1e3) * (top - crown[0][1]) / 1e3
        self.assertAlmostEqual(weight - stones, area - aside, 9)
        self.assertLess(s.load_factor(kern.RIGHT), bare.load_factor(kern.RIGHT))
        with self.assertWarnsRegex(kern.DrawingWarning, "looks like soil"):
            t = self.margin(sheet(ring + lwpolyline("0", fill)))
        self.assertEqual(len(t), 24)
        t = self.margin(sheet(ring + lwpolyline("0", fill)),
                        layers={"0": "fill"}, density={"": 2, "0": 1})
        self.assertAlmostEqual(sum(c.body().mass for c in t.blocks
                                   if not c.fixed), 2 * stones + area - aside, 9)
        t = self.margin(sheet(ring + lwpolyline("0", fill)),
                        layers={"0": "ignore"})
        self.assertEqual(len(t), 23)

    def test_ground(self):
        """Without a label of ground the lowest row, or a line, is ground; what
        lies below the line is cut, and what hangs in the air is named."""
        rows = [Block("s%d%d" % (i, j), BOX).move(i * 1.001, j)
                for i in range(3) for j in range(2)]
        rows += [Block("high", BOX).move(0, 9)]
        photo = page(rows)
        with self.assertWarnsRegex(kern.DrawingWarning, "hangs in the air: high"):
            s = kern.from_labelme(photo, pixel=.01)
        self.assertEqual([b.fixed for b in s.blocks],
                         [True, False] * 3 + [False])
        self.assertIn("the lowest row is fixed, s00, s10 and s20", s.notes[0])
        y = photo["imageHeight"] - 500 - 50
        s = kern.from_labelme(photo, pixel=.01, ground=y)
        fixed = [b for b in s.blocks if b.fixed]
        self.assertEqual([b.name for b in fixed], ["ground"])
        self.assertAlmostEqual(min(y for b in s.blocks if not b.fixed
                                   for _, y in b.vertices.tolist()), 5.5)
        self.assertIn("3 outlines are cut there", s.notes[0])
        self.assertFalse(s.verdict())

    def test_roles(self):
        """The last word with a role decides, in any case and some languages;
        the user's word is stronger."""
        def role(label, **what):
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                s = self.margin(sheet(lwpolyline("GROUND", [
                    (0, -9), (90, -9), (90, 0), (0, 0)]) + lwpolyline(
                    "stones", [(0, 0), (9, 0), (9, 9), (0, 9)]) + lwpolyline(
                    label, [(20, 0), (29, 0), (29, 9), (20, 9)])), **what)
            if len(s) == 3:
                return "ground" if s.blocks[2].fixed else "stone"
            return "ignore" if s.skipped else "fill"
        for label, want in (
                ("Abutment", "ground"), ("WIDERLAGER 2", "ground"),
                ("A-Footing_01", "ground"), ("AbutmentLeft", "ground"),
                ("base stones", "stone"), ("centre pier", "stone"),
                ("rock", "stone"), ("playground", "stone"), ("fill", "fill"),
                ("stone fill", "fill"), ("Soil-1", "fill"),
                ("Hinterf\u00fcllung", "fill"), ("HINTERF\u00dcLLUNG", "fill"),
                ("RAHMEN", "ignore"), ("A-ANNO-DIMS", "ignore"),
                ("centre", "ignore"), ("scale 10 cm", "ignore")):
            self.assertEqual(role(label), want, label)
        self.assertEqual(role("fill", layers={"FILL": "stone"}), "stone")
        self.assertEqual(role("x", layers={"X": "ground"}), "ground")
        with self.assertRaisesRegex(ValueError, "roles ground, stone, fill"):
            role("x", layers={"x": "wall"})
        s = self.margin(drawing(two(0)), layers={"y": "ground"})
        self.assertIn("no label is y, which the user gives a role", s.notes)

    def test_stones_of_photographs(self):
        """Groups, parts, masks, holes, crossings, circles, other shapes."""
        box = lambda x, y, w, h: [[x, y], [x + w, y], [x + w, y + h], [x, y + h]]
        def shape(label, points, kind="polygon", group=None):
            return {"label": label, "points": points, "shape_type": kind,
                    "group_id": group}
        ground = shape("Ground", box(0, 400, 600, 50))
        s = kern.from_labelme({"imageHeight": 450, "shapes": [
            ground, shape("stone", box(100, 300, 40, 100), group=3),
            shape("stone", box(142, 300, 58, 100), group=3),
            shape("stone", box(300, 300, 50, 100), group=4),
            shape("bar", [[0, 10], [100, 10]], "line"), shape("p", [[1, 2]],
                                                             "point"),
            shape("tie", [[400, 300], [500, 400], [500, 300], [400, 400]]),
            shape("disc", [[60, 370], [60, 400]], "circle"),
            shape("four", box(200.5, 300, 50, 100), "rectangle"),
            shape("none", None), None, shape("mask", [[0, 0], [5, 5]], "mask")]})
        self.assertEqual([b.name for b in s.blocks], [
            "Ground", "stone", "stone_2", "tie", "disc", "four"])
        self.assertEqual([round(abs(b.body().area)) for b in s.blocks][1:4],
                         [10000, 5000, 10000])
        self.assertEqual({row[0]: row[1] for row in s.skipped}, {
            "line": "bar", "point": "p", "shape without its points": "none",
            "shape that is none": "", "mask without its PNG": "mask"})
        width, height, rows = 60, 50, [[0] * 60 for _ in range(50)]
        for y in range(10, 40):
            for x in range(5, 55):
                rows[y][x] = 0 if 20 <= x < 30 and 20 <= y < 30 else 1
        rows[2][2] = 1
        flat, counts, last = [rows[y][x] for x in range(width)
                              for y in range(height)], [0], 0
        for value in flat:
            if value == last:
                counts[-1] += 1
            else:
                counts.append(1)
                last = value
        word, runs = "", []
        for i, run in enumerate(counts):
            x, more = run - (counts[i - 2] if i > 2 else 0), True
            while more:
                c, x = x & 31, x >> 5
                more = x != -1 if c & 16 else x != 0
                word += chr(48 + (c | (32 if more else 0)))
        for runs in (counts, word):
            t = kern.from_coco({"images": [{"id": 1, "height": 50}],
                                "categories": [{"id": 7, "name": "ground"}],
                                "annotations": [
                {"image_id": 1, "iscrowd": 0, "segmentation": {
                    "size": [height, width], "counts": runs}},
                {"image_id": 1, "category_id": 7, "segmentation": [
                    [0, 40, 60, 40, 60, 50, 0, 50]]},
                {"image_id": 1, "iscrowd": 1, "segmentation": {
                    "size": [5, 5], "counts": [25]}}]})
            self.assertEqual([(b.name, round(b.body().area)) for b in t.blocks],
                             [("stone", 1500), ("ground", 600)])
            self.assertEqual([row[0] for row in t.skipped],
                             ["hole", "speck of a mask", "crowd"])
            self.assertTrue(t.verdict())

    def test_several_images(self):
        """One is named; without a name it is said how."""
        def coco(images):
            return {"images": [{"id": i, "height": 100, "file_name": "%d.jpg" % i}
                               for i in images], "annotations": [
                {"image_id": i, "segmentation": [[0, y, 60, y, 60, y + 30, 0,
                                                  y + 30]]}
                for i in images for y in (i, i + 30)]}
        with self.assertRaisesRegex(ValueError, "2 images: one must be named, "
                                    "for example --image 3"):
            kern.from_coco(coco((3, 4)))
        for image in (4, "4", "4.jpg"):
            self.assertEqual(len(kern.from_coco(coco((3, 4)), image=image)), 2)
        no_list = coco((3, 4))
        del no_list["images"]
        with self.assertRaisesRegex(ValueError, "several images: one must be"):
            kern.from_coco(no_list)
        with self.assertRaisesRegex(ValueError, "no image is 'x'"):
            kern.from_coco(coco((3, 4)), image="x")
        region = lambda y: {"shape_attributes": {
            "name": "polygon", "all_points_x": [0, 60, 60, 0],
            "all_points_y": [y, y, y + 30, y + 30]},
            "region_attributes": {"kind": "stone" if y < 60 else "ground"}}
        via = {"a.jpg1": {"filename": "a.jpg", "regions": [region(30),
                                                          region(60)]}}
        for pages in (via, {"_via_img_metadata": via}, {"a": {
                "regions": {"0": region(30), "1": region(60)}}}):
            s = self.margin(json.dumps(pages), ".json")
            self.assertEqual([(b.name, b.fixed) for b in s.blocks],
                             [("stone", False), ("ground", True)])
        for bad, words in (("{", "the file ends"), ("[" * 200, "100 lists"),
                           ('{"shapes": [1, ]}', "a value is expected"),
                           ('{"a": NaN}', "read 'NaN'"), ("{}", "neither LabelMe"),
                           ("", "a value is expected")):
            with self.assertRaisesRegex(ValueError, words):
                self.margin(bad, ".json")

    def test_svg(self):
        """Groups, transforms, paths and curves; what is hidden is listed."""
        s = self.margin("""<?xml version="1.0"?><!-- <rect/> -->
<svg xmlns="x"><defs><rect id="d" width="9" height="9"/></defs>
<g id="ground" transform="translate(0 10)"><rect x="-9" width="30" height="2"/>
</g><g transform="matrix(1 0 0 1 0 8)"><path id="low" d="M0 2h4v-2h-4z"/></g>
<path id="top" d="m0,8 4,0 0-2 c0-3-4-3-4,0 z"/><text x="3">a > b</text>
<polygon points="6,10 8,10 8,8 6,8" style="display:none"/>
<g transform="rotate(90 10 9) scale(.5)"><rect x="18" y="16" width="4"
height="4"/></g></svg>""", ".svg")
        self.assertEqual([b.name for b in s.blocks],
                         ["ground_1", "low_2", "top_3", "rect_4"])
        self.assertEqual(s.skipped, [("text", "text", 5, 1), (
            "invisible element", "polygon", 6, 1)])
        self.assertAlmostEqual(abs(s.blocks[2].body().area),
                               8 + 7.2, 1)
        self.assertAlmostEqual(abs(s.blocks[3].body().area), 4, 9)
        self.assertAlmostEqual(s.blocks[3].body().centre[1], -9, 9)

    def test_program_reads_the_same(self):
        """The program writes (--kern) what Python reads: names and places, to
        the last digit; and its JSON lists the same as skipped."""
        b = Bridge()
        files = (("b.dxf", sheet(b.arcs() + b.abutments() + CLUTTER)),
                 ("i.dxf", sheet(b.inserted()[1] + b.abutments(),
                                 b.inserted()[0])),
                 ("p.json", json.dumps(page(two(0.2)))),
                 ("s.svg", '<svg><g id="base"><rect y="1" width="9" height="1"/>'
                  '</g><path d="M1 1V0A2 2 0 0 1 3 0V1z"/></svg>'))
        with tempfile.TemporaryDirectory() as folder:
            for name, text in files:
                path = pathlib.Path(folder, name)
                path.write_text(text)
                made = path.with_suffix(".kern")
                run = subprocess.run(
                    [PROGRAM, "--json", "--verdict", "--kern", str(made),
                     str(path)], stdout=subprocess.PIPE, universal_newlines=True)
                told, s, t = (json.loads(run.stdout), kern.read(path),
                              kern.read(made))
                self.assertEqual([c.name for c in s.blocks],
                                 [c.name for c in t.blocks])
                for c, d in zip(s.blocks, t.blocks):
                    self.assertEqual((c.vertices.tolist(), c.fixed, c.body()),
                                     (d.vertices.tolist(), d.fixed, d.body()))
                self.assertEqual(s.options, t.options)
                self.assertEqual([tuple(row[key] for key in (
                    "kind", "name", "line", "count"))
                    for row in told["skipped"]], s.skipped)
                self.assertEqual((told["notes"], told["units"]),
                                 (s.notes, s.units))

    def test_image(self):
        """Pixels, y down, become metres, y up, and a measured structure."""
        s = self.margin(json.dumps(page(two(0.2))), ".json", pixel=0.01)
        self.assertAlmostEqual(s.measure().margin, 0.3, 1)
        self.assertEqual(s.options.pose_error, 0.01 * math.hypot(1, 1.5))
        coco = {"images": [{"id": 3, "height": 4000}],
                "categories": [{"id": 1, "name": "stone"},
                               {"id": 2, "name": "ground"}],
                "annotations": [
                    {"id": i, "image_id": 3, "category_id": 1 + (i == 0),
                     "segmentation": [[n for q in shape["points"] for n in q]]}
                    for i, shape in enumerate(page(two(0.2))["shapes"])]}
        t = self.margin(json.dumps(coco), ".json", pixel=0.01)
        self.assertEqual(t.measure().margin, s.measure().margin)
        coco["annotations"][1]["segmentation"] = {"counts": "x"}
        with self.assertWarnsRegex(kern.DrawingWarning, "hangs in the air"):
            t = kern.from_coco(coco)
        self.assertEqual(t.skipped, [("mask that is none", "stone", 1, 1)])

    def test_fuzzed(self):
        """A message or an answer, 2,000 times of each kind."""
        warnings.simplefilter("ignore", kern.DrawingWarning)
        draw = random.Random(7)
        drawn = '<svg><g id="base"><rect y="2" width="9" height="1"/></g>' + (
            "".join('<path d="M%d 0h1v1h-1z"/>' % x for x in range(9))) + "</svg>"
        texts = drawing(two(0.2)), json.dumps(page(two(0.2))), drawn
        for text, suffix in zip(texts, (".dxf", ".json", ".svg")):
            answers = 0
            for _ in range(2000):
                data = list(text)
                for _ in range(draw.randint(1, 3)):
                    i = draw.randrange(len(data))
                    j = min(len(data), i + draw.choice((0, 1, 1, 5, 40)))
                    data[i:j] = draw.choice(("", "\n", "0", "9", "-", "1e300",
                                             "\x00", "[", "}", "nan", "VERTEX"))
                try:
                    self.margin("".join(data), suffix).verdict()
                    answers += 1
                except ValueError:  # KernError too
                    pass
            self.assertGreater(answers, 100)


class Library(unittest.TestCase):
    def import_it(self, **environment):
        return subprocess.run(
            [sys.executable, "-S", "-c", "import kern"], cwd=MODULE,
            env={**os.environ, **environment}, stderr=subprocess.PIPE,
            universal_newlines=True)

    def test_built_once_or_named(self):
        with tempfile.TemporaryDirectory() as folder:
            fresh = {"XDG_CACHE_HOME": folder, "CC": "cc -g0"}
            self.assertEqual(self.import_it(**fresh).returncode, 0)
            made = list(pathlib.Path(folder, "kern").iterdir())
            self.assertEqual(len(made), 1)
            when = made[0].stat().st_mtime_ns
            self.assertEqual(self.import_it(**fresh).returncode, 0)
            self.assertEqual(made[0].stat().st_mtime_ns, when)
            self.assertEqual(self.import_it(
                KERN_LIBRARY=str(made[0]), CC="false").returncode, 0)

    def test_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            run = self.import_it(XDG_CACHE_HOME=folder, CC="false")
            self.assertIn("could not be compiled", run.stderr)
            library = folder + "/other.so"
            source = kern._source().replace("FIELD(kern_contact, n)", "0, 0,")
            for text, message in ((source, "kern_contact has another layout"),
                                  ("int x;", "was not built by kern.py")):
                subprocess.run(
                    ["cc", "-shared", "-fPIC", "-x", "c", "-", "-o", library,
                     "-I%s" % ROOT, "-lm"],
                    input=text.encode(), check=True)
                run = self.import_it(KERN_LIBRARY=library)
                self.assertIn(message, run.stderr)


def added():
    """Prints what Python adds to calls: less the same call with its arguments
    at hand and no result, plus the bare call of a C function by ctypes."""
    def best(call):
        return min(timeit.repeat(call, timer=time.process_time, number=300,
                                 repeat=40)) / 300 * 1e6

    s = kern.read(ROOT / "examples" / "structures" / "tower.kern")
    plan, b = Plan(s.blocks[:-1], s.options), s.blocks[-1]
    plan.measure()
    b._fill(plan._candidate)
    force, motion, m = s._forces(), s._motions(), kern._Margin()
    proof = kern.byref(kern._Proof(kern.addressof(force),
                                   kern.addressof(motion)))
    out, c = kern.byref(m), kern.byref(plan._candidate)
    bare = best(lambda: kern._status_text(0))
    for name, call, same in (
            ("verdict", s.verdict, lambda: kern._verdict(s._at_task, 0, proof)),
            ("measure", s.measure,
             lambda: kern._measure(s._at_task, out, proof)),
            ("try_", lambda: plan.try_(b),
             lambda: kern._plan_try(plan._at_plan, c, out, None)),
            ("bears", lambda: plan.bears(b, 0.01),
             lambda: kern._plan_bears(plan._at_plan, c, 0.01, None))):
        whole, less = best(call), best(same)
        print("%-8s %6.2f us, of these %.2f added" % (name, whole,
                                                      whole - less + bare))


if __name__ == "__main__":
    PROGRAM = str(pathlib.Path(sys.argv.pop(1)).resolve())
    if sys.argv[1:] == ["--time"]:
        added()
    else:
        unittest.main()
