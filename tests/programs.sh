#!/usr/bin/env bash
# bash tests/programs.sh CHECK ...    the programs of examples/, as the README
#                                     builds them
. "$(dirname "$0")/lib.sh"

# ---- as the README has it

in_a_copy() { # in_a_copy FILE: runs commands where nothing was built
    cp -r . "$out/fresh" &&
        (cd "$out/fresh" && timeout 300 bash -e "$1")
}

readme() { # its commands, and its figures
    awk '/^```sh/ { on = 1; next } /^```/ { on = 0 } on' README.md \
        >"$out/readme.sh"
    grep -q kern_test "$out/readme.sh" && in_a_copy "$out/readme.sh" &&
        python3 tests/figures.py
}

block_of() { # block_of WORD: the block of code in README with that word
    awk -v word="$1" '/^```/ { if (on && index(text, word)) printf "%s", text
        on = !on; text = ""; next } on { text = text $0 "\n" }' README.md
}

three_stones() { # a report, of which it has some lines; its file, its programs
    local kern
    kern=$(program kern examples/kern.c) || return 1
    block_of "block beam" >"$out/mine.kern"
    block_of "int main" >"$out/mine.c"
    { echo '#define KERN_IMPLEMENTATION'
      echo '#include "examples/copy/wall.hpp"'
      echo '#include <cstdio>'
      echo 'int main() {' && block_of "kern::Wall" && echo '}'; } >"$out/mine.cpp"
    block_of "irregular-wall.kern: stands" >"$out/lines"
    "$kern" examples/structures/irregular-wall.kern |
        diff - tests/report.txt || return 1
    [ -s "$out/lines" ] && ! diff tests/report.txt "$out/lines" | grep "^>" ||
        { echo "these lines of README are not in the report"; return 1; }
    "$kern" --svg "$out/mine.svg" "$out/mine.kern" | grep -q ": stands" &&
        $judge svg "$out/mine.svg" &&
        gcc -std=c99 -Wall -Wextra -Werror -I. -o "$out/mine" "$out/mine.c" \
            -lm && "$out/mine" | grep -qx "stands, margin 0.5 m" &&
        g++ -std=c++17 -Wall -Wextra -Werror -I. -o "$out/places" \
            "$out/mine.cpp" && [ "$("$out/places" | wc -l)" -gt 20 ]
}

firmware() { # its commands; ticks, stack and flash are not compared. The page
    # says what the program's comment does
    awk '/^```sh/ { on = 1; next } /^```/ { on = 0 } on' \
        examples/firmware/README.md >"$out/firmware.sh"
    grep -q qemu-system-arm "$out/firmware.sh" || return 1
    in_a_copy "$out/firmware.sh" >"$out/firmware.out" 2>&1 || return 1
    awk '/^\/\* Output,/ { on = 1; next } /^\*\// { on = 0 } on' \
        examples/firmware/main.c >"$out/firmware.want"
    diff "$out/firmware.want" \
        <(grep -A 15 '^wall of 30 stones:' examples/firmware/README.md) &&
        diff <(sed 's/[0-9]* ticks/N ticks/; /variables/d' \
            "$out/firmware.want") \
            <(sed 's/[0-9]* ticks/N ticks/; /variables/d' "$out/firmware.out")
}

# ---- programs a stranger copies

output() { # output FILE: what it prints is the comment at its end
    local run
    run=$(program "$(basename "$1" .c)" "$1") && "$run" >"$out/got" || return 1
    awk '/^\/\* Output:/ { on = 1; next } /^\*\// { on = 0 } on' \
        "$1" >"$out/want"
    diff "$out/want" "$out/got"
}

outputs() { # of every program with such a comment
    local file
    for file in examples/copy/*.c examples/{place,push,nudge}.c; do
        output "$file" || { echo "FAILED: $file"; return 1; }
    done
}

structures() { # every file of examples/structures, and which one falls
    local kern
    kern=$(program kern examples/kern.c) || return 1
    "$kern" --json --forces --mechanism examples/structures/*.kern \
        >"$out/all.json"
    [ $? -le 1 ] && $judge structures "$out/all.json"
}

profiles() { # the least of a profile is the measure
    local kern
    kern=$(program kern examples/kern.c) || return 1
    "$kern" --json --profile examples/structures/*.kern >"$out/all.json"
    $judge profiles "$out/all.json"
}

bad_input() { # a bad file is reported, the next analysed
    local kern
    kern=$(program kern examples/kern.c) || return 1
    printf 'block a * 0 0 1 0 1\n' >"$out/bad.kern"
    "$kern" "$out/bad.kern" examples/structures/three-boxes.kern \
        >"$out/o" 2>"$out/e"
    [ $? -eq 2 ] && grep -q "bad.kern:1:" "$out/e" && grep -q stands "$out/o"
}

refuses() { # refuses WORDS OPTIONS...: kern does, with these words and nothing
    local words=$1 kern # on stdout
    shift
    kern=$(program kern examples/kern.c) || return 1
    "$kern" "$@" >"$out/o" 2>"$out/e"
    [ $? -eq 2 ] && [ ! -s "$out/o" ] && [ "$(wc -l <"$out/e")" -eq 1 ] &&
        grep -qF -- "$words" "$out/e" ||
        { echo "kern $*: not '$words'"; cat "$out/o" "$out/e"; return 1; }
}

ranges() { # numbers that cannot be meant are refused with their option; whole
    # files, of blocks .677 in size and contacts up to 1.4 long
    local tower=examples/structures/tower.kern size mean angle kern
    size="takes a length up to the mean size of the blocks, 0.677, read"
    mean="takes a length up to a fifth of the mean size of the blocks, 0.1354"
    angle="takes an angle in radians from 0 to below 0.5, read"
    sed 's/^friction/epsilon 5\nfriction/' "$tower" >"$out/step.kern"
    refuses "$tower: --gap $size 1e+09" --gap 1e9 $tower &&
        refuses "$tower: --overlap $size 0.7" --overlap .7 $tower &&
        refuses "$tower: --error $size 0.7" --error .7 $tower &&
        refuses "$tower: --measured $mean, read 0.2" --measured .2 $tower &&
        refuses "kern: --measured $angle '10'" --measured .005,10 $tower &&
        refuses "kern: --error $angle '0.5'" --error .005,0.5 $tower &&
        refuses "$tower: --at takes a length up to 0.7, at" --at .71 $tower &&
        refuses "$tower: --epsilon takes a length up to 0.7, at" -e 1 $tower &&
        refuses "step.kern:3: epsilon takes a length up to" "$out/step.kern" &&
        refuses "step.kern:3: epsilon takes a share (--relative) up to 1, " \
            -r "$out/step.kern" &&
        refuses "--epsilon takes a share up to 1, read 1.5" -r -e 1.5 $tower &&
        refuses "--at takes a share up to 1, read 2" -r --at 2 $tower &&
        refuses "1 to 2,000,000,000, or 0, read '1.5'" --limit 1.5 $tower &&
        refuses "from 1 to 10,000, read '2.5'" --sweep 2.5 $tower &&
        refuses "tower.kern: not one free block" --place $tower $tower ||
        return 1
    # what makes sense is not, in other units either
    kern=$(program kern examples/kern.c) &&
        sed 's/^friction/epsilon 0.7\nfriction/' "$tower" >"$out/step.kern" &&
        "$kern" --gap .1 --at .7 --epsilon .7 "$tower" >"$out/o"
    [ $? -eq 1 ] && "$kern" -r "$out/step.kern" >"$out/o" &&
        "$kern" --measured .1,.1 --error .1,.4 --overlap .6 --limit 0 "$tower" \
            >"$out/o" && awk '$1 == "fixed" || $1 == "block" {
                for (i = $1 == "fixed" ? 3 : 4; i <= NF; i++) $i *= 1000
            } { print }' "$tower" >"$out/mm.kern" &&
        "$kern" --gap 1 --epsilon 10 --measured 5 --at 200 "$out/mm.kern" \
            >"$out/o" && grep -q 'margin  *320.9' "$out/o"
}

robot() { # the error of a robot, in place alone as well: margin / 2E; with
    # --relative the error is a length as well, and the number the same
    local kern mode tower=examples/structures/tower.kern
    kern=$(program kern examples/kern.c) || return 1
    "$kern" --error .01 "$tower" | grep '^  bears  *16.04 ' || return 1
    for mode in "" --relative "--relative --epsilon .5"; do
        # shellcheck disable=SC2086
        "$kern" --error .01,.01 $mode "$tower" | grep '^  bears  *16.04 ' ||
            return 1
    done
}

keys() { # every key of the JSON stands in the help
    local kern
    kern=$(program kern examples/kern.c) || return 1
    echo 'block stone * 0 0 .6 0 .7 .3 .1 .4' >"$out/stone.kern"
    "$kern" --json --forces --mechanism --profile --near --raised --sequence \
        --place "$out/stone.kern" --most 2 --stays all --error 0.01 --measured 0.001 \
        examples/structures/{falls,tower}.kern >"$out/all.json"
    [ $? -eq 1 ] && "$kern" --help >"$out/help" &&
        $judge keys "$out/all.json" "$out/help"
}

arrays() { # a structure as C arrays has the margin that the program prints
    local kern file name
    kern=$(program kern examples/kern.c) || return 1
    # shellcheck disable=SC2086
    gcc $plain -DKERN_IMPLEMENTATION -x c -c kern.h -o "$out/lib.o" || return 1
    for file in examples/structures/*.kern; do
        name=$(basename "$file" .kern)
        "$kern" --json --c "$out/$name.h" "$file" |
            sed 's/.*"margin": \([^,]*\),.*/\1/' >"$out/want"
        name=$(echo "$name" | tr - _)
        {
            echo '#include <stdio.h>'
            echo "#include \"$(basename "$file" .kern).h\""
            echo "enum { B = ${name^^}_BLOCKS, C = ${name^^}_CONTACTS };"
            echo 'static kern_real real[KERN_REALS(B, C)];'
            echo 'static int index[KERN_INTS(B, C)];'
            echo 'int main(void) {'
            echo '    kern_work work = kern_work_of(real, KERN_REALS(B, C),'
            echo '                                  index, KERN_INTS(B, C));'
            echo "    kern_task task = ${name}_task(&work);"
            echo '    kern_margin m;'
            echo '    kern_measure(&task, &m, NULL);'
            echo '    printf("%.17g\n", (double)m.margin);'
            echo '    return 0;'
            echo '}'
        } >"$out/arrays.c"
        # shellcheck disable=SC2086
        gcc $plain -I. -I"$out" "$out/arrays.c" "$out/lib.o" -o "$out/arrays" \
            -lm &&
            "$out/arrays" >"$out/got" &&
            gcc $plain -Wfloat-conversion -DKERN_SINGLE -I. -I"$out" \
                -fsyntax-only "$out/arrays.c" &&
            python3 -c 'import sys; sys.exit(float(sys.argv[1]) != float(
                sys.argv[2]))' "$(cat "$out/want")" "$(cat "$out/got")" ||
            { echo "$file: $(cat "$out/want") $(cat "$out/got")"; return 1; }
    done
    ! "$kern" --c examples/structures/tower.kern "$file" 2>"$out/e"
}

