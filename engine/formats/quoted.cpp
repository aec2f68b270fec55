#include "formats/quoted.h"

#include <vector>

#include "base/terminal.h"

namespace enfilade {
namespace {

/// Longest part of a file's word that a message repeats [bytes].
constexpr std::size_t kShownBytes = 60;

/// How many letters must be put in, taken out, replaced or swapped with their neighbour to turn one word into the
/// other (optimal string alignment; Damerau, "A technique for computer detection and correction of spelling errors",
/// 1964). Cost: the product of the lengths.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> two_ago(b.size() + 1), previous(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::swap(two_ago, previous);
        std::swap(previous, row);
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = previous[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            row[j] = std::min({replaced, previous[j] + 1, row[j - 1] + 1});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], two_ago[j - 2] + 1);
        }
    }
    return row[b.size()];
}

}  // namespace

std::string quoted(std::string_view word) {
    std::size_t length = std::min(word.size(), kShownBytes);
    while (length < word.size() && length > 0 && (static_cast<unsigned char>(word[length]) & 0xC0) == 0x80) --length;
    return "'" + printable_line(word.substr(0, length)) + (length < word.size() ? "…'" : "'");
}

std::string_view nearest_word(std::string_view word, std::span<const std::string_view> known) {
    std::size_t best = word.size() > kShownBytes ? 0 : 1 + word.size() / 3;
    std::string_view nearest;
    for (std::string_view candidate : known) {
        const std::size_t distance =
            best == 0 || candidate.size() > word.size() + best ? best + 1 : edit_distance(word, candidate);
        if (distance > best || distance == 0 || (distance == best && !nearest.empty())) continue;
        best = distance;
        nearest = candidate;
    }
    return nearest;
}

std::string nearest_suggestion(std::string_view word, std::span<const std::string_view> known) {
    const std::string_view nearest = nearest_word(word, known);
    return nearest.empty() ? std::string() : "; did you mean " + quoted(nearest) + "?";
}

std::string suggestion(std::string_view word, std::span<const std::string_view> known) {
    if (std::string near = nearest_suggestion(word, known); !near.empty()) return near;
    std::string list = "; known here: ";
    for (std::string_view candidate : known) list += std::string(candidate) + ", ";
    list.resize(list.size() - 2);
    return list;
}

}  // namespace enfilade
