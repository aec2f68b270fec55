// Where the player starts, and whether the things are in the map.
#include <cmath>
#include <string>
#include <vector>

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

bool is_in_range(Vec2 p) { return std::abs(p.x) <= kWorldLimit && std::abs(p.y) <= kWorldLimit; }

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
                  "expected the player's eye between the floor at " + to_text(sector.floor.z) +
                      " m and the ceiling at " + to_text(sector.ceiling.z) + " m, found z = " + to_text(start.eye_z));
}

void place_player(Draft& draft) {
    if (!draft.file.player) {
        draft.warning({}, "no-player", "the map has no [player], so nobody can start in it; only --view shows it");
        return;
    }
    const PlayerRecord& record = *draft.file.player;
    if (!is_in_range(record.position) || !(std::abs(record.eye_z) <= kWorldLimit)) {
        draft.error(record.place, "player-out-of-range",
                    "expected the player's position between -32768 and 32768 m, found " + to_text(record.position) +
                        " at z = " + to_text(record.eye_z));
        return;
    }
    PlayerStart start{{}, snap_to_point_grid(record.position), record.eye_z, {}};
    if (std::abs(record.yaw_degrees) < 0x1p40) start.yaw = Angle::from_degrees(record.yaw_degrees);
    const NameIndex names = sector_names(draft);
    const auto found = names.find(0, record.sector);
    if (!found)
        return start_somewhere(draft, start,
                               "expected the name of a sector for the player, found " + quoted(record.sector) +
                                   did_you_mean(names.nearest(0, record.sector)),
                               "player-sector");
    start.sector = SectorId(*found);
    if (!draft.sectors[*found].measurable) return;
    if (!is_inside(draft.map, start.sector, start.position))
        return start_somewhere(
            draft, start,
            "the player's position " + to_text(start.position) + " is outside sector " + quoted(record.sector),
            "player-outside");
    check_eye(draft, start);
    draft.map.player = start;
}

}  // namespace

void place_inhabitants(Draft& draft) { place_player(draft); }

}  // namespace enfilade
