#!/usr/bin/env bash
# bash tests/sizes.sh              tables of examples/firmware; fails above a limit
# bash tests/sizes.sh --goals      the same; fails where a goal is missed as well
# bash tests/sizes.sh --chapters   what each chapter of kern.h takes
# bash tests/sizes.sh --functions  every function: code, frame, deepest stack
#
# Sizes of the whole library as arm-none-eabi-gcc compiles it. Goals and limits
# are for a Cortex-M4F in float at -Os. Stack is the deepest path through the call
# graph that gcc writes; recursion, a call through a pointer and a frame of
# unknown size are errors, since then there would be no deepest path.
set -u
cd "$(dirname "$0")/.." || exit 1
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT

# NAME GOAL LIMIT: what is wished for, and what no change may exceed
limits="tokens of the implementation|62369|72370
text of the library|57000|65650
text, kern_measure with contacts given|32000|29630
text, kern_verdict with contacts given|22000|22310
text of the library, KERN_NO_INTERIOR|54000|62580
text, kern_measure, KERN_NO_INTERIOR|32000|28000
text, kern_verdict, KERN_NO_INTERIOR|22000|20000
deepest stack|2700|2600"
allowed='sqrtf'  # symbols that the library may need

m4f="-mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16"
m0="-mcpu=cortex-m0plus -mthumb"
# gcc may turn loops into calls of memset() and memcpy(), unless told not to
common="-std=c99 -ffp-contract=off -fno-tree-loop-distribute-patterns
 -fstack-usage -fcallgraph-info=su -I."

fail() { echo "LIMIT: $*" >>"$out/failed"; }

compile() { # compile FLAGS...: makes $out/kern.o and its call graph
    printf '#define KERN_IMPLEMENTATION\n#include "kern.h"\n' >"$out/kern.c"
    # shellcheck disable=SC2086
    arm-none-eabi-gcc $common "$@" -c "$out/kern.c" -o "$out/kern.o"
}

