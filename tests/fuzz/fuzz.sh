#!/bin/sh
# Throws bytes at one target for some seconds: tests/fuzz/fuzz.sh TARGET SECONDS, or through ./run fuzz, which installs
# what this needs. What it finds stays in out/fuzz/TARGET, and so does the corpus as it grows; the next run goes on with it.
# `tests/fuzz/fuzz.sh all SECONDS` does so with every target, as many at once as there are cores, and prints what came
# of it and which lines of the readers it ran.
# `tests/fuzz/fuzz.sh keep TARGET BYTES` puts the fewest files of up to so many bytes that lead as far as all of them into
# tests/fuzz/corpus.
set -eu

top=$(CDPATH='' cd -- "$(dirname -- "$0")/../.." && pwd)
build=$top/build/fuzz
counting=$top/build/coverage
kept=$top/tests/fuzz/corpus
usual_seconds=600
most_seconds=25     # for one input; ten times as long as any takes
most_megabytes=4096 # of memory, the sanitizer's with it
most_megabytes_at_once=1024
least_percent=95 # of a reader's lines, unless tests/fuzz/coverage.txt says why there are fewer

say() { printf 'fuzz: %s\n' "$*" >&2; }

targets() { (cd "$kept" && echo *); }

# What the bytes of a target are.
meaning() {
    case $1 in
        compiled) echo "changes of a compiled map, which is drawn and walked in" ;;
        hashes) echo "recorded frames" ;;
        list) echo "files that the title lists" ;;
        map) echo "a map, read, built, checked, drawn and walked in" ;;
        options) echo "values on the command line" ;;
        parts) echo "parts of a recording, which are merged" ;;
        png) echo "a picture" ;;
        report) echo "a report of accuracy or speed" ;;
        save) echo "a saved game, played on" ;;
        script) echo "a flythrough's script" ;;
        settings) echo "settings and bindings of keys" ;;
        tape) echo "a recorded walk" ;;
        texture) echo "the text that names a picture, its size and offset" ;;
        toml) echo "TOML, read by both readers" ;;
        views) echo "a list of views" ;;
        wad) echo "an archive of Doom, converted and drawn" ;;
        wav) echo "a sound" ;;
        world) echo "choices of which a legal world is made, that everything runs in" ;;
    esac
}

list() {
    echo "usage: ./run fuzz TARGET SECONDS, or ./run fuzz all [SECONDS]; targets, and what their bytes are:"
    for target in $(targets); do printf '  %-8s %s\n' "$target" "$(meaning "$target")"; done
}

usage() {
    say "$*"
    list >&2
    exit 2
}

expect_number() {
    case $1 in '' | *[!0-9]*) usage "expected a number of $2, found '$1'" ;; esac
}

# compile PRESET TARGET...: the targets' programs, with or without sanitizers.
compile() {
    preset=$1
    shift
    [ -f "$top/build/$preset/build.ninja" ] ||
        { (cd "$top" && cmake --preset "$preset") >&2 && say "compiling: some minutes this time"; }
    # shellcheck disable=SC2046 # a list of words
    NINJA_STATUS='[%f of %t, %p after %e s] ' cmake --build "$top/build/$preset" --target $(printf 'fuzz_%s ' "$@") >&2
}

# Sets what the rest refers to: the program, and where it leaves what.
choose() {
    target=$1
    if [ -z "$target" ] || [ ! -d "$kept/$target" ]; then usage "there is no target '$target'"; fi
    program=$build/tests/fuzz/fuzz_$target
    out=$top/out/fuzz/$target
    mkdir -p "$out/corpus" "$out/findings"
}

findings() { (cd "$out/findings" && find . -type f | sort); }

# Throws bytes at the chosen target for so many seconds.
throw() {
    "$program" --words | sort -u >"$out/words"
    findings >"$out/before"
    if [ -d /dev/shm ]; then export TMPDIR="${TMPDIR:-/dev/shm}"; fi # a saved game is flushed each time
    # Memory that was given back counts as used for as long as the sanitizer keeps it.
    export ASAN_OPTIONS="quarantine_size_mb=16:allocator_release_to_os_interval_ms=500"
    status=0
    "$program" -max_total_time="$1" -dict="$out/words" -artifact_prefix="$out/findings/" -timeout=$most_seconds \
        -rss_limit_mb=$most_megabytes -malloc_limit_mb=$most_megabytes_at_once -print_final_stats=1 "$out/corpus" "$kept/$target" || status=$?
    findings | comm -13 "$out/before" - >"$out/found"
    rm "$out/before"
    return $status
}

