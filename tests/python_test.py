"""Tests of examples/python/kern.py; the first argument is the program kern.

    cc -O2 -ffp-contract=off -o kern examples/kern.c -lm
    python3 tests/python_test.py ./kern           with numpy, if there is one
    python3 -S tests/python_test.py ./kern        without
    python3 tests/python_test.py ./kern --time    what Python adds to a call
"""

import json
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time
import timeit
import unittest
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
                                 self.shapes(s._repr_svg_()))
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
        self.refuse(Status.OVERLAP, ("low", "top"),
                    lambda: Plan(two(0)[:2]).try_(deep[2]))
        self.refuse(Status.SAME_BLOCK, (),
                    lambda: kern.contact_make(1, 1, (0, 1), (0, 0)))

    def test_depth(self):
        deep = two(0)
        deep[2].move(0, -0.25)
        with self.assertRaises(kern.KernError) as caught:
            Structure(deep)
        self.assertGreater(caught.exception.value, 0.001)

    def test_text(self):
        with self.assertRaisesRegex(ValueError, "^x:2: block"):
            kern.parse("friction 0.4\nblock a * 0 0 1 0\n", "x")


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
