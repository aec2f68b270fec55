// What a sector must be whatever its shape: a name of its own, a ceiling that is not below its floor.
#include <algorithm>
#include <string>
#include <vector>

#include "formats/text_parts.h"
#include "map/draft.h"

namespace enfilade {
namespace {

void check_heights(Draft& draft, const SectorRecord& sector) {
    if (sector.ceiling.z >= sector.floor.z) return;
    const FlatRecord& written = sector.ceiling.places.has("z") ? sector.ceiling : sector.floor;
    if (!sector.ceiling.places.is_sound("z") || !sector.floor.places.is_sound("z")) return;
    draft.error(known(key_place(written, "z"), sector.place), "ceiling-below-floor",
                "the ceiling of sector " + in_quotes(sector.name) + " at " + number_text(sector.ceiling.z) +
                    " m is below its floor at " + number_text(sector.floor.z) +
                    " m; raise it, or make them equal for a closed door");
}

std::string line_text(TextPlace place) {
    return place.line != 0 ? " in line " + std::to_string(place.line) : std::string();
}

void check_sector_names(Draft& draft) {
    std::vector<ScopedName> names;
    for (std::uint32_t i = 0; i < draft.sectors.size(); ++i)
        if (!draft.sectors[i].record->name.empty()) names.push_back({0, draft.sectors[i].record->name, i});
    for (const auto& [first, again] : NameIndex(std::move(names)).duplicates()) {
        SectorDraft &one = draft.sectors[first], &other = draft.sectors[again];
        one.is_only_one = other.is_only_one = false;
        draft.error(*other.record, "name", "duplicate-sector",
                    "expected a name no other sector has, found " + in_quotes(other.record->name) +
                        " again; it is first used" + line_text(key_place(*one.record, "name")));
    }
}

void check_wall_names(Draft& draft) {
    std::vector<ScopedName> names;
    for (std::uint32_t i = 0; i < draft.walls.size(); ++i)
        if (!draft.walls[i].record->name.empty())
            names.push_back({draft.map.walls[i].sector.index, draft.walls[i].record->name, i});
    for (const auto& [first, again] : NameIndex(std::move(names)).duplicates())
        draft.error(*draft.walls[again].record, "name", "duplicate-wall",
                    "expected a name no other wall of the sector has, found " +
                        in_quotes(draft.walls[again].record->name) + " again; it is first used" +
                        line_text(key_place(*draft.walls[first].record, "name")));
}

}  // namespace

void check_sectors(Draft& draft) {
    for (const SectorDraft& sector : draft.sectors) check_heights(draft, *sector.record);
    check_sector_names(draft);
    check_wall_names(draft);
}

// Walls, steps and flats that can be seen but have no texture, and textures that cannot be seen.

namespace {

constexpr const char* kMeant = " (say texture = \"-\" if that is what you want)";

/// The first picture of a wall that only a portal would show, or null.
const TextureSpec* first_for_portals(const WallRecord& wall) {
    for (const auto* spec : {&wall.upper, &wall.lower, &wall.middle})
        if (*spec) return &**spec;
    return nullptr;
}

void check_solid(Draft& draft, WallId id) {
    const WallDraft& written = draft.walls[id.index];
    const std::string sector = in_quotes(draft.map[draft.map[id].sector].name);
    if (!written.record->texture)
        draft.warning(known(written.record->place, written.place), "no-texture",
                      "this solid wall of sector " + sector + " has no texture; a placeholder is drawn" + kMeant);
    if (const TextureSpec* unused = first_for_portals(*written.record))
        draft.warning(unused->place, "unused-texture",
                      "only portals have steps and a middle, but this wall of sector " + sector +
                          " has no next; upper, lower and middle are not drawn");
}

/// A step that is there while nothing moves, and of which nothing is said.
void check_steps(Draft& draft, WallId id) {
    const Wall& wall = draft.map[id];
    const WallDraft& written = draft.walls[id.index];
    if (written.record->texture) return;  // serves both steps
    const Sector &here = draft.map[wall.sector], &there = draft.map[wall.behind];
    const double rise = draft.map.passage(wall).rise;
    const TextPlace head = known(written.record->place, written.place);
    const std::string way = in_quotes(here.name) + " to " + in_quotes(there.name);
    if (!written.record->lower && there.floor.z - rise > here.floor.z)
        draft.warning(head, "no-step-texture",
                      "the step up from " + way + " has no texture, so nothing is drawn there; give it lower");
    if (!written.record->upper && there.ceiling.z - rise < here.ceiling.z && !(here.ceiling.sky && there.ceiling.sky))
        draft.warning(
            head, "no-step-texture",
            "the step down from the ceiling of " + way + " has no texture, so nothing is drawn there; give it upper");
}

void check_flat(Draft& draft, const SectorRecord& sector, const FlatRecord& flat, const char* which) {
    if (flat.texture) return;
    draft.warning(known(flat.place, sector.place), "no-texture",
                  std::string("the ") + which + " of sector " + in_quotes(sector.name) +
                      " has no texture; a placeholder is drawn" + kMeant);
}

}  // namespace

void check_textures(Draft& draft) {
    for (std::size_t i = 0; i < draft.map.walls.size(); ++i) {
        const Wall& wall = draft.map.walls[i];
        if (wall.kind == WallKind::portal) check_steps(draft, WallId(i));
        // A portal whose next is wrong has been reported as that.
        const bool is_shown_whole = wall.kind == WallKind::solid || wall.kind == WallKind::way_back;
        if (is_shown_whole && draft.walls[i].record->next.empty()) check_solid(draft, WallId(i));
    }
    for (const SectorDraft& sector : draft.sectors) {
        check_flat(draft, *sector.record, sector.record->floor, "floor");
        check_flat(draft, *sector.record, sector.record->ceiling, "ceiling");
    }
}

namespace {

// Sectors that move as one: each learns who leads its group, and what cannot move as one is said.

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
                    in_quotes(first.name) + " of the same group " + in_quotes(first.group) + " has it, found " +
                    number_text((other.*flat).z) + " m; what moves as one starts at one height");
}

void check_bob(Draft& draft, const char* what, const SectorRecord& first, const SectorRecord& other,
               FlatRecord SectorRecord::* flat) {
    if ((first.*flat).bob == (other.*flat).bob) return;
    draft.error(place_of(other.*flat, other), "group-bobs",
                "expected the " + std::string(what) + " of sector " + in_quotes(other.name) +
                    " to bob as that of sector " + in_quotes(first.name) + " of the same group " +
                    in_quotes(first.group) + "; what moves as one has one bob, or none: write the same one in both");
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
                  "sector " + in_quotes(with.name) + " of the group " + in_quotes(with.group) +
                      " has a trigger on \"use\", sector " + in_quotes(without.name) +
                      " has none; give it the same one, or nothing happens to who uses it from that side");
}

void check_lonely(Draft& draft, const SectorRecord& sector) {
    draft.warning(sector, "group", "group-of-one",
                  "expected two sectors or more in the group " + in_quotes(sector.group) + ", found only " +
                      in_quotes(sector.name) + "; give another one the same group, or take it out");
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
