#!/bin/sh
# Writes FIGURES.md beside this script: how long frames take, the instructions of a pixel, and what parts of the engine
# cost, with the machine, compiler and commit they were measured on. `figures.sh BUILD_FOLDER [SUBJECT...]`: the
# programs enfilade, wadconv and part_cost built there; more subjects as `enfilade bench` takes them, MAP:WALK.csv for
# one. Measures for some minutes: leave the machine alone meanwhile.
set -eu

top=$(cd "$(dirname "$0")/../.." && pwd)
build=$(cd "${1:?the build folder}" && pwd)
shift
enfilade=$build/engine/app/enfilade
wads=${DOOMWADDIR:-/usr/share/games/doom}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cached() { sed -n "s/^$1:[A-Z]*=//p" "$build/CMakeCache.txt"; }

machine() { sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | sort | uniq -c | sed 's/^ *\([0-9]*\) /\1 x /'; }

# TITLE COMMAND...: a section with what the command prints
section() {
    printf '\n## %s\n\n```\n' "$1"
    shift
    "$@"
    printf '```\n'
}

# WAD MAP: converted, where the WAD is installed
converted() {
    [ -e "$wads/$1.wad" ] || return 0
    "$build/wadconv/wadconv" "$wads/$1.wad" --map "$2" --out "$work/$1" >/dev/null
    mv "$work/$1" "$work/$2"
    echo "$2/$(echo "$2" | tr '[:upper:]' '[:lower:]').toml"
}

parts() {
    if [ -x "$build/tests/bench/part_cost" ]; then
        "$build/tests/bench/part_cost" --benchmark_min_time=0.2 2>/dev/null
    else
        echo "not measured: part_cost is not built; it needs Google Benchmark (libbenchmark-dev)"
    fi
}

# The instructions, or why there are none.
instructions() { "$enfilade" bench --instructions "$@" 2>&1 || true; }

figures() {
    # shellcheck disable=SC2016 # quotes of Markdown
    printf '# Figures\n\nWritten by `tests/bench/figures.sh`.\n\n'
    printf '%s\n' "- machine: $(machine), $(uname -sm)"
    printf '%s\n' "- compiler: $("$(cached CMAKE_CXX_COMPILER)" --version | head -n 1), $(cached CMAKE_BUILD_TYPE)"
    printf '%s\n' "- commit: $(git -C "$top" describe --always --dirty --abbrev=12)"
    section 'Frames, 1280x800, one thread' "$enfilade" bench --threads 1 "$@"
    section 'Frames, 320x200, one thread' "$enfilade" bench --threads 1 --size 320x200 "$@"
    section 'Frames, 1280x800, two threads' "$enfilade" bench --threads 2 "$@"
    section 'Instructions, 1280x800' instructions "$@"
    section 'Parts' parts
}

for level in 'freedoom1 E1M1' 'freedoom2 MAP12'; do
    # shellcheck disable=SC2086 # two words
    map=$(converted $level)
    [ -z "$map" ] || set -- "$@" "$map"
done
for map in enfilade mirrors effects; do
    cp "$top/maps/$map.toml" "$work"
    set -- "$@" "$map.toml"
done
cp -R "$top/maps/textures" "$top/maps/sounds" "$work"
cd "$work"
figures "$@" >"$top/tests/bench/FIGURES.md.new"
mv "$top/tests/bench/FIGURES.md.new" "$top/tests/bench/FIGURES.md"