each_block() { # every block in the order of the file, with its chance; the last
    # one's is that of --stays NAME
    local kern file last
    kern=$(program kern examples/kern.c) || return 1
    for file in examples/structures/{tower,falls,arch}.kern; do
        last=$(awk '$1 == "block" { name = $2 } END { print name }' "$file")
        "$kern" --json --stays all "$file" >"$out/each.json"
        "$kern" --json --stays "$last" "$file" >"$out/last.json"
        $judge each_block "$out"/{each,last}.json "$file" || return 1
    done
    "$kern" --stays all examples/structures/tower.kern >"$out/o" &&
        [ "$(grep -c '^  stays  ' "$out/o")" -eq 10 ]
}

open() { # open KEY VALUE OPTIONS...: with these it is undecided, the status 3
    local key=$1 value=$2 kern
    shift 2
    kern=$(program kern examples/kern.c) || return 1
    "$kern" --json "$@" >"$out/o"
    [ $? -eq 3 ] && $judge undecided "$key" "$value" "$out/o"
}

undecided() { # by the limit of work: what is missing is named; of what is asked
    # for in vain there is a message alone
    local tower=examples/structures/tower.kern axle kern
    kern=$(program kern examples/kern.c) && axle=$out/axle.kern &&
        { cat examples/structures/arch.kern; echo live v7 0 -9 -5 9; } >"$axle"
    open raised raised --raised --limit 120 $tower &&
        open raised_load_left raised_load_left --raised --limit 300 $tower &&
        open certain certain --measured .001 --limit 100 $tower &&
        open bears bears --error .01 --limit 1 $tower &&
        open least_friction least_friction --error .01 --limit 1 $tower &&
        open sequence margin --sequence --limit 1 $tower &&
        open stays stays --stays stone9 --limit 20 $tower &&
        open stays stays --stays all --limit 20 $tower &&
        open sweep live --sweep 7 --limit 300 "$axle" || return 1
    "$kern" --stays all --sequence --limit 1 $tower >"$out/o"
    [ "$(grep -c undecided "$out/o")" -eq 23 ] && ! grep -w nan "$out/o" &&
        sed '$agravity 0 0\nload stone10 0 -1 0 4' $tower >"$out/no.kern" &&
        refuses "--stays: there is no gravity" --stays all "$out/no.kern" &&
        refuses "there is no free block 'ground'" --stays ground $tower
}

unheard() { # options that a file or another option leaves without effect
    local kern tower=examples/structures/tower.kern
    local given=examples/structures/explicit.kern all
    kern=$(program kern examples/kern.c) || return 1
    all="--near --lone --gap .01 --overlap .01 --measured .01"
    # shellcheck disable=SC2086
    "$kern" $all $given >"$out/o" && ! grep -q '^  near contacts' "$out/o" &&
        grep -q "without effect: $(echo "$all" | sed 's/ [.]01//g')\$" \
            "$out/o" &&
        "$kern" --json --near $given | grep -q '"near": false' || return 1
    ! "$kern" $given | grep -q 'without effect' &&
        "$kern" --at .1 --measured .001 $tower | grep -q 'not told with --at' &&
        "$kern" --near $tower | grep -q 'not in the verdict above$' &&
        "$kern" --near --raised $tower | grep -q 'nor in what --raised' &&
        "$kern" --json --near $tower | grep -q '"near": true' || return 1
    refuses "--mechanism live: no live load" --mechanism live $tower
}

live() { # live loads, weight that is no stone, and loads that stay
    local kern
    kern=$(program kern examples/kern.c) || return 1
    {   # a wall 1 wide tips over its corner under a push at the height of 2:
        # 2 M g .5 = f 2
        printf 'friction 2\ngravity 0 -10\n'
        printf 'fixed g -3 -1 3 -1 3 0 -3 0\nblock a 2 0 0 1 0 1 2 0 2\n'
    } >"$out/wall.kern"
    { cat "$out/wall.kern"; echo live a 1 0 0.5 2; } >"$out/live.kern"
    { cat "$out/wall.kern"; echo mass a 2 0.5 2; } >"$out/mass.kern"
    { cat "$out/wall.kern"; echo load a 0 -20 0.5 2; } >"$out/load.kern"
    {   # the same weight in all, its centre at (2 1 + 2 2) / 4
        sed 's/block a 2/block a 4/' "$out/wall.kern"
        echo com a 0.5 1.5
    } >"$out/heavy.kern"
    "$kern" --raised --mechanism live "$out/live.kern" >"$out/o" || return 1
    grep -q '^  live        \[0, 5\]: ' "$out/o" && grep -q '^  live limit  \[0, 5\]: limit' "$out/o" &&
        grep -q ' -0.70711$' "$out/o" || return 1
    "$kern" --json --raised "$out"/{live,mass,heavy,load}.kern >"$out/live.json"
    "$kern" --help >"$out/help" && $judge keys "$out/live.json" "$out/help" &&
        [ "$(grep -c '"load_right": 0.3333333333' "$out/live.json")" -eq 2 ] &&
        [ "$(grep -c '"loads_stay": true' "$out/live.json")" -eq 1 ] &&
        "$kern" "$out/load.kern" | grep -q 'loads stay as they are' || return 1
    echo 'live g 1 0 0 0' >>"$out/live.kern"
    "$kern" "$out/live.kern" 2>&1 | grep -q 'live.kern:6: live: a block that is'
}

usage() { # one page, topics that make up the whole, and what a word may mean
    local kern topic word
    kern=$(program kern examples/kern.c) || return 1
    "$kern" -h >"$out/brief" && "$kern" --help >"$out/whole" || return 1
    [ "$(wc -l <"$out/brief")" -le 25 ] || return 1
    for word in $(grep -o -- '--[a-z]*' "$out/brief"); do
        grep -q -- "$word" "$out/whole" || { echo "not in --help: $word"; return 1; }
    done
    for topic in asks drawing taken written format json; do
        "$kern" --help $topic >"$out/topic" && [ -s "$out/topic" ] &&
            grep -qF "$(head -n 1 "$out/topic")" "$out/whole" &&
            [ "$(wc -l <"$out/topic")" -lt 130 ] || { echo $topic; return 1; }
    done
    refuses "--help takes asks" --help nothing &&
        refuses "unknown option --sequense; --sequence?" --sequense a.kern &&
        refuses "unknown option --xyzzy; try" --xyzzy a.kern &&
        refuses "unknown option --sgv; --svg?" --sgv a.svg a.kern &&
        refuses "makes a PNG" --svg wall.png a.kern &&
        [ "$("$kern" -V)" = "$("$kern" --version)" ] || return 1
    printf '\211PNG\r\n' >"$out/wall.png" && printf '%%PDF-1.4' >"$out/a.pdf" &&
        refuses "wall.png: a picture, which has no outlines: draw a polygon" \
            "$out/wall.png" &&
        refuses "a.pdf: a PDF, which is not read: save it as DXF" "$out/a.pdf" ||
        return 1
    "$kern" --limit 5 examples/structures/arch.kern |
        grep -q '^  undecided   the limit of work'
}

let_go() { # the whole structure let go, by textbook answers and by laws
    local kern slope=examples/structures/toppling-slope.kern
    kern=$(program kern examples/kern.c) || return 1
    mkdir -p "$out/let-go" && $judge let_go_files $slope "$out/let-go" &&
        "$kern" --json --error .01 --raised --stays all $slope \
            examples/structures/ladder.kern "$out"/let-go/*.kern \
            >"$out/let-go.json"
    [ $? -le 1 ] && $judge let_go "$out/let-go.json" || return 1
    "$kern" "$out/let-go/slope-above.kern" >"$out/o" &&
        grep -q '^  let go      stays ' "$out/o" &&
        grep -q '^  load  .* Coulomb friction bears as it grows from 0$' "$out/o" &&
        grep -q '^  load limit .* too high' "$out/o" || return 1
    # loads that differ by less than a per cent are two in report, page and JSON
    "$kern" --report "$out/two.html" examples/structures/prestwood.kern >"$out/o"
    grep -q '^  load        0.5945 left, 0.5945 right: .* (without the live' "$out/o" &&
        grep -q '^  load limit  0.5982 left, 0.5982 right: limit analysis$' \
            "$out/o" && grep -q '<td>0.5945 left, 0.5945 right' "$out/two.html" &&
        grep -q '<td>0.5982 left, 0.5982 right' "$out/two.html" &&
        "$kern" --json examples/structures/prestwood.kern |
        grep '"load_left": 0.5982' | grep -q '"raised_load_left": 0.5944' &&
        says 'load limit  0.1339 left, 0.123 right: horizontal load, in g, by' \
            --near examples/structures/irregular-wall.kern || return 1
    "$kern" --stays all examples/structures/falls.kern >"$out/o"
    [ "$(grep -c '^  stays ' "$out/o")" -eq 1 ] &&
        grep -q '^  stays       no: the whole structure falls' "$out/o"
}

sweep() { # as an ordinary load at its place and on its block, what --sweep says
    # stands when it is smaller by 1e-6, and falls when it is larger
    local kern arch=examples/structures/arch.kern
    kern=$(program kern examples/kern.c) || return 1
    { cat "$arch"; echo live v7 0 -100 -5 9; } >"$out/axle.kern"
    "$kern" --json --raised --sweep 13 --svg "$out/axle.svg" \
        "$out/axle.kern" >"$out/axle.json" && mkdir -p "$out/axles" &&
        $judge axles "$out/axle.json" "$arch" "$out/axles" || return 1
    "$kern" --verdict "$out"/axles/stands-*.kern >"$out/o" || return 1
    grep -q '^12 files: 12 stand' "$out/o" || return 1
    "$kern" --verdict "$out"/axles/falls-*.kern >"$out/o"
    grep -q '^12 files: 0 stand, 12 fall' "$out/o" || return 1
    "$kern" --help >"$out/help" && $judge keys "$out/axle.json" "$out/help" &&
        $judge svg "$out"/axle*.svg && [ -s "$out/axle-sweep.svg" ] || return 1
    grep -q 'live load' "$out/axle.svg" && ! grep -q '>mass<' "$out/axle.svg" &&
        { cat "$arch"; echo mass v7 9 -5 9; } >"$out/fill.kern" &&
        "$kern" --svg "$out/fill.svg" "$out/fill.kern" >"$out/o" &&
        grep -q '>mass<' "$out/fill.svg" &&
        ! grep -q 'live load' "$out/fill.svg" || return 1
    refuses 'no live load' --sweep 3 "$arch" || return 1
    # a beam of 10 on a pier below its middle half tips under 10 at its end: that
    # comes first, though the file has the load where it may have any factor
    printf '%s\n' 'gravity 0 -1' 'friction .6' 'fixed g 1 -1 3 -1 3 0 1 0' \
        'block beam 10 0 0 4 0 4 1 0 1' 'live beam 0 -1 2 1' >"$out/beam.kern"
    "$kern" --sweep 9 --report "$out/beam.html" "$out/beam.kern" >"$out/o" &&
        grep -q 'worst place 10        least factor, with the live load at x' \
            "$out/o" &&
        says ' 1.11111           1         any         any  beam' --sweep 9 \
            "$out/beam.kern" &&
        grep -q 'The factor that governs is 10, with' "$out/beam.html" &&
        grep -A3 '<h2>Results' "$out/beam.html" |
        grep -q 'worst place</th><td>10</td>' &&
        grep -q '<td>0 to any</td><td>factors at which it stays' \
            "$out/beam.html" &&
        grep -q 'g bears it with 0 to the right and 10 up' "$out/beam.html" &&
        grep -q 'g bears it with 0 to the right and 11 up' "$out/beam.html" &&
        grep -q '<td>5</td><td>between g and beam' "$out/beam.html" &&
        grep -q '<td>5.5</td><td>between g and beam' "$out/beam.html" || return 1
    # the worst place is found from few places as from many
    for axle in "live v7 0 -100 -5 9" "axle -5 100 1"; do
        { cat "$arch"; echo "$axle"; } >"$out/axle.kern"
        for places in 3 40 1000; do
            "$kern" --json --sweep $places "$out/axle.kern"
        done >"$out/worst.json"
        $judge worst "$out/worst.json" || return 1
    done
    sed 's/^axle.*/axle -1.6375 60 0.3/' examples/structures/prestwood.kern \
        >"$out/axle.kern"
    for places in 1 40 500; do
        "$kern" --json --sweep $places "$out/axle.kern"
    done >"$out/worst.json"
    $judge worst "$out/worst.json"
}

