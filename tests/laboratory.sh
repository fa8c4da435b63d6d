#!/usr/bin/env bash
# bash tests/laboratory.sh CHECK ...    simulator, shaking table and planners of
#                                       examples/laboratory
. "$(dirname "$0")/lib.sh"

simulator() {
    local rigid shake
    rigid=$(program rigid_test tests/rigid_test.c) &&
        "$rigid" examples/structures/arch.kern &&
        shake=$(program shake examples/laboratory/shake.c) &&
        "$shake" --levels 3 examples/structures/three-boxes.kern
}

film() { # of a shake
    local shake
    shake=$(program shake examples/laboratory/shake.c) &&
        "$shake" --levels 2 --svg "$out/two.svg" --film "$out/film.svg" \
            examples/structures/three-boxes.kern &&
        $judge svg "$out/two.svg" "$out/film.svg" &&
        grep -q animate "$out/film.svg"
}

figures() { # a small version; numbers are checked, not pixels
    local figures study
    figures=$(program figures examples/laboratory/figures.c) &&
        study=$(program study examples/laboratory/study.c) || return 1
    mkdir -p "$out/structures" "$out/scatter"
    "$figures" --quick "$out" &&
        "$study" --csv "$out/measures.csv" --svg "$out/scatter" "$out" \
            >"$out/study.md" && $judge figures "$out"
}

timeless() { # the lines of JSON in two files are the same, but for times
    diff <(sed 's/, "seconds": [0-9.]*//' "$1") \
        <(sed 's/, "seconds": [0-9.]*//' "$2") && [ "$(wc -l <"$1")" -eq "$3" ]
}

spread() { # a study over two jobs prints the lines of one process
    local figures shake stack tower=$PWD/examples/structures/tower.kern
    local parallel="parallel --will-cite --keep-order --jobs 2"
    local walls="--json --irregularity 30 --stones 10 --walls 2"
    figures=$(program figures examples/laboratory/figures.c) &&
        shake=$(program shake examples/laboratory/shake.c) &&
        stack=$(program stack examples/laboratory/stack.c) &&
        mkdir -p "$out"/{one,two}/structures && cd "$out" || return 1
    "$figures" --quick --json --seed 1-6 one >f1 &&
        seq 6 | $parallel "$figures" --quick --json --seed {} two >f2 &&
        timeless f1 f2 6 && diff -r one two &&
        "$shake" --json --levels 9 --seed 1-4 "$tower" >s1 &&
        seq 4 | $parallel "$shake" --json --levels 9 --seed {} "$tower" >s2 &&
        timeless s1 s2 4 || return 1
    # shellcheck disable=SC2086
    "$stack" $walls --seed 1-3 --out w.kern --svg w.svg >w1 &&
        seq 3 | $parallel "$stack" $walls --seed {} --out w-{}.kern \
            --svg w-{}.svg >w2 && timeless w1 w2 3
}

alike() { # gcc and clang make the same stones, structures and walls
    local cc
    for cc in gcc clang; do
        # shellcheck disable=SC2086
        mkdir -p "$out/$cc/structures" &&
            $cc $plain -o "$out/figures-$cc" examples/laboratory/figures.c -lm &&
            $cc $plain -o "$out/stack-$cc" examples/laboratory/stack.c -lm &&
            "$out/figures-$cc" --quick --json "$out/$cc" >"$out/$cc.json" &&
            "$out/stack-$cc" --irregularity 30 --stones 12 --walls 3 \
                --no-shaking --out "$out/$cc/w.kern" --svg "$out/$cc/w.svg" \
                >"$out/$cc/w.table" || return 1
    done
    timeless "$out/gcc.json" "$out/clang.json" 6 && diff -r "$out"/{gcc,clang}
}

stacking() { # stones, features, walls that stand at every step; bad input
    local kern stack test bad i=0
    kern=$(program kern examples/kern.c) &&
        stack=$(program stack examples/laboratory/stack.c) &&
        test=$(program stack_test tests/stack_test.c) && "$test" || return 1
    "$stack" --stones 12 --irregularity 40 --walls 4 --film \
        "$out/film.svg" --out "$out/w.kern" --svg "$out/w.svg" &&
        "$kern" "$out/w.kern" >/dev/null &&
        "$stack" --planner combined --no-shaking --out "$out/v.kern" \
            --svg "$out/v.svg" --against "$out/w.kern" \
            examples/structures/irregular-wall.kern &&
        grep -q "sideways reserve" "$out/film.svg" &&
        $judge svg "$out"/{film,w,v}.svg || return 1
    for bad in "" "--irregularity 99" "--threshold no=1 x" "no-such-file" \
        "--irregularity 10 --walls 1.5" "--planner x" "a b"; do
        # shellcheck disable=SC2086
        "$stack" $bad 2>"$out/e"
        [ $? -eq 2 ] && [ -s "$out/e" ] || return 1
        i=$((i + 1))
    done
    [ "$i" -eq 7 ]
}

walls() { # Figs. 8 and 9, a small version; who wins is not judged
    local walls
    walls=$(program walls examples/laboratory/walls.c) &&
        mkdir -p "$out/walls" "$out/settled/walls" &&
        "$walls" --quick "$out" 2>/dev/null && $judge walls "$out" &&
        "$walls" --quick --settled "$out/settled" 2>/dev/null &&
        [ "$(wc -l <"$out/settled/walls.csv")" -eq 21 ] &&
        $judge svg "$out"/settled/fig{8,9}.svg
}

kept() { # no picture is written over a structure
    local shake stack
    shake=$(program shake examples/laboratory/shake.c) &&
        stack=$(program stack examples/laboratory/stack.c) &&
        keeps "$shake --svg" "$shake --film" \
            "$stack --irregularity 10 --svg" "$stack --irregularity 10 --film"
}

run_check "$@"
