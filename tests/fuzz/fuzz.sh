#!/bin/sh
# Throws bytes at one target for some seconds: tests/fuzz/fuzz.sh TARGET SECONDS, or through ./run fuzz, which installs
# what this needs. What it finds stays in out/fuzz/TARGET, and so does the corpus as it grows; the next run goes on with it.
# `tests/fuzz/fuzz.sh keep TARGET BYTES` puts the fewest files of up to so many bytes that lead as far as all of them into
# tests/fuzz/corpus.
set -eu

top=$(CDPATH='' cd -- "$(dirname -- "$0")/../.." && pwd)
build=$top/build/fuzz
kept=$top/tests/fuzz/corpus
most_seconds=25     # for one input; ten times as long as any takes
most_megabytes=4096 # of memory, the sanitizer's with it
most_megabytes_at_once=1024

say() { printf 'fuzz: %s\n' "$*" >&2; }

targets() { (cd "$kept" && echo *); }

# What the bytes of a target are.
meaning() {
    case $1 in
        hashes) echo "recorded frames" ;;
        map) echo "a map, read, built, checked, drawn and walked in" ;;
        png) echo "a picture" ;;
        save) echo "a saved game" ;;
        script) echo "a flythrough's script" ;;
        tape) echo "a recorded walk" ;;
        texture) echo "the text that names a picture, its size and offset" ;;
        toml) echo "TOML, read by both readers" ;;
        views) echo "a list of views" ;;
        wad) echo "an archive of Doom" ;;
        wav) echo "a sound" ;;
        world) echo "choices of which a legal world is made, that everything runs in" ;;
    esac
}

list() {
    echo "usage: ./run fuzz TARGET SECONDS; targets, and what their bytes are:"
    for target in $(targets); do printf '  %-8s %s\n' "$target" "$(meaning "$target")"; done
}

usage() {
    say "$*"
    list >&2
    exit 2
}

# Sets what the rest refers to: the program, its words, and where it leaves what.
choose() {
    target=$1
    if [ -z "$target" ] || [ ! -d "$kept/$target" ]; then usage "there is no target '$target'"; fi
    program=$build/tests/fuzz/fuzz_$target
    out=$top/out/fuzz/$target
    mkdir -p "$out/corpus" "$out/findings"
    [ -f "$build/build.ninja" ] || { (cd "$top" && cmake --preset fuzz) >&2 && say "compiling: some minutes this time"; }
    NINJA_STATUS='[%f of %t, %p after %e s] ' cmake --build "$build" --target "fuzz_$target" >&2
    "$program" --words | sort -u >"$out/words"
}

findings() { (cd "$out/findings" && find . -type f | sort); }

fuzz() {
    case ${2:-} in '' | *[!0-9]*) usage "expected a number of seconds, found '${2:-}'" ;; esac
    choose "$1"
    findings >"$out/before"
    if [ -d /dev/shm ]; then export TMPDIR="${TMPDIR:-/dev/shm}"; fi # a saved game is flushed each time
    # Memory that was given back counts as used for as long as the sanitizer keeps it.
    export ASAN_OPTIONS="quarantine_size_mb=16:allocator_release_to_os_interval_ms=500"
    say "$target for $2 s; what is found stays in $out"
    status=0
    "$program" -max_total_time="$2" -dict="$out/words" -artifact_prefix="$out/findings/" -timeout=$most_seconds \
        -rss_limit_mb=$most_megabytes -malloc_limit_mb=$most_megabytes_at_once -print_final_stats=1 "$out/corpus" "$kept/$target" || status=$?
    findings | comm -13 "$out/before" - | sed "s|^\.|to see it again: $program $out/findings|" >&2
    rm "$out/before"
    [ "$status" -ne 0 ] || say "nothing was found; the next run goes on from what this one tried"
    return $status
}

keep() {
    case ${2:-} in '' | *[!0-9]*) usage "expected a number of bytes, found '${2:-}'" ;; esac
    choose "$1"
    fresh=$(mktemp -d "$out/kept-XXXXXX")
    small=$(mktemp -d "$out/small-XXXXXX")
    find "$kept/$target" "$out/corpus" -type f -size -"$2"c -exec cp {} "$small" \;
    "$program" -set_cover_merge=1 -use_counters=0 -timeout=$most_seconds "$fresh" "$small"
    rm -r "${kept:?}/$target" "$small"
    chmod 755 "$fresh"
    mv "$fresh" "$kept/$target"
}

case ${1:-} in
    '') list ;;
    keep) keep "${2:-}" "${3:-}" ;;
    *) fuzz "${1:-}" "${2:-}" ;;
esac