says() { # says WORDS OPTIONS...: kern does, on stdout
    local words=$1
    shift
    "$kern" "$@" | grep -qF -- "$words" ||
        { echo "kern $*: not '$words'"; "$kern" "$@"; return 1; }
}

axles() { # axles OUT: what bears an axle on fill
    # a beam on two piers: each crushes at its foot, .5 wide, under 464 of the
    # beam, so the axle may grow to (928 - 57.6 - 32) / 100. What lies in the shade
    # of the beam bears nothing of it
    printf '%s\n' 'gravity 0 -1' 'density 24' 'fixed ground -5 -1 10 -1 10 0 -5 0' \
        'block p * 0 0 .5 0 .5 3 0 3' 'block q * 3.5 0 4 0 4 3 3.5 3' \
        'block beam * 0 3 4 3 4 3.6 0 3.6' 'strength 1000' 'fill 4 20' \
        >"$1/bare.kern"
    { cat "$1/bare.kern" && echo axle 2 100 .3; } >"$1/beam.kern" &&
        says 'live limit  [0, 8.384]: limit' "$1/beam.kern" &&
        ! "$kern" "$1/beam.kern" | grep 'no free block' &&
        { cat "$1/beam.kern" && echo 'block s * 1 0 3 0 3 1 1 1'; } \
            >"$1/shade.kern" && says '[0, 8.384]: limit' "$1/shade.kern" || return 1
    # at 1 of its 4 it presses 3/4 on one pier; mirrored on the other
    { cat "$1/bare.kern" && echo axle 1 100 .3; } >"$1/left.kern" &&
        { cat "$1/bare.kern" && echo axle 3 100 .3; } >"$1/right.kern" &&
        "$kern" --json "$1/left.kern" | grep -o '"live": [0-9.]*' >"$1/one" &&
        "$kern" --json "$1/right.kern" | grep -o '"live": [0-9.]*' >"$1/two" &&
        cmp "$1/one" "$1/two" || return 1
    # over a gap .2 wide and 3 deep a line load loses its share of 1.909 degrees,
    # (.03332 + .03330) / (.5236 + .4330) = .0696; a stone cut in two is as one
    printf '%s\n' 'gravity 0 -1' 'fixed ground -5 -1 10 -1 10 0 -5 0' 'fill 3 20' \
        'strength 1000' >"$1/floor.kern"
    { cat "$1/floor.kern" && printf '%s\n' 'block a * 0 0 1.9 0 1.9 2 0 2' \
        'block b * 2.1 0 4 0 4 2 2.1 2' 'axle 2 100'; } >"$1/gap.kern" &&
        says '6.98 % of the axles reaches no free block' "$1/gap.kern" &&
        { cat "$1/floor.kern" && printf '%s\n' 'block a * 0 0 4 0 4 2 0 2' \
            'axle 1.2 100 .5'; } >"$1/whole.kern" &&
        { cat "$1/floor.kern" && printf '%s\n' 'block a * 0 0 4 0 4 1 0 1' \
            'block b * 0 1 4 1 4 2 0 2' 'axle 1.2 100 .5'; } >"$1/cut.kern" &&
        "$kern" --json "$1/whole.kern" | grep -o '"live": [0-9.]*' >"$1/one" &&
        "$kern" --json "$1/cut.kern" | grep -o '"live": [0-9.]*' >"$1/two" &&
        cmp "$1/one" "$1/two" || return 1
    # it drives from .25 + 3 tan 30 beside the stone to as far behind it
    says '    -1.58385           0 ' --sweep 10 "$1/whole.kern"
}

passive() { # passive OUT BRIDGE: what counts on the passive pressure of fill says so,
    # and beside it stands what the same file says whose fill has no phi
    sed 's/^axle.*/axle -1.5 60 .3/' "$2" >"$1/axle.kern"
    { cat "$1/axle.kern" && echo strength 1500; } >"$1/crush.kern"
    sed 's/^fill/prop v8 -1 0 -2.25 1.05 9\n&/' "$1/axle.kern" >"$1/prop.kern"
    { cat "$1/axle.kern" && echo 'prop v8 -1 0 -2.25 1.05 9'; } >"$1/last.kern"
    for f in axle crush prop last; do
        sed 's/ phi 37//' "$1/$f.kern" >"$1/$f-weight.kern" &&
            "$kern" --json --sweep 6 "$1/$f.kern" "$1/$f-weight.kern" \
                >"$1/passive.json" && $judge without "$1/passive.json" || return 1
    done
    says '0.9854]: factors of the live load at which it stays when it is let go, with the' \
        "$2" && says 'no passive  [0, 0.525]: rely on these factors of the' "$2" &&
        "$kern" --sweep 6 --svg "$1/passive.svg" --report "$1/passive.html" \
            "$1/axle.kern" >"$1/o" && $judge svg "$1"/passive*.svg &&
        grep -q '^  warning     as the live load drives over, it falls' "$1/o" &&
        grep -q 'worst place 0.8633 .*, with the full passive pressure of the fill' \
            "$1/o" && grep -q 'no passive  0.5095 .* without the passive' "$1/o" &&
        grep -q 'worst place, factor 0.5095 without passive pressure; ' \
            "$1/passive.html" && grep -q '>worst place<' "$1/passive.svg" || return 1
    # the factor to rely on is told first: in report, headline and table
    for words in 'no passive  [' 'live        [' 'no passive  0.5095    rely on' \
        'worst place 0.8633'; do
        grep -nF "  $words" "$1/o" || { echo "not '$words'"; return 1; }
    done | sort -nc -t: -k1,1 &&
        grep -q 'governs is 0.5095, with .*without the passive pressure of the' \
            "$1/passive.html" &&
        grep -q 'With all of that pressure it would be 0.8633, at' \
            "$1/passive.html" && grep -A1 '<td>0.5095</td>.*, without the passive' \
            "$1/passive.html" |
        grep -q '^<tr><th>with passive pressure</th><td>0.8633</td>' &&
        grep -A1 '<td>0 to 0.[0-9]*</td>.*, without the passive pressure' \
            "$1/passive.html" |
        grep -q '^<tr><th>with passive pressure</th><td>0 to ' || return 1
    # so do the warnings: one axle that only this pressure bears at its worst place
    sed 's/^axle.*/axle 0 40 .3/' "$2" >"$1/worst.kern" &&
        says 'of the fill its least factor is below 1 as the live load drives' \
            --sweep 6 "$1/worst.kern" || return 1
    # a dead load that only this pressure holds is the first thing said
    { cat "$2" && echo load v12 0 -40 -1.6 1.4; } >"$1/drop.kern" &&
        says 'no passive  none      no factor is known, without the passive' \
            --sweep 2 "$1/drop.kern" || return 1
    { grep -v ^axle "$2" && echo load v12 0 -40 -1.6 1.4; } >"$1/dead.kern"
    "$kern" --report "$1/dead.html" "$1/dead.kern" >"$1/o" &&
        sed -n 3p "$1/o" |
        grep -q '^  warning     without the passive pressure of the fill it falls$' &&
        grep -q '<p class="verdict">.* Without the passive .* it falls\.</p>' \
            "$1/dead.html"
}

