// Building a map, step by step; how its findings are counted; and the names in it: which one is meant, and which
// sectors a trigger is about.
#include <algorithm>
#include <array>
#include <set>
#include <tuple>
#include <utility>

#include "formats/text_parts.h"
#include "map/draft.h"
#include "map/load.h"

namespace enfilade {

std::optional<Map> build_map(const MapFile& file, const TextureSet& textures, Findings& findings) {
    Draft draft{file, textures, findings, {}, {}, {}, {}, {}, !has_errors(findings)};
    draft.map.name = file.name;
    draft.map.render = file.render;
    place_walls(draft);
    check_sectors(draft);
    gather_groups(draft);
    check_loops(draft);
    place_panels(draft);
    resolve_portals(draft);
    link_walls(draft);
    lay_surfaces(draft);
    check_textures(draft);
    place_inhabitants(draft);
    place_triggers(draft);
    place_keys(draft);
    place_sounds(draft);
    place_suns(draft);
    note_picture_changes(draft);
    if (has_errors(findings)) return std::nullopt;
    list_near_things(draft.map);
    return std::move(draft.map);
}

void Draft::error(TextPlace place, std::string_view code, std::string sentence) {
    ++error_count;
    if (error_count == kMostErrors + 1)
        findings.push_back({{}, Severity::error, "too-many-errors", "there are more errors than these"});
    if (error_count <= kMostErrors)
        findings.push_back({place, Severity::error, std::string(code), std::move(sentence)});
}

void Draft::warning(TextPlace place, std::string_view code, std::string sentence) {
    if (!was_sound) return;
    ++warning_count;
    if (warning_count == kMostWarnings + 1)
        findings.push_back({{}, Severity::warning, "too-many-warnings", "there are more warnings than these"});
    if (warning_count <= kMostWarnings)
        findings.push_back({place, Severity::warning, std::string(code), std::move(sentence)});
}

// Names.

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

namespace {

/// Members of all lists together [1]: 64 MB. Equal lists are one, so that only triggers that each put large tags
/// together in another way come near.
constexpr std::size_t kMostListed = std::size_t{1} << 24;

std::vector<ScopedName> scoped_names(const MapFile& file) {
    std::vector<ScopedName> names;
    for (std::uint32_t i = 0; i < file.sectors.size(); ++i) {
        names.push_back({0, file.sectors[i].name, i});
        for (const std::string& tag : file.sectors[i].tags) names.push_back({0, tag, i});
    }
    return names;
}

}  // namespace

TargetLists::TargetLists(Draft& draft)
    : draft_(draft), last_list_(draft.map.sectors.size(), 0), index_(scoped_names(draft.file)) {
    std::vector<ScopedName> names = scoped_names(draft.file);
    const auto key = [](const ScopedName& name) { return std::pair(name.name, name.id); };
    std::ranges::sort(names, {}, key);
    const auto again = std::ranges::unique(names, {}, key);
    names.erase(again.begin(), again.end());
    for (const ScopedName& name : names) {
        names_.push_back(name.name);
        named_.emplace_back(name.id);
    }
}

std::span<const SectorId> TargetLists::sectors_of(std::string_view name) const {
    const auto [first, last] = std::ranges::equal_range(names_, name);
    return std::span(named_).subspan(static_cast<std::size_t>(first - names_.begin()),
                                     static_cast<std::size_t>(last - first));
}

SectorId TargetLists::first_of(std::string_view name) const {
    const auto sectors = sectors_of(name);
    return sectors.empty() ? SectorId() : sectors.front();
}

TargetRange TargetLists::list_of(const TriggerRecord& record) {
    std::vector<std::span<const SectorId>> parts;
    std::set<const SectorId*> seen;
    for (const std::string& name : record.targets)
        if (const auto sectors = sectors_of(name); !sectors.empty() && seen.insert(sectors.data()).second)
            parts.push_back(sectors);
    std::vector<const SectorId*> key;
    for (const auto part : parts) key.push_back(part.data());
    const auto [it, is_new] = known_.try_emplace(std::move(key));
    if (is_new && has_room_for(record, parts)) it->second = new_list(parts);
    return it->second;
}

TargetRange TargetLists::list_of(SectorId sector) {
    const auto [it, is_new] = alone_.try_emplace(sector);
    if (is_new) it->second = new_list(std::array{std::span<const SectorId>(&sector, 1)});
    return it->second;
}

bool TargetLists::has_room_for(const TriggerRecord& record, std::span<const std::span<const SectorId>> parts) {
    const bool had_room = listed_ <= kMostListed;
    for (const auto part : parts) listed_ += part.size();
    if (had_room && listed_ > kMostListed)
        draft_.error(record, "target", "too-many-targets",
                     "with this trigger the different lists of targets of the map have more than " +
                         std::to_string(kMostListed) +
                         " sectors together; give triggers that are about the same sectors the same targets");
    return listed_ <= kMostListed;
}

TargetRange TargetLists::new_list(std::span<const std::span<const SectorId>> parts) {
    std::vector<SectorId>& targets = draft_.map.targets;
    const std::size_t first = targets.size();
    ++list_count_;
    for (const auto part : parts)
        for (const SectorId sector : part) {
            const SectorId leader = draft_.map[sector].leader;  // who calls one sector of a group calls the group
            if (std::exchange(last_list_[leader.index], list_count_) != list_count_) targets.push_back(leader);
        }
    return {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(targets.size() - first)};
}

}  // namespace enfilade
