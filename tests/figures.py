"""python3 tests/figures.py    the figures of README.md are those of its pages

README has each figure that another page or a program gives once more, so a change
there must reach it. A row below is a pattern in README.md, where its numbers come
from, and a pattern there; the groups of both must be the same numbers, to the
digits that README has. Fails where they are not, or a pattern is not found.
"""

import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
BENCH, TRUST, PUBLISHED, REALITY = (
    "tests/%s.md" % name for name in ("BENCH", "TRUST", "PUBLISHED", "REALITY"))
STUDY = "examples/laboratory/STUDY.md"
N = r"([\d.,]+)"  # a number

ROWS = (
    # which number answers which question
    (r"either way; %s near-critical verdicts agree" % N, TRUST,
     r"`\./exact %s`: none wrong" % N),
    (r"on %s toppling slopes it says `stays` never below" % N, TRUST,
     r"\| %s slopes at 0\.9 and 0\.99 .* 0 of 720" % N),
    (r"and always at %s times the critical" % N, TRUST,
     r"the same at %s and 1\.1 \| said to stay \| 720 of 720" % N),
    (r"from a chance of %s keeps %s %% .* rejects %s %%" % (N, N, N), TRUST,
     r"\n\| (0\.5) \| %s \| %s \|" % (N, N)),
    (r"algorithm on all of %s structures" % N, TRUST,
     r"level on all %s structures" % N),
    (r"a noise of %s %% of the stone size the margin is above its lower bound in "
     r"%s %% of settled structures; of the verdicts %s %% of `stands` and %s %% of"
     % (N, N, N, N), TRUST,
     r"(?s)mean size \| 0\.2 % \| ([\d.]+) %.*?stands, and is certain \| 68 % \| "
     r"([\d.]+) %.*?falls, and is certain \| 99 % \| ([\d.]+) %.*?above the "
     r"lower end \| 94 % \| ([\d.]+) %"),
    (r"%s of the load at which .*? in the median of %s brick walls; from %s to "
     r"%s" % (N, N, N, N), TRUST,
     r"%s brick walls with openings, raised load .* \| median \| %s \|\n"
     r"\| the same \| all \| %s to %s \|" % (N, N, N, N)),
    (r"rank correlation with the level of collapse %s on %s structures \(0\.80 on [^)]*\); load "
     r"factor %s, margin %s" % (N, N, N, N), STUDY,
     r"(?s)near: expected drop \| %s .*?load factor \| (0\.45) .*?margin \| %s "
     r".*?\| %s structures of the" % (N, N, N)),
    (r"load was %s to %s of limit equilibrium on %s such rows" % (N, N, N),
     TRUST,
     r"%s rows of 20 to 90 columns, raised load / limit equilibrium \| at least "
     r"0\.97 \| 75 of 90 \|\n\| the same \| all \| %s to %s \|" % (N, N, N)),
    (r"`--raised`\) is below %s\. A" % N, TRUST, r"A reserve of %s g" % N),
    (r"on %s walls with both good .* stays in a simulator on "
     r"%s, the place of the highest margin on %s" % (N, N, N), TRUST,
     r"%s walls that offer places .*\n.*\n\| `kern_place_compare\(\)` \| %s \|\n"
     r"\| the highest margin \| %s \|" % (N, N, N)),
    (r"on random brick walls up to %s times" % N, "tests/DESIGN.md",
     r"random ones by up to %s times" % N),
    (r"topple in a row it was up to %s times" % N, TRUST,
     r"load factor of limit analysis / limit equilibrium \| most \| %s" % N),
    # beside one simulated run
    (r"one run of Box2D: of %s placements it keeps %s %% of what stays, kern %s"
     % (N, N, N), TRUST,
     r"\| %s that rock .* \| %s %% \| \|\n.*0\.5 \| %s %%" % (N, N, N)),
    (r"On %s placements Box2D v3 accepted %s %% of what stays and rejected %s %% "
     r"of what moves; an earlier version of kern %s %% and %s %%" % (N, N, N, N, N), TRUST,
     r"\| %s \| one run of Box2D v3 at 60 Hz \| %s %% \| %s %% \|\n.*data "
     r"\| %s %% \| %s %%" % (N, N, N, N, N)),
    (r"walls of (19) to (25) bricks kern .* in %s us, one run of Box2D in %s us"
     % (N, N), BENCH, r"\| (19)-(25) \| 72 (?:\|[^|]*){5}\| %s [^|]*\| %s " % (N, N)),
    (r"in the median %s for a verdict, %s for the margin, %s for the load factor "
     r"and %s for one more" % (N, N, N, N), BENCH,
     r"\| all \| 167 \| %s [^|]*\| %s [^|]*\| %s [^|]*\|[^|]*\| %s " % (N, N, N, N)),
    # how many
    (r"computes %s formulas" % N, "cc tests/published.c", r"\n%s results" % N),
    (r"reality\.c\) %s experiments" % N, "cc tests/reality.c", r"\n%s rows" % N),
    (r"%s structures, \d+ of them with known outcomes" % N, "tests/CORPUS.md",
     r"The corpus: %s structures" % N),
    # textbooks and experiments
    (r"Milankovitch 1907\) \| %s \| %s" % (N, N), PUBLISHED,
     r"Milankovitch 1907\) \| %s \| %s" % (N, N)),
    (r"157\.5 degrees: load factor \| %s \| %s" % (N, N), PUBLISHED,
     r"157\.5 deg, t/R 0\.15: load factor, four hinges \| %s \| %s" % (N, N)),
    (r"phi 30, delta 20: overturning \| %s \| %s" % (N, N), PUBLISHED,
     r"phi 30, delta 2/3 phi: against overturning \| %s \| %s" % (N, N)),
    (r"least friction, let go \| %s \| %s" % (N, N), PUBLISHED,
     r"least friction, let go \| %s \| %s" % (N, N)),
    (r"least push at its foot \| %s \| %s" % (N, N), PUBLISHED,
     r"least push at the foot that holds it \| %s \| %s" % (N, N)),
    (r"Prestwood bridge 1986, collapse \[kN\] \| %s \| %s" % (N, N), REALITY,
     r"Prestwood 1986 \| %s \| %s" % (N, N)),
    (r"Dundee model bridge \[kN\] \| %s \| %s" % (N, N), REALITY,
     r"Dundee model 1989 \| %s \| %s" % (N, N)),
    (r"no crushing: kern / test .* \| 1 \| %s," % N, REALITY,
     r"\| no crushing \| %s " % N),
    (r"from least to most \| 1 \| [\d.]+, %s to %s" % (N, N), REALITY,
     r"(?s)\| Strathmashie 1989 \|[^|]*\|[^|]*\| %s .*\| Bolton model 1990 "
     r"\|[^|]*\|[^|]*\| %s " % (N, N)),
    (r"5 MPa: kern / test in the mean \| 1 \| %s" % N, REALITY, r"\n\| 5 MPa \| %s " % N),
    (r"right verdicts .* \| %s \| %s" % (N, N), REALITY,
     r"Right in %s of %s\. C" % (N, N)),
    (r"height of fill \[ft\] \| %s \| %s" % (N, N), REALITY,
     r"brick in wet sand, fill \| %s \| %s" % (N, N)),
)


