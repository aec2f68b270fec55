// What a sector must be whatever its shape: a name of its own, a ceiling that is not below its floor.
#include <string>
#include <vector>

#include "formats/number_text.h"
#include "formats/quoted.h"
#include "map/draft.h"
#include "map/names.h"

namespace enfilade {
namespace {

void check_heights(Draft& draft, const SectorRecord& sector) {
    if (sector.ceiling.z >= sector.floor.z) return;
    const FlatRecord& written = sector.ceiling.places.has("z") ? sector.ceiling : sector.floor;
    if (!sector.ceiling.places.is_sound("z") || !sector.floor.places.is_sound("z")) return;
    draft.error(known(key_place(written, "z"), sector.place), "ceiling-below-floor",
                "the ceiling of sector " + quoted(sector.name) + " at " + number_text(sector.ceiling.z) +
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
                    "expected a name no other sector has, found " + quoted(other.record->name) +
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
                        quoted(draft.walls[again].record->name) + " again; it is first used" +
                        line_text(key_place(*draft.walls[first].record, "name")));
}

}  // namespace

void check_sectors(Draft& draft) {
    for (const SectorDraft& sector : draft.sectors) check_heights(draft, *sector.record);
    check_sector_names(draft);
    check_wall_names(draft);
}

}  // namespace enfilade