soil() { # a bridge with backfill and a retaining wall, from their files alone
    local kern bridge=examples/structures/prestwood.kern
    local wall=examples/structures/retaining-wall.kern
    kern=$(program kern examples/kern.c) || return 1
    # of the load that was measured; and with stone of 5 MPa, and the bare ring
    says '[0, 0.9854]: factors' $bridge &&
        says 'fill        weighs 86.34 kN about (0, ' $bridge &&
        { cat $bridge; echo strength 5000; } >"$out/crush.kern" &&
        says '[0, 0.8394]: factors' "$out/crush.kern" &&
        grep -v ^fill $bridge >"$out/bare.kern" &&
        says '[0, 0.2092]: factors' "$out/bare.kern" || return 1
    # K = .2444 of Coulomb, 57 kN/m level; tests/REALITY.md: falls at 25.2 feet
    says 'earth       57 kN to the left and 24.59 kN down, ' $wall &&
        says '(1.626, 2.032), on 20 faces; K = 0.2444, phi 35, delta 23.33' $wall &&
        sed 's/^earth right 6.096/earth right 7.66/' $wall >"$out/high.kern" &&
        "$kern" --verdict "$out/high.kern" | grep -q stands &&
        sed 's/^earth right 6.096/earth right 7.7/' $wall >"$out/high.kern" &&
        ! "$kern" --verdict "$out/high.kern" >"$out/o" || return 1
    # as a live load its pressure may grow by the factor by which its weight may
    sed 's/^earth.*/& live/' $wall >"$out/live.kern" &&
        says ', on 20 faces: live load' "$out/live.kern" &&
        says '[0, 1.924]: factors' "$out/live.kern" &&
        sed 's/13.67/26.28/' $wall >"$out/heavy.kern" &&
        "$kern" --verdict "$out/heavy.kern" | grep -q stands &&
        sed 's/13.67/26.33/' $wall >"$out/heavy.kern" &&
        ! "$kern" --verdict "$out/heavy.kern" >"$out/o" || return 1
    # about the toe the wall, 22.3 6.5443, and the earth on its back, 24.59 1.6256,
    # are 1.605 of 57 2.032; the whole thrust is 1.924. The lower comes first; each
    # with how the wall falls: over its toe, or with a friction of .42, that bears
    # .42 162.7 of 57, on its lowest bed
    says 'Rely on this factor: it compares forces and moments as a design does' $wall &&
        "$kern" $wall | grep -A 3 '^  earth grows' | cut -c1-58 | diff - <(
            over='    beyond it course1 to course20 tipping left about (0, 0'
            echo '  earth grows 1.605     times the horizontal part of its t'
            echo "$over"
            echo '  earth grows 1.924     times the whole thrust, horizontal'
            echo "$over") &&
        sed 's/^friction .*/friction .42/' $wall >"$out/slides.kern" &&
        says 'earth grows 1.199     times the horizontal' "$out/slides.kern" &&
        says 'course20 sliding left on the bed between ground and course1' \
            "$out/slides.kern" &&
        sed 's/^earth.*/& surcharge 10/' $wall >"$out/surcharge.kern" &&
        says 'delta 23.33; surcharge 10 kN/m2' "$out/surcharge.kern" || return 1
    # below a back that leans over it, earth lifts the wall and its whole thrust
    # governs: about the toe 20 1 of 1.888 1 and .6292 1.333
    printf '%s\n' 'gravity 0 -1' 'friction 2' 'fixed g -3 -1 5 -1 5 0 -3 0' \
        'block w 20 0 0 1 0 2 3 1 3' 'earth right 3 2 30 0' >"$out/lean.kern"
    "$kern" "$out/lean.kern" | grep -m 1 '^  earth grows' |
        grep -q ' 7.335  .* limit analysis 7.335. Rely on this factor$' || return 1
        "$kern" --json $wall |
        grep -q '"earth": 1.9238.*, "earth_horizontal": 1.6050' &&
        says 'on 20 faces: live load, its vertical part as well' \
            "$out/live.kern" &&
        sed 's/23.3333/0/' $wall >"$out/level.kern" &&
        says 'times the whole thrust, when it is let go' "$out/level.kern" &&
        ! "$kern" "$out/level.kern" | grep 'earth grows .* horizontal' || return 1
    # a stone 1 wide and 2 tall of the weight 20 crushes by 20 / (2 40) at its toe
    printf '%s\n' 'gravity 0 -10' 'fixed g -3 -1 3 -1 3 0 -3 0' 'friction 2' \
        'block a 2 0 0 1 0 1 2 0 2' 'live a 1 0 0 2' 'strength 40' \
        >"$out/toe.kern"
    says '[0, 2.5]: factors' "$out/toe.kern" &&
        says 'moved in by up to 0.25 ' "$out/toe.kern" || return 1
    # and under a pressure that all of it cannot bear, rest or live, central or not
    sed 's/^strength.*/strength 19/' "$out/toe.kern" >"$out/weak.kern" &&
        says 'weak.kern: falls (crushes)' "$out/weak.kern" &&
        says 'let go      moves' "$out/weak.kern" &&
        says 'a bears on nothing: its contact with g crushed' "$out/weak.kern" &&
        { cat "$out/toe.kern" && echo 'block t 1 .4 3 .5 2 .6 3'; } \
            >"$out/tip.kern" &&
        says 'not applied to 1 point contact, which has no width' \
            "$out/tip.kern" &&
        "$kern" --json "$out/tip.kern" | grep -q '"strength": 40, "crushed": 0' &&
        ! "$kern" --json "$out/weak.kern" >"$out/weak.json" &&
        grep -q '"crushes": true' "$out/weak.json" &&
        "$kern" --help >"$out/help" &&
        $judge keys "$out/weak.json" "$out/help" &&
        sed 's/^live.*/live a 0 -1 .5 2/' "$out/toe.kern" >"$out/press.kern" &&
        says 'live limit  [0, 20]: limit' "$out/press.kern" &&
        says 'live        [0, 20]: factors' "$out/press.kern" &&
        sed 's/^live.*/live a 0 -1 .75 2/' "$out/toe.kern" >"$out/press.kern" &&
        says '[0, 12.36]: factors' "$out/press.kern" || return 1
    # a bed is all of a contact: pressed at 1/3, by 200 on the toe of the wall
    printf '%s\n' 'gravity 0 -1' 'friction .6' 'density 24' \
        'fixed ground -5 -1 10 -1 10 0 -5 0' 'block w * 0 0 2 0 2 4 0 4' \
        'earth right 4 18 30 0 water 0 10' 'strength 200' >"$out/bed.kern"
    says '192       -48   0.167         0 (2, 0)                   192 (0, 0)' \
        --forces "$out/bed.kern" &&
        says 'stress      144 ' "$out/bed.kern" &&
        says 'uplift of the water under the wall' "$out/bed.kern" || return 1
    # a corner that touches an upright face is no part of the springing, .45 long:
    # of 54207 and 18172 at its ends e is -.2489, the edge 2 72379 / (3 .45 .2511)
    "$kern" --density RING=2100 --density FILL=2000 --phi 37 --mu 0.7 --kern \
        "$out/ring.kern" examples/structures/bridge.dxf >"$out/o" &&
        sed '/^fixed/s/3\.2 2 /2.86 2 /; /^fixed/s/3\.2 0\.27 /2.86 0.27 /' \
            "$out/ring.kern" >"$out/corner.kern" &&
        says '7.238e+04 -1.036e+04  -0.249 4.271e+05 (2.5, 0) ' --forces \
            "$out/corner.kern" || return 1
    # a live surcharge alone: 40 / 3 at 2 up, against 192 at 1 from the toe
    sed '/^strength/d; s/^earth.*/earth right 4 0 30 0 surcharge 10 live/' \
        "$out/bed.kern" >"$out/top.kern" &&
        says 'live limit  [0, 7.2]: limit' "$out/top.kern" &&
        ! "$kern" --mu .7 "$out/top.kern" | grep 'without effect' &&
        says 'without effect: --mu NAME=MU' --mu w=.7 "$out/top.kern" || return 1
    # half of an axle that stands half beside a stone is lost, and says so
    sed '/^earth/d; s/^strength.*/axle 2 100 1/' "$out/bed.kern" \
        >"$out/edge.kern" && says '% of the axles reaches no free block' \
        "$out/edge.kern" || return 1
    axles "$out" && passive "$out" $bridge || return 1
    # mirrored it is the same wall
    sed 's/^earth right/earth left/' $wall | awk '$1 ~ /^(fixed|block)$/ {
        for (i = $1 == "fixed" ? 3 : 4; i < NF; i += 2) $i = -$i } { print }' \
        >"$out/left.kern"
    says '57 kN to the right' "$out/left.kern" &&
        says 'margin      0.2191 m' "$out/left.kern" &&
        "$kern" --json --forces $wall "$out/crush.kern" >"$out/soil.json" &&
        "$kern" --help >"$out/help" && $judge keys "$out/soil.json" "$out/help"
}

drawing() { # LAYER X Y X Y ... a line, as DXF in mm
    awk 'BEGIN { print "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC"
        print "0\nSECTION\n2\nENTITIES" }
    { print "0\nLWPOLYLINE\n8\n" $1 "\n90\n" (NF - 1) / 2 "\n70\n1"
      for (i = 2; i < NF; i += 2) print "10\n" $i * 1000 "\n20\n" $(i + 1) * 1000
    } END { print "0\nENDSEC\n0\nEOF" }'
}

