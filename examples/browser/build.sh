#!/usr/bin/env bash
# bash examples/browser/build.sh [FOLDER]
#
# Makes the pages kern.html (of page.html) and essay.html (of steps.html), here
# or in FOLDER: each with the files that it includes, page.c as WebAssembly and
# structures. Needs clang, lld (wasm-ld), gzip and base64; the same versions of
# them make the same pages.
set -eu
shopt -s extglob
folder=$(cd "${1:-$(dirname "$0")}" && pwd)
cd "$(dirname "$0")"
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT

exports=""
for name in vertex force motion meeting group centre point overlap fault answer constant; do
    exports="$exports -Wl,--export=$name"
done
# shellcheck disable=SC2086
clang --target=wasm32 -std=c99 -Oz -mbulk-memory \
    -ffp-contract=off -nostdlib -fno-builtin -Wall -Wextra -Werror \
    -Wl,--no-entry -Wl,--strip-all $exports \
    -o "$out/page.wasm" page.c

# Prints a source with what it asks for, without comments and indentation.
assemble() {
    local line name
    while IFS= read -r line; do
        case $line in
        *"<!-- include "*)
            line=${line#*<!-- include }
            assemble "${line% -->}"
            ;;
        "<!-- structures "*)
            line=${line#<!-- structures }
            for name in ${line% -->}; do
                printf '%s' "<script type=\"text/plain\" data-structure " \
                    "id=\"$name\">"
                sed 's/ *#.*//; /^$/d' "../structures/$name.kern" | tr '\n' '|'
                echo "</script>"
            done
            ;;
        *"<!-- wasm -->"*)
            printf '%s' "${line%%<!-- wasm -->*}"
            gzip -9n <"$out/page.wasm" | base64 -w 0
            printf '%s\n' "${line#*<!-- wasm -->}"
            ;;
        *([[:space:]])/\**) # a comment on lines of its own
            while [[ $line != *\*/ ]]; do IFS= read -r line; done
            ;;
        *) # without its indentation and the comment behind it
            line=${line##*([[:space:]])}
            printf '%s\n' "${line%%+([[:space:]])// *}"
            ;;
        esac
    done <"$1"
}

for page in page.html:kern.html steps.html:essay.html; do
    assemble "${page%:*}" | tr '\n' ' ' >"$out/page"
    mv "$out/page" "$folder/${page#*:}"
done
