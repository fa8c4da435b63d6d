#!/usr/bin/env bash
# bash tests/mutants.sh [N [SEED]]    does a test notice when kern.h is wrong?
#
# Of N copies of kern.h (40) each has one operator of its implementation changed:
# < to <=, + to -, && to ||, and the like, at a place drawn from SEED (1). A copy
# that compiles must be noticed by what once failed, the quick unit tests or the
# work table; the golden hash would notice any. Fails where more than one in four
# lives; those are printed, for a reader who may find what no test sees.
. "$(dirname "$0")/lib.sh"

many=${1:-40}
seed=${2:-1}
mkdir -p "$out/copy"
cp -r tests examples kern_lp.h "$out/copy"

mutant() { # mutant NUMBER: writes a copy of kern.h, prints the line changed
    awk -v number="$1" -v seed="$seed" '
    BEGIN { srand(seed * 1000 + number) }
    { line[NR] = $0 }
    />>impl/ && /====/ { start = NR }
    END {
        n = split("< @<= #> @>= #<= @< #>= @> #+ @- #- @+ #&& @|| #|| @&& #" \
            "== @!= #!= @== ", swap, "#")
        while (!done && tries++ < 1e5) {
            k = start + int(rand() * (NR - start))
            if (line[k] ~ /^ ?\/?\*|^#|^   [A-Za-z]/ || line[k] !~ /;|\{/)
                continue
            split(swap[1 + int(rand() * n)], pair, "@")
            at = index(line[k], " " pair[1])
            if (!at || index(line[k], "/*") && index(line[k], "/*") < at)
                continue
            line[k] = substr(line[k], 1, at) pair[2] \
                substr(line[k], at + 1 + length(pair[1]))
            printf "%d: %s\n", k, line[k]
            done = 1
        }
        for (k = 1; k <= NR; k++) print line[k] >copy
    }' copy="$out/copy/kern.h" kern.h
}

noticed() { # by which test; 1: by none
    local test
    cd "$out/copy" || return 1
    gcc -O1 $exact -fsyntax-only tests/golden.c 2>/dev/null ||
        { echo compiler; return 0; }
    for test in regressions "quick gcc -O1" work; do
        # shellcheck disable=SC2086
        timeout 120 bash tests/unit.sh $test >/dev/null 2>&1 ||
            { echo "$test"; return 0; }
    done
    return 1
}

cp kern.h "$out/copy/kern.h"
by=$(noticed) && { echo "fails without a change: $by"; exit 1; }
alive=0
tried=0
for number in $(seq "$many"); do
    change=$(mutant "$number")
    by=$(noticed) || by="NOT NOTICED"
    [ "$by" != compiler ] || continue
    tried=$((tried + 1))
    [ "$by" != "NOT NOTICED" ] || alive=$((alive + 1))
    printf '%-14s %s\n' "$by" "$change"
done
echo "$alive of $tried not noticed"
[ "$tried" -gt 0 ] && [ $((4 * alive)) -le "$tried" ]