layers() { # fill in layers: each is counted once, from files and from drawings
    local kern f=$out/layers.kern g=$out/layers.dxf
    kern=$(program kern examples/kern.c) || return 1
    # a heel 2 wide at y = 1: 2 (18 1) below 2, 2 (20 1) above
    printf '%s\n' 'gravity 0 -1' 'fixed g -5 -1 8 -1 8 0 -5 0' \
        'block w * 0 0 3 0 3 1 1 1 1 4 0 4' 'fill 2 18' 'fill 3 20' >"$f"
    says 'fill        weighs 36 about (2, 1.5)' "$f" &&
        says 'fill        weighs 40 about (2, 2.5)' "$f" &&
        sed -i 's/^fill 3.*/fill 2 20/' "$f" &&
        refuses 'and nothing is left of this one' "$f" &&
        sed -i 's/^fill 2 18/& from 0 to 2.5/' "$f" &&
        says 'weighs 27 about (1.75, 1.5)' "$f" &&
        says 'weighs 10 about (2.75, 1.5)' "$f" || return 1
    # a slope 2 high: the lower layer pushes back by 3 (10 .5 + 20 2) 1 below 1;
    # the upper weighs 20 (12 - 4 - 1), and is cut at its top where stone is higher
    printf '%s\n' 'gravity 0 -1' 'fixed g -5 -1 8 -1 8 0 -5 0' \
        'block w * 0 0 4 0 0 2' 'fill 1 10 phi 30' 'fill 3 20' >"$f"
    says 'weighs 10 about (3.333, 0.6667) on 1 face; pushes 1 of them back, with up to 135 ' \
        "$f" && says 'weighs 140 about ' "$f" || return 1
    # of a drawing: a layer on a layer; one over a void weighs what is drawn
    local ground='GROUND -5 -1 5 -1 5 0 -5 0' stone='STONE 0 0 1 0 1 1 0 1'
    printf '%s\n' "$ground" "$stone" 'FILL 0 1 1 1 1 2 0 2' \
        'FILL 0 2 1 2 1 3 0 3' | drawing >"$g"
    "$kern" --density 1000 --phi 30 "$g" >"$out/o" &&
        [ "$(grep -c 'fill        weighs 9810 N' "$out/o")" -eq 2 ] || return 1
    printf '%s\n' "$ground" "$stone" 'FILL 0 3 1 3 1 4 0 4' | drawing >"$g"
    # fills that overlap by half count once: 1.5 wide; and slopes of 1
    # each that cross in the middle: 1 + 1 - .5
    printf '%s\n' "$ground" 'STONE 0 0 2 0 2 1 0 1' 'FILL 0 1 1 1 1 2 0 2' \
        'FILL .5 1 1.5 1 1.5 2 .5 2' | drawing >"$out/half.dxf"
    says 'fill        weighs 14.71 kN about (0.75, 1.5) on 1 block' \
        --density 1000 "$out/half.dxf" &&
        says '50 % of it is drawn over other fill, and counts once' \
            "$out/half.dxf" || return 1
    printf '%s\n' "$ground" 'STONE 0 0 2 0 2 1 0 1' 'FILL 0 1 2 1 2 2' \
        'FILL 0 1 2 1 0 2' | drawing >"$out/half.dxf"
    says 'fill        weighs 14.71 kN about (1, 1.389) on 1 block' \
        --density 1000 "$out/half.dxf" || return 1
    printf '%s\n' "$ground" "$stone" 'FILL 0 1 1 1 1 2 0 2' \
        'FILL 1 2 0 2 0 1 1 1' | drawing >"$out/again.dxf"
    says 'skipped     1 outline drawn twice on FILL' --density 1000 --phi 30 \
        "$out/again.dxf" && says 'fill        weighs 9810 N' --density 1000 \
        --phi 30 "$out/again.dxf" || return 1
    says 'fill        weighs 9810 N about (0.5, 3.5) on 1 block' --density 1000 \
        "$g" && { printf '%s\n' 'units m N' 'fixed g -2 -1 3 -1 3 0 -2 0' \
        'block a 5 0 0 1 0 1 2 0 2' 'mass a 1000 .5 2' 'mass a 3000 .5 3'; } >"$f" &&
        says 'mass        weighs 39.24 kN about (0.5, 2.75) in 2 statements' "$f" &&
        "$kern" --json "$f" >"$out/mass.json" &&
        grep -q '"mass_weight": 39240, "mass_x": 0.5, "mass_y": 2.75' \
            "$out/mass.json" && "$kern" --help >"$out/help" &&
        $judge keys "$out/mass.json" "$out/help" || return 1
    "$kern" --density 1000 --phi 30 --kern "$f" "$g" >"$out/o" &&
        grep -q 'its outline differs by 66.7 % from a fill' "$out/o" &&
        grep -q '^mass STONE_2 1000 \|^mass STONE_2 999.99' "$f"
}

swept() { # the least of a sweep is found where no sample has a bound, at the end of
    # a deck: 24 10.8 .3 5 / .4 by the load at it, and at .3 by an axle .2 wide
    local kern n f=$out/deck.kern
    kern=$(program kern examples/kern.c) || return 1
    printf '%s\n' 'gravity 0 -1' 'density 24' 'friction .6' \
        'fixed A 0 -1 1 -1 1 0 0 0' 'fixed B 9 -1 10 -1 10 0 9 0' \
        'block deck * -.4 0 10.4 0 10.4 .3 -.4 .3' >"$f"
    for n in 1 3 10 40; do
        { cat "$f" && echo live deck 0 -1 5 .3; } >"$out/force.kern" &&
            says ' 972  deck  least' --sweep $n "$out/force.kern" &&
            { cat "$f" && echo axle 5 1; } >"$out/axle.kern" &&
            says ' 972  deck  least' --sweep $n "$out/axle.kern" &&
            { cat "$f" && echo axle 5 1 .2; } >"$out/wide.kern" &&
            says ' 1296  deck  least' --sweep $n "$out/wide.kern" || return 1
    done
    # of 400 decks one overhangs by .25 of its length, with three forces on them
    awk 'BEGIN { print "gravity 0 -1\ndensity 24\nfriction .6"
        for (i = 0; i < 400; i++) { d = i == 5 ? .25 : .05
            print "fixed p" i, i + d, -1, i + 1 - d, -1, i + 1 - d, 0, i + d, 0
            print "block d" i, "*", i + .01, 0, i + .99, 0, i + .99, .3, \
                i + .01, .3 }
        for (i = 0; i < 3; i++) print "live d20" i, 0, -1, 200.02 + i * 1.03, .3
        }' >"$out/decks.kern"
    "$kern" --sweep 3 "$out/decks.kern" >"$out/o" &&
        grep -q ' 7.35.* d5  least' "$out/o" &&
        ! grep 'not tried' "$out/o" || return 1
    # it falls without the live load
    printf '%s\n' 'gravity 0 -1' 'fixed G -5 -1 1 -1 1 0 -5 0' \
        'block W * 0 0 4 0 4 1 0 1' 'live W 0 -3 .5 1' >"$out/need.kern"
    ! "$kern" --sweep 4 "$out/need.kern" >"$out/o" &&
        grep -q 'sweep       none: without the live load' "$out/o" &&
        ! "$kern" --json --sweep 4 "$out/need.kern" >"$out/o" &&
        grep -q '"sweep": \[\], .*"sweep_why": ' "$out/o"
}

backs() { # of earth: steps over it are upright, and fill beside it is refused; a
    # prop is on its stone; a drawing with a second abutment that is not fixed
    local kern f=$out/back.kern
    kern=$(program kern examples/kern.c) || return 1
    printf '%s\n' 'gravity 0 -1' 'units m kN' 'density 24' 'friction .7' \
        'fixed G -5 -1 8 -1 8 0 -5 0' >"$out/ground.kern"
    # 20 4 4 / 2 / 3 on a course that hangs over by 1; and by Coulomb's K = .4277 on
    # a back that leans under it, which bears 17.11 down
    { cat "$out/ground.kern" && printf '%s\n' 'block v * 0 0 2 0 2 2 0 2' \
        'block w * 0 2 3 2 3 4 0 4' 'earth right 4 20 30 0'; } >"$f"
    says 'earth       53.33 kN to the left and 0 kN down' "$f" &&
        says 'back taken as the line from (2, 0) to (3, 4), 0 deg' "$f" || return 1
    { cat "$out/ground.kern" && printf '%s\n' 'block w * 0 0 3 0 2 4 0 4' \
        'earth right 4 20 30 0'; } >"$f"
    says '68.43 kN to the left and 17.11 kN down' "$f" &&
        says '(3, 0) to (2, 4), 14 deg under the earth' "$f" &&
        "$kern" --json "$f" >"$out/back.json" && "$kern" --help >"$out/help" &&
        $judge keys "$out/back.json" "$out/help" &&
        echo 'fill 4 20' >>"$f" &&
        refuses 'from x = 2 to 3 bears the earth on it already' "$f" &&
        sed -i 's/^fill.*/prop w 0 -1 -77 1 5/' "$f" &&
        refuses "prop: a point on block 'w', which is from x = 0 to 3" "$f" &&
        sed -i 's/^prop.*/prop w 0 -1 3.5 1 5/' "$f" &&
        refuses "prop: a point on block 'w', which is from x = 0 to 3" "$f" ||
        return 1
    # a flat back, on which a plane within the soil is worse than the back
    printf '%s\n' 'fixed g -5 -1 9 -1 9 0 -5 0' 'block w 9 0 0 4 0 1 3 0 3' \
        'earth right 3 18 30 30' >"$f"
    refuses 'under it by at most 45 - phi / 2 = 30 degrees, is expected' "$f" ||
        return 1
    printf '%s\n' 'LOW 0 0 1 0 1 2 0 2' 'HIGH 3 1 4 1 4 2 3 2' \
        'DECK 0 2 4 2 4 3 0 3' | drawing >"$out/second.dxf"
    says 'note        nothing is below HIGH_2, and not fixed' "$out/second.dxf" &&
        says '1 block on 2 fixed' --layer LOW=ground --layer HIGH=ground \
            "$out/second.dxf"
}

