// A map file as a whole: its keys, those of the player's start and of the picture, and how they are read.
#include "formats/map_toml.h"

#include <algorithm>
#include <array>

#include "formats/expand.h"
#include "formats/map_keys.h"

namespace enfilade {
namespace {

/// Height of the eye above the floor where the file gives none [m]: a grown-up's.
constexpr double kUsualEyeHeight = 1.6;

/// Radians to degrees.
constexpr double kDegreesPerRadian = 57.29577951308232;

/// The tutorial's `angle`, in radians.
void read_angle(Reading& reading, const NamedValue& value, Range range, PlayerRecord& player) {
    double radians = 0;
    read_value(reading, value, range, radians);
    player.yaw_degrees = radians * kDegreesPerRadian;
}

constexpr std::array kPlayerKeys{
    key<&PlayerRecord::sector>("sector", kBoth),
    key<&PlayerRecord::position, &Vec2::x>("x", kBoth, Need::required, kPositions),
    key<&PlayerRecord::position, &Vec2::y>("y", kBoth, Need::required, kPositions),
    key<&PlayerRecord::eye_z>("z", kBoth, Need::written, kHeights),
    key<&PlayerRecord::yaw_degrees>("yaw", kNew, Need::optional, kAngles),
    Key<PlayerRecord>{"angle", kBoth, Need::optional, kAngles, read_angle},
};

constexpr std::array kRenderKeys{
    key<&RenderRecord::stretch>("stretch", kNew, Need::optional, kStretches),
    key<&RenderRecord::light>("light", kNew),
    color_key<&RenderRecord::recursion_color>("recursion_color", kNew),
    key<&RenderRecord::max_depth>("max_depth", kNew, Need::optional, kDepths),
    color_key<&RenderRecord::fog_color>("fog_color", kNew),
    key<&RenderRecord::fog_reach>("fog_reach", kNew, Need::optional, kFogReaches),
    key<&RenderRecord::sky>("sky", kNew),
    key<&RenderRecord::things>("things", kNew),
    key<&RenderRecord::rays>("rays", kNew),
    file_key<&RenderRecord::color_table>("color_table", kNew),
};

void read_format(Reading& reading, const NamedValue& value, Range, MapFile& map) {
    map.format = 1;
    if (value.node.kind() != TomlKind::integer || value.node.integer() != 1)
        reading.error(value.node.place(), "unknown-format", "'format' must be 1, the only one there is so far");
}

void write_format(TableText& table, const Key<MapFile>& key, const MapFile&, const MapFile&) {
    table.add(key.name, "1");
}

constexpr std::array kMapKeys{
    Key<MapFile>{"format", kBoth, Need::optional, {}, read_format, write_format},
    key<&MapFile::name>("name", kBoth),
    file_key<&MapFile::textures, Files::anywhere>("textures", kBoth),
    key<&MapFile::size>("size", kNew, Need::optional, kTexelsPerMetre),
    header_key<&MapFile::render>("render", kNew),
    header_key<&MapFile::player>("player", kBoth),
    header_key<&MapFile::sectors>("sectors", kBoth, Need::required),
    header_key<&MapFile::prefabs>("prefabs", kNew),
    header_key<&MapFile::openings>("openings", kNew),
    header_key<&MapFile::things>("things", kNew),
    header_key<&MapFile::lights>("lights", kNew),
    header_key<&MapFile::suns>("suns", kNew),
    header_key<&MapFile::animations>("animations", kNew),
    header_key<&MapFile::switches>("switches", kNew),
    header_key<&MapFile::sounds>("sounds", kNew),
};

/// Where the file gives the player no eye height: standing on the floor.
void stand_on_the_floor(MapFile& map) {
    const auto has_name = [&](const SectorRecord& sector) { return sector.name == map.player->sector; };
    const auto sector = std::find_if(map.sectors.begin(), map.sectors.end(), has_name);
    map.player->eye_z = (sector == map.sectors.end() ? 0 : sector->floor.z) + kUsualEyeHeight;
}

constexpr KeyList<PlayerRecord> kPlayerList{"the player", kPlayerKeys};
constexpr KeyList<RenderRecord> kRenderList{"'render'", kRenderKeys};
constexpr KeyList<MapFile> kMapList{"a map", kMapKeys};

}  // namespace

template <>
const KeyList<PlayerRecord>& keys_of() {
    return kPlayerList;
}

template <>
const KeyList<RenderRecord>& keys_of() {
    return kRenderList;
}

template <>
const KeyList<MapFile>& keys_of() {
    return kMapList;
}

template <>
void check_record(Reading& reading, TomlNode, std::span<const TomlEntry> entries, PlayerRecord&) {
    refuse_both(reading, entries, "yaw", "angle", "yaw-and-angle");
}

namespace {

Dialect dialect_of(TomlNode root) {
    return root.find("format").kind() == TomlKind::absent ? Dialect::tutorial : Dialect::enfilade;
}

std::uint32_t lines_in(std::string_view text) { return static_cast<std::uint32_t>(std::ranges::count(text, '\n')) + 1; }

}  // namespace

void read_document(Reading& reading, TomlNode root, PrefabFiles& files, MapFile& map) {
    read_record(reading, root, map);
    for (SectorRecord& sector : map.sectors) write_out_loops(reading, files.expansion(), sector);
    files.place_all(map);
    cut_openings(reading, files.expansion(), map);
    if (map.player && !map.player->places.has("z")) stand_on_the_floor(map);
}

MapReading read_map(std::string_view text, const FileReader& prefabs) {
    MapReading result;
    const auto document = TomlDocument::parse(text, {kMaxMapBytes, kMaxMapValues}, result.findings);
    if (!document) return result;
    Reading reading{result.findings, dialect_of(document->root())};
    Expansion expansion(reading);
    PrefabFiles files(prefabs, reading, expansion, lines_in(text) + 1);
    read_document(reading, document->root(), files, result.map);
    result.sources = files.sources();
    sort_by_place(result.findings);
    return result;
}

bool is_map(std::string_view text) {
    Findings ignored;
    const auto document = TomlDocument::parse(text, {kMaxMapBytes, kMaxMapValues}, ignored);
    return document && document->root().find("sectors").kind() == TomlKind::array;
}

namespace {

/// The record's keys as lines below a header, set off by an empty line.
template <class Record>
void add_under(std::string& text, std::string_view header, const Record& record) {
    text.append("\n").append(header).append("\n");
    text += record_text(record, Record{}, TableText::Style::lines);
}

void add_sector(std::string& text, const SectorRecord& sector) {
    add_under(text, "[[sectors]]", sector);
    for (const LoopRecord& loop : sector.loops) add_under(text, "[[sectors.loops]]", loop);
    for (const PanelRecord& panel : sector.panels) add_under(text, "[[sectors.panels]]", panel);
}

}  // namespace

std::string write_map(const MapFile& map) {
    std::string text = record_text(map, MapFile{}, TableText::Style::lines);
    if (map.sectors.empty()) text += "sectors = []\n";
    if (!record_text(map.render, RenderRecord{}, TableText::Style::lines).empty())
        add_under(text, "[render]", map.render);
    if (map.player) add_under(text, "[player]", *map.player);
    for (const AnimationRecord& animation : map.animations) add_under(text, "[[animations]]", animation);
    for (const SwitchRecord& faces : map.switches) add_under(text, "[[switches]]", faces);
    for (const SoundRecord& sound : map.sounds) add_under(text, "[[sounds]]", sound);
    for (const SunRecord& sun : map.suns) add_under(text, "[[suns]]", sun);
    for (const SectorRecord& sector : map.sectors) add_sector(text, sector);
    for (const ThingRecord& thing : map.things) add_under(text, "[[things]]", thing);
    for (const PointLightRecord& light : map.lights) add_under(text, "[[lights]]", light);
    return text;
}

}  // namespace enfilade