def text_of(source):
    """The text of a page, or what a program prints."""
    if not source.startswith("cc "):
        return (ROOT / source).read_text(encoding="utf-8")
    with tempfile.TemporaryDirectory() as folder:
        program = folder + "/program"
        subprocess.run(["cc", "-O2", "-ffp-contract=off", "-o", program,
                        source[3:], "-lm"], cwd=ROOT, check=True)
        return subprocess.run([program], cwd=ROOT, stdout=subprocess.PIPE,
                              check=True, universal_newlines=True).stdout


def words(found):
    """The numbers of a match as they are written, in order of size."""
    return sorted((word.replace(",", "").rstrip(".") for word in found.groups()
                   if word), key=float)


def same(mine, theirs):
    """Are these the same, to the digits of mine? A share may be in per cent."""
    return len(mine) == len(theirs) and all(
        any(abs(float(m) - scale * float(t)) <= 0.5000001 / 10 ** len(
            m.partition(".")[2]) for scale in (1, 100))
        for m, t in zip(mine, theirs))


def main():
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    flat, bad = re.sub(r"\n(?!\||\n) *", " ", readme), 0
    for mine, source, theirs in ROWS:
        here, there = re.search(mine, flat), re.search(theirs, text_of(source))
        if here and there and same(words(here), words(there)):
            continue
        bad += 1
        print("README.md, %s: %s\n    %s: %s" % (
            mine, here and words(here), source, there and words(there)))
    print("%d of %d figures of README.md are not those of their pages"
          % (bad, len(ROWS)))
    return bad > 0


if __name__ == "__main__":
    sys.exit(main())