hand_in() { # drawings of the bridge and the wall, and a photograph: the answers of
    # their files, and a page of each that a browser reads
    local kern name bridge=examples/structures/prestwood.kern
    local wall=examples/structures/retaining-wall.kern
    kern=$(program kern examples/kern.c) || return 1
    {   # ring, springings and fill, as layers
        awk '$1 == "block" { $1 = "RING"; $2 = $3 = ""; print }
             $1 == "fixed" { $1 = "ABUTMENT"; $2 = ""; print }' $bridge
        echo BACKFILL -4 1.813 4 1.813 4 0 3.43620 0.14971 0 1.648 \
            -3.43620 0.14971 -4 0
    } | drawing >"$out/bridge.dxf"
    "$kern" --density RING=2100 --density BACKFILL=2000 --mu RING=.75 \
        --mu RING,ABUTMENT=.75 --phi 37 --kern "$out/bridge.kern" \
        --report "$out/read.html" "$out/bridge.dxf" >"$out/o" || return 1
    grep -q '^  fill .* kN about (0, ' "$out/o" && grep -q ' kPa ' "$out/o" &&
        echo "axle -1.6375 58860 .3" >>"$out/bridge.kern" &&
        says '[0, 0.9854]: factors' "$out/bridge.kern" &&
        "$kern" --svg "$out/bridge.svg" "$out/bridge.kern" >"$out/o" &&
        grep -q '>58.86 kN<' "$out/bridge.svg" || return 1
    awk '$1 == "block" { $1 = "WALL"; $2 = $3 = ""; print }
         $1 == "fixed" { $1 = "GROUND"; $2 = ""; print }' $wall |
        drawing >"$out/wall.dxf"
    "$kern" --mu .75 --density 2273.19 --kern "$out/wall.kern" "$out/wall.dxf" \
        >"$out/o" && echo "earth right 6.096 1393.48 35 23.3333" >>"$out/wall.kern" &&
        says 'margin      0.2191 m' "$out/wall.kern" &&
        says 'earth       57 kN to the left' "$out/wall.kern" || return 1
    "$kern" --pixel .01 --density 2000 --report "$out/photo.html" \
        tests/seeds/drawing-labelme.json >"$out/o"
    [ $? -le 1 ] || return 1
    "$kern" --raised --report "$out/all.html" $bridge $wall >"$out/o"
    # pushes are arrows, no stones; the back of the wall is a line
    ! grep -q '#dfe9d8' "$out/all-prestwood.html" &&
        grep -q 'Short arrows onto the stones' "$out/all-prestwood.html" &&
        grep -q 'stroke-dasharray="4 3"' "$out/all-retaining-wall.html" ||
        return 1
    # what was read stands in the page, and can be run again from it
    python3 - "$out/all-prestwood.html" $bridge <<'END' || return 1
import html, re, sys
page = open(sys.argv[1], encoding='utf-8').read()
text = html.unescape(re.search('<pre>(.*)</pre>', page, re.S).group(1))
assert text == open(sys.argv[2], encoding='utf-8').read()
assert '<code>kern --raised --report ' in page
END
    for name in read photo all-prestwood all-retaining-wall; do
        $judge page "$out/$name.html" || { echo "$name"; return 1; }
    done
    # its headline has the factor that governs; large forces in N are kN
    grep '<p class="verdict">' "$out/all-retaining-wall.html" >"$out/head"
    grep -q "is 1.605 on the horizontal part of the earth's thrust" "$out/head" &&
        grep -q 'thrust, .*; on the whole thrust .* is 1.924 ' "$out/head" &&
        grep -q 'Beyond 1.605: course1 to course20 tipping left' "$out/head" &&
        grep -A 9 '<h2>How it would fall as the earth grows' \
            "$out/all-retaining-wall.html" >"$out/fall" &&
        grep -q '^<li>beyond 1.605: course1 to course20 tipping left' "$out/fall" &&
        grep -q 'the narrowest course limits it' "$out/fall" &&
        "$kern" --title 'Wall <B>, 1834' --report "$out/n.html" "$out/wall.kern" \
            >"$out/o" && grep -q '<h1>Wall &lt;B&gt;, 1834</h1>' "$out/n.html" &&
        grep -q '<td>57 kN to the left' "$out/n.html" &&
        grep -q '<th>normal \[kN\]</th><th>shear \[kN\]</th>' "$out/n.html" &&
        grep -q '<th>stress \[kPa\]</th>' "$out/n.html" &&
        grep -q '>length 0.5 m<' "$out/n.html" &&
        grep -q 'margin 0.2191 m<' "$out/n.html" &&
        grep -q '<td>162.7</td><td>-57</td>' "$out/n.html" &&
        "$kern" --title Walls --report "$out/t.html" $bridge $wall >"$out/o" &&
        grep -q '<title>Walls: prestwood.kern</title>' "$out/t-prestwood.html" &&
        refuses "--report OUT.html is missing beside --title" --title T $wall &&
        refuses "a text is missing after --title" --title '' $wall || return 1
    refuses "--report takes a name that ends in .html" --report a.kern $wall &&
        refuses "--phi takes an angle in degrees from 5 to 60" --phi .6 $wall &&
        refuses "--mu takes a number not below zero" --mu a=b $wall
}

stated() { # what numbers leave out or assume is said in report, JSON and page
    local kern wall=examples/structures/retaining-wall.kern f=$out/bond.kern
    kern=$(program kern examples/kern.c) || return 1
    # a live load is no part of the verdict
    sed 's/^earth.*/& live/; s/13.67/136.7/' $wall >"$out/live.kern" &&
        says 'live.kern: stands without the live load' "$out/live.kern" &&
        says 'warning     it falls under the live load as' "$out/live.kern" &&
        "$kern" --json --report "$out/live.html" "$out/live.kern" \
            >"$out/live.json" &&
        grep -q '"without_live": true, "as_stated": "falls"' "$out/live.json" &&
        grep -q 'Under the live load as stated it falls' "$out/live.html" &&
        "$kern" --json $wall >"$out/wall.json" &&
        grep -q '"without_live": null, "as_stated": null' "$out/wall.json" &&
        "$kern" --help >"$out/help" && $judge keys "$out/live.json" "$out/help" ||
        return 1
    # the bond of 2 on 1 by 5 is no compression of the stone: 5 is; as it tips
    # the pull is 2 at most, and with a strength of 8 a toe of .7 bears
    printf '%s\n' 'gravity 0 -1' 'friction 9' 'fixed g -2 -1 3 -1 3 0 -2 0' \
        'block a 5 0 0 1 0 1 2 0 2' 'live a 1 0 0 1' 'bond 2' >"$f"
    says 'stress      5  ' "$f" && says '[0, 3.5]: factors' "$f" &&
        says 'warning     the bond is plastic' "$f" &&
        says ' 5         0   0.000         5 (1, 0)' --forces "$f" &&
        "$kern" --report "$out/bond.html" "$f" >"$out/o" &&
        "$kern" --json "$f" | grep -q '"bond": 2,' &&
        grep -q 'unsafe for brittle mortar' "$out/bond.html" &&
        echo 'strength 8' >>"$f" && says '[0, 1.05]: factors' "$f" || return 1
    # stone without a strength does not crush, which is said beside the factors
    says 'strength    none is stated: the stone is taken as infinitely strong' \
        "$out/live.kern" && grep -q '^<p class="verdict">.*infinitely strong\.</p>' \
        "$out/live.html" && grep -A1 '<h2>Results' "$out/live.html" |
        grep -q '^<p>No strength is stated: the stone is taken as inf' &&
        ! "$kern" --report "$out/bond.html" "$f" | grep 'infinitely' &&
        ! grep 'infinitely strong' "$out/bond.html" || return 1
    # densities of a weight under a gravity of 9.81 are a mistake; t/m3 are not
    printf '%s\n' 'units m kN' 'density 22' 'fixed g -2 -1 3 -1 3 0 -2 0' \
        'block a * 0 0 1 0 1 2 0 2' >"$out/odd.kern"
    says 'blocks weigh 216 kN/m3: give densities in' "$out/odd.kern" &&
        sed -i 's/22/2.2/' "$out/odd.kern" &&
        ! "$kern" "$out/odd.kern" | grep 'blocks weigh' &&
        sed -i 's/2\.2/22/; 1i gravity 0 -1' "$out/odd.kern" &&
        ! "$kern" "$out/odd.kern" | grep 'blocks weigh' || return 1
    # fill in front of an upright face lies on nothing
    printf '%s\n' 'fixed g -5 -1 6 -1 6 0 -5 0' 'block w * 0 0 1 0 1 3 0 3' \
        'fill .8 18 phi 30 from -5 to 0' >"$out/front.kern"
    refuses "from x = -5 to 0 is 'g', which is fixed." "$out/front.kern" &&
        refuses 'write prop NAME FX FY X Y MOST' "$out/front.kern" || return 1
    sed -i 's/^fill.*/fill .8 18 phi 30/' "$out/front.kern" &&
        refuses 'the outline begins at 3' "$out/front.kern"
}

assumed() { # of a drawing: density, friction, ground; masks of LabelMe
    local kern
    kern=$(program kern examples/kern.c) || return 1
    awk '$1 == "block" { $1 = "RING"; $2 = $3 = ""; print }' \
        examples/structures/arch.kern | drawing >"$out/arch.dxf"
    says 'note        density 1 is assumed' "$out/arch.dxf" &&
        says 'note        friction 0.4 is assumed (--mu MU)' "$out/arch.dxf" &&
        says 'and cannot turn or slide: the favourable side' "$out/arch.dxf" &&
        says ' per unit of density  mean stress' "$out/arch.dxf" &&
        "$kern" --mu .6 --density 2000 --kern "$out/arch.kern" "$out/arch.dxf" \
            >"$out/o" && ! grep -q assumed "$out/o" &&
        grep -q '^  stress .* k*Pa ' "$out/o" &&
        grep -q '^friction .6$' "$out/arch.kern" &&
        says 'friction 0.4 is assumed where --mu names no' --mu RING=.6 \
            "$out/arch.dxf" &&
        diff <(sed -n 's/^.*: stands/stands/; /stands/,$p' "$out/o") \
            <("$kern" "$out/arch.kern" | sed 's/^.*: stands/stands/') || return 1
    # a PNG stored, of fixed and of own codes, of all filters, and a broken one
    "$kern" --kern "$out/mask.kern" tests/seeds/drawing-mask.json >"$out/o" ||
        return 1
    grep -q 'skipped     1 mask that is no PNG without interlace on broken, line 9' \
        "$out/o" && [ "$(grep -c ^block "$out/mask.kern")" -eq 5 ] &&
        awk '$1 == "block" { for (i = 4; i < NF; i += 2) printf "%g %g ",
                $i - $4, $(i + 1) - $5
            print "" }' "$out/mask.kern" | uniq >"$out/o" &&
        grep -qx '0 0 -16 0 -16 12 -40 12 -40 -18 0 -18 ' "$out/o" &&
        [ "$(wc -l <"$out/o")" -eq 1 ]
}

arcs() { # arcs LAYER, GAP: a semicircular arch of 21 voussoirs as lines and arcs
    # on abutments, with fill whose outline has other chords; ends of the second
    # arc miss the joints by GAP [mm]
    awk -v layer="$1" -v gap="$2" 'function line(x, y, u, v) {
            printf "0\nLINE\n8\nRING\n10\n%.9f\n20\n%.9f\n11\n%.9f\n21\n%.9f\n",
                x, y, u, v }
        BEGIN { pi = atan2(0, -1)
        for (r = 4000; r < 4600; r += 500) print "0\nARC\n8\nRING\n10\n0\n20\n" \
            (r > 4000 ? gap : 0) "\n40\n" r "\n50\n0\n51\n180"
        for (i = 0; i < 22; i++) { c = cos(pi * i / 21); s = sin(pi * i / 21)
            line(4000 * c, 4000 * s, 4500 * c, 4500 * s) }
        for (k = -1; k < 2; k += 2) print "0\nLWPOLYLINE\n8\nABUTMENT\n70\n1\n" \
            "10\n" 4000 * k "\n20\n0\n10\n" 5500 * k "\n20\n0\n10\n" 5500 * k \
            "\n20\n-2000\n10\n" 4000 * k "\n20\n-2000"
        print "0\nLWPOLYLINE\n8\n" layer "\n70\n1\n10\n5500\n20\n0"
        for (i = 0; i < 61; i++) printf "10\n%.9f\n20\n%.9f\n",
            4500 * cos(pi * i / 60), 4500 * sin(pi * i / 60)
        print "10\n-5500\n20\n0\n10\n-5500\n20\n5200\n10\n5500\n20\n5200" }' |
        awk 'BEGIN { print "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC"
            print "0\nSECTION\n2\nENTITIES" } { print }
            END { print "0\nENDSEC\n0\nEOF" }'
}

