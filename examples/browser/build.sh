#!/usr/bin/env bash
# bash examples/browser/build.sh [FILE]
#
# Makes the page kern.html, or FILE: page.html with page.c as WebAssembly and
# with structures in it. Needs clang, lld (wasm-ld), gzip and base64; the same
# versions of them make the same page.
set -eu
shopt -s extglob
cd "$(dirname "$0")"
page=${1:-kern.html}
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

{
    while IFS= read -r line; do
        case $line in
        "<!-- structures -->")
            for name in wall-30 irregular-wall arch tower toppling-slope falls; do
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
    done <page.html
} | tr '\n' ' ' >"$out/page"
mv "$out/page" "$page"