fuzz() {
    expect_number "${2:-}" seconds
    choose "$1"
    compile fuzz "$target"
    say "$target for $2 s; what is found stays in $out"
    status=0
    throw "$2" || status=$?
    sed "s|^\.|to see it again: $program $out/findings|" "$out/found" >&2
    [ "$status" -ne 0 ] || say "nothing was found; the next run goes on from what this one tried"
    return $status
}

# One target of all, in silence.
fuzz_quietly() {
    choose "$1"
    throw "$2" >"$out/log" 2>&1 || true
    say "$target is done"
}

# The number behind a word of libFuzzer's statistics; 0 where it told none.
statistic() { sed -n "s/^stat::$1: *//p" "$out/log" | tail -n 1 | grep . || echo 0; }

# "SOURCE PERCENT" of the sources that coverage.txt tells of the target, over its whole corpus.
count_lines() {
    sources=$(awk -v target="$target" '$1 !~ /^#/ && $2 == target { print $1 }' "$top/tests/fuzz/coverage.txt")
    [ -n "$sources" ] || return 0
    counted=$counting/tests/fuzz/fuzz_$target
    LLVM_PROFILE_FILE=$out/lines.raw "$counted" -runs=0 -timeout=$most_seconds "$out/corpus" "$kept/$target" >"$out/counting" 2>&1 || true
    llvm-profdata-19 merge -sparse "$out/lines.raw" -o "$out/lines"
    for source in $sources; do
        llvm-cov-19 export -summary-only -instr-profile="$out/lines" "$counted" "$top/$source" |
            sed -n 's|.*"totals":.*"lines":{"count":\([0-9]*\),"covered":\([0-9]*\).*|\1 \2|p' |
            awk -v source="$source" '{ printf "%s %.1f\n", source, $1 > 0 ? 100 * $2 / $1 : 0 }'
    done
    rm "$out/lines.raw"
}

# What came of one target, as a row.
summarize() {
    choose "$1"
    count_lines >"$out/coverage"
    printf '%-9s %12s %9s %7s %9s  %s\n' "$target" "$(statistic number_of_executed_units)" \
        "$(statistic average_exec_per_sec)" "$(find "$out/corpus" "$kept/$target" -type f | wc -l)" \
        "$(wc -l <"$out/found")" "$(sed 's|.*/||; s|$| %|' "$out/coverage" | paste -sd, | sed 's/,/, /g')"
}

# Sources of which too few lines were run, against what coverage.txt says.
too_few_lines() {
    cat "$top"/out/fuzz/*/coverage | awk -v least=$least_percent '
        NR == FNR { if ($1 !~ /^#/) wanted[$1] = NF > 2 ? $3 : least; next }
        $2 < wanted[$1] { printf "%s: %s %% of its lines, expected %s\n", $1, $2, wanted[$1] }' "$top/tests/fuzz/coverage.txt" -
}

fuzz_all() {
    seconds=${1:-$usual_seconds}
    expect_number "$seconds" seconds
    # shellcheck disable=SC2046 # a list of words
    compile fuzz $(targets)
    cores=$(getconf _NPROCESSORS_ONLN)
    say "every target for $seconds s, $cores at once; what is found stays in $top/out/fuzz"
    targets | tr ' ' '\n' | xargs -P "$cores" -I {} "$0" quietly {} "$seconds"
    # shellcheck disable=SC2046
    compile coverage $(targets)
    summary=$top/out/fuzz/summary.txt
    {
        printf '%-9s %12s %9s %7s %9s  %s\n' target executions 'a second' corpus findings 'lines run'
        for each in $(targets); do summarize "$each"; done
    } | tee "$summary"
    awk 'NR > 1 { executions += $2; findings += $5 }
         END { printf "%-9s %12d %9s %7s %9d\n", "all", executions, "", "", findings }' "$summary" | tee -a "$summary"
    too_few_lines | tee -a "$summary" | grep . >&2 && return 1
    [ -z "$(cat "$top"/out/fuzz/*/found)" ]
}

keep() {
    expect_number "${2:-}" bytes
    choose "$1"
    compile fuzz "$target"
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
    all) fuzz_all "${2:-}" ;;
    quietly) fuzz_quietly "$2" "$3" ;;
    keep) keep "${2:-}" "${3:-}" ;;
    *) fuzz "${1:-}" "${2:-}" ;;
esac
