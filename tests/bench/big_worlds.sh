#!/bin/sh
# Worlds of 10^3 to 10^6 sectors with the same view: what they take to load, from their text and from the cache, and what
# a frame takes in each. `big_worlds.sh BUILD_FOLDER [MOST_SECTORS]`; the first load of 10^6 takes 7 GB.
set -eu

build=${1:?the build folder}
most=${2:-1000000}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export XDG_CACHE_HOME="$folder/cache"

# SECTORS: without pictures, so that chequers are drawn; districts of 10 x 10 rooms of 4 m, open to one another within a district; the player looks across the first.
world() {
    awk -v sectors="$1" '
    function room(d, i, j) { return "r" (d * 100 + j * 10 + i) }
    function side(d, i, j, is_open) {
        return is_open ? "{next = \"" room(d, i, j) "\", texture = \"step\"}" : "{texture = \"wall\"}"
    }
    BEGIN {
        across = 1; while (across * across * 100 < sectors) ++across
        print "format = 1\n[player]\nsector = \"r0\"\nx = 2\ny = 2\nz = 1.75\nyaw = 45\n"
        for (d = 0; d * 100 < sectors; ++d) for (j = 0; j < 10; ++j) for (i = 0; i < 10; ++i) {
            x = d % across * 41 + i * 4; y = int(d / across) * 41 + j * 4
            printf "[[sectors]]\nname = \"%s\"\nlight = %g\n", room(d, i, j), 0.5 + (i * 7 + j * 3) % 8 / 16
            printf "floor = {z = %g, texture = \"floor\"}\n", (i * 3 + j * 5) % 4 / 8
            printf "ceiling = {z = %g, texture = \"roof\"}\n", 3 + (i + j * 7) % 5 / 4
            printf "[[sectors.loops]]\nv = [%d, %d, %d, %d, %d, %d, %d, %d]\n", x, y, x + 4, y, x + 4, y + 4, x, y + 4
            printf "walls = [%s, %s, %s, %s]\n", side(d, i, j - 1, j > 0), side(d, i + 1, j, i < 9), \
                side(d, i, j + 1, j < 9), side(d, i - 1, j, i > 0)
        }
    }'
}

# MAP: instructions of its first frame
frame_instructions() {
    valgrind --tool=callgrind --callgrind-out-file=/dev/null --instr-atstart=yes \
        --toggle-collect='*::ColumnRenderer::render_columns(*' "$build/engine/app/enfilade" render "$1" \
        --size 1280x800 --threads 1 --out "$folder/frame.png" 2>&1 | sed -n 's/.*Collected : //p'
}

printf '%9s %28s %28s %20s\n' sectors 'from text: s, cpu s, MiB' 'again: s, cpu s, MiB' instructions/frame
maps=
for sectors in 1000 10000 100000 1000000; do
    [ "$sectors" -le "$most" ] || break
    map=$folder/$sectors.toml
    world "$sectors" >"$map"
    maps="$maps $map"
    first=$("$build/tests/bench/map_load" "$map" 2>/dev/null)
    again=$("$build/tests/bench/map_load" "$map" 2>/dev/null)
    "$build/engine/app/enfilade" render "$map" --size 16x10 --out "$folder/frame.png" 2>/dev/null  # its own cache
    printf '%9s %28s %28s %20s\n' "$sectors" "${first% * *}" "${again% * *}" "$(frame_instructions "$map")"
done

# Frames of all worlds in turn.
# shellcheck disable=SC2086 # one word for each map
"$build/engine/app/enfilade" bench $maps --threads 1 --rounds 25 2>/dev/null
