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
MANUAL = "kern.h"
N = r"([\d.,]+)"  # a number

ROWS = (
    # which number answers which question
    (r"We tested %s structures that almost fell or almost stood, with exact" % N, TRUST,
     r"`\./exact %s`: none wrong" % N),
    (r"On %s slopes with too little friction it never" % N, TRUST,
     r"\| %s slopes at 0\.9 and 0\.99 .* 0 of 720" % N),
    (r"threshold of %s kern accepts %s %% .* rejects %s %%" % (N, N, N), TRUST,
     r"\n\| (0\.5) \| %s \| %s \|" % (N, N)),
    (r"For all of %s structures their algorithm" % N, TRUST,
     r"level on all %s structures" % N),
    (r"errors of %s %% of a stone's size the exact margin was above this bound for "
     r"%s %% of" % (N, N), TRUST,
     r"(?s)mean size \| 0\.2 % \| ([\d.]+) %.*?above the "
     r"lower end \| 94 % \| ([\d.]+) %"),
    (r"On %s brick walls `load` was %s to %s times" % (N, N, N), TRUST,
     r"%s brick walls with openings, raised load .*\n"
     r"\| the same \| all \| %s to %s \|" % (N, N, N)),
    (r"correlation is %s, where 1 is perfect\. That of the margin is %s\." % (N, N),
     STUDY, r"(?s)\n\| margin \| [\d.]+ \| [^|]*\.\.(?:[^|]*\|){3} %s \|.*?"
     r"\n\| near: expected drop \| [\d.]+ \| [^|]*\.\.(?:[^|]*\|){3} %s \|"
     % (N, N)),
    (r"On %s walls kern's first choice stays in a simulator on %s, the place with the "
     r"highest margin on %s" % (N, N, N), TRUST,
     r"%s walls that offer places .*\n.*\n\| `kern_place_compare\(\)` \| %s \|\n"
     r"\| the highest margin \| %s \|" % (N, N, N)),
    # limits
    (r"up to %s %% less friction than they need\. It can be worse: .* with a "
     r"friction of %s and needs %s\." % (N, N, N), MANUAL,
     r"(?s)up\s+to\s+(31)\s+%% too\s+low\s.*?friction\s+of\s+(\.44)\s+where\s+%s" % N),
    (r"up to %s times too high on random brick" % N, "tests/DESIGN.md",
     r"random ones by up to %s times" % N),
    (r"up to %s times too high on %s rows of toppling" % (N, N), TRUST,
     r"(?s)\n\| %s rows of 20 to 90 columns, .*?load factor of limit analysis / "
     r"limit equilibrium \| most \| %s" % (N, N)),
    (r"and %s times on another row" % N, MANUAL,
     r"one\s+load\s+factor\s+was\s+(100)\s+times\s+too\s+high"),
    (r"On the %s rows `load` was %s to %s times the right" % (N, N, N), TRUST,
     r"%s rows of 20 to 90 columns, raised load / limit equilibrium \| at least "
     r"0\.97 \| 75 of 90 \|\n\| the same \| all \| %s to %s \|" % (N, N, N)),
    (r"accept %s %% of the single stones that moved" % N, TRUST,
     r"%s %% of the placements that move have forces" % N),
    (r"if the reserve is below %s g\." % N, TRUST, r"A reserve of %s g" % N),
    (r"In %s walls a longer stone .* with %s to %s times the load that kern allows\. %s of"
     % (N, N, N, N), MANUAL,
     r"(?s)f\s+(51)\s+(?:such\s+)?walls\s+under\s+(\.6)\s+to\s+(\.9)\s.{0,40}?load,"
     r"\s+(7)\s+move"),
    (r"more than %s %% on %s of %s slopes" % (N, N, N), TRUST,
     r"\| %s slopes at 1\.005 to .*\n.*\n\| the same, turned, .*off by more than "
     r"%s %% \| %s of 360" % (N, N, N)),
    (r"Of such stones %s %% .* Of all kinds that we tested it was %s %%" % (N, N), TRUST,
     r"(?s)That is %s %% of one half.*?drops at one end \| [\d,]+ of [\d,]+ \| %s %%"
     % (N, N)),
    # beside one simulated run
    (r"%s stones rocked onto a neighbour and stayed: Box2D accepts %s %% of them, "
     r"kern %s %%" % (N, N, N), TRUST,
     r"\| %s that rock .* \| %s %% \| \|\n.*0\.5 \| %s %%" % (N, N, N)),
    (r"On %s placements one run of" % N, TRUST, r"\| %s \| one run of Box2D v3" % N),
    (r"(?s)walls of (19) to (25) bricks .{,60}takes %s us .{,90}Box2D\s+takes %s us" % (N, N),
     BENCH, r"\| (19)-(25) \| 72 (?:\|[^|]*){5}\| %s [^|]*\| %s " % (N, N)),
    # how many
    (r"with %s textbook results" % N, "cc tests/published.c", r"\n%s results" % N),
    (r"with %s experiments" % N, "cc tests/reality.c", r"\n%s rows" % N),
    (r"%s structures, \d+ of them with known outcomes" % N, "tests/CORPUS.md",
     r"The corpus: %s structures" % N),
    # textbooks and experiments
    (r"Milankovitch 1907\) \| %s \| %s \|" % (N, N), PUBLISHED,
     r"Milankovitch 1907\) \| %s \| %s" % (N, N)),
    (r"arch of 7 stones, 157\.5 degrees, .* \| %s \| %s \|" % (N, N), PUBLISHED,
     r"157\.5 deg, t/R 0\.15: load factor, four hinges \| %s \| %s" % (N, N)),
    (r"multiplied by this factor \| %s \| %s" % (N, N), PUBLISHED,
     r"phi 30, delta 2/3 phi: against overturning \| %s \| %s" % (N, N)),
    (r"Goodman and Bray 1976\) \| %s \| %s \|" % (N, N), PUBLISHED,
     r"least friction, let go \| %s \| %s" % (N, N)),
    (r"push at its foot, in N \| %s \| %s" % (N, N), PUBLISHED,
     r"least push at the foot that holds it \| %s \| %s" % (N, N)),
    (r"Prestwood bridge .* kN .*\| %s \| %s" % (N, N), REALITY,
     r"Prestwood 1986 \| %s \| %s" % (N, N)),
    (r"Ten bridges, .* \| 1 \| %s \|" % N, REALITY, r"\| no crushing \| %s " % N),
    (r"most cautious ratio \| 1 \| %s and %s \|" % (N, N), REALITY,
     r"(?s)\| Strathmashie 1989 \|[^|]*\|[^|]*\| %s .*\| Bolton model 1990 "
     r"\|[^|]*\|[^|]*\| %s " % (N, N)),
    (r"crushes at (5) MPa: .* \| 1 \| %s \|" % N, REALITY, r"\n\| (5) MPa \| %s " % N),
    (r"right verdicts on \d stages\..* \| %s \| %s" % (N, N), REALITY,
     r"Right in %s of %s\. C" % (N, N)),
    (r"height of soil, in feet \| %s \| %s" % (N, N), REALITY,
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
