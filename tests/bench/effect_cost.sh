#!/bin/sh
# Instructions that a pixel of rooms without any effect takes: in the engine as it is, and in builds with one effect
# left out, so that the difference is what that effect costs those who do not use it. Counted by callgrind while
# pictures are drawn, as the difference of two runs of different length, so that the first round does not count. Prints
# a table in Markdown, last scalar inner loops, and those that ask five flags for each pixel. Exit status 1 where an
# effect costs more than 0.2 %, or where a picture differs. `effect_cost.sh BUILD_FOLDER`: builds in that folder, one
# variant after the other.
set -eu

top=$(cd "$(dirname "$0")/../.." && pwd)
folder=${1:?a folder to build in}
most_percent=0.2
programs=$folder/programs

# NAME WITHOUT TARGET: builds the program without an effect and keeps it under a name
build() {
    cmake -S "$top" -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=Release -DENFILADE_WITHOUT="$2" >&2
    cmake --build "$folder" --target "$3" >&2
    mkdir -p "$programs"
    cp "$folder/tests/bench/$3" "$programs/$1"
}

counted() {
    valgrind --tool=callgrind --callgrind-out-file=/dev/null --toggle-collect='*::draw_rounds(*' "$@" 2>&1 | sed -n 's/.*Collected : //p'
}

# PROGRAM: instructions for a round
per_round() { echo $(($(counted "$1" 2) - $(counted "$1" 1))); }

# PROGRAM: fails where it draws anything else than the full engine
check_picture() {
    [ "$("$1" 1)" = "$picture" ] || {
        echo "$1 draws another picture" >&2
        exit 1
    }
}

build full '' effect_cost
build flagged '' flagged_cost
picture=$("$programs/full" 1)
pixels=${picture% *}
with_all=$(per_round "$programs/full")
awk -v all="$with_all" -v pixels="$pixels" 'BEGIN {
    print "| left out | instructions per pixel | the whole engine takes more |"
    print "|---|---|---|"
    printf "| nothing | %.3f | |\n", all / pixels
}'
status=0
for effect in $("$programs/full" names); do
    build "$effect" "$effect" effect_cost
    check_picture "$programs/$effect"
    without=$(per_round "$programs/$effect")
    awk -v name="$effect" -v all="$with_all" -v without="$without" -v pixels="$pixels" -v most="$most_percent" 'BEGIN {
        more = (all / without - 1) * 100
        printf "| %s | %.3f | %+.3f %% |\n", name, without / pixels, more
        exit more > most
    }' || status=1
done
check_picture "$programs/flagged"
ENFILADE_KERNELS=scalar
export ENFILADE_KERNELS
scalar=$(per_round "$programs/full")
flagged=$(per_round "$programs/flagged")
awk -v scalar="$scalar" -v flagged="$flagged" -v pixels="$pixels" 'BEGIN {
    printf "| nothing, pixels drawn one by one | %.3f | |\n", scalar / pixels
    printf "| the same, and five flags asked for each | %.3f | %.2f times as many |\n", flagged / pixels, flagged / scalar
}'
exit $status