drawn() { # an arch of lines and arcs that end across from each other, under fill;
    # a wall with fill behind it and in front of it
    local kern f=$out/arch.dxf
    kern=$(program kern examples/kern.c) && arcs BACKFILL 0 >"$f" &&
        says 'reads 23 blocks of a drawing, in m' "$f" &&
        says '21 blocks on 2 fixed; 22 line contacts and 0 points' "$f" &&
        says 'margin      0.06891 m' "$f" && ! "$kern" "$f" | grep -q skipped &&
        arcs BACKFILL 9 >"$out/gap.dxf" || return 1
    says 'note        ends of lines meet within 0.0005, and that of' "$out/gap.dxf" ||
        return 1
    printf '%s\n' 'GROUND -4 -2 6 -2 6 -1 -4 -1' 'STONES 0 -1 2 -1 2 1 0 1' \
        'STONES 0 1 2 1 2 3 0 3' 'BACKFILL 2 -1 6 -1 6 3 2 3' \
        'SOIL -4 -1 0 -1 0 0 -4 0' | drawing >"$out/wall.dxf"
    says 'fill: SOIL_5 lies on no stone' --phi 30 "$out/wall.dxf" &&
        says 'say --layer "BACKFILL=ignore" --kern OUT.kern and write in that file: earth right 3 1800 30 DELTA' \
            --density 1800 --phi 30 "$out/wall.dxf"
}

on_one_arc() { # voussoirs of lines and arcs under a wall whose outline has the
    # same arc with chords of its own: they touch, and nothing overlaps
    local kern
    kern=$(program kern examples/kern.c) && arcs WALL 0 >"$out/fill.dxf" &&
        awk '{ print } /^WALL$/ { print "70\n1\n10\n-4500\n20\n0\n10\n-5500"
            print "20\n0\n10\n-5500\n20\n5200\n10\n5500\n20\n5200\n10\n5500"
            print "20\n0\n10\n4500\n20\n0\n42\n1\n0\nENDSEC\n0\nEOF"; exit }' \
            "$out/fill.dxf" >"$out/wall.dxf" &&
        says '22 blocks on 2 fixed' "$out/wall.dxf"
}

photographed() { # parts of one stone that are apart are no beam between them; masks
    # whose runs are not their pixels are left out by name
    local kern f=$out/parts.json
    kern=$(program kern examples/kern.c) || return 1
    coco() { # coco SEGMENTATION: of annotation 2, on ground
        printf '{"images": [{"id": 1, "height": 100}], "categories": [{"id": 2,
            "name": "ground"}], "annotations": [{"id": 1, "image_id": 1,
            "category_id": 2, "segmentation": [[0, 90, 100, 90, 100, 100, 0,
            100]]}, {"id": 2, "image_id": 1, "segmentation": %s}]}' "$1"
    }
    coco '[[10,80,20,80,20,90,10,90],[70,80,80,80,80,90,70,90]]' >"$f" &&
        says 'do not touch are stones of their own: stone and stone_2' "$f" &&
        says '2 blocks on 1 fixed' "$f" || return 1
    # the second lies on half of the first, and the third joins both
    coco '[[10,80,30,80,30,90,10,90],[62,80,70,80,70,90,62,90],
        [22,70,70,70,70,80,22,80]]' >"$f" &&
        says '1 block on 1 fixed' "$f" &&
        "$kern" --kern "$out/parts.kern" "$f" >"$out/o" &&
        awk '$1 == "block" { n = (NF - 3) / 2
            for (i = 0; i < n; i++) { j = 4 + 2 * i; k = 4 + 2 * ((i + 1) % n)
                area += ($j * $(k + 1) - $k * $(j + 1)) / 2 } }
            END { exit area != 760 }' "$out/parts.kern" || return 1
    coco '{"size": [100, 100], "counts": [4070, 20, 80, 15, 80, 20, 5710]}' >"$f" &&
        refuses 'also 1 mask 2 of 9995 pixels, not 10000' "$f"
}

styled() { # what is not read of an SVG is left out by name or refused; so are a DWG
    # and a block that inserts itself
    local kern f=$out/styled.svg
    kern=$(program kern examples/kern.c) || return 1
    svg() { # svg ELEMENTS: on a stone on ground
        echo '<svg width="99"><rect id="ground" y="90" width="99" height="9"/>' \
            '<rect x="10" y="80" width="10" height="10"/>' "$1</svg>" >"$f"
    }
    svg '<g style="transform:translate(9px,0)"><path d="M30 80h9v9h-9z"/></g>' &&
        says '1 element moved by a style on path, line 1' "$f" &&
        says '1 block on 1 fixed' "$f" &&
        svg '<svg x="50"><rect width="1" height="1"/></svg>' &&
        says '1 element in a nested svg on rect' "$f" &&
        svg '<g opacity="0"><rect width="9" height="9"/></g>' &&
        says '1 invisible element on rect' "$f" &&
        svg '<rect x="1em" width="9" height="9"/>' &&
        says '1 outline that cannot be read on rect' "$f" &&
        svg '<style>.h { display: none }</style>' &&
        says 'the style sheet in line 1 has a rule with display' "$f" &&
        svg '<rect y="80" x="10mm" width="10" height="10"/>' &&
        "$kern" --kern "$out/styled.kern" "$f" >"$out/o" &&
        grep -q ' 37.795' "$out/styled.kern" &&
        svg '<defs><g id="two"><rect width="9" height="9"/><rect y="9" width="9"
            height="9"/></g></defs><use href="#two" x="30" y="72"/><use id="in"
            href="#in"/><use href="a.svg#two"/><use id="away" x="-14"
            href="#late"/>
            <use xlink:href="#two" transform="translate(50,72) scale(2,1)"/>
            <path id="late" d="M80 80h9v10h-9z" transform="translate(5,0)"/>' &&
        "$kern" --kern "$out/styled.kern" "$f" >"$out/o" &&
        grep -q 'skipped     1 use in more than 8 others on in, line 2' "$out/o" &&
        grep -q 'skipped     1 use on use, line 3' "$out/o" &&
        grep -q ' 7 blocks on 1 fixed' "$out/o" &&
        grep -q '  50 -90  50 -81  68 -81  68 -90$' "$out/styled.kern" &&
        svg '' && sed -i 's/<svg width="99">/<svg viewBox="0 0 200 100">/
            s/x="10" y="80" width="10"/x="10%" y="80%" width="10%"/' "$f" &&
        "$kern" --kern "$out/styled.kern" "$f" >"$out/o" &&
        grep -q '  20 -90  20 -80  40 -80  40 -90$' "$out/styled.kern" &&
        sed -i 's/viewBox="0 0 200 100"/width="200" height="100"/' "$f" &&
        "$kern" --kern "$out/styled.kern" "$f" >"$out/o" &&
        grep -q '  20 -90  20 -80  40 -80  40 -90$' "$out/styled.kern" &&
        svg "<defs><rect id='u0' width='9' height='9' />$(for i in {1..9}; do
            echo "<g id='u$i'><use href='#u$((i - 1))' /></g>"
        done)</defs><use href='#u9' x='30'/>" &&
        says '1 use in more than 8 others' "$f" &&
        svg '<g><rect width="9" height="9">' &&
        refuses "styled.svg:1: the element 'rect' of line 1 is not closed" "$f" &&
        awk 'BEGIN { printf "<svg><path d=\""
            for (i = 0; i < 40000; i++) printf "M0 0h1v1h-1z"
            print "M0 1h1v-1h-1zM0 1h1v1h-1z\"/></svg>" }' >"$f" &&
        timeout 30 "$kern" --ground .5 "$f" >"$out/o" &&
        grep -q 'skipped     40000 outline drawn twice' "$out/o" &&
        awk 'BEGIN { printf "<svg><path d=\""
            for (i = 0; i < 20001; i++) printf "M%d 0h1v1h-1z", 2 * i
            print "\"/></svg>" }' >"$f" &&
        refuses "styled.svg: 20001 closed outlines, at most 20000 are" "$f" &&
        svg '<rect width="-9" height="9"/>' && says \
            'skipped     1 outline that cannot be read on rect, line 1' \
            "$f" && printf 'AC1032\0\0' >"$out/a.dwg" &&
        refuses 'a DWG, which is not read: save it as DXF' "$out/a.dwg" || return 1
    echo 'GROUND -5 -1 5 -1 5 0 -5 0' | drawing | awk '/^ENTITIES$/ {
            print "BLOCKS\n0\nBLOCK\n2\nA\n10\n0\n20\n0\n0\nLWPOLYLINE\n8\n0"
            print "70\n1\n10\n0\n20\n0\n10\n999\n20\n0\n10\n999\n20\n999"
            print "0\nINSERT\n8\n0\n2\nA\n10\n999\n20\n0\n0\nENDBLK\n0\nENDSEC"
            print "0\nSECTION\n2\nENTITIES\n0\nINSERT\n8\n0\n2\nA\n10\n0\n20\n0"
            next } { print }' >"$out/self.dxf"
    says '1 self-inserting INSERT' "$out/self.dxf" &&
        says '1 block on 1 fixed' "$out/self.dxf"
}

named() { # a layer that its name makes ground is told; a course of stones is none
    local kern f=$out/named.dxf
    kern=$(program kern examples/kern.c) || return 1
    printf '%s\n' 'GROUND -5 -1 5 -1 5 0 -5 0' 'Base_course 4 0 6 0 6 1 4 1' \
        'SOIL -5 0 0 0 0 1 -5 1' | drawing >"$f"
    says 'note        ground by name: GROUND (--layer' "$f" &&
        says 'note        fill by name: SOIL (--layer' "$f" &&
        says '1 block on 1 fixed' "$f"
}

