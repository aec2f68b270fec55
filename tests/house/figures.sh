#!/bin/sh
# The house in numbers: files and functions with their lengths, comments in headers, circles of includes, headers with
# one reader, and names of types that stand for more than one thing. `tests/house/figures.sh`; exit status 1 where such a
# name is found, or includes go in a circle.
set -eu

cd "$(dirname "$0")/../.."
sources=$(git ls-files 'engine/*.h' 'engine/*.cpp' 'wadconv/*.h' 'wadconv/*.cpp')
headers=$(echo "$sources" | grep '\.h$')

# Of numbers on lines: how many there are, their sum, median, 95th percentile and greatest.
spread() {
    sort -n | awk '{ n[NR] = $1; sum += $1 }
        END { printf "%d, %d lines in all; median %d, 95 %% up to %d, longest %d\n", NR, sum, n[int((NR + 1) / 2)], n[int(NR * 0.95)], n[NR] }'
}

# A function begins on a line of its own that ends in ") {" or the like, and ends with "}" at the same indentation.
function_lengths() {
    # shellcheck disable=SC2086 # file names
    awk '
    FNR == 1 { begin = 0 }
    begin == 0 && /^ *[A-Za-z~].*[)a-z] \{$/ && !/^ *(namespace|class|struct|enum|union|if|for|while|switch|do|else|return|extern|try)[ (]/ && !/= \{$/ {
        match($0, /^ */); indent = RLENGTH
        if (indent <= 4) begin = FNR
        next
    }
    begin > 0 && /^ *\}/ { match($0, /^ */); if (RLENGTH == indent) { print FNR - begin - 1; begin = 0 } }' $sources
}

# "FILE HEADER" for each header of ours that a file includes; headers as they are included.
includes() {
    # shellcheck disable=SC2086 # file names
    grep -o '^#include "[^"]*"' $sources | sed 's|^engine/||; s|:#include "| |; s|"$||'
}

# The headers that whoever uses the engine or its test library gets to read: what those two begin with leads to.
public_headers() {
    includes | awk '
        { behind[$1] = behind[$1] " " $2 }
        $1 ~ /^(enfilade|testing\/.*)\.h$/ { waiting[$1] }
        END {
            do {
                more = 0
                for (header in waiting) {
                    if (header in seen) continue
                    seen[header]
                    more = 1
                    count = split(behind[header], next_ones)
                    for (i = 1; i <= count; ++i) waiting[next_ones[i]]
                }
            } while (more)
            for (header in seen) print "engine/" header
        }'
}

# How many of the lines of these files are comments, and how many have one.
comment_share() {
    cat "$@" | awk '/^ *\/\// { ++comments } /\/\// { ++commented } /[^ ]/ { ++lines }
        END { printf "%d %% of lines are comments, %d %% have one\n", 100 * comments / lines, 100 * commented / lines }'
}

printf 'files: '
for file in $sources; do wc -l <"$file"; done | spread
printf 'functions of more than one line: '
function_lengths | spread
# shellcheck disable=SC2086 # file names
printf 'headers: %s, ' "$(echo $headers | wc -w)" && comment_share $headers
# shellcheck disable=SC2046 # file names
printf 'public headers: %s, ' "$(public_headers | wc -l)" && comment_share $(public_headers)

circles=$(includes | grep '^[^ ]*\.h ' | tsort 2>&1 >/dev/null | grep -c 'input contains a loop' || :)
echo "circles of includes: $circles"

echo "headers with one reader but their own source and tests:"
includes | awk '
    { stem = $1; sub(/\.(h|cpp)$/, "", stem); own = $2; sub(/\.h$/, "", own) }
    stem != own { ++readers[$2]; reader[$2] = $1 }
    END { for (h in readers) if (readers[h] == 1) print "  " h " <- " reader[h] }' | sort

# shellcheck disable=SC2086 # file names
twice=$(grep -EHo '^ *(struct|class|enum class|union) [A-Z][A-Za-z]+ (final )?(: [a-z:_0-9A-Z ]+ )?\{' $sources |
    sed -E 's/:[ ]*(struct|class|enum class|union) / /; s/ (final )?(:.*)?\{$//' |
    awk '{ places[$2] = places[$2] " " $1; ++count[$2] } END { for (n in count) if (count[n] > 1) print "  " n ":" places[n] }' | sort)
echo "types of one name in more than one place: ${twice:-none}"

[ "$circles" -eq 0 ] && [ -z "$twice" ]
