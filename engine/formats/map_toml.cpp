#include "formats/map_toml.h"

#include "formats/map_keys.h"

namespace enfilade {

namespace {

Dialect dialect_of(TomlNode root) {
    return root.find("format").kind() == TomlKind::absent ? Dialect::tutorial : Dialect::enfilade;
}

}  // namespace

MapReading read_map(std::string_view text) {
    MapReading result;
    const auto document = TomlDocument::parse(text, {kMaxMapBytes, kMaxMapValues}, result.findings);
    if (!document) return result;
    Reading reading{result.findings, dialect_of(document->root())};
    read_record(reading, document->root(), result.map);
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
