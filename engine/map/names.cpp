#include "map/names.h"

#include <algorithm>
#include <tuple>

#include "formats/text_parts.h"

namespace enfilade {
namespace {

constexpr std::size_t kComparisons = 200'000;  ///< suggestions may cost this many comparisons, about 0.1 s

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

std::string NameIndex::suggestion(std::uint32_t scope, std::string_view name) const {
    std::vector<std::string_view> known;
    auto it = std::lower_bound(names_.begin(), names_.end(), ScopedName{scope, {}, 0}, comes_before);
    for (; it != names_.end() && it->scope == scope && comparisons_left_ > 0; ++it, --comparisons_left_)
        known.push_back(it->name);
    return nearest_suggestion(name, known);
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

std::string edge_text(Vec2 a, Vec2 b) { return point_text(a) + "-" + point_text(b); }

}  // namespace enfilade
