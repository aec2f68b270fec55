// Where the player starts, and where the things and the lights are.
#include <algorithm>
#include <string>
#include <vector>

#include "formats/text_parts.h"
#include "map/draft.h"
#include "map/sector_finder.h"
#include "math/vec.h"

namespace enfilade {
namespace {

/// What a lamp counts for at least [m^2].
constexpr double kLeastLitArea = 16;

std::vector<std::uint32_t> measurable_sectors(const Draft& draft) {
    std::vector<std::uint32_t> sectors;
    for (std::uint32_t i = 0; i < draft.sectors.size(); ++i)
        if (draft.sectors[i].measurable) sectors.push_back(i);
    return sectors;
}

/// Player and things against the finished rooms.
class Inhabitants {
public:
    explicit Inhabitants(Draft& draft)
        : draft_(draft), names_(sector_names(draft)), finder_(draft.map, measurable_sectors(draft)) {}

    void place_player(const PlayerRecord& record) {
        PlayerStart start{
            {}, snap_to_point_grid(record.position), record.eye_z, Angle::from_degrees(record.yaw_degrees)};
        const auto found = names_.find(0, record.sector);
        if (!found)
            return start_where_it_is(start, "sector", "player-sector",
                                     "expected the name of a sector for the player, found " + in_quotes(record.sector) +
                                         names_.suggestion(0, record.sector));
        start.sector = SectorId(*found);
        if (!can_be_asked(start.sector)) return;
        if (!is_inside(draft_.map, start.sector, start.position))
            return start_where_it_is(start, "x", "player-outside",
                                     "the player's position " + point_text(start.position) + " is outside sector " +
                                         in_quotes(record.sector));
        check_eye(start);
        draft_.map.player = start;
    }

    void place_thing(const ThingRecord& thing) {
        const Vec2 position = snap_to_point_grid(thing.position);
        const auto found = names_.find(0, thing.sector);
        if (!thing.sector.empty() && !found) return unknown_sector(thing, "thing", thing.sector);
        const SectorId sector = found ? SectorId(*found) : finder_.around(position);
        if (sector && !is_outside(sector, position))
            add_thing(draft_, thing, sector, sprites_);
        else
            draft_.warning(thing, "x", "thing-outside",
                           "the thing at " + point_text(position) + " is outside " +
                               (found ? "sector " + in_quotes(thing.sector) : "every sector") + "; nobody will see it");
    }

    void place_light(const PointLightRecord& record) {
        lit_area_ += lit_area(record.reach);
        if (lit_area_ > kMostLitArea) {
            if (!has_too_many_lights_)
                draft_.error(record, "reach", "too-many-lights",
                             "with this light the lights of the map reach too far together: expected at most " +
                                 number_text(kMostLitArea) +
                                 " square metres, counting the square of twice its reach for each");
            has_too_many_lights_ = true;
            return;
        }
        const Vec2 position = snap_to_point_grid(record.position);
        const auto found = names_.find(0, record.sector);
        if (!record.sector.empty() && !found) return unknown_sector(record, "light", record.sector);
        const SectorId sector = found ? SectorId(*found) : finder_.around(position);
        if (!sector || is_outside(sector, position))
            return draft_.warning(record, "x", "light-outside",
                                  "the light at " + point_text(position) + " is outside " +
                                      (found ? "sector " + in_quotes(record.sector) : "every sector") +
                                      "; it lights nothing, so move it into one");
        draft_.map.lights.push_back({sector, position, record.z, record.color, record.brightness,
                                     snap_to_point_grid(record.reach), record.effect});
        check_light(sector, record);
    }

private:
    template <class Record>
    void unknown_sector(const Record& record, const char* what, const std::string& name) {
        if (!draft_.has_nameless_sectors)
            draft_.error(record, "sector", "unknown-sector",
                         "expected the name of a sector for the " + std::string(what) + ", found " + in_quotes(name) +
                             names_.suggestion(0, name));
    }

