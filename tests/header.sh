#!/usr/bin/env bash
# bash tests/header.sh CHECK    the header is clean wherever it is compiled
. "$(dirname "$0")/lib.sh"

strict="-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion
 -Wdouble-promotion -Wfloat-equal -Wundef -Wcast-qual -Wvla -Werror"
strict_c="$strict -Wstrict-prototypes -Wmissing-prototypes
 -Wold-style-definition -Wc++-compat"

strict() { # strict COMPILER STANDARD FLAGS...: included three times, and run
    local cc=$1 std=$2 lang=c flags=$strict_c
    shift 2
    case $std in c++*) lang=c++ flags=$strict ;; esac
    printf '%s\n' '#include "kern.h"' '#define KERN_IMPLEMENTATION' \
        '#include "kern.h"' '#include "kern.h"' \
        'int main(void) { return kern_status_text(KERN_FALLS)[0] == 0; }' \
        >"$out/probe.$lang"
    # shellcheck disable=SC2086
    $cc -x "$lang" -std="$std" $flags -I. "$@" "$out/probe.$lang" \
        -o "$out/probe" -lm && "$out/probe"
}

strict_all() { # strict_all COMPILER: the first and the last standards, in both
    local std precision
    for precision in "" -DKERN_SINGLE; do
        for std in c99 c17 c++11 c++2b; do
            # shellcheck disable=SC2086
            strict "$1" $std -O2 $precision ||
                { echo "FAILED: $1 $std $precision"; return 1; }
        done
    done
    strict "$1" c99 -O2 -DKERN_STATIC
}

cpp() { # wall.hpp and what uses it, with warnings for C++; in threads, and
    # when there is no memory
    local cc
    for cc in g++ clang++; do
        $cc -std=c++17 -Wall -Wextra -Wpedantic -Wshadow -Wconversion \
            -Wold-style-cast -Werror -fsyntax-only examples/copy/planner.cpp &&
            $cc -std=c++17 -Wall -Wextra -Wpedantic -Wshadow -Wold-style-cast \
                -Werror -fsyntax-only -DKERN_IMPLEMENTATION \
                examples/copy/planner.cpp || return 1
    done
    for cc in address,undefined thread; do
        clang++ -std=c++17 -O1 -g -pthread -DKERN_IMPLEMENTATION \
            -fsanitize=$cc -fno-sanitize-recover=all \
            examples/copy/planner.cpp -o "$out/planner" &&
            "$out/planner" | grep -q '^x 2.375: stays 0.999' || return 1
    done
    clang++ -std=c++17 -O1 -g -Wall -Wextra -Werror \
        -fsanitize=address,undefined -fno-sanitize-recover=all \
        tests/wall_test.cpp -o "$out/wall" && "$out/wall"
}

two_files() {
    printf '%s\n' '#include "kern.h"' 'kern_options o(void);' \
        'kern_options o(void) { return kern_defaults(); }' >"$out/a.c"
    printf '%s\n' '#define KERN_IMPLEMENTATION' '#include "kern.h"' \
        'kern_options o(void);' \
        'int main(void) { return o().mu > 0 ? 0 : 1; }' >"$out/b.c"
    gcc -I. "$out/a.c" "$out/b.c" -o "$out/two" -lm && "$out/two"
}

precisions() { # a caller in double must not link with a float library
    printf '%s\n' '#define KERN_IMPLEMENTATION' '#define KERN_SINGLE' \
        '#include "kern.h"' >"$out/b.c"
    printf '%s\n' '#include "kern.h"' \
        'int main(void) { return kern_defaults().mu > 1; }' >"$out/a.c"
    ! gcc -I. "$out/a.c" "$out/b.c" -o "$out/two" -lm
}

c90() { # the declarations
    echo '#include "kern.h"' >"$out/c90.c"
    gcc -std=c90 -pedantic -Wall -Wextra -Werror -I. -c "$out/c90.c" \
        -o "$out/c90.o"
}

windows() { # its headers define far and near
    local file
    for file in tests/*.c examples/*.c examples/*/*.c; do
        case $file in */firmware/*) continue ;; esac
        gcc -fsyntax-only -DFUZZ_STRUCTURE -Dfar= -Dnear= "$file" || return 1
    done
}

format() { # every C file is as .clang-format says
    git ls-files '*.c' '*.h' | xargs clang-format --dry-run -Werror
}

alone() { # kern_lp.h says what to do
    printf '#include "kern_lp.h"\n' >"$out/alone.c"
    gcc -I. -c "$out/alone.c" -o "$out/alone.o" 2>&1 |
        grep -q 'include kern.h instead'
}

symbols() { # one global name more than kern_* would be a leak
    printf '#define KERN_IMPLEMENTATION\n#include "kern.h"\n' >"$out/s.c"
    gcc -O2 -I. -c "$out/s.c" -o "$out/s.o" &&
        ! nm "$out/s.o" | grep -E ' [BDCbdc] ' &&
        ! nm "$out/s.o" | grep -E ' T ' | grep -v ' kern_' &&
        ! nm "$out/s.o" | grep ' U ' | grep -vE ' (sqrt|memset|memcpy|memmove|_GLOBAL_OFFSET_TABLE_)$'
}

others() { # every header of the examples and tests includes what it uses
    local header
    for header in examples/*/*.h tests/*.h tests/unit/*.h; do
        gcc -std=c99 -Wall -Wextra -Wno-unused-function -Werror \
            -Wno-unused-const-variable -fsyntax-only -x c "$header" || return 1
    done
}

one_room() { # the tests of one room alone, as tests/kern_test.c says
    # shellcheck disable=SC2086
    gcc -O1 $exact -DONLY=push -o "$out/kern_test" tests/kern_test.c -lm &&
        "$out/kern_test" | grep '^1 tests: .* 0 failed$'
}

fence() { # no other example needs a file of the laboratory
    ! grep -rn 'laboratory/' examples --exclude-dir=laboratory \
        --include='*.[ch]' --include='*.py' --include='*.sh'
}

chapter() { # chapter TAG: the lines of kern.h from its ruler to the next
    awk -v tag=">>$1 " '
        /^\/\* (----|====).*>>/ { on = index($0 " ", tag) > 0 }
        on' kern.h | sed 's/\*\/$/ \*\//'
}

rooms() { # linear programs know no stones, the proofs no linear program, and a
    # struct is touched in the chapters that rooms.txt names
    chapter lp >"$out/lp" && [ -s "$out/lp" ] &&
        ! grep -niE 'stone|gravity|friction|contact_' "$out/lp" &&
        chapter proof >"$out/proof" && [ -s "$out/proof" ] &&
        ! grep -nE 'kern_lp|simplex|basis' "$out/proof" &&
        python3 tests/rooms.py
}

analysed() { # analysed FLAGS...: gcc's own analyzer
    gcc -std=c99 -O1 -fanalyzer -Werror -I. -DKERN_IMPLEMENTATION "$@" \
        -x c -c kern.h -o "$out/an.o"
}

cpp_checked() {
    cppcheck --quiet --error-exitcode=1 --std=c99 \
        --enable=warning,portability --suppress=missingInclude \
        -DKERN_IMPLEMENTATION --inline-suppr kern.h
}

run_check "$@"
