// The keys of openings and prefabs.
#include <array>

#include "formats/map_keys.h"
#include "formats/text_keys.h"

namespace enfilade {
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
