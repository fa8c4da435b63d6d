#!/usr/bin/env python3
"""python3 tests/ablate.py [--units] [NAME...]    what leaving a mechanism out costs

Takes one mechanism after the other out of a copy of kern.h and asks all
questions of tests/work.c again: of the even half of the corpus, and of made
structures whose seeds no other test uses ("unseen"). Prints the table of
tests/DESIGN.md: instructions without the mechanism, as a multiple of those with
it, summed over the structures; and how many statuses and answers differ.

A mechanism is taken out by statements that are put at the head of a function.
Where kern.h has no such function any more, where the copy does not compile, or
where a status differs, the script says so, goes on and fails at the end. Names
are those of MECHANISMS: all, or those given. --units counts the library's own
units of work, in a minute, instead of instructions under valgrind."""
import argparse
import csv
import io
import os
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
QUESTIONS = ["verdict", "measure", "load", "tilt", "raised", "try", "bears"]
FAMILIES = ["bond", "rag", "irr", "tower", "arch", "brick"]
SIZES = [8, 15, 25, 40, 80]
NUMBERS = [40, 41]  # tests/work.c asks about 0 and 1, tests/bench.c 0 to 8
ALIKE = 5e-6  # answers that differ by less are one; above 1 as a share

# Name, what it is in the table, and the statements: {function: head}, in the
# order of the sections of DESIGN.md. None: a line before all others.
MECHANISMS = [
    ("bodies", "bodies first",
     {"kern_body_line": "m->graph.carrier[g] = KERN_OUT; return KERN_OUT;"}),
    ("alone", "one group alone, 3 x 3",
     {"kern_pass_alone": "return KERN_UNDECIDED;"}),
    ("clusters", "clusters",
     {"kern_pass_grow": "return 0;"}),
    ("pass", "the whole top-down pass",
     {"kern_model_pass": "return KERN_UNDECIDED;"}),
    ("known", "forces known from the last measure",
     {"kern_known_begin": "return;", "kern_known_start": "return;"}),
    ("crash", "crash basis",
     {"kern_crash_choose": "return 0;"}),
    ("triangular", "block-triangular basis",
     {"kern_own_enter": "return 0;"}),
    ("interior", "interior point",
     {None: "#define KERN_NO_INTERIOR"}),
    ("order", "Cuthill-McKee order",
     {"kern_norm_order": """{
        int *local = p->m->graph.local, g, n = 0;
        for (g = 0; g < p->groups; g++)
            if (local[g] == KERN_OUT)
                p->group[n++] = g;
        for (p->groups = n; n-- > 0;)
            local[p->group[n]] = n;
        return;
    }"""}),
    ("follow", "program with the value as a column",
     {"kern_path_follow": "return KERN_UNDECIDED;"}),
    ("extrapolate", "extrapolated prices",
     {"kern_raise_extrapolate": """{
        const kern_part *q = r->part;
        kern_real sum = 0;
        int i;
        (void)round;
        for (i = 0; i < q->contacts; i++) {
            q->dual.price[i] = q->dual.change[2 * i];
            sum += q->dual.change[2 * i + 1] * q->dual.change[2 * i + 1];
        }
        return sum;
    }"""}),
]


class Fault(Exception):
    """A mechanism cannot be taken out, or what is left does not run."""


def take_out(text, heads):
    """kern.h with the statements at the head of each function."""
    for name, head in heads.items():
        if name is None:
            text = head + "\n" + text
            continue
        # a definition begins in the first column and has "{" in the first too
        found = list(re.finditer(r"^(?:\w[^;{}()]*\b)?" + name
                                 + r"\([^;{}]*\)\n\{\n", text, re.M))
        if len(found) != 1:
            raise Fault("kern.h defines %s() %d times, not once: mend "
                        "MECHANISMS" % (name, len(found)))
        at = found[0].end()
        text = text[:at] + "    " + head + "\n" + text[at:]
    return text