    void check_light(SectorId id, const PointLightRecord& light) {
        const Sector& sector = draft_.map[id];
        const bool is_open = sector.floor.z < sector.ceiling.z;
        if (!is_open || (light.z > sector.floor.z && light.z < sector.ceiling.z)) return;
        draft_.warning(light, "z", "light-hidden",
                       "expected the light between the floor at " + number_text(sector.floor.z) +
                           " m and the ceiling at " + number_text(sector.ceiling.z) + " m of sector " +
                           in_quotes(sector.name) + ", found z = " + number_text(light.z));
    }

    /// Whether what is inside the sector, or another of its name, does not depend on an error that was found.
    bool can_be_asked(SectorId id) const {
        const SectorDraft& sector = draft_.sectors[id.index];
        return sector.measurable && sector.is_only_one;
    }

    bool is_outside(SectorId sector, Vec2 p) const { return can_be_asked(sector) && !is_inside(draft_.map, sector, p); }

    /// Says what is wrong. In the tutorial dialect, which never checked, the player starts wherever that is.
    /// key : of the player, which is wrong
    void start_where_it_is(PlayerStart start, const char* key, const char* code, const std::string& complaint) {
        const PlayerRecord& player = *draft_.file.player;
        if (!player.places.is_sound() || (!start.sector && draft_.has_nameless_sectors)) return;
        start.sector = finder_.around(start.position);
        const std::string around = start.sector ? in_quotes(draft_.map[start.sector].name) : "no sector";
        if (draft_.is_strict())
            return draft_.error(player, key, code,
                                complaint + (start.sector ? "; " + point_text(start.position) + " is in " + around
                                                          : "; no sector is there, so move the player into one"));
        draft_.warning(player, key, code, complaint + "; the player starts in " + around);
        if (start.sector) draft_.map.player = start;
    }

    void check_eye(const PlayerStart& start) {
        const Sector& sector = draft_.map[start.sector];
        const bool is_open = sector.floor.z < sector.ceiling.z;
        if (!is_open || (start.eye_z > sector.floor.z && start.eye_z < sector.ceiling.z)) return;
        draft_.warning(*draft_.file.player, "z", "player-eye",
                       "expected the player's eye between the floor at " + number_text(sector.floor.z) +
                           " m and the ceiling at " + number_text(sector.ceiling.z) +
                           " m, found z = " + number_text(start.eye_z));
    }

    Draft& draft_;
    NameIndex names_;
    SpriteShelf sprites_{draft_};
    SectorFinder finder_;
    double lit_area_ = 0;  ///< [m^2]
    bool has_too_many_lights_ = false;
};

void check_thing_names(Draft& draft) {
    std::vector<ScopedName> names;
    for (std::uint32_t i = 0; i < draft.file.things.size(); ++i)
        if (!draft.file.things[i].name.empty()) names.push_back({0, draft.file.things[i].name, i});
    for (const auto& [first, again] : NameIndex(std::move(names)).duplicates())
        draft.error(draft.file.things[again], "name", "duplicate-thing",
                    "expected a name no other thing has, found " + in_quotes(draft.file.things[again].name) + " again");
}

}  // namespace

double lit_area(double reach_m) { return std::max(4 * reach_m * reach_m, kLeastLitArea); }

void place_inhabitants(Draft& draft) {
    if (!draft.file.player)
        draft.warning(kTopOfFile, "no-player",
                      "the map has no [player]: it can be looked at with --view, but nobody can start; add "
                      "[player] with sector, x and y");
    check_thing_names(draft);
    const bool is_empty = !draft.file.player && draft.file.things.empty() && draft.file.lights.empty();
    if (draft.map.sectors.empty() || is_empty) return;
    Inhabitants inhabitants(draft);
    if (draft.file.player) inhabitants.place_player(*draft.file.player);
    for (const ThingRecord& thing : draft.file.things) inhabitants.place_thing(thing);
    for (const PointLightRecord& light : draft.file.lights) inhabitants.place_light(light);
    list_solid_things(draft.map);
}

}  // namespace enfilade
