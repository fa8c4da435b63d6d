#!/usr/bin/env bash
# bash tests/bench.sh [OPTIONS]    measures and writes the tables of BENCH.md;
#                                  without OPTIONS with --quick --release
#
# GLPK and Clp are asked where their headers are; DAQP, OSQP and Box2D where the
# variables DAQP, OSQP and BOX2D name their folders (the head of bench.c says how
# they are made).
. "$(dirname "$0")/lib.sh"

with=() libraries=()
[ -e /usr/include/glpk.h ] && with+=(-DBENCH_GLPK) && libraries+=(-lglpk)
[ -e /usr/include/coin/Clp_C_Interface.h ] && with+=(-DBENCH_CLP) &&
    libraries+=(-lClp -lCoinUtils)
[ -n "${DAQP:-}" ] && with+=(-DBENCH_DAQP -I"$DAQP/include") &&
    libraries+=(-L"$DAQP" -ldaqp)
[ -n "${OSQP:-}" ] &&
    with+=(-DBENCH_OSQP -I"$OSQP/include/public"
        -I"$OSQP/build/include/public") &&
    libraries+=(-L"$OSQP/build/out" -losqpstatic)
[ -n "${BOX2D:-}" ] && with+=(-DBENCH_BOX2D -I"$BOX2D/include") &&
    libraries+=(-L"$BOX2D" -lbox2d -lpthread)

[ $# -gt 0 ] || set -- --quick --release
# shellcheck disable=SC2086
cc -O2 $exact "${with[@]}" -o "$out/bench" tests/bench.c "${libraries[@]}" -lm &&
    "$out/bench" "$@" >"$out/times.csv" &&
    awk -v summary=1 -f tests/bench.awk "$out/times.csv" >"$out/summary.md" &&
    sed -i -e '/^<!-- bench/,/^<!-- end/{//!d}' \
        -e "/^<!-- bench/r $out/summary.md" tests/BENCH.md
