#!/bin/sh
# Writes FIGURES.md beside this script: how long frames take, the instructions of a pixel, and what ticks, effects and
# parts of the engine cost, with the machine, compiler and commit they were measured on. `figures.sh BUILD_FOLDER
# [SUBJECT...]`: with the programs built there (ninja enfilade wadconv bench_programs); more subjects as `enfilade bench`
# takes them, MAP:WALK.csv for one. Measures for some minutes: leave the machine alone meanwhile. What effects cost that
# are not used takes longer to find out: `effect_cost.sh FOLDER >BUILD_FOLDER/effect_cost.md` before.
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

# MAP: which functions the instructions of drawing go to, from 0.5 % on.
profile() {
    valgrind --tool=callgrind --callgrind-out-file="$work/callgrind" --toggle-collect='*draw_measured*' \
        "$enfilade" bench --threads 1 --rounds 1 --quiet "$1" >/dev/null 2>&1 || return 0
    callgrind_annotate "$work/callgrind" | sed -nE 's/^ *[0-9,]+ \( ?([0-9.]+)%\) +[^:]*:(.*)\[.*$/\1 \2/p' |
        sed -E "s/, /,/g; s/enfilade::|column::|\(anonymous namespace\)::|^([0-9.]+ )void /\1/g; s/\(.*//; s/'.*//" |
        awk '{ share[$2] += $1 } END { for (name in share) if (share[name] >= 0.5) printf "%5.1f %%  %s\n", share[name], name }' |
        sort -rn
}

figures() {
    # shellcheck disable=SC2016 # quotes of Markdown
    printf '# Figures\n\nWritten by `tests/bench/figures.sh`.\n\n'
    printf '%s\n' "- machine: $(machine), $(uname -sm)"
    printf '%s\n' "- compiler: $("$(cached CMAKE_CXX_COMPILER)" --version | head -n 1), $(cached CMAKE_BUILD_TYPE)"
    printf '%s\n' "- commit: $(git -C "$top" describe --always --dirty --abbrev=12)"
    printf '\nTimes differ from run to run, on a shared machine by half and more; counts of instructions do not.\n'
    section 'Frames, 1280x800, one thread' "$enfilade" bench --threads 1 "$@"
    section 'Frames, 320x200, one thread' "$enfilade" bench --threads 1 --size 320x200 "$@"
    section 'Frames, 1280x800, two threads' "$enfilade" bench --threads 2 "$@"
    section 'Instructions, 1280x800' instructions "$@"
    for map in "$@"; do section "Where the instructions of $map go, 1280x800" profile "$map"; done
    section 'Parts' parts
    section 'Ticks, in instructions' "$top/tests/bench/tick_cost.sh" "$build"
    section 'Longest ticks' "$build/tests/bench/worst_tick"
    section 'Pictures in play, 60 a second' env SDL_VIDEODRIVER=dummy "$build/tests/bench/frame_pacing" enfilade.toml
    if [ -e "$work/MAP15/map15.toml" ]; then
        section 'Hearing in MAP15, four sounds at a time' "$build/tests/bench/hearing_cost" "$work/MAP15/map15.toml" 4
    fi
    # shellcheck disable=SC2016 # quotes of Markdown
    printf '\n## Effects of maps/effects.toml, 640x400, one thread\n\nWritten by `enfilade bench --effects`.\n\n'
    "$enfilade" bench --effects effects.toml
    [ -e "$build/effect_cost.md" ] || return 0
    # shellcheck disable=SC2016 # quotes of Markdown
    printf '\n## Effects that are not used\n\nWritten by `tests/bench/effect_cost.sh`: instructions for a pixel of plain rooms, in the\nengine as it is and in builds with one effect left out.\n\n'
    cat "$build/effect_cost.md"
}

for level in 'freedoom1 E1M1' 'freedoom2 MAP12'; do
    # shellcheck disable=SC2086 # two words
    map=$(converted $level)
    [ -z "$map" ] || set -- "$@" "$map"
done
converted freedoom2 MAP15 >/dev/null
for map in enfilade mirrors effects; do
    cp "$top/maps/$map.toml" "$work"
    set -- "$@" "$map.toml"
done
cp -R "$top/maps/textures" "$top/maps/sounds" "$work"
cd "$work"
figures "$@" >"$top/tests/bench/FIGURES.md.new"
mv "$top/tests/bench/FIGURES.md.new" "$top/tests/bench/FIGURES.md"
