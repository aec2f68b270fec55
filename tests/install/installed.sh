#!/bin/sh
# installed.sh BUILD: installs what was built there into a folder of its own, and uses it as a stranger would: both
# programs, and the examples by every compiler there is, with warnings as errors, through CMake and pkg-config.
set -eu

build=$(realpath "$1")
source=$(sed -n 's/^enfilade_SOURCE_DIR:STATIC=//p' "$build/CMakeCache.txt")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
prefix=$scratch/prefix
share=$prefix/share/enfilade

cmake --install "$build" --prefix "$prefix" >"$scratch/log"
cd "$scratch"

fail() {
    echo "$*"
    exit 1
}

if grep -rl -- "$source" "$prefix"; then fail "they remember the source folder"; fi

enfilade=$prefix/bin/enfilade
ENFILADE_MAP_CACHE=off HOME=$scratch
export ENFILADE_MAP_CACHE HOME
"$enfilade" check "$share/maps" >checked
"$enfilade" render "$share/maps/enfilade.toml" --size 320x200 --out start.png
"$enfilade" fly "$share/maps/flythroughs/tutorial.toml" --check
# An author's first map finds its pictures, wherever it lies.
"$enfilade" new mine
[ "$("$enfilade" check mine.toml)" = "1 map checked, 0 refused: 0 errors, 0 warnings" ]
# What comes along is found beside the program, or where the environment says.
"$enfilade" bench --effects --size 64x40 --rounds 2 | grep "^$share/maps/effects.toml"
mkdir other
mv "$share/maps" other/maps
ENFILADE_SHARE=$scratch/other "$enfilade" bench --effects --size 64x40 --rounds 2 | grep "^$scratch/other/maps/effects"
mv other/maps "$share/maps"
"$prefix/bin/wadconv" --version
# The menu of a desktop opens the title screen; its file manager hands over a map or a WAD.
grep -qx 'Exec=enfilade' "$prefix/share/applications/enfilade.desktop"
grep -qx 'Exec=enfilade play %f' "$prefix/share/applications/enfilade-play.desktop"
if command -v desktop-file-validate; then desktop-file-validate "$prefix"/share/applications/*.desktop; fi

for compiler in g++ clang++-19; do
    command -v "$compiler" >/dev/null || continue
    cmake -S "$share/examples" -B "$compiler" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$prefix" \
        -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_CXX_FLAGS="-Wall -Wextra -Werror" -DCMAKE_EXPORT_COMPILE_COMMANDS=ON
    if grep -E -- '-W(shadow|conversion|no-)' "$compiler/compile_commands.json"; then fail "warnings came along"; fi
    cmake --build "$compiler"
    ctest --test-dir "$compiler" --output-on-failure
done

PKG_CONFIG_PATH=$(dirname "$(find "$prefix" -name enfilade.pc)")
export PKG_CONFIG_PATH
[ "enfilade $(pkg-config --modversion enfilade)" = "$("$enfilade" --version)" ]
# shellcheck disable=SC2046 # a list of words
g++ -std=c++20 "$share/examples/frame.cpp" $(pkg-config --cflags --libs enfilade) -o frame
./frame "$share/maps/enfilade.toml" frame.png
cmp frame.png g++/frame.png
