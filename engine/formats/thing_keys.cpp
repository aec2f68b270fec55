// The keys of what is put into rooms, or between them: things with the pictures they show, lamps, openings, prefabs.
#include <array>

#include "formats/map_keys.h"

namespace enfilade {
namespace {

/// "skills = [1, 2, 5]".
void read_skills(Reading& reading, const NamedValue& value, Range range, ThingRecord& thing) {
    if (!expect(reading, value, TomlKind::array)) return;
    thing.skills = 0;
    for (std::size_t i = 0; i < value.node.size() && !reading.is_full(); ++i) {
        int skill = 0;
        read_value(reading, {value.name, value.node.at(i)}, range, skill);
        if (skill > 0) thing.skills = static_cast<std::uint8_t>(thing.skills | 1u << (skill - 1));
    }
}

void write_skills(TableText& table, const Key<ThingRecord>& key, const ThingRecord& thing, const ThingRecord& usual) {
    if (thing.skills == usual.skills) return;
    std::string list;
    for (int skill = 1; skill <= kMostSkill; ++skill)
        if (thing.skills & 1u << (skill - 1)) list += (list.empty() ? "" : ", ") + std::to_string(skill);
    table.add(key.name, "[" + list + "]");
}

constexpr std::array kFrameKeys{
    file_key<&SpriteFrameRecord::texture>("texture", kNew, Need::required),
    key<&SpriteFrameRecord::seconds>("seconds", kNew, Need::optional, kSeconds),
    key<&SpriteFrameRecord::origin_tx>("origin", kNew, Need::optional, kOrigins),
};

constexpr std::array kThingKeys{
    key<&ThingRecord::name>("name", kNew),
    key<&ThingRecord::kind>("class", kNew),
    key<&ThingRecord::sector>("sector", kNew),
    key<&ThingRecord::position, &Vec2::x>("x", kNew, Need::required, kPositions),
    key<&ThingRecord::position, &Vec2::y>("y", kNew, Need::required, kPositions),
    key<&ThingRecord::z>("z", kNew, Need::optional, kHeights),
    key<&ThingRecord::yaw_degrees>("yaw", kNew, Need::optional, kAngles),
    key<&ThingRecord::turn>("turn", kNew, Need::optional, kTurnSpeeds),
    key<&ThingRecord::bob>("bob", kNew),
    key<&ThingRecord::radius>("radius", kNew, Need::optional, kThingSizes),
    key<&ThingRecord::height>("height", kNew, Need::optional, kThingSizes),
    key<&ThingRecord::solid>("solid", kNew),
    key<&ThingRecord::holds_up>("holds_up", kNew),
    key<&ThingRecord::hanging>("hanging", kNew),
    key<&ThingRecord::rotations>("rotations", kNew, Need::optional, {1, 8}),
    key<&ThingRecord::size>("size", kNew, Need::optional, kTexelsPerMetre),
    key<&ThingRecord::light>("light", kNew, Need::optional, kLight),
    Key<ThingRecord>{"skills", kNew, Need::optional, {1, kMostSkill}, read_skills, write_skills},
    key<&ThingRecord::multiplayer>("multiplayer", kNew),
    key<&ThingRecord::frames>("frames", kNew),
    key<&ThingRecord::triggers>("triggers", kNew),
    key<&ThingRecord::gives_key>("gives_key", kNew),
    key<&ThingRecord::gives_health>("gives_health", kNew, Need::optional, kHealth),
    key<&ThingRecord::sound>("sound", kNew),
    key<&ThingRecord::doom>("doom", kNew),
};

constexpr KeyList<SpriteFrameRecord> kFrameList{"a sprite's frame", kFrameKeys};
constexpr KeyList<ThingRecord> kThingList{"a thing", kThingKeys};

// The keys of point lights and suns.

constexpr std::array kPointLightKeys{
    key<&PointLightRecord::sector>("sector", kNew),
    key<&PointLightRecord::position, &Vec2::x>("x", kNew, Need::required, kPositions),
    key<&PointLightRecord::position, &Vec2::y>("y", kNew, Need::required, kPositions),
    key<&PointLightRecord::z>("z", kNew, Need::required, kHeights),
    color_key<&PointLightRecord::color>("color", kNew),
    key<&PointLightRecord::brightness>("brightness", kNew, Need::optional, kBrightnesses),
    key<&PointLightRecord::reach>("reach", kNew, Need::optional, kLightReaches),
    key<&PointLightRecord::effect>("effect", kNew),
};

constexpr std::array kSunKeys{
    key<&SunRecord::name>("name", kNew, Need::required),
    key<&SunRecord::yaw_degrees>("yaw", kNew, Need::optional, kAngles),
    key<&SunRecord::elevation_degrees>("elevation", kNew, Need::optional, {0, 90}),
    color_key<&SunRecord::color>("color", kNew),
    key<&SunRecord::brightness>("brightness", kNew, Need::optional, kBrightnesses),
};

constexpr KeyList<PointLightRecord> kPointLightList{"a light", kPointLightKeys};
constexpr KeyList<SunRecord> kSunList{"a sun", kSunKeys};

}  // namespace

template <>
const KeyList<SpriteFrameRecord>& keys_of() {
    return kFrameList;
}

template <>
const KeyList<ThingRecord>& keys_of() {
    return kThingList;
}

template <>
void check_record(Reading& reading, TomlNode, std::span<const TomlEntry> entries, ThingRecord& thing) {
    if (thing.rotations == 1 || thing.rotations == 8) return;
    reading.error(find_entry(entries, "rotations")->value.place(), "out-of-range",
                  "'rotations' must be 1 or 8, found " + std::to_string(thing.rotations));
    thing.rotations = 1;
}

template <>
const KeyList<PointLightRecord>& keys_of() {
    return kPointLightList;
}

template <>
const KeyList<SunRecord>& keys_of() {
    return kSunList;
}

// Openings and prefabs.

namespace {

/// Widths and depths of openings [m].
constexpr Range kWidths{kVertexGrid, kWorldLimit};

/// Steps of stairs.
constexpr Range kSteps{1, 256};

/// Turns of prefabs: once round, to either side [degrees].
constexpr Range kTurns{-360, 360};

template <auto member>
constexpr auto of_wall(std::string_view name, Range range = {}) {
    return header_key<&OpeningRecord::wall, member>(name, kNew, Need::optional, range);
}
template <auto member>
constexpr auto of_sector(std::string_view name, Range range = {}) {
    return header_key<&OpeningRecord::sector, member>(name, kNew, Need::optional, range);
}

constexpr std::array kOpeningKeys{
    header_key<&OpeningRecord::between>("between", kNew, Need::required),
    header_key<&OpeningRecord::at>("at", kNew, Need::optional, kPositions),
    header_key<&OpeningRecord::to>("to", kNew, Need::optional, kPositions),
    header_key<&OpeningRecord::width>("width", kNew, Need::optional, kWidths),
    header_key<&OpeningRecord::depth>("depth", kNew, Need::optional, kWidths),
    header_key<&OpeningRecord::bottom>("bottom", kNew, Need::optional, kHeights),
    header_key<&OpeningRecord::top>("top", kNew, Need::optional, kHeights),
    header_key<&OpeningRecord::steps>("steps", kNew, Need::optional, kSteps),
    header_key<&OpeningRecord::leaf>("leaf", kNew),
    of_wall<&WallRecord::texture>("texture"),
    of_wall<&WallRecord::upper>("upper"),
    of_wall<&WallRecord::lower>("lower"),
    of_wall<&WallRecord::middle>("middle"),
    of_wall<&WallRecord::size>("size", kTexelsPerMetre),
    of_wall<&WallRecord::blocks>("blocks"),
    of_wall<&WallRecord::rise>("rise", kHeights),
    of_sector<&SectorRecord::name>("name"),
    of_sector<&SectorRecord::light>("light", kLight),
    of_sector<&SectorRecord::floor>("floor"),
    of_sector<&SectorRecord::ceiling>("ceiling"),
    of_sector<&SectorRecord::tags>("tags"),
    of_sector<&SectorRecord::group>("group"),
    of_sector<&SectorRecord::triggers>("triggers"),
    of_sector<&SectorRecord::light_effect>("light_effect"),
    of_sector<&SectorRecord::secret>("secret"),
    of_sector<&SectorRecord::move_sound>("move_sound"),
    of_sector<&SectorRecord::down_sound>("down_sound"),
    of_sector<&SectorRecord::stop_sound>("stop_sound"),
};

constexpr auto prefab_file_key() {
    auto file = file_key<&PrefabRecord::file>("file", kNew, Need::required);
    file.write = nullptr;
    return file;
}

constexpr std::array kPrefabKeys{
    header_key<&PrefabRecord::name>("name", kNew, Need::required),
    prefab_file_key(),
    header_key<&PrefabRecord::at>("at", kNew, Need::optional, kPositions),
    header_key<&PrefabRecord::z>("z", kNew, Need::optional, kHeights),
    header_key<&PrefabRecord::turn>("turn", kNew, Need::optional, kTurns),
};

constexpr KeyList<OpeningRecord> kOpeningList{"an opening", kOpeningKeys};
constexpr KeyList<PrefabRecord> kPrefabList{"a prefab", kPrefabKeys};

void refuse_height(Reading& reading, const FlatRecord& flat, std::string_view key) {
    if (flat.places.has("z"))
        reading.error(key_place(flat, "z"), "given-twice",
                      "the height of an opening is its " + in_quotes(key) + "; write that instead of 'z'");
}

}  // namespace

template <>
const KeyList<OpeningRecord>& keys_of() {
    return kOpeningList;
}

template <>
const KeyList<PrefabRecord>& keys_of() {
    return kPrefabList;
}

template <>
void check_record(Reading& reading, TomlNode, std::span<const TomlEntry> entries, OpeningRecord& opening) {
    refuse_height(reading, opening.sector.floor, "bottom");
    refuse_height(reading, opening.sector.ceiling, "top");
    for (const auto* spec : {&opening.wall.texture, &opening.wall.upper, &opening.wall.lower, &opening.wall.middle})
        if (*spec && opening.wall.size) refuse_tile_and_size(reading, **spec);
    refuse_both(reading, entries, "leaf", "steps", "given-twice");
    const TextPlace between = key_place(opening, "between");
    if (opening.places.has("between") && opening.places.is_sound("between") && opening.between.size() != 2)
        reading.error(
            between, "wrong-type",
            "'between' must be an array of two names of sectors, found " + std::to_string(opening.between.size()));
    if (opening.to && !opening.at) missing_key(reading, opening.place, "an opening with 'to'", "at");
    if (opening.at && !opening.width) missing_key(reading, opening.place, "an opening with 'at'", "width");
    if (opening.depth && !opening.to)
        reading.error(key_place(opening, "depth"), "depth-without-to",
                      "'depth' belongs to a link, with 'to'; between rooms that lie apart it is the distance of their "
                      "walls");
    if (opening.wall.rise && !opening.to)
        reading.error(key_place(opening, "rise"), "rise-without-via", "'rise' belongs to a link; give 'to', too");
}

}  // namespace enfilade
