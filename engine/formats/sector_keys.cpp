// The keys of sectors, their flats and panels, and of what a conversion leaves.
#include <algorithm>
#include <array>

#include "formats/map_keys.h"

namespace enfilade {
namespace {

constexpr std::array kFlatLayerKeys{
    key<&FlatLayerRecord::texture>("texture", kNew, Need::required),
    key<&FlatLayerRecord::scroll>("scroll", kNew, Need::optional, kScrollSpeeds),
    key<&FlatLayerRecord::turn>("turn", kNew, Need::optional, kScrollSpeeds),
};

constexpr std::array kFlatKeys{
    key<&FlatRecord::z>("z", kBoth, Need::optional, kHeights),
    key<&FlatRecord::texture>("texture", kBoth),
    key<&FlatRecord::size>("size", kNew, Need::optional, kTexelsPerMetre),
    key<&FlatRecord::is_relative>("isRelative", kBoth),
    key<&FlatRecord::parallax>("parallax", kBoth),
    key<&FlatRecord::scroll>("scroll", kNew, Need::optional, kScrollSpeeds),
    key<&FlatRecord::carries>("carries", kNew),
    key<&FlatRecord::bob>("bob", kNew),
    key<&FlatRecord::layers>("layers", kNew),
};

/// "v = [x0, y0, x1, y1]".
void read_ends(Reading& reading, const NamedValue& value, Range range, PanelRecord& panel) {
    if (value.node.kind() != TomlKind::array || value.node.size() != 4)
        return wrong_type(reading, value, "an array of four numbers, x0, y0, x1, y1");
    double* const numbers[] = {&panel.a.x, &panel.a.y, &panel.b.x, &panel.b.y};
    for (std::size_t i = 0; i < 4; ++i) read_value(reading, {value.name, value.node.at(i)}, range, *numbers[i]);
}

void write_ends(TableText& table, const Key<PanelRecord>& key, const PanelRecord& panel, const PanelRecord&) {
    table.add(key.name, vertices_text(std::array{panel.a, panel.b}));
}

constexpr std::array kPanelKeys{
    Key<PanelRecord>{"v", kNew, Need::required, kVertices, read_ends, write_ends},
    key<&PanelRecord::bottom>("bottom", kNew, Need::required, kHeights),
    key<&PanelRecord::top>("top", kNew, Need::required, kHeights),
    key<&PanelRecord::texture>("texture", kNew, Need::required),
    key<&PanelRecord::size>("size", kNew, Need::optional, kTexelsPerMetre),
    key<&PanelRecord::one_sided>("one_sided", kNew),
    key<&PanelRecord::blocks>("blocks", kNew),
    key<&PanelRecord::scroll>("scroll", kNew, Need::optional, kScrollSpeeds),
    key<&PanelRecord::triggers>("triggers", kNew),
    key<&PanelRecord::doom>("doom", kNew),
};

/// Keys for what stands for the corners and the walls of a loop, or of a sector's outline.
template <class Record, auto member>
void read_shorthand(Reading& reading, const NamedValue& value, Range range, Record& record) {
    if (!record.shorthand) record.shorthand.emplace();
    read_field(reading, value, range, (*record.shorthand).*member);
}

template <class Record, auto member>
constexpr Key<Record> short_key(std::string_view name, Range range = {}) {
    return {name, kNew, Need::optional, range, read_shorthand<Record, member>};
}

using Short = Shorthand<WallRecord>;

constexpr std::array kDoomKeys{
    key<&DoomRecord::special>("special", kNew),
    key<&DoomRecord::tag>("tag", kNew),
    key<&DoomRecord::flags>("flags", kNew),
};

constexpr std::array kSectorKeys{
    key<&SectorRecord::name>("name", kBoth, Need::required),
    key<&SectorRecord::light>("light", kBoth, Need::optional, kLight),
    key<&SectorRecord::unlit>("unlit", kNew),
    key<&SectorRecord::sun>("sun", kNew),
    key<&SectorRecord::floor>("floor", kBoth),
    key<&SectorRecord::ceiling>("ceiling", kBoth),
    key<&SectorRecord::tags>("tags", kNew),
    key<&SectorRecord::group>("group", kNew),
    key<&SectorRecord::triggers>("triggers", kNew),
    key<&SectorRecord::light_effect>("light_effect", kNew),
    key<&SectorRecord::damage>("damage", kNew, Need::optional, kHealth),
    key<&SectorRecord::secret>("secret", kNew),
    key<&SectorRecord::move_sound>("move_sound", kNew),
    key<&SectorRecord::down_sound>("down_sound", kNew),
    key<&SectorRecord::stop_sound>("stop_sound", kNew),
    key<&SectorRecord::doom>("doom", kNew),
    short_key<SectorRecord, &Short::rect>("rect", kVertices),
    short_key<SectorRecord, &Short::polygon>("polygon"),
    short_key<SectorRecord, &Short::wall>("wall"),
    header_key<&SectorRecord::loops>("loops", kBoth),
    header_key<&SectorRecord::panels>("panels", kNew),
};

constexpr KeyList<FlatRecord> kFlatList{"a floor or ceiling", kFlatKeys};
constexpr KeyList<FlatLayerRecord> kFlatLayerList{"a layer", kFlatLayerKeys};
constexpr KeyList<PanelRecord> kPanelList{"a panel", kPanelKeys};
constexpr KeyList<DoomRecord> kDoomList{"'doom'", kDoomKeys};
constexpr KeyList<SectorRecord> kSectorList{
    "a sector", kSectorKeys, [](std::string_view key) -> std::string_view {
        return key == "v" || key == "walls" ? "write it under a line [[sectors.loops]] of its own" : "";
    }};

// The keys of walls and loops.

constexpr std::array kWallKeys{
    key<&WallRecord::name>("name", kNew),
    key<&WallRecord::texture>("texture", kBoth),
    key<&WallRecord::next>("next", kBoth),
    key<&WallRecord::via>("via", kNew),
    key<&WallRecord::rise>("rise", kNew, Need::optional, kHeights),
    key<&WallRecord::mirror>("mirror", kNew),
    key<&WallRecord::blocks>("blocks", kNew),
    key<&WallRecord::way_back>("way_back", kNew),
    key<&WallRecord::upper>("upper", kBoth),
    key<&WallRecord::lower>("lower", kBoth),
    key<&WallRecord::middle>("middle", kNew),
    key<&WallRecord::texture_peg>("peg", kNew),
    key<&WallRecord::upper_peg>("upper_peg", kNew),
    key<&WallRecord::lower_peg>("lower_peg", kNew),
    key<&WallRecord::middle_peg>("middle_peg", kNew),
    key<&WallRecord::size>("size", kNew, Need::optional, kTexelsPerMetre),
    key<&WallRecord::scroll>("scroll", kNew, Need::optional, kScrollSpeeds),
    key<&WallRecord::triggers>("triggers", kNew),
    key<&WallRecord::doom>("doom", kNew),
    header_key<&WallRecord::upper>("up", kBoth),
    header_key<&WallRecord::lower>("down", kBoth),
};

/// "v = [x0, y0, x1, y1, …]".
void read_vertices(Reading& reading, const NamedValue& value, Range range, LoopRecord& loop) {
    if (!expect(reading, value, TomlKind::array)) return;
    const std::size_t count = value.node.size();
    if (count > 0 && value.node.at(0).kind() == TomlKind::array)
        return reading.error(value.node.at(0).place(), "wrong-type",
                             "'v' must list numbers, the x and y of each corner in turn, found an array in it; take "
                             "the inner brackets away, as in v = [0, 0, 0, 4, 8, 4]");
    if (count % 2 != 0)
        reading.error(value.node.place(), "odd-vertices",
                      "'v' must have an x and a y for each corner, found " + std::to_string(count) +
                          " numbers; add the one that is missing, or take one away");
    loop.vertices.resize(count / 2);
    loop.vertex_places.resize(count / 2);
    for (std::size_t i = 0; i < count / 2 && !reading.is_full(); ++i) {
        loop.vertex_places[i] = value.node.at(2 * i).place();
        read_value(reading, {value.name, value.node.at(2 * i)}, range, loop.vertices[i].x);
        read_value(reading, {value.name, value.node.at(2 * i + 1)}, range, loop.vertices[i].y);
    }
}

void write_vertices(TableText& table, const Key<LoopRecord>& key, const LoopRecord& loop, const LoopRecord&) {
    table.add(key.name, vertices_text(loop.vertices));
}

constexpr std::array kLoopKeys{
    key<&LoopRecord::name>("name", kBoth),
    Key<LoopRecord>{"v", kBoth, Need::written, kVertices, read_vertices, write_vertices},
    short_key<LoopRecord, &Short::rect>("rect", kVertices),
    short_key<LoopRecord, &Short::polygon>("polygon"),
    short_key<LoopRecord, &Short::wall>("wall"),
    key<&LoopRecord::walls>("walls", kBoth, Need::written),
};

constexpr KeyList<WallRecord> kWallList{"a wall", kWallKeys};
constexpr KeyList<LoopRecord> kLoopList{"a loop", kLoopKeys};

}  // namespace

template <>
const KeyList<FlatRecord>& keys_of() {
    return kFlatList;
}

template <>
const KeyList<FlatLayerRecord>& keys_of() {
    return kFlatLayerList;
}

template <>
const KeyList<PanelRecord>& keys_of() {
    return kPanelList;
}

template <>
const KeyList<DoomRecord>& keys_of() {
    return kDoomList;
}

template <>
const KeyList<SectorRecord>& keys_of() {
    return kSectorList;
}

template <>
void check_record(Reading& reading, TomlNode, std::span<const TomlEntry> entries, FlatRecord& flat) {
    if (flat.texture && flat.size) refuse_tile_and_size(reading, *flat.texture);
    if (flat.layers.size() <= kMostFlatLayers) return;
    reading.error(
        find_entry(entries, "layers")->key_place, "too-many-layers",
        "expected at most " + std::to_string(kMostFlatLayers) + " layers, found " + std::to_string(flat.layers.size()));
    flat.layers.resize(kMostFlatLayers);
}

template <>
void check_record(Reading& reading, TomlNode, std::span<const TomlEntry>, PanelRecord& panel) {
    if (panel.size) refuse_tile_and_size(reading, panel.texture);
}

template <>
const KeyList<WallRecord>& keys_of() {
    return kWallList;
}

template <>
const KeyList<LoopRecord>& keys_of() {
    return kLoopList;
}

template <>
void check_record(Reading& reading, TomlNode, std::span<const TomlEntry> entries, WallRecord& wall) {
    refuse_both(reading, entries, "upper", "up", "given-twice");
    refuse_both(reading, entries, "lower", "down", "given-twice");
    for (const auto* spec : {&wall.texture, &wall.upper, &wall.lower, &wall.middle})
        if (*spec && wall.size) refuse_tile_and_size(reading, **spec);
}

}  // namespace enfilade
