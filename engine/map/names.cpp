#include "map/names.h"

#include <algorithm>
#include <array>
#include <string>
#include <tuple>

#include "map/say.h"

namespace enfilade {
namespace {

constexpr std::size_t kComparisons = 200'000;  ///< nearest() may cost this many distances, about 0.1 s
constexpr std::size_t kLongestName = 40;       ///< longer names are not guessed at [bytes]

/// Letters to change, add or drop to make b of a (Levenshtein 1966). Both at most kLongestName long.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::array<std::size_t, kLongestName + 1> row;
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t changed = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({changed, row[j] + 1, row[j - 1] + 1});
        }
    }
    return row[b.size()];
}

bool comes_before(const ScopedName& a, const ScopedName& b) {
    return std::tie(a.scope, a.name, a.id) < std::tie(b.scope, b.name, b.id);
}

}  // namespace

NameIndex::NameIndex(std::vector<ScopedName> names) : names_(std::move(names)), comparisons_left_(kComparisons) {
    std::sort(names_.begin(), names_.end(), comes_before);
}

std::optional<std::uint32_t> NameIndex::find(std::uint32_t scope, std::string_view name) const {
    const auto it = std::lower_bound(names_.begin(), names_.end(), ScopedName{scope, name, 0}, comes_before);
    if (it == names_.end() || it->scope != scope || it->name != name) return {};
    return it->id;
}

std::string_view NameIndex::nearest(std::uint32_t scope, std::string_view name) const {
    std::string_view best;
    std::size_t least = name.size() / 3 + 1;  // a third of its letters wrong, and one more: "hal" for "hall"
    if (name.size() > kLongestName) return best;
    auto it = std::lower_bound(names_.begin(), names_.end(), ScopedName{scope, {}, 0}, comes_before);
    for (; it != names_.end() && it->scope == scope && comparisons_left_ > 0; ++it, --comparisons_left_) {
        if (it->name.size() > kLongestName) continue;
        const std::size_t distance = edit_distance(name, it->name);
        if (distance > least || (distance == least && !best.empty())) continue;
        least = distance;
        best = it->name;
    }
    return best;
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> NameIndex::duplicates() const {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    std::size_t first = 0;
    for (std::size_t i = 1; i < names_.size(); ++i) {
        if (names_[i].scope != names_[first].scope || names_[i].name != names_[first].name)
            first = i;
        else
            pairs.emplace_back(names_[first].id, names_[i].id);
    }
    return pairs;
}

std::string did_you_mean(std::string_view nearest) {
    return nearest.empty() ? std::string() : " (did you mean " + quoted(nearest) + "?)";
}

}  // namespace enfilade
