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
                    self.assertEqual(s.deficit(), row["deficit"])
                for side, word in ((kern.LEFT, "left"), (kern.RIGHT, "right")):
                    self.assertEqual(finite(s.load_factor(side)),
                                     row["load_" + word])
                    self.assertEqual(finite(s.tilt(side)), row["tilt_" + word])
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
        """The example of the README runs, and draws its picture."""
        code = re.search(r"```python\n(.*?)```",
                         (ROOT / "README.md").read_text(), re.S).group(1)
        with tempfile.TemporaryDirectory() as folder:
            out = subprocess.run(
                [sys.executable, "-S", "-c", code], cwd=folder,
                env={**os.environ, "PYTHONPATH": str(MODULE)},
                stdout=subprocess.PIPE, check=True).stdout.decode()
            xml.dom.minidom.parse(os.path.join(folder, "mine.svg"))
        found = re.fullmatch(r"Verdict\(stands=True\) Margin\(stands=True, "
                             r"margin=(.*), level=16, saturated=False\) (.*)\n",
                             out)
        self.assertAlmostEqual(float(found.group(1)), 0.4, 6)
        self.assertAlmostEqual(float(found.group(2)), 0.388, 6)

    @staticmethod
    def shapes(text):
        """What is drawn above the caption."""
        return [line for line in text.splitlines() if "<text" not in line]

    def test_pictures(self):
        """They are those of the program, but for the caption."""
        for path in FILES:
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
        s = Structure(two(0)[:2], kern.contact_travels(made))
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
                ("no error was told", s.interval), ("no error was", s.certain),
                ("load_factor..: there is no gravity",
                 lambda: still.load_factor(kern.LEFT)),
                ("tilt..: there is no gravity", lambda: still.tilt(kern.LEFT)),
                ("reserve=True.: there is no gravity",
                 lambda: still.raised(reserve=True)),
                ("stays..: there is no gravity", lambda: still.stays("top")),
                ("no live load", s.live), ("'ground' is fixed", lambda: s.live(
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
                    s.sensitivity, s.svg, s.deficit, s.forces, s.raised):
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
                "critical", "sensitivity", "raised", "forces", "update",
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


class Drawings(unittest.TestCase):
    def margin(self, text, suffix=".dxf", **scale):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "s" + suffix)
            path.write_text(text)
            return kern.read(path, **scale)

    def test_same_margin(self):
        """A drawing of every example has its margin, whatever its unit."""
        for path in FILES:
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
                if blocks is not deep:  # an overlap is no fault of the reader
                    with self.assertRaisesRegex(ValueError, "s.dxf:%d: %s" % (
                            line, words)):
                        kern.read(path)

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
        texts = drawing(two(0.2)), json.dumps(page(two(0.2)))
        for text, suffix in zip(texts, (".dxf", ".json")):
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
