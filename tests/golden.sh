#!/usr/bin/env bash
# bash tests/golden.sh            every target whose compiler is installed
# bash tests/golden.sh GROUP...   the groups of targets named (the functions at
#                                 the end); a missing compiler is an error
#
# Compiles tests/golden.c for each target, in double and in float, runs it
# (natively, in qemu-user, or on the bare Cortex-M4F in qemu-system-arm) and
# expects the hashes that stand in golden.c. Flags that break the promise must
# be noticed. After a change that is meant to change results, copy the hashes
# that the first line prints into golden.c.
. "$(dirname "$0")/lib.sh"

wanted="$*"
failed=0
say() { printf '%-32s%s\n' "$@"; }
fail() { say "$1" "FAILED: $2"; failed=1; }

missing() { # missing COMMAND...: is one of them not installed?
    local command
    for command in "$@"; do
        [ -n "$command" ] || continue
        command -v "$command" >/dev/null && continue
        [ -z "$wanted" ] && say "no $command" "left out" || fail "no $command" ""
        return 0
    done
    return 1
}

both() { # both NAME RUNNER COUNT COMPILER FLAGS...: in both precisions
    local name=$1 runner=$2 count=$3 cc=$4 precision
    shift 4
    missing "$cc" "${runner%% *}" && return
    for precision in "" -DKERN_SINGLE; do
        # shellcheck disable=SC2086
        { $cc $exact $precision "$@" tests/golden.c -o "$out/golden" -lm &&
            timeout 300 $runner "$out/golden" $count; } >"$out/log" 2>&1 ||
            fail "$name" "status $?"
        sed "s/^/$(printf '%-32s' "$name")/" "$out/log"
    done
}

broken() { # broken NAME RUNNER COMPILER FLAGS...: must not compile or not pass
    local name=$1 runner=$2 cc=$3
    shift 3
    missing "$cc" "$runner" && return
    if $cc -O2 "$@" tests/golden.c -o "$out/golden" -lm >"$out/log" 2>&1 &&
        timeout 300 $runner "$out/golden" 200 >"$out/log" 2>&1; then
        fail "$name" "not noticed"
    else
        say "$name" "noticed: $(
            sed -nE 's/.*(FAILED: |error: (#error )?)//p' "$out/log" |
                head -n 1)"
    fi
}

# ---- groups; doubles are slow in QEMU, slower without an FPU

native() { # native COMPILER
    local opt
    for opt in -O0 -O1 -O2 -O3 -Os; do
        both "x86-64 $1 $opt" "" 5000 "$1" $opt
    done
}

by_gcc() { native gcc; }

by_clang() { native clang; }

little() {
    both "i386 SSE" qemu-i386 1000 i686-linux-gnu-gcc -O2 -msse2 -mfpmath=sse \
        -static
    both "AArch64" qemu-aarch64 1000 aarch64-linux-gnu-gcc -O2 -static
    both "ARM hard float" qemu-arm 1000 arm-linux-gnueabihf-gcc -O2 -static
    # libgcc 12 rounds some sums of doubles wrong, as 1 - 0x1.4430308p-33
    both "ARM soft float" qemu-arm 200 arm-linux-gnueabi-gcc -O2 -static
}

big() {
    both "PowerPC (big-endian)" qemu-ppc 200 powerpc-linux-gnu-gcc -O2 -static
    both "s390x (big-endian)" qemu-s390x 200 s390x-linux-gnu-gcc -O2 -static
}

bare() { # libm has the square root of a double
    both "Cortex-M4F, bare" "qemu-system-arm -M mps2-an386 -nographic
        -semihosting-config enable=on,target=native -kernel" "" \
        arm-none-eabi-gcc -Os -mcpu=cortex-m4 -mthumb -mfloat-abi=hard \
        -mfpu=fpv4-sp-d16 -ffunction-sections -fdata-sections \
        -Wl,--gc-sections -nostartfiles -DGOLDEN_BARE \
        -Wl,--defsym=board_ram=0x20000 \
        -T examples/firmware/mps2-an386.ld examples/firmware/board.c
}

promise() { # what breaks it
    broken "-ffast-math" "" gcc -ffast-math
    broken "-Ofast" "" clang -Ofast
    broken "-funsafe-math-optimizations" "" gcc -funsafe-math-optimizations
    broken "x87" qemu-i386 i686-linux-gnu-gcc -mfpmath=387 -static
    ! grep -qw fma /proc/cpuinfo || broken "fused multiply-add, x86-64" "" \
        gcc -mfma -ffp-contract=fast
    broken "fused multiply-add, AArch64" qemu-aarch64 aarch64-linux-gnu-gcc \
        -ffp-contract=fast -static
    broken "fused multiply-add, PowerPC" qemu-ppc powerpc-linux-gnu-gcc \
        -ffp-contract=fast -static
}

for group in ${wanted:-by_gcc by_clang little big bare promise}; do
    run_check "$group"
done
[ $failed -eq 0 ] && echo "every target agrees" ||
    { echo "not every target agrees"; exit 1; }
