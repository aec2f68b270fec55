#!/bin/sh
# Instructions a tick takes, counted by callgrind while ticks run: the difference of two runs of different length, so
# that the first ticks do not count. `tick_cost.sh BUILD_FOLDER`
set -eu

program=${1:?the build folder}/tests/bench/tick_cost

counted() {
    valgrind --tool=callgrind --callgrind-out-file=/dev/null --instr-atstart=no --toggle-collect='*::run_ticks(*' "$program" "$@" 2>&1 | sed -n 's/.*Collected : //p'
}

# SECTORS ACTIVE SEEN: instructions of one tick
per_tick() {
    echo $((($(counted "$@" 300) - $(counted "$@" 200)) / 100))
}

printf '%10s %8s %6s %18s %s\n' sectors active seen instructions/tick allocations
for sectors in 1000 10000 100000; do
    for how in '0 0' '10 0' '10 100' '10 200'; do
        # shellcheck disable=SC2086 # two words
        set -- $sectors $how
        allocations=$("$program" "$@" 300)
        printf '%10s %8s %6s %18s %s\n' "$@" "$(per_tick "$@")" "${allocations%% *}"
    done
done