# FUNCTION FRAME DEEPEST for every function, from the call graph; what makes
# the depth unknown is a line that starts with "!".
depths() {
    awk '
    function name(s) { sub(/.*:/, "", s); return s }
    function deepest(f,    i, most, d) {
        if (f in open) { print "! recursion through " f; return 0 }
        if (f in depth) return depth[f]
        open[f] = 1
        for (i = 1; i <= calls[f]; i++) {
            d = deepest(call[f, i])
            if (d > most) most = d
        }
        delete open[f]
        return depth[f] = frame[f] + most
    }
    { split($0, part, "\"") }
    /^node:/ {
        f = name(part[2])
        if (match(part[4], /[0-9]+ bytes/))
            frame[f] = substr(part[4], RSTART) + 0
        if (part[4] ~ /bytes \(dynamic/) print "! unbounded frame: " f
    }
    /^edge:/ {
        f = name(part[2])
        call[f, ++calls[f]] = name(part[4])
        if (part[4] ~ /__indirect_call/) print "! call by pointer in " f
    }
    END { for (f in frame) print f, frame[f], deepest(f) }' "$out/kern.ci"
}

undefined() { arm-none-eabi-nm -u "$out/kern.o" | awk '{ print $2 }'; }

row() { # row NAME FLAGS...: one line of the table; sets text, stack, needs
    local name=$1 data bss
    shift
    compile "$@" || exit 1
    read -r text data bss _ < <(arm-none-eabi-size "$out/kern.o" | tail -n 1)
    stack=$(depths | awk '$3 > most { most = $3 } END { print most + 0 }')
    needs=$(undefined | grep -v '^__aeabi' | tr '\n' ' ')
    emulated=$(undefined | grep -c '^__aeabi')
    printf '| %s | %s | %s | %s | %s | %s%s |\n' "$name" "$text" "$data" \
        "$bss" "$stack" "${needs% }" \
        "$([ "$emulated" -gt 0 ] && echo " and $emulated of libgcc")"
    [ "$data" -eq 0 ] && [ "$bss" -eq 0 ] || fail "$name: data or bss"
    depths | grep '^!' | sort -u >"$out/unknown"
    [ ! -s "$out/unknown" ] || fail "$name: $(cat "$out/unknown")"
}

foreign() { # of the configuration that was compiled last
    undefined | grep -vxE "$allowed" >"$out/foreign" &&
        fail "undefined symbols: $(tr '\n' ' ' <"$out/foreign")"
}


held() { # held NAME TODAY: a row of the goals, and whether the limit is kept
    local name=$1 today=$2 goal limit
    IFS='|' read -r _ goal limit < <(grep "^$name|" <<<"$limits")
    printf '| %s | %s | %s | %s%s |\n' "$name" "$goal" "$limit" "$today" \
        "$([ "$today" -le "$goal" ] || echo ", goal missed")"
    [ "$today" -le "$limit" ] || fail "$name: $today, the limit $limit"
    [ "$today" -le "$goal" ] || [ "$mode" != --goals ] ||
        fail "$name: $today, the goal $goal"
}

# What a program links of it that calls some functions only.
linked() { # linked FUNCTION...: makes $out/kern.elf
    local roots=() f
    for f in "$@"; do roots+=(-u "kern_${f}_f32"); done
    arm-none-eabi-ld --gc-sections -e "kern_${1}_f32" "${roots[@]}" \
        --unresolved-symbols=ignore-all -o "$out/kern.elf" "$out/kern.o" ||
        exit 1
}

text_of() { arm-none-eabi-size "$out/$1" | awk 'NR == 2 { print $1 }'; }

mode=${1:-}
given="measure contact_make"
programs="verdict contact_make
$given
measure contacts block_init
plan_try plan_add plan_remove measure block_init
lp_solve"
in_sections="-ffunction-sections -fdata-sections"

# TAG BYTES of each chapter in $1, inlined code where it stands; then constants
chapters() {
    {
        arm-none-eabi-size "$1" | awk 'NR == 2 { print "text", $1 }'
        arm-none-eabi-objdump -dlz "$1"
    } | awk -F '\t' '
    FNR == NR {
        if (/^\/\* (----|====).*>>/) { sub(/.*>>/, ""); sub(/ .*/, ""); tag = $0 }
        chapter[FNR] = tag
        next
    }
    /^text/ { rest = substr($0, 5) + 0 }
    match($0, /kern\.h:[0-9]+/) {
        tag = chapter[substr($0, RSTART + 7, RLENGTH - 7) + 0]
    }
    /^ *[0-9a-f]+:\t/ {
        gsub(/ /, "", $2)
        bytes[tag] += length($2) / 2
        rest -= length($2) / 2
    }
    END {
        for (tag in bytes) print tag, bytes[tag]
        print "constants", rest
    }' kern.h -
}

if [ "${1:-}" = --functions ]; then
    # shellcheck disable=SC2086
    compile -Os -DKERN_SINGLE $m4f || exit 1
    depths | sort >"$out/depths"
    arm-none-eabi-nm -S "$out/kern.o" | awk 'NF == 4 { print $4, $2 }' |
        while read -r f size; do echo "$f $((16#$size))"; done |
        sort >"$out/code"
    echo "  code frame  deepest  function (Cortex-M4F, float, -Os; inlined ones"
    echo "                       count where they are inlined)"
    join "$out/code" "$out/depths" | sort -k2,2nr |
        awk '{ printf "%6d %5d %8d  %s\n", $2, $3, $4, $1; sum += $2 }
             END { printf "%6d                 in functions\n", sum }'
    exit 0
fi
if [ "${1:-}" = --chapters ]; then
    # shellcheck disable=SC2086
    compile -Os -g -DKERN_SINGLE $m4f $in_sections || exit 1
    {
        chapters "$out/kern.o" | sed 's/^/0 /'
        for n in 1 2 3 4 5; do
            # shellcheck disable=SC2046
            linked $(sed -n ${n}p <<<"$programs")
            chapters "$out/kern.elf" | sed "s/^/$n /"
        done
    } | awk '
    FNR == NR { bytes[$2, $1] = $3; sum[$1] += $3; next }
    /^\/\* (----|====).*>>/ {
        name = $0
        sub(/^[^A-Z]*/, "", name)
        sub(/ [-=]+ *>>.*/, "", name)
        sub(/.*>>/, "")
        print_row(name, $1)
    }
    function print_row(name, tag,    i, any) {
        for (i = 0; i < 6; i++) any += bytes[tag, i]
        if (!any) return
        printf "| %s |", name
        for (i = 0; i < 6; i++) printf " %d |", bytes[tag, i]
        print ""
    }
    BEGIN {
        print "| chapter (Cortex-M4F, float, -Os) | all | verdict, contacts" \
            " given | measure, contacts given | measure and contacts |" \
            " plan_try | lp_solve |\n|---|---|---|---|---|---|---|"
    }
    END {
        print_row("Constants", "constants")
        for (i = 0; i < 6; i++) bytes["sum", i] = sum[i]
        print_row("Sum", "sum")
    }' - kern.h
    exit 0
fi

echo '| target | text | data | bss | deepest stack | needs |'
echo '|---|---|---|---|---|---|'
# shellcheck disable=SC2086
{
    row 'Cortex-M4F, float, -Os' -Os -DKERN_SINGLE $m4f
    whole=$text whole_stack=$stack
    foreign
    row 'Cortex-M4F, float, -O2' -O2 -DKERN_SINGLE $m4f
    row 'Cortex-M4F, double, -Os' -Os $m4f
    row 'Cortex-M0+, float, -Os' -Os -DKERN_SINGLE $m0
}

echo
echo '| a program that calls (Cortex-M4F, float, -Os) | text |'
echo '|---|---|'
# shellcheck disable=SC2086
compile -Os -DKERN_SINGLE $m4f $in_sections || exit 1
while read -r -a functions; do
    linked "${functions[@]}"
    size=$(text_of kern.elf)
    name=kern_${functions[0]}
    case ${functions[*]} in
    *contact_make) name="$name, contacts given" ;;
    *" contacts "*) name="$name and kern_contacts" ;;
    esac
    printf '| %s | %s |\n' "$name" "$size"
    case ${functions[*]} in
    "$given") size_given=$size ;;
    "verdict contact_make") size_verdict=$size ;;
    esac
done <<<"$programs"

echo
echo '| Cortex-M4F, float, -Os | goal | limit | today |'
echo '|---|---|---|---|'
held "tokens of the implementation" "$(python3 tests/judge.py tokens kern.h)"
held "text of the library" "$whole"
held "text, kern_measure with contacts given" "$size_given"
held "text, kern_verdict with contacts given" "$size_verdict"
# shellcheck disable=SC2086
compile -Os -DKERN_SINGLE $m4f $in_sections -DKERN_NO_INTERIOR || exit 1
held "text of the library, KERN_NO_INTERIOR" "$(text_of kern.o)"
# shellcheck disable=SC2086
linked $given
held "text, kern_measure, KERN_NO_INTERIOR" "$(text_of kern.elf)"
linked verdict contact_make
held "text, kern_verdict, KERN_NO_INTERIOR" "$(text_of kern.elf)"
held "deepest stack" "$whole_stack"

[ ! -s "$out/failed" ] || { cat "$out/failed"; exit 1; }
