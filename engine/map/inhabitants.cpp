// Where the player starts, and whether the things are in the map.
#include <string>
#include <vector>

#include "formats/number_text.h"
#include "formats/quoted.h"
#include "map/draft.h"
#include "map/inside.h"
#include "map/names.h"
#include "map/say.h"
#include "math/grid.h"

namespace enfilade {
namespace {

/// The first sector that contains p, or none.
SectorId first_around(const Draft& draft, Vec2 p) {
    for (std::size_t i = 0; i < draft.sectors.size(); ++i)
        if (draft.sectors[i].measurable && is_inside(draft.map, SectorId(i), p)) return SectorId(i);
    return {};
}

NameIndex sector_names(const Draft& draft) {
    std::vector<ScopedName> names;
    for (std::uint32_t i = 0; i < draft.map.sectors.size(); ++i) names.push_back({0, draft.map.sectors[i].name, i});
    return NameIndex(std::move(names));
}

/// Puts the player where he is, not where the file says: in the tutorial dialect nothing was checked.
void start_somewhere(Draft& draft, PlayerStart start, const std::string& complaint, const char* code) {
    start.sector = first_around(draft, start.position);
    if (draft.is_strict()) {
        const std::string hint = start.sector ? "; that place is in " + quoted(draft.map[start.sector].name) : "";
        draft.error(draft.file.player->place, code, complaint + hint);
    } else if (start.sector) {
        draft.warning(draft.file.player->place, code,
                      complaint + "; the player starts in " + quoted(draft.map[start.sector].name));
        draft.map.player = start;
    } else {
        draft.warning(draft.file.player->place, code, complaint + "; the map has no start");
    }
}

void check_eye(Draft& draft, const PlayerStart& start) {
    const Sector& sector = draft.map[start.sector];
    const bool is_closed = sector.floor.z == sector.ceiling.z;
    if (is_closed || (start.eye_z > sector.floor.z && start.eye_z < sector.ceiling.z)) return;
    draft.warning(draft.file.player->place, "player-eye",
                  "expected the player's eye between the floor at " + number_text(sector.floor.z) +
                      " m and the ceiling at " + number_text(sector.ceiling.z) +
                      " m, found z = " + number_text(start.eye_z));
}

void place_player(Draft& draft) {
    if (!draft.file.player) {
        draft.warning({}, "no-player", "the map has no [player], so nobody can start in it; only --view shows it");
        return;
    }
    const PlayerRecord& record = *draft.file.player;
    PlayerStart start{{}, snap_to_point_grid(record.position), record.eye_z, Angle::from_degrees(record.yaw_degrees)};
    const NameIndex names = sector_names(draft);
    const auto found = names.find(0, record.sector);
    if (!found)
        return start_somewhere(draft, start,
                               "expected the name of a sector for the player, found " + quoted(record.sector) +
                                   names.suggestion(0, record.sector),
                               "player-sector");
    start.sector = SectorId(*found);
    if (!draft.sectors[*found].measurable) return;
    if (!is_inside(draft.map, start.sector, start.position))
        return start_somewhere(
            draft, start,
            "the player's position " + point_text(start.position) + " is outside sector " + quoted(record.sector),
            "player-outside");
    check_eye(draft, start);
    draft.map.player = start;
}

}  // namespace

void place_inhabitants(Draft& draft) { place_player(draft); }

}  // namespace enfilade
