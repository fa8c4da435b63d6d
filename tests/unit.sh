#!/usr/bin/env bash
# bash tests/unit.sh CHECK ...    kern_test.c and its kin, in many builds
. "$(dirname "$0")/lib.sh"

build() { # build COMPILER FLAGS...: kern_test with them
    local cc=$1
    shift
    $cc $exact "$@" -o "$out/kern_test" tests/kern_test.c $libs -lm
}

tests() { # tests COMPILER FLAGS...
    build "$@" && "$out/kern_test"
}

quick() { # quick COMPILER FLAGS...: where the code is slow, fewer structures
    build "$@" && "$out/kern_test" --quick
}

sanitized() { # sanitized FLAGS...
    # shellcheck disable=SC2086
    quick clang $sanitize "$@"
}

audited() { # audited FLAGS...: asserts, and the engine's state after each pivot
    quick gcc -O2 -include tests/audit.h "$@"
}

golden() { # golden N: the hash of N structures
    # shellcheck disable=SC2086
    gcc $plain -o "$out/golden" tests/golden.c -lm && "$out/golden" "$1"
}

random() { # random N: audited, and N more structures against the twin
    audited && "$out/kern_test" --random "$1"
}

glpk() { # what has more than 96 rows: no other test calls it
    libs=-lglpk
    build gcc -O2 -DKERN_USE_GLPK &&
        "$out/kern_test" thin_arch known_walls laws_u sensitivity_c twin status memory_l
}

glpk_always() { # the cases with known answers, and small plans
    libs=-lglpk
    build gcc -O2 -DKERN_USE_GLPK -DKERN_GLPK_ROWS=0 &&
        "$out/kern_test" known laws plan_ca plan_p plan_s
}

big_endian() { # what is quick in an emulator
    build s390x-linux-gnu-gcc -O2 -static &&
        qemu-s390x "$out/kern_test" --quick polygon contact lp_ proof known_
}

# ---- what a proof is worth

faults() { # faults FLAGS...: too little memory
    # shellcheck disable=SC2086
    gcc $plain "$@" -o "$out/faults" tests/faults.c $libs -lm && "$out/faults"
}

lies() { # a solver that lies
    libs=-lglpk
    faults -DKERN_USE_GLPK
}

rational() { # verdicts against exact arithmetic
    # shellcheck disable=SC2086
    gcc $plain -o "$out/exact" tests/exact.c -lgmp -lm &&
        "$out/exact" 20000 && "$out/exact" 1000 1 14 &&
        "$out/exact" families 5000
}

rational_long() { # as many as TRUST.md says
    # shellcheck disable=SC2086
    gcc $plain -o "$out/exact" tests/exact.c -lgmp -lm &&
        "$out/exact" 100000 && "$out/exact" families 20000
}

paper() { # levels against the paper's own algorithm, a program a step
    # shellcheck disable=SC2086
    gcc $plain -o "$out/paper" tests/paper.c -lm &&
        "$out/paper" tests/corpus/odd.txt tests/corpus/even.txt \
            examples/structures/*.kern
}

design() { # the examples of DESIGN.md
    # shellcheck disable=SC2086
    gcc $plain -o "$out/design" tests/design.c -lm && "$out/design"
}

regressions() { # structures on which earlier versions failed
    # shellcheck disable=SC2086
    gcc $plain -o "$out/regressions" tests/regressions.c -lm &&
        "$out/regressions"
}

published() { # results of the literature and closed forms
    # shellcheck disable=SC2086
    gcc $plain -o "$out/published" tests/published.c -lm &&
        "$out/published" --markdown >"$out/published.md" &&
        cmp "$out/published.md" tests/PUBLISHED.md
}

reality() { # experiments, and whether the page is what they say today
    # shellcheck disable=SC2086
    gcc $plain -o "$out/reality" tests/reality.c -lm &&
        "$out/reality" --markdown >"$out/reality.md" &&
        cmp "$out/reality.md" tests/REALITY.md
}

friction() { # toppling slopes, walls that slide, plain walls, other frames
    # shellcheck disable=SC2086
    gcc $plain -o "$out/friction" tests/friction.c -lm && "$out/friction"
}

noise() { # what nearly stands is not said to stand for certain
    # shellcheck disable=SC2086
    gcc $plain -o "$out/noise" tests/noise.c -lm && "$out/noise"
}

misses() { # how often what lacks a support is said to stand for certain
    # shellcheck disable=SC2086
    gcc $plain -o "$out/misses" tests/misses.c -lm && "$out/misses"
}

work() { # how much work each question takes, against tests/work.csv
    # shellcheck disable=SC2086
    gcc $plain -o "$out/work" tests/work.c -lm && "$out/work"
}

uninitialised() { # nothing is read before it is written, in all those questions
    clang -g -O1 $exact -fsanitize=memory -fno-sanitize-recover=all \
        -o "$out/work" tests/work.c -lm && "$out/work" --table >/dev/null
}

work_table() { # writes that table anew
    # shellcheck disable=SC2086
    gcc $plain -o "$out/work" tests/work.c -lm &&
        "$out/work" --table >"$out/work.csv" &&
        mv "$out/work.csv" tests/work.csv
}

bytes() { # bytes FLAGS...: without libFuzzer: files, and bytes from a seed
    # shellcheck disable=SC2086
    gcc $plain "$@" -DFUZZ_PLAIN -o "$out/plain" tests/fuzz.c -lm &&
        case "$*" in
        *TEXT*) "$out/plain" examples/structures/* ;;
        *DRAWING*) "$out/plain" tests/seeds/drawing* ;;
        *) "$out/plain" tests/seeds/structure-* ;;
        esac && "$out/plain" --random 100000 7
}

fuzz_drawing() { # fuzz_drawing .dxf|.json|.svg: a minute of libFuzzer
    mkdir -p "$out/seeds" && cp tests/seeds/drawing*"$1" "$out/seeds" &&
        fuzz_one "DRAWING=\"$1\"" "$out/seeds"
}

fuzz_one() { # fuzz_one WHAT [SEEDS]: a minute of libFuzzer
    mkdir -p "$out/$1" &&
        clang -g -O1 $exact -fsanitize=fuzzer,address,undefined \
            -fno-sanitize-recover=all "-DFUZZ_$1" -o "$out/fuzz_$1" \
            tests/fuzz.c -lm &&
        "$out/fuzz_$1" -max_total_time=60 -timeout=100 -max_len=3000 \
            -verbosity=0 -print_final_stats=1 -artifact_prefix="$out/" \
            "$out/$1" ${2:+"$2"}
}

libs=""
run_check "$@"
