#!/bin/sh
# Writes the report beside this script: what accuracy costs in time. `report.sh BUILD_FOLDER`: with the programs built
# there (ninja enfilade wadconv texel_rows peer_views). Two maps of FreeDoom are among the scenes where it is installed. Counts
# instructions where valgrind is installed and draws the pictures where gnuplot is; that takes up to an hour, and
# `report.sh BUILD_FOLDER --resume` goes on where it was cut off. Times mean something on a machine left alone.
# PEER_VIEWS may name a folder with pictures by dsda-doom, as tests/wadconv/freedoom/peer_views.cpp wants them.
set -eu

here=$(cd "$(dirname "$0")" && pwd)
build=$(cd "${1:?the build folder}" && pwd)
shift
maps=$here/../../maps
wads=${DOOMWADDIR:-/usr/share/games/doom}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# WAD MAP: converted, where the WAD is installed
converted() {
    [ -e "$wads/$1.wad" ] || return 0
    "$build/wadconv/wadconv" "$wads/$1.wad" --map "$2" --out "$work/$2" >/dev/null
    echo "$work/$2/$(echo "$2" | tr '[:upper:]' '[:lower:]').toml"
}

# shellcheck disable=SC2046 # none or one word each
"$build/engine/app/enfilade" accuracy "$maps/rooms.toml" "$maps/enfilade.toml" "$maps/hut.toml" \
    "$maps/quarter_turn.toml" "$maps/facing_doors.toml" $(converted freedoom1 E1M1) $(converted freedoom2 MAP01) \
    --out "$here" "$@" >/dev/null

# Another renderer of two maps, held against the truth as anybody's pictures can be; nothing where it does not start.
score_of() {
    for map in rooms quarter_turn; do
        "$build/engine/app/enfilade" render "$maps/$map.toml" --views "$work/truth/$map/views.csv" --size 320x200 \
            --renderer "$1" --out "$work/$1/$map/colors" --ids "$work/$1/$map/ids" --quiet || return 0
    done
    printf '\nThe %s renderer:\n\n' "$1"
    "$build/engine/app/enfilade" accuracy "$maps/rooms.toml" "$maps/quarter_turn.toml" --score "$work/$1"
}

# Scripts and pictures name no folder of this machine.
sed -i "s|$here/||g" "$here/accuracy.gp"
{
    cat <<'TEXT'

## Other ways, old and new

A wall that goes away from the eye, drawn row by row as engines of polygons did, by `tests/bench/texel_rows`. All but the
last are held against a division for each pixel in double, which is within 1e-12.

TEXT
    "$build/tests/bench/texel_rows"
    cat <<'TEXT'

Three claims, tried today:

- *One division every 16 pixels is nearly as fast as none, and nobody sees the difference* (Michael Abrash, "Graphics
  Programming Black Book", 1997). It was so. A processor of today divides while it waits for texels: dividing for each
  pixel is faster than drawing straight lines between every sixteenth, which are off by many texels on such a wall.
- *A bound of the error saves several orders of magnitude of divisions* (Yakov Kamen, Leon Shirman, "Triangle Rendering
  Using Adaptive Subdivision", 1998). The bound is kept, and a twelfth of the divisions do; but choosing the spans costs
  more than the divisions.
- *Additions alone are twice as fast as divisions* (Bart Barenbrug, Frans Peters, Kees van Overveld, "Algorithms for
  Division Free Perspective Correct Rendering", 2000). They find the right texels, and are slower by half: a texel's
  step waits for the one before.
TEXT
    cat <<'TEXT'

## Other renderers

Held against the truth by `enfilade accuracy --score`, as the pictures of anybody else can be.
TEXT
    "$build/engine/app/enfilade" accuracy "$maps/rooms.toml" "$maps/quarter_turn.toml" --export "$work/truth"
    score_of column
    score_of stencil
    [ -z "${PEER_VIEWS:-}" ] || cat <<TEXT

dsda-doom's software renderer, of levels of FreeDoom, 1280 x 800 pixels, most without things, beside the column renderer:
blocks of 8 x 8 pixels are alike where their mean colours are within 12 of 255. It is measured by
\`tests/wadconv/freedoom/peer_views\`.

$("$build/tests/wadconv/freedoom/peer_views" "$PEER_VIEWS")
TEXT
} >>"$here/README.md"
