#!/bin/sh
# Breaks lines of the source, one at a time, and sees which test notices (broken_lines.txt); then writes the last table
# of CASES.md. Takes an hour or two.
#   tests/hard_cases/break_lines.sh [FOLDER]    works in a copy of the tree there, by default build/broken_lines; stopped
#                                               and started again it goes on. Status 1: something was not noticed
set -eu

here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
top=$(CDPATH='' cd -- "$here/../.." && pwd)
list=$here/broken_lines.txt
folder=${1:-$top/build/broken_lines}
tree=$folder/tree
results=$folder/results
mkdir -p "$tree"
folder=$(cd "$folder" && pwd)
touch "$results"

say() { printf 'break_lines: %s\n' "$*" >&2; }

# Makes the copy equal to the tree, with the times of the tree, and removes what was built from a broken line: so that
# little is built again.
restore() {
    [ -e "$folder/began" ] && find "$tree/build" -type f -newer "$folder/began" \( -name '*.[oa]' -o -name '*_tests' \) -delete
    rm -f "$folder/began"
    (cd "$top" && git ls-files) | while read -r file; do
        [ -e "$top/$file" ] || continue
        cmp -s "$top/$file" "$tree/$file" && continue
        mkdir -p "$tree/$(dirname "$file")"
        cp -p "$top/$file" "$tree/$file"
    done
}

# The block of that number.
block() { awk -v RS= -v n="$1" '/^= / && ++i == n' "$list"; }

# The rest of the lines of a block, read from standard input, that begin so.
lines() { sed -n "s/^$1 //p"; }

# FILE OLD NEW: puts one line in the place of another, which there is once.
break_line() {
    OLD=$2 NEW=$3 awk '
        { text = $0; sub(/^ */, "", text) }
        text == ENVIRON["OLD"] { match($0, /^ */); print substr($0, 1, RLENGTH) ENVIRON["NEW"]; ++found; next }
        { print }
        END { exit found != 1 }' "$1" >"$folder/broken" || return 1
    cp "$folder/broken" "$1"
}

# Builds the programs that lines "PROGRAM TESTS" name.
build() {
    # shellcheck disable=SC2046 # a list of words
    (cd "$tree" && cmake --build --preset release --target $(sed 's/ .*//; s/.*\///; s/$/_tests/' "$1")) >"$folder/build.log" 2>&1
}

# Runs such lines and prints the test that failed first, if any: of a program that crashed, or took more than 15 minutes
# or 8 GB, the one that ran.
first_failed() {
    # shellcheck disable=SC3045 # dash and bash have it
    ulimit -v 8000000
    while read -r program tests; do
        status=0
        timeout 900 "$tree/build/release/tests/${program}_tests" --gtest_filter="$tests" >"$folder/said" 2>&1 </dev/null || status=$?
        grep -q '^\[==========\] Running 0 tests' "$folder/said" && { say "$program has no test $tests" && return 1; }
        [ "$status" -eq 0 ] && continue
        failed=$(sed -n 's/^\[  FAILED  \] \([^ ,]*\)[ ,].*/\1/p' "$folder/said" | head -n 1)
        [ -n "$failed" ] || failed=$(sed -n 's/^\[ RUN      \] //p' "$folder/said" | tail -n 1)
        echo "${program%/*}: $failed"
        return
    done <"$1"
}

# Breaks what a block says and prints what noticed it.
trial() {
    block "$1" >"$folder/block"
    file=$(sed -n 2p "$folder/block")
    touch "$folder/began"
    lines '>' <"$folder/block" >"$folder/asked"
    break_line "$tree/$file" "$(lines - <"$folder/block")" "$(lines + <"$folder/block")" ||
        { say "$file has not that one line any more: $(lines - <"$folder/block")" && return 1; }
    build "$folder/asked" || { tail -n 20 "$folder/build.log" >&2 && say "it does not compile" && return 1; }
    first_failed "$folder/asked"
}

# All that is asked holds while nothing is broken.
try_whole_tree() {
    failed=$(first_failed "$folder/asked") || exit 2
    [ -z "$failed" ] || { say "$failed fails though nothing is broken" && exit 2; }
}

write_table() {
    sed '/^## Lines broken on purpose$/,$d' "$here/CASES.md" >"$folder/page"
    {
        cat "$folder/page"
        # shellcheck disable=SC2016 # Markdown's
        printf '## Lines broken on purpose\n\nWritten by `tests/hard_cases/break_lines.sh`: each line is broken alone, and the named test is the first to notice.\n\n'
        printf '| what is broken | where | noticed by |\n|---|---|---|\n'
        for row in $(seq "$count"); do
            printf '| %s | %s | %s |\n' "$(block "$row" | lines '=')" "$(block "$row" | sed -n 2p)" "$(tried "$row")"
        done
    } >"$folder/whole_page"
    cp "$folder/whole_page" "$here/CASES.md"
}

key() { block "$1" | cksum | tr ' ' -; }
result() { sed -n "s/^$(key "$1") //p" "$results"; }
tried() { result "$1" | grep . || echo 'not tried yet'; }

count=$(grep -c '^= ' "$list")
restore
[ -f "$tree/build/release/build.ninja" ] || (cd "$tree" && cmake --preset release >/dev/null)
say "building what is not broken"
lines '>' <"$list" | grep / | sort -u >"$folder/asked"
build "$folder/asked" || { tail -n 20 "$folder/build.log" >&2 && exit 2; }
grep -q '^whole' "$results" || { say "testing it" && try_whole_tree && echo whole >>"$results"; }
began=$(date +%s)
done=0
status=0
for n in $(seq "$count"); do
    [ -n "$(result "$n")" ] && continue
    noticed=$(trial "$n") || { restore && status=2 && continue; }
    restore
    echo "$(key "$n") ${noticed:-**nothing**}" >>"$results"
    write_table
    done=$((done + 1))
    left=$((($(date +%s) - began) * (count - n) / done / 60))
    say "$n of $count, $(block "$n" | lines '='): ${noticed:-NOTHING}; at most $left min left"
done
write_table
[ "$status" -eq 0 ] || exit "$status"
! sed -n '/^## Lines broken/,$p' "$here/CASES.md" | grep -q 'nothing'