class Copy:
    """A copy of what tests/work.sh needs, with a kern.h of its own."""

    def __init__(self, folder, units):
        self.folder = folder
        self.units = units
        for part in ("tests", "examples"):
            shutil.copytree(os.path.join(ROOT, part),
                            os.path.join(folder, part))
        for part in ("kern.h", "kern_lp.h"):
            shutil.copy(os.path.join(ROOT, part), folder)
        with open(os.path.join(folder, "kern.h")) as file:
            self.text = file.read()

    def run(self, *command):
        done = subprocess.run(command, cwd=self.folder, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        if done.returncode:
            raise Fault(" ".join(command) + "\n" + done.stdout[-999:]
                        + done.stderr[-999:])
        return done.stdout

    def compile(self, source, program):
        self.run("gcc", "-O2", "-ffp-contract=off", "-o", program, source,
                 "-lm")

    def make_unseen(self):
        """Writes the made structures and their list."""
        self.compile("tests/bench.c", "printer")
        os.mkdir(os.path.join(self.folder, "unseen"))
        names = []
        for family in FAMILIES:
            for size in SIZES:
                for number in NUMBERS:
                    names.append("unseen/%s-%d-%d.kern"
                                 % (family, size, number))
                    text = self.run("./printer", "--print", "--family", family,
                                    "--sizes", str(size), "--number",
                                    str(number))
                    with open(os.path.join(self.folder, names[-1]),
                              "w") as file:
                        file.write(text)
        with open(os.path.join(self.folder, "unseen.txt"), "w") as file:
            file.write("\n".join(names) + "\n")

    def count(self, heads):
        """{(list, name, question): (status, cost, answer)} of all questions."""
        with open(os.path.join(self.folder, "kern.h"), "w") as file:
            file.write(take_out(self.text, heads))
        out = {}
        if self.units:
            self.compile("tests/work.c", "work")
        for which in ("tests/corpus/even.txt", "unseen.txt"):
            if self.units:
                text = self.run("nice", "./work", "--each", which)
            else:
                text = self.run("bash", "tests/work.sh", "count", which)
            seen = {}
            for row in csv.reader(io.StringIO(text)):
                if row[0] == "set":
                    continue
                at = (which, row[1], row[2])
                seen[at] = seen.get(at, 0) + 1  # three stones are tried
                cost = int(row[5] if self.units else row[9])
                out[at + (seen[at],)] = (int(row[4]), cost, float(row[8]))
        return out


def ratio(with_it, without, which, question):
    """Cost without the mechanism over that with it; None: nothing was asked."""
    both = [at for at in with_it
            if at[0] == which and at[2] == question and at in without]
    cost = sum(with_it[at][1] for at in both)
    return sum(without[at][1] for at in both) / cost if cost else None


def ninth(with_it, without, which, question):
    """The ratio that nine tenths of the structures do not exceed."""
    each = sorted(without[at][1] / with_it[at][1] for at in with_it
                  if at[0] == which and at[2] == question and at in without
                  and with_it[at][1])
    return each[len(each) * 9 // 10] if each else None


def differences(with_it, without):
    """How many statuses differ, and how many answers where these do not."""
    status = answer = 0
    for at, one in with_it.items():
        other = without.get(at)
        if other is None or other[0] != one[0]:
            status += 1
        elif at[2] in QUESTIONS and one[0] > 0 and abs(one[2] - other[2]) \
                > ALIKE * max(abs(one[2]), abs(other[2]), 1):
            answer += 1
    return status, answer


def cell(with_it, without, cost, question):
    """Both ratios; empty where leaving it out changes nothing."""
    both = [cost(with_it, without, which, question)
            for which in ("tests/corpus/even.txt", "unseen.txt")]
    text = ", ".join("%.2f" % (c if c else 1) for c in both)
    return "" if text == "1.00, 1.00" else text


def print_table(rows):
    print("\nCost without it, as a multiple: even half of the corpus, then %d "
          "made structures of %d to %d blocks.\n"
          % (len(FAMILIES) * len(SIZES) * len(NUMBERS), SIZES[0], SIZES[-1]))
    print("| left out | " + " | ".join(QUESTIONS) + " | measure, p90 |")
    print("|---|" + "---:|" * (len(QUESTIONS) + 1))
    for what, with_it, without in rows:
        cells = [cell(with_it, without, ratio, q) for q in QUESTIONS]
        cells.append(cell(with_it, without, ninth, "measure"))
        print("| %s | %s |" % (what, " | ".join(cells)))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--units", action="store_true")
    parser.add_argument("names", nargs="*", metavar="NAME")
    options = parser.parse_args()
    known = [m[0] for m in MECHANISMS]
    for name in options.names:
        if name not in known:
            sys.exit("no mechanism %s; there are %s" % (name, ", ".join(known)))
    rows, faults = [], []
    with tempfile.TemporaryDirectory() as folder:
        copy = Copy(os.path.join(folder, "kern"), options.units)
        copy.make_unseen()
        base = copy.count({})
        for name, what, heads in MECHANISMS:
            if options.names and name not in options.names:
                continue
            try:
                without = copy.count(heads)
            except Fault as fault:
                faults.append("%s: %s" % (name, fault))
                print("FAILED  " + faults[-1], flush=True)
                continue
            rows.append((what, base, without))
            status, answer = differences(base, without)
            if status:
                faults.append("%s: changes what is answered" % name)
            print("%-36s of %d questions, statuses that differ: %d, answers: %d"
                  % (what, len(base), status, answer), flush=True)
    print_table(rows)
    if faults:
        sys.exit("\n".join(["", "%d faults:" % len(faults)] + faults))


if __name__ == "__main__":
    main()
