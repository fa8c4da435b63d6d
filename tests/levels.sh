#!/usr/bin/env bash
# bash tests/levels.sh [N]     levels in float against those in double
#
# Of N random structures (10,000): the same level on 99 %, the others one apart
# or undecided, and never the opposite verdict. More than one apart are levels
# only where it is open what exists: a load within the tolerance of a closed
# kern, or a contact as short as the coordinates' last digits.
set -u
cd "$(dirname "$0")/.." || exit 1
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
many=${1:-10000}
for precision in "" -DKERN_SINGLE; do
    # shellcheck disable=SC2086
    ${CC:-cc} -O2 -ffp-contract=off $precision -o "$out/levels" \
        tests/levels.c -lm || exit 1
    "$out/levels" "$many" >"$out/in${precision:-double}"
done
join "$out/indouble" "$out/in-DKERN_SINGLE" --nocheck-order | awk '
    # seed, then status level contacts closing in double, and again in float
    $2 >= 0 && $6 >= 0 && $2 != $6 { opposite++; print "verdict:", $0; next }
    $6 == -1 || ($6 >= 0 && $7 == -1) { undecided++; next }
    $2 != $6 { other++; print "status:", $0; next }
    $3 == $7 { same++; next }
    $3 - $7 == 1 || $7 - $3 == 1 { one++; next }
    $5 || $9 || $4 != $8 { open++; next }
    { more++; print "level:", $0 }
    END {
        printf "%d structures: same level %d, one apart %d, undecided in " \
            "float %d, open %d, more than one apart %d, other status %d, " \
            "opposite verdict %d\n", NR, same, one, undecided, open, more, \
            other, opposite
        exit !(NR > 0 && same >= 0.99 * NR && open <= 0.001 * NR && !more \
            && !other && !opposite)
    }'
