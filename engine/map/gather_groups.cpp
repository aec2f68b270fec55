// Sectors that move as one: each learns who leads its group, and what cannot move as one is said.
#include <algorithm>
#include <string>

#include "formats/text_parts.h"
#include "map/draft.h"

namespace enfilade {
namespace {

/// The sectors that name a group, by its name and then in the order of the file.
std::vector<SectorId> grouped_sectors(const Draft& draft) {
    std::vector<SectorId> grouped;
    for (std::size_t i = 0; i < draft.sectors.size(); ++i)
        if (!draft.sectors[i].record->group.empty()) grouped.emplace_back(i);
    std::stable_sort(grouped.begin(), grouped.end(), [&](SectorId a, SectorId b) {
        return draft.sectors[a.index].record->group < draft.sectors[b.index].record->group;
    });
    return grouped;
}

TextPlace place_of(const FlatRecord& flat, const SectorRecord& sector) {
    return flat.place.line != 0 ? flat.place : sector.place;
}

void check_height(Draft& draft, const char* what, const SectorRecord& first, const SectorRecord& other,
                  FlatRecord SectorRecord::* flat) {
    if ((first.*flat).z == (other.*flat).z) return;
    draft.error(place_of(other.*flat, other), "group-heights",
                "expected the " + std::string(what) + " at " + number_text((first.*flat).z) + " m, where sector " +
                    quoted(first.name) + " of the same group " + quoted(first.group) + " has it, found " +
                    number_text((other.*flat).z) + " m; what moves as one starts at one height");
}

void check_bob(Draft& draft, const char* what, const SectorRecord& first, const SectorRecord& other,
               FlatRecord SectorRecord::* flat) {
    if ((first.*flat).bob == (other.*flat).bob) return;
    draft.error(place_of(other.*flat, other), "group-bobs",
                "expected the " + std::string(what) + " of sector " + quoted(other.name) +
                    " to bob as that of sector " + quoted(first.name) + " of the same group " + quoted(first.group) +
                    "; what moves as one has one bob, or none: write the same one in both");
}

bool can_be_used(const SectorRecord& sector) {
    return std::any_of(sector.triggers.begin(), sector.triggers.end(),
                       [](const TriggerRecord& trigger) { return trigger.on == Activation::use; });
}

/// A door of two parts that opens for who uses the one is meant to open for who uses the other.
void check_uses(Draft& draft, const SectorRecord& first, const SectorRecord& other) {
    if (can_be_used(first) == can_be_used(other)) return;
    const SectorRecord& with = can_be_used(first) ? first : other;
    const SectorRecord& without = can_be_used(first) ? other : first;
    draft.warning(without, "group", "group-use",
                  "sector " + quoted(with.name) + " of the group " + quoted(with.group) +
                      " has a trigger on \"use\", sector " + quoted(without.name) +
                      " has none; give it the same one, or nothing happens to who uses it from that side");
}

void check_lonely(Draft& draft, const SectorRecord& sector) {
    draft.warning(sector, "group", "group-of-one",
                  "expected two sectors or more in the group " + quoted(sector.group) + ", found only " +
                      quoted(sector.name) + "; give another one the same group, or take it out");
}

/// Sectors [first, last) of `grouped` have the same group.
void join(Draft& draft, const std::vector<SectorId>& grouped, std::size_t first, std::size_t last) {
    const SectorRecord& leader = *draft.sectors[grouped[first].index].record;
    if (last - first == 1) return check_lonely(draft, leader);
    for (std::size_t i = first; i < last; ++i) {
        Sector& sector = draft.map.sectors[grouped[i].index];
        sector.leader = grouped[first];
        sector.next_of_group = grouped[i + 1 == last ? first : i + 1];
        const SectorRecord& record = *draft.sectors[grouped[i].index].record;
        check_height(draft, "floor", leader, record, &SectorRecord::floor);
        check_height(draft, "ceiling", leader, record, &SectorRecord::ceiling);
        check_bob(draft, "floor", leader, record, &SectorRecord::floor);
        check_bob(draft, "ceiling", leader, record, &SectorRecord::ceiling);
        check_uses(draft, leader, record);
    }
}

}  // namespace

void gather_groups(Draft& draft) {
    const std::vector<SectorId> grouped = grouped_sectors(draft);
    const auto group_of = [&](std::size_t i) { return draft.sectors[grouped[i].index].record->group; };
    for (std::size_t first = 0, last = 0; first < grouped.size(); first = last) {
        while (last < grouped.size() && group_of(last) == group_of(first)) ++last;
        join(draft, grouped, first, last);
    }
}

}  // namespace enfilade
