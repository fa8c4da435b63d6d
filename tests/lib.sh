# Sourced by the scripts of this folder. The working directory is the root of
# the project; $out is a directory for what a script makes, and goes when it
# ends. A script is called with the name of one of its checks:
#
#     bash tests/programs.sh pictures
set -u
cd "$(dirname "${BASH_SOURCE[0]}")/.." || exit 1
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
exact="-ffp-contract=off"
plain="-std=c99 -O2 -Wall -Wextra -Werror $exact"
sanitize="-g -O1 -fsanitize=address,undefined -fno-sanitize-recover=all"
judge="python3 tests/judge.py"

# Checks of one run share the programs that they build: they lie in $PROGRAMS.
programs=${PROGRAMS:-$out}

program() { # program NAME SOURCE FLAGS...: builds it once, prints its path
    local name=$1 source=$2
    shift 2
    # shellcheck disable=SC2086
    flock "$programs/$name.lock" sh -c '[ -x "$0" ] || gcc "$@"' \
        "$programs/$name" $plain "$source" "$@" -o "$programs/$name" -lm &&
        echo "$programs/$name"
}

keeps() { # keeps COMMAND...: each refuses to write a picture over a structure
    local command file=$out/kept.kern
    cp examples/structures/tower.kern "$file" || return 1
    for command in "$@"; do
        $command "$file" examples/structures/falls.kern >"$out/o" 2>"$out/e"
        [ $? -eq 2 ] && cmp "$file" examples/structures/tower.kern || return 1
    done
}

# The check that the command line names.
run_check() {
    [ "$(type -t "${1:-}")" = function ] ||
        { echo "usage: bash $0 CHECK: see \"() {\" in it"; exit 2; }
    "$@"
}
