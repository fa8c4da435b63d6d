#!/usr/bin/env bash
# bash examples/browser/build.sh [FOLDER]
#
# Makes kern.html and essay.html, here or in FOLDER: page.html and essay.html.in
# with page.c as WebAssembly, and with structures or chapters of page.html's
# script in them. Needs clang, lld (wasm-ld), gzip and base64; the same versions
# of them make the same pages.
set -eu
shopt -s extglob
folder=$(realpath "${1:-$(dirname "$0")}")
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

chapters() { # those of page.html in place of lines <!-- page.html: HEAD -->
    awk 'FNR == NR {
            if (/^\/\* (====|----) /) { head = $2 " " $3
                for (i = 4; i <= NF && $i !~ /^(=|-|\*)/; i++) head = head " " $i }
            chapter[head] = chapter[head] $0 "\n"; next
        }
        /^<!-- page.html: / { sub(/^<!-- page.html: /, ""); sub(/ -->$/, "")
            printf "%s", chapter[$0]; next }
        { print }' page.html "$1"
}

make_page() { # make_page SOURCE: the page, on one line
    chapters "$1" | while IFS= read -r line; do
        case $line in
        "<!-- structures -->")
            for name in wall-30 irregular-wall arch tower falls; do
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
    done | tr '\n' ' '
}

make_page page.html >"$out/kern.html"
make_page essay.html.in >"$out/essay.html"
mv "$out/kern.html" "$out/essay.html" "$folder"
