#!/usr/bin/env bash
# bash tests/golden.sh            every target whose compiler is installed
# bash tests/golden.sh --all      a missing compiler or emulator is an error
#
# Compiles tests/golden.c for each target, in double and in float, runs it
# (natively, in qemu-user, or on the bare Cortex-M4F in qemu-system-arm) and
# expects the hashes that stand in golden.c. At the end, flags that break the
# promise must be noticed. After a change that is meant to change results, copy
# the hashes that the first line prints into golden.c. Two targets run at a
# time.
set -u
cd "$(dirname "$0")/.." || exit 1
all=${1:-}
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
exact="-ffp-contract=off"
jobs=0

missing() { # missing COMMAND...: is one of them not installed?
    local command
    for command in "$@"; do
        [ -n "$command" ] || continue
        command -v "$command" >/dev/null && continue
        echo "no $command"
        [ "$all" != --all ] || echo "FAILED: no $command"
        return 0
    done
    return 1
}

start() { # start COMMAND...: in the background, output kept in order
    jobs=$((jobs + 1))
    mkdir "$out/$jobs"
    [ $jobs -le 2 ] || wait -n
    (cd "$out/$jobs" && "$@") >"$out/$jobs.log" 2>&1 &
}

# ---- what runs in the background, in a directory of its own
root=$PWD

both() { # both NAME RUNNER COMPILER FLAGS...: $count structures in both precisions
    local name=$1 runner=$2 cc=$3 precision
    shift 3
    missing "$cc" "$runner" && return
    for precision in "" -DKERN_SINGLE; do
        # shellcheck disable=SC2086
        { $cc $exact $precision "$@" "$root/tests/golden.c" -o golden -lm &&
            timeout 300 $runner ./golden $count; } >log 2>&1 ||
            echo "FAILED: status $?" >>log
        sed "s/^/$(printf '%-32s' "$name")/" log
    done
}

board() { # on the bare Cortex-M4F; libm has the square root of a double
    local precision
    missing arm-none-eabi-gcc qemu-system-arm && return
    for precision in "" -DKERN_SINGLE; do
        # shellcheck disable=SC2086
        { arm-none-eabi-gcc -Os -mcpu=cortex-m4 -mthumb -mfloat-abi=hard \
            -mfpu=fpv4-sp-d16 $exact $precision -ffunction-sections \
            -fdata-sections -Wl,--gc-sections -nostartfiles -DGOLDEN_BARE \
            -Wl,--defsym=board_ram=0x20000 \
            -T "$root/examples/firmware/mps2-an386.ld" \
            "$root/tests/golden.c" "$root/examples/firmware/board.c" \
            -o golden -lm &&
            timeout 300 qemu-system-arm -M mps2-an386 -nographic \
                -semihosting-config enable=on,target=native \
                -kernel golden; } >log 2>&1 || echo "FAILED: status $?" >>log
        sed "s/^/$(printf '%-32s' "Cortex-M4F, bare")/" log
    done
}

broken() { # broken NAME RUNNER COMPILER FLAGS...: must not compile or not pass
    local name=$1 runner=$2 cc=$3
    shift 3
    missing "$cc" "$runner" && return
    # shellcheck disable=SC2086
    if $cc "$@" "$root/tests/golden.c" -o golden -lm >log 2>&1 &&
        timeout 300 $runner ./golden 200 >log 2>&1; then
        echo "FAILED: nothing noticed $name"
    else
        printf '%-32snoticed: %s\n' "$name" "$(
            sed -nE 's/.*(FAILED: |error: (#error )?)//p' log | head -n 1)"
    fi
}

count=""
for opt in -O0 -O1 -O2 -O3 -Os; do
    start both "x86-64 gcc $opt" "" gcc $opt
    start both "x86-64 clang $opt" "" clang $opt
done
count=200 # doubles are slow without an FPU and in QEMU
start both "ARM soft float" qemu-arm arm-linux-gnueabi-gcc -O2 -static
start both "PowerPC (big-endian)" qemu-ppc powerpc-linux-gnu-gcc -O2 -static
count=1000
start both "s390x (big-endian)" qemu-s390x s390x-linux-gnu-gcc -O2 -static
start both "i386 SSE" qemu-i386 i686-linux-gnu-gcc -O2 -msse2 -mfpmath=sse \
    -static
start both "AArch64" qemu-aarch64 aarch64-linux-gnu-gcc -O2 -static
start both "ARM hard float" qemu-arm arm-linux-gnueabihf-gcc -O2 -static
start board
start broken "-ffast-math" "" gcc -O2 -ffast-math
start broken "-Ofast" "" clang -Ofast
start broken "-funsafe-math-optimizations" "" gcc -O2 \
    -funsafe-math-optimizations
start broken "x87" qemu-i386 i686-linux-gnu-gcc -O2 -mfpmath=387 -static
grep -qw fma /proc/cpuinfo && start broken "fused multiply-add, x86-64" "" \
    gcc -O2 -mfma -ffp-contract=fast
start broken "fused multiply-add, AArch64" qemu-aarch64 aarch64-linux-gnu-gcc \
    -O2 -ffp-contract=fast -static
start broken "fused multiply-add, PowerPC" qemu-ppc powerpc-linux-gnu-gcc \
    -O2 -ffp-contract=fast -static
wait
for ((i = 1; i <= jobs; i++)); do cat "$out/$i.log"; done | tee "$out/all.log"
if grep -q FAILED "$out/all.log"; then
    echo "not every target agrees"
    exit 1
fi
echo "every target agrees"
