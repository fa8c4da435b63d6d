#!/usr/bin/env bash
# bash tests/wasm.sh            the golden hashes in WebAssembly, under node
# bash tests/wasm.sh --time     and how much longer it takes than a native build
#
# Needs clang, wasm-ld (lld) and node. The code is compiled as the page in
# examples/browser is: without a C library, the square root an instruction.
set -eu
cd "$(dirname "$0")/.."
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT

cat >"$out/string.h" <<'C'
void *memcpy(void *to, const void *from, __SIZE_TYPE__ bytes);
void *memset(void *to, int value, __SIZE_TYPE__ bytes);
C
cat >"$out/run.js" <<'JS'
const fs = require("fs");
const code = new WebAssembly.Module(fs.readFileSync(process.argv[2]));
const library = new WebAssembly.Instance(code, { env: {
    board_print(at) {
        const bytes = Buffer.from(library.memory.buffer, at, 200);
        process.stdout.write(bytes.subarray(0, bytes.indexOf(0)));
    },
} }).exports;
let status = library.golden_main();
for (let round = Number(process.argv[3] || 0); round > 0; round--) {
    const start = process.cpuUsage().user;
    status |= library.golden_main();
    console.log("seconds", (process.cpuUsage().user - start) / 1e6);
}
process.exit(status);
JS

build() { # build FLAGS...: golden.wasm
    clang --target=wasm32 -std=c99 -Os -mbulk-memory \
        -ffp-contract=off -nostdlib -I"$out" -DGOLDEN_BARE -Dmain=golden_main "$@" \
        -Wl,--no-entry -Wl,--allow-undefined -Wl,--export=golden_main \
        -o "$out/golden.wasm" tests/golden.c
}

build '-DKERN_SQRT(x)=__builtin_sqrtf(x)' -DKERN_SINGLE
node "$out/run.js" "$out/golden.wasm"
build '-DKERN_SQRT(x)=__builtin_sqrt(x)'
node "$out/run.js" "$out/golden.wasm"
[ "${1:-}" = --time ] || exit 0

clang -O2 -ffp-contract=off -o "$out/golden" tests/golden.c -lm
TIMEFORMAT="seconds %U"
for _ in 1 2 3 4 5 6; do
    time "$out/golden" 200
done >"$out/native" 2>&1
node "$out/run.js" "$out/golden.wasm" 6 >"$out/wasm"
for run in wasm native; do
    sed -n 's/^seconds //p' "$out/$run" | sort -n | head -n 1
done | paste -sd ' ' | awk '{ printf "200 structures: %.3f s of CPU, ", $1
    printf "native %.3f s: %.2f times\n", $2, $1 / $2 }'
