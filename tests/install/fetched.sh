#!/bin/sh
# fetched.sh SOURCE: configures a project that fetches Enfilade, with its programs and without them, and looks at what
# comes along.
set -eu

source=$(realpath "$1")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
for programs in ON OFF; do
    cmake -S "$source/tests/install/consumer" -B "$scratch/$programs" -G Ninja -DENFILADE_SOURCE="$source" \
        -DENFILADE_PROGRAMS=$programs -DCMAKE_EXPORT_COMPILE_COMMANDS=ON >"$scratch/log" 2>&1 || {
        cat "$scratch/log"
        exit 1
    }
    options=$(tr '\n' ' ' <"$scratch/$programs/compile_commands.json" | grep -o '[^{]*flythrough_test.cpp[^}]*')
    case $options in *' -W'*) echo "warnings came along: $options" && exit 1 ;; esac
    case $options in *-ffp-contract=off*) ;; *) echo "the engine needs contraction off: $options" && exit 1 ;; esac
done
if grep -q libSDL2 "$scratch/OFF/build.ninja"; then echo "SDL came along" && exit 1; fi
