#!/usr/bin/env bash
# bash tests/work.sh count [LIST]       instructions of every question, a line
#                                       each: those of tests/work.c, which see
#                                       what its units do not
# bash tests/work.sh corpus [LIST]      tables of them, as shares of one cold LP
#                                       of the better of GLPK and Clp
# bash tests/work.sh lp [LIST]          instructions of that LP, a line each
# bash tests/work.sh against COMMIT     sums beside those of kern.h at COMMIT;
#                                       fails where one is 3 % larger
#
# bash tests/work.sh limits [FILE...]   instructions of a unit of whole answers;
#                                       what a call takes beyond 3,000, for each
#                                       unit of its limit; fails where kern.h
#                                       says otherwise (>>verdicts)
#
# LIST names files, tests/corpus/even.txt unless another is given. Needs
# valgrind; corpus and lp need libglpk-dev and coinor-libclp-dev. Instructions
# depend on the compiler: compare what one machine counted.
. "$(dirname "$0")/lib.sh"

built() { # built NAME FLAGS...: work as callgrind runs it
    local name=$1
    shift
    gcc -O2 $exact -DWORK_CALLGRIND -o "$out/$name" tests/work.c "$@" -lm
}

counted() { # counted NAME ARGUMENTS...: the lines of --each, and instructions
    local name=$1
    shift
    nice valgrind --tool=callgrind --combine-dumps=yes \
        --callgrind-out-file="$out/dumps" "$out/$name" --each "$@" \
        >"$out/lines" 2>"$out/err" || { tail "$out/err" >&2; return 1; }
    awk -F, '
    FNR == NR {
        if (sub(/^desc: Trigger: Client Request: /, "")) at = $0
        else if (/^(totals|summary): / && at != "") {
            split($0, word, " ")
            tag[++dumps] = at
            count[dumps] = word[2]
            at = ""
        }
        next
    }
    tag[FNR] != $2 "," $3 { print "no dump of " $0; exit 1 }
    { print $0 "," count[FNR] }' "$out/dumps" "$out/lines"
}

count() { # count [LIST]
    echo "set,name,question,stones,status,units,solves,pivots,answer,instructions"
    built work && counted work "${1:-tests/corpus/even.txt}"
}

corpus() { # corpus [LIST]
    built work -DBENCH_GLPK -DBENCH_CLP -lglpk -lClp -lCoinUtils &&
        counted work "${1:-tests/corpus/even.txt}" >"$out/counts" || return 1
    awk -F, '
    { n++; name[n] = $2; ask[n] = $3; size[n] = $4; many[n] = $10 }
    $3 == "GLPK" || $3 == "Clp" {
        if (!($2 in lp) || $10 < lp[$2]) lp[$2] = $10
    }
    END {
        for (i = 1; i <= n; i++) {
            at = name[i]
            sub(/\//, "," size[i] ",", at)
            printf "%s,2,%s M,%.9g\n", at, ask[i], many[i] / 1e6
            printf "%s,2,%s / LP,%.9g\n", at, ask[i], many[i] / lp[name[i]]
        }
    }' "$out/counts" | awk -f tests/bench.awk
}

lp() { # lp [LIST]
    built work -DBENCH_GLPK -DBENCH_CLP -lglpk -lClp -lCoinUtils &&
        counted work "${1:-tests/corpus/even.txt}" | awk -F, '
        $3 == "GLPK" || $3 == "Clp" {
            if (!($2 in lp) || $10 < lp[$2]) lp[$2] = $10
        }
        END { for (name in lp) print name "," lp[name] }' | sort
}

sums() { awk -F, '{ s[$1 "," $3] += $10 } END { for (k in s) print k "," s[k] }'; }

shopt -s extglob
limits() { # limits [FILE...]
    # prestwood is left out: the pushes of its fill are blocks with one contact
    [ $# -gt 0 ] ||
        set -- examples/structures/!(prestwood).kern tests/regressions/{bricks,rubble}_* \
            tests/corpus/placed/w00*-r.kern \
            tests/corpus/shaken/*-gaps-0[1-3].kern
    gcc -O2 $exact -o "$out/limits" tests/limits.c -lm || return 1
    for file; do
        nice valgrind --tool=callgrind --combine-dumps=yes \
            --collect-atstart=no --callgrind-out-file="$out/dumps" \
            "$out/limits" "$file" >"$out/lines" 2>"$out/err" ||
            { tail "$out/err" >&2; return 1; }
        awk '
        FNR == NR {
            if (sub(/^desc: Trigger: Client Request: /, "")) at = $0
            else if (/^totals: / && at != "") {
                count[at] = $2
                at = ""
            }
            next
        }
        { split($1, word, "/"); print word[2], $2, $3, $4, count[$1] }
        ' "$out/dumps" "$out/lines"
        rm "$out/dumps"
    done | awk '
    {
        ask = $1
        unit = $5 / $3
        over = ($5 - 3000) / $2
        if (!(ask in low)) low[ask] = 1e9
        if ($4 == "whole" && unit < low[ask]) low[ask] = unit
        if ($4 == "whole" && unit > high[ask]) high[ask] = unit
        if (over > most[ask]) most[ask] = over
    }
    END {
        print "question        a unit, from    to   and of a limit, at most"
        for (ask in low) {
            printf "%-14s %13.0f %5.0f %15.0f\n", ask, low[ask], high[ask],
                   most[ask]
            missed += low[ask] < 550 || high[ask] > 2000 || most[ask] > 2000
        }
        exit missed > 0
    }'
}

against() { # against COMMIT
    mkdir -p "$out/then/tests" && cp -r examples "$out/then" &&
        cp tests/*.[ch] "$out/then/tests" || return 1
    git show "$1:kern.h" >"$out/then/kern.h" &&
        git show "$1:kern_lp.h" >"$out/then/kern_lp.h" ||
        { echo "no such commit here: left out"; return 0; }
    built now && counted now | sums | sort >"$out/now.sums" || return 1
    gcc -O2 $exact -DWORK_CALLGRIND -o "$out/before" "$out/then/tests/work.c" \
        -lm 2>/dev/null || { echo "other functions at $1: left out"; return 0; }
    counted before | sums | sort >"$out/before.sums" || return 1
    awk -F, '
    FNR == NR { before[$1 "," $2] = $3; next }
    {
        at = $1 "," $2
        ratio = before[at] ? $3 / before[at] : 1
        printf "%-28s %12d %12d %6.3f%s\n", at, before[at], $3, ratio, \
            (ratio > 1.03 ? "  LARGER" : "")
        larger += ratio > 1.03
    }
    END { exit larger > 0 }' "$out/before.sums" "$out/now.sums"
}

run_check "$@"