thrust() { # the least and the greatest of a support: of a stone that friction
    # holds by 2 under a load of 5; symmetric
    local kern stone
    kern=$(program kern examples/kern.c) && stone=$out/stone.kern || return 1
    printf '%s\n' 'gravity 0 -10' 'fixed g -3 -1 3 -1 3 0 -3 0' 'friction 2' \
        'block a 2 0 0 1 0 1 2 0 2' 'fixed r 1 0 2 0 2 2 1 2' \
        'friction 0 a r' >"$stone"
    says '[0, 40]: to the left, of r' --thrust r "$stone" &&
        printf '%s\n' 'friction .1 a g' 'load a 5 0 .5 .5' >>"$stone" &&
        says '[3, 7]: to the left, of r' --thrust r "$stone" || return 1
    stone=examples/structures/prestwood.kern
    says '[6.039 kN, 65.28 kN]: to the left' --thrust right $stone &&
        says '[6.039 kN, 65.28 kN]: to the right' --thrust left $stone &&
        "$kern" --json --thrust right $stone >"$out/thrust.json" &&
        "$kern" --help >"$out/help" &&
        $judge keys "$out/thrust.json" "$out/help" &&
        refuses "--thrust: there is no fixed block 'v1'" --thrust v1 $stone &&
        says 'thrust      undecided' --thrust ground \
            examples/structures/retaining-wall.kern
}

kept() { # no picture is written over a structure
    local kern place
    kern=$(program kern examples/kern.c) &&
        place=$(program place examples/place.c) &&
        keeps "$kern --svg" "$place"
}

bricks() { # bricks COURSES LENGTH: a wall in half bond
    awk -v courses="$1" -v length_="$2" 'BEGIN {
        print "friction 0.6\nfixed ground  -9 -1  99 -1  99 0  -9 0"
        for (c = 0; c < courses; c++)
            for (i = 0; i < length_; i++) {
                x = i + c % 2 / 2
                y = c / 2
                print "block b" c "_" i " *", x, y, x + 1, y, x + 1, y + 0.5,
                    x, y + 0.5
            }
    }'
}

large() { # the verdict on 2,000 bricks takes a tenth of a second, the margin and
    # load factors of 500, of which hundreds move at once, some seconds
    local kern
    kern=$(program kern examples/kern.c) || return 1
    bricks 50 40 >"$out/large.kern"
    timeout 20 "$kern" --verdict "$out/large.kern" | grep -q ": stands" &&
        bricks 23 22 >"$out/large.kern" &&
        timeout 60 "$kern" "$out/large.kern" | grep "margin *0.11" &&
        bricks 25 20 >"$out/large.kern" &&
        timeout 60 "$kern" "$out/large.kern" | grep "margin *0.1"
}

reader() { # in any locale, and of files without an end
    local kern text
    kern=$(program kern examples/kern.c) &&
        text=$(program text_test tests/text_test.c) && "$text" || return 1
    timeout 20 "$kern" /dev/zero 2>"$out/e"
    [ $? -eq 2 ] && grep -q "/dev/zero:1:" "$out/e"
}

pictures() {
    local kern f
    kern=$(program kern examples/kern.c) || return 1
    for f in examples/structures/*.kern; do
        "$kern" --svg "$out/$(basename "$f").svg" --mechanism --profile "$f" \
            >/dev/null
        [ $? -le 1 ] || return 1
    done
    $judge svg "$out"/*.svg
}

places() { # walls of brick and of found stone, and the program's own answer
    local place f kern
    kern=$(program kern examples/kern.c) || return 1
    echo 'block stone * 0 0 .6 0 .7 .3 .1 .4' >"$out/stone.kern"
    place=$(program place examples/place.c) || return 1
    for f in wall-60 irregular-wall; do
        "$place" "$out/$f.svg" "examples/structures/$f.kern" >"$out/o" \
            2>/dev/null && grep -q best "$out/o" &&
            "$kern" --json --place "$out/stone.kern" --turns 5 --most 4 \
                --svg "$out/$f-best.svg" "examples/structures/$f.kern" \
                >"$out/best.json" && $judge best "$out/best.json" || return 1
    done
    # a stone does not lie in earth or fill, and ground alone is refused
    echo 'block stone * 0 0 1.2 0 1.2 .8 0 .8' >"$out/stone.kern"
    "$kern" --json --place "$out/stone.kern" --most 400 \
        examples/structures/retaining-wall.kern >"$out/best.json" &&
        python3 - "$out/best.json" <<'END' || return 1
import json, sys
places = json.load(open(sys.argv[1]))["places"]
assert any(p["x"] > 1 for p in places) and any(p["x"] < 0 for p in places)
for p in places:
    if min(y for x, y in p["polygon"]) < 6.09:
        assert max(x for x, y in p["polygon"]) < 1.63, p
END
    echo 'fixed ground -9 -1 9 -1 9 0 -9 0' >"$out/bare.kern"
    ! "$kern" --place "$out/stone.kern" "$out/bare.kern" 2>"$out/e" >/dev/null &&
        grep -q "no block is free" "$out/e" || return 1
    $judge svg "$out"/*.svg
}

moves() { # of single stones: what they bear, and what they need
    local push nudge f
    push=$(program push examples/push.c) &&
        nudge=$(program nudge examples/nudge.c) || return 1
    "$push" --json "$out/push.svg" >"$out/push.json" &&
        $judge pushes "$out/push.json" &&
        "$push" "$out/arch.svg" examples/structures/arch.kern >/dev/null &&
        "$nudge" "$out/nudge.svg" examples/structures/wall-60.kern g7 \
            >"$out/o" && grep -q "before, .* after" "$out/o" &&
        "$nudge" - examples/structures/lintel.kern >"$out/o" &&
        grep -q "^no move" "$out/o" && $judge svg "$out"/*.svg || return 1
    for f in "$push" "$nudge"; do
        ! "$f" - examples/structures/falls.kern >/dev/null 2>"$out/e" &&
            grep -q falls "$out/e" || return 1
        "$f" picture >/dev/null
        [ $? -eq 2 ] || return 1
    done
}

memory() { # under valgrind; also where the limit of work ends a call
    local valgrind="valgrind -q --error-exitcode=9 --leak-check=full" limit
    gcc -g -O1 $exact -o "$out/kern_g" examples/kern.c -lm &&
        $valgrind "$out/kern_g" --json --forces --mechanism --profile \
            examples/structures/*.kern >/dev/null
    [ $? -le 1 ] || return 1
    for limit in 40 200 900; do
        $valgrind "$out/kern_g" --profile --raised --limit $limit \
            examples/structures/arch.kern >/dev/null
        [ $? -lt 9 ] || return 1
    done
}

placements() { # that stay and that move, told apart in double and in float
    local truth
    truth=$(program truth tests/truth.c) && "$truth" tests/truth 0.8 0.8 0.9 &&
        truth=$(program truth_single tests/truth.c -DKERN_SINGLE) &&
        "$truth" tests/truth 0.8 0.8 0.9
}

benchmark() { # answers must agree with GLPK; times are not judged
    gcc -std=c99 -O2 $exact -DBENCH_GLPK -o "$out/bench" tests/bench.c \
        -lglpk -lm && "$out/bench" --quick >"$out/times.csv" &&
        awk -f tests/bench.awk "$out/times.csv" >"$out/tables" &&
        grep -q '| growth | median |' "$out/tables"
}

# ---- Python and the browser

python() { # python WANT OPTIONS: doctests and tests; is numpy there (0) or not?
    local want=$1 kern
    shift
    export XDG_CACHE_HOME="$out/cache"
    kern=$(program kern examples/kern.c) || return 1
    /usr/bin/python3 "$@" -c 'import numpy'
    [ $? -eq "$want" ] || return 1
    /usr/bin/python3 "$@" -m doctest examples/python/kern.py &&
        /usr/bin/python3 "$@" tests/python_test.py "$kern"
}

types() { # mypy and pyright, both strict; pyright where npm can bring it
    local tool=pyright
    MYPYPATH=examples/python mypy --strict examples/python/*.py \
        tests/typed.py || return 1
    if ! command -v pyright >/dev/null; then
        npm install --silent --prefix "$out" pyright@1.1.414 >/dev/null 2>&1 ||
            { echo "pyright is not installed, and npm does not bring it"
              return 0; }
        tool=$out/node_modules/.bin/pyright
    fi
    "$tool" -p examples/python
}

python_sanitized() { # no call of the module touches memory that is not its own
    local kern asan
    kern=$(program kern examples/kern.c) || return 1
    asan=$(gcc -print-file-name=libasan.so)
    XDG_CACHE_HOME="$out/cache" CC="gcc -g -O1 -fsanitize=address" \
        ASAN_OPTIONS=detect_leaks=0 LD_PRELOAD="$asan" PYTHONMALLOC=malloc \
        /usr/bin/python3 tests/python_test.py "$kern" Calls BadInput ManyWalls
}

python_installed() { # pip, without the network, then the doctests: the wheel of
    # the folder and of the source archive, then the folder itself
    local pip="$out/venv/bin/pip" of=(--no-index --no-build-isolation) what cache
    /usr/bin/python3 -m venv "$out/venv" &&
        (cd examples/python && /usr/bin/python3 -c "
import backend
backend.build_sdist('$out')") || return 1
    for what in ./examples/python "$out"/kern_dry_stone-*.tar.gz \
        "-e ./examples/python"; do
        cache=/nowhere # an installed library is not compiled again
        [[ $what != -e* ]] || cache=$out/cache
        "$pip" install "${of[@]}" --force-reinstall $what &&
            "$pip" show kern-dry-stone | grep '^License: MIT' &&
            (cd "$out" && XDG_CACHE_HOME="$cache" venv/bin/python -c '
import doctest, kern
assert doctest.testmod(kern).failed == 0
print(kern.__version__, kern.__file__)') || return 1
    done
}

page() { # is built, no larger than it may be, and works in Chromium
    bash examples/browser/build.sh "$out" &&
        [ "$(wc -c <"$out/kern.html")" -le 186500 ] &&
        [ "$(wc -c <"$out/essay.html")" -le 142500 ] &&
        /usr/bin/python3 tests/browser_test.py "$out/kern.html"
}

# ---- reading the source

tidy() { # tidy FILES...
    clang-tidy --quiet "$@" -- -std=c99 -DFUZZ_STRUCTURE -DFUZZ_PLAIN
}

tidy_examples() { # the analyzer, one by one: clang-tidy 14 forgets va_start()
    local file    # of the first; in other programs it takes arrays that were
                  # sized, and what a verdict wrote, for garbage
    for file in examples/kern.c examples/push.c examples/copy/contour.c \
        examples/copy/plan.c examples/copy/tower.c \
        examples/laboratory/shake.c; do
        tidy "$file" || return 1
    done
    tidy --checks=-clang-analyzer-* examples/*.c examples/copy/*.c \
        examples/laboratory/*.c examples/firmware/main.c
}

tidy_tests() {
    tidy --checks=-clang-analyzer-* tests/golden.c tests/exact.c \
        tests/faults.c tests/levels.c tests/fuzz.c
}

run_check "$@"
