#!/usr/bin/env bash
# bash tests/fused.sh
#
# No multiplication and addition may become one operation that rounds once,
# also where the processor has it: gcc and clang for x86-64-v3, in double and in
# float, at -O3, which does all that -O2 does. No vfm* may stand in the object
# code of golden.c with all of kern.h, of examples/kern.c, and of other examples
# (with -fno-tree-vectorize). The hashes of golden.c must be what they are
# everywhere: that takes a processor with FMA or qemu-x86_64; without either it
# is left out, and said so.
set -u
cd "$(dirname "$0")/.." || exit 1
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
exact="-ffp-contract=off"
v3="-march=x86-64-v3"
failed=0

fail() { echo "FAILED: $*"; failed=1; }

case $(uname -m) in x86_64) ;; *) echo "not an x86-64: left out"; exit 0 ;; esac
runner=none
if grep -qw fma /proc/cpuinfo; then runner=
elif command -v qemu-x86_64 >/dev/null; then runner="qemu-x86_64 -cpu max"
else echo "no FMA here, and no qemu-x86_64: hashes are not compared"
fi

fused() { # fused OBJECT: the functions with fused operations, if any
    objdump -d "$1" |
        awk '/^[0-9a-f]+ <.*>:/ { f = $2 } /\tvfn?m/ { print f }' | sort -u
}

free_of_fused() { # free_of_fused NAME COMPILER FLAGS...: makes $out/object.o
    local name=$1 found
    shift
    "$@" -c -o "$out/object.o" || { fail "$name: not compiled"; return; }
    found=$(fused "$out/object.o")
    [ -z "$found" ] || fail "$name: fused in" $found
}

# does this find anything at all?
echo 'double f(double a, double b, double c) { return a * b + c; }' >"$out/f.c"
gcc -O2 -mfma -ffp-contract=fast -c "$out/f.c" -o "$out/f.o" &&
    [ -n "$(fused "$out/f.o")" ] || fail "fused operations are not seen"

for precision in "" -DKERN_SINGLE; do
    for cc in gcc clang; do
        name="golden.c, $cc -O3 $v3${precision:+, float}"
        before=$failed
        free_of_fused "$name" $cc -O3 $v3 $exact $precision -DGOLDEN_WHOLE \
            tests/golden.c
        [ "$runner" = none ] ||
            { $cc "$out/object.o" -o "$out/v3" -lm &&
                $runner "$out/v3" 200; } || fail "$name"
        [ $failed -ne "$before" ] || echo "ok      $name"
    done
done
free_of_fused "kern.c, gcc -O3 $v3" gcc -O3 $v3 $exact examples/kern.c
for example in laboratory/stack laboratory/shake place; do
    free_of_fused "examples/$example.c, gcc -O3 $v3" gcc -std=c99 -O3 $v3 \
        $exact -fno-tree-vectorize "examples/$example.c"
done
[ $failed -eq 0 ] && echo "nothing is fused"
exit $failed
