#!/bin/sh
# Fills in CASES.md: which tests hold each hard case, and what they tried. A test names its cases in the line before it,
# `// hard cases R4, I1: more words`.
#   tests/hard_cases/catalogue.sh --check    is every case held, every mark known, and the page as the tests say? 1: no
#   tests/hard_cases/catalogue.sh --tests    writes the tests' names anew and leaves the figures of what was tried
#   tests/hard_cases/catalogue.sh BUILD      runs the marked tests of a build folder (an hour on two cores, or less), and
#                                            writes the page anew; what was run is not run again until it is rebuilt
set -eu

[ $# -eq 1 ] || { sed -n '2,7s/^# //p' "$0" >&2 && exit 2; }
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
page=$here/CASES.md
cd "$here/../.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# "ID FOLDER TEST" for each mark; a mark that no test follows has no test.
marks() {
    # shellcheck disable=SC2016 # awk's words
    find tests -name '*_test.cpp' | LC_ALL=C sort | xargs awk '
        FNR == 1 && ids != "" { print ids, before, "nothing"; ids = "" }
        /^\/\/ hard cases? / { ids = $0; sub(/^\/\/ hard cases? /, "", ids); sub(/:.*/, "", ids); gsub(/ /, "", ids); before = FILENAME; next }
        ids == "" { next }
        { test = "nothing" }
        /^TEST(_F|_P)?\(.*\)/ { test = $0; sub(/^[^(]*\(/, "", test); sub(/\).*/, "", test); sub(/, /, ".", test) }
        { folder = FILENAME; sub(/^tests\//, "", folder); sub(/\/[^\/]*$/, "", folder)
          count = split(ids, id, ","); for (i = 1; i <= count; ++i) print id[i], folder, test
          ids = "" }'
}

# What the marked tests of a program tell, as GoogleTest's XML; nothing to do where it is newer than the program.
run_marked() {
    [ -n "$(find "$2" -newer "$1" 2>/dev/null)" ] && return
    "$1" --gtest_brief=1 --gtest_filter="$filter" --gtest_output="xml:$2.part" >"$work/said" 2>&1 ||
        { cat "$work/said" >&2 && return 1; }
    mv "$2.part" "$2"
}

# "FOLDER TEST VALUE WHAT" for each figure that a marked test of a build tells (support/trials.h).
figures() {
    filter=$(awk '{ print $3 ":*/" $3 "/*" }' "$work/marks" | sort -u | paste -sd:)
    programs=$(find "$1/tests" -name '*_tests' -type f -perm -u+x | sort)
    told=$1/catalogue
    mkdir -p "$told"
    number=0
    for program in $programs; do
        number=$((number + 1))
        echo "catalogue: $number of $(echo "$programs" | wc -l), ${program#"$1"/tests/}" >&2
        run_marked "$program" "$told/${program##*/}.xml" || exit 1
        awk '
            / *<testcase / {
                folder = $0; sub(/.* file="/, "", folder); sub(/".*/, "", folder)
                sub(/^(.*\/)?tests\//, "", folder); sub(/\/[^\/]*$/, "", folder)
                suite = $0; sub(/.* classname="/, "", suite); sub(/".*/, "", suite); sub(/.*\//, "", suite)
                name = $0; sub(/.*<testcase name="/, "", name); sub(/".*/, "", name); sub(/\/.*/, "", name)
            }
            / *<property / {
                what = $0; sub(/.*<property name="/, "", what); sub(/".*/, "", what)
                value = $0; sub(/.* value="/, "", value); sub(/".*/, "", value)
                if (value ~ /^[0-9.]+(e[-+]?[0-9]+)?$/) print folder, suite "." name, value, what
            }' "$told/${program##*/}.xml"
    done
}

# The page with its last two columns filled in from the marks, and, where there are any, from the figures. Complaints go
# to standard error and give status 1.
filled_page() {
    awk -v marks="$work/marks" -v figures="$work/figures" -v write="$1" '
        function complain(sentence) { print "CASES.md: " sentence >"/dev/stderr"; wrong = 1 }
        function grouped(n) { while (match(n, /[0-9][0-9][0-9][0-9]($| )/)) n = substr(n, 1, RSTART) " " substr(n, RSTART + 1); return n }
        function seen(id,    parts, key, text, n, i) {
            for (i = 1; i <= kinds; ++i) {
                key = id SUBSEP kind[i]
                if (!(key in total)) continue
                text = text (text == "" ? "" : "; ") (kind[i] ~ /^at most / ? "at most " sprintf("%.2g", total[key]) substr(kind[i], 8) : grouped(sprintf("%.0f", total[key])) " " kind[i])
            }
            return text
        }
        BEGIN {
            while ((getline line < marks) > 0) {
                split(line, m, " "); marked[m[1]] = 1
                if (m[3] == "nothing") complain("the mark " m[1] " in " m[2] " is not in the line before a TEST")
                held[m[1]] = held[m[1]] (held[m[1]] == "" ? "" : "<br>") m[2] ": " m[3]
                cases_of[m[2] " " m[3]] = cases_of[m[2] " " m[3]] " " m[1]
            }
            while ((getline line < figures) > 0) {
                split(line, f, " "); what = line
                for (i = 1; i <= 3; ++i) sub(/^[^ ]* /, "", what)
                if (!(what in known)) { known[what] = 1; kind[++kinds] = what }
                count = split(cases_of[f[1] " " f[2]], id, " ")
                for (i = 1; i <= count; ++i) {
                    key = id[i] SUBSEP what
                    total[key] = what ~ /^at most / ? (f[3] > total[key] ? f[3] + 0 : total[key]) : total[key] + f[3]
                }
            }
        }
        /^\| [RCTWGDI][0-9]+ \|/ {
            split($0, cell, / *\| */); name = cell[2]
            if (name in listed) complain(name " is listed twice")
            listed[name] = 1
            tests = name in held ? held[name] : cell[5] ~ /^does not apply: / ? cell[5] : ""
            if (tests == "") complain(name " is held by no test: mark one, or write \"does not apply: \" and why")
            if (tests != cell[5] && write == "nothing") complain("other tests hold " name " than the page says: run catalogue.sh --tests, or BUILD")
            print "| " name " | " cell[3] " | " cell[4] " | " tests " | " (write == "all" ? seen(name) : cell[6]) " |"
            next
        }
        { print }
        END {
            for (name in marked) if (!(name in listed)) complain("a test names " name ", which is not listed")
            exit wrong
        }' "$page"
}

marks >"$work/marks"
: >"$work/figures"
case $1 in
    --check)
        filled_page nothing >/dev/null
        exit
        ;;
    --tests) filled_page tests >"$work/page" ;;
    *)
        figures "$1" >"$work/figures"
        [ -s "$work/figures" ] || { echo "catalogue: no test told what it tried; CASES.md stays as it is" >&2 && exit 1; }
        filled_page all >"$work/page"
        ;;
esac
cp "$work/page" "$page"
