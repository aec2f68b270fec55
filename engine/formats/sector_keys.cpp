// The keys of sectors, their flats and panels, and of what a conversion leaves.
#include <array>

#include "formats/map_keys.h"

namespace enfilade {
namespace {

constexpr auto kBoth = Dialect::tutorial;
constexpr auto kNew = Dialect::enfilade;

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
    key<&SectorRecord::damage>("damage", kNew, Need::optional, {0, 1000}),
    key<&SectorRecord::secret>("secret", kNew),
    key<&SectorRecord::move_sound>("move_sound", kNew),
    key<&SectorRecord::down_sound>("down_sound", kNew),
    key<&SectorRecord::stop_sound>("stop_sound", kNew),
    key<&SectorRecord::doom>("doom", kNew),
    header_key<&SectorRecord::loops>("loops", kBoth, Need::required),
    header_key<&SectorRecord::panels>("panels", kNew),
};

constexpr KeyList<FlatRecord> kFlatList{"a floor or ceiling", kFlatKeys};
constexpr KeyList<FlatLayerRecord> kFlatLayerList{"a layer", kFlatLayerKeys};
constexpr KeyList<PanelRecord> kPanelList{"a panel", kPanelKeys};
constexpr KeyList<DoomRecord> kDoomList{"'doom'", kDoomKeys};
constexpr KeyList<SectorRecord> kSectorList{"a sector", kSectorKeys};

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
void check_record(Reading& reading, TomlNode, std::span<const TomlEntry> entries, SectorRecord& sector) {
    const TomlEntry* loops = find_entry(entries, "loops");
    if (loops && loops->value.kind() == TomlKind::array && sector.loops.empty())
        missing_key(reading, loops->value.place(), "a sector", "loops");
}

}  // namespace enfilade
