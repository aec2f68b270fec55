#include "formats/map_keys.h"

#include <algorithm>
#include <utility>

#include "formats/text_parts.h"

namespace enfilade {
namespace {

/// Widest line of vertices [characters].
constexpr std::size_t kLineWidth = 100;

void add_trigger_infos(std::vector<KeyInfo>& all, const std::string& prefix) {
    add_key_infos<TriggerRecord>(all, prefix);
    add_key_infos<LightEffectRecord>(all, prefix + "effect.");
}

void add_wall_infos(std::vector<KeyInfo>& all, const std::string& prefix) {
    add_key_infos<WallRecord>(all, prefix);
    add_trigger_infos(all, prefix + "triggers.");
    add_key_infos<DoomRecord>(all, prefix + "doom.");
}

void add_flat_infos(std::vector<KeyInfo>& all, const std::string& prefix) {
    add_key_infos<FlatRecord>(all, prefix);
    add_key_infos<BobRecord>(all, prefix + "bob.");
    add_key_infos<FlatLayerRecord>(all, prefix + "layers.");
}

void add_opening_infos(std::vector<KeyInfo>& all) {
    add_key_infos<OpeningRecord>(all, "openings.");
    add_flat_infos(all, "openings.floor.");
    add_flat_infos(all, "openings.ceiling.");
    add_trigger_infos(all, "openings.triggers.");
    add_key_infos<LightEffectRecord>(all, "openings.light_effect.");
}

}  // namespace

std::size_t tables_in(TomlNode array) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < array.size(); ++i) count += array.at(i).kind() == TomlKind::table;
    return count;
}

void needs_format_1(Reading& reading, const TomlEntry& entry) {
    if (std::exchange(reading.lacks_format, true)) return;  // what mends one mends all
    reading.error(entry.key_place, "needs-format-1",
                  in_quotes(entry.key) + " belongs to the enfilade dialect; put 'format = 1' at the top of the file");
}

void missing_key(Reading& reading, TextPlace place, std::string_view record, std::string_view key) {
    reading.error(place, "missing-key", std::string(record) + " needs " + in_quotes(key) + ", found none");
}

const TomlEntry* find_entry(std::span<const TomlEntry> entries, std::string_view key) {
    const auto it = std::find_if(entries.begin(), entries.end(), [&](const TomlEntry& e) { return e.key == key; });
    return it == entries.end() ? nullptr : &*it;
}

void refuse_both(Reading& reading, std::span<const TomlEntry> entries, std::string_view one, std::string_view other,
                 std::string_view code) {
    const TomlEntry* first = find_entry(entries, one);
    const TomlEntry* second = find_entry(entries, other);
    if (!first || !second) return;
    reading.error(std::max(first->key_place, second->key_place), code,
                  in_quotes(one) + " and " + in_quotes(other) + " exclude each other; give only one of them");
}

void refuse_tile_and_size(Reading& reading, const TextureSpec& spec) {
    if (spec.tile_m)
        reading.error(spec.place, "tile-and-size",
                      "the texture gives metres per tile, and 'size' gives texels per metre; give only one of them "
                      "(an offset alone is \"NAME - OU,OV\")");
}

std::string vertices_text(std::span<const Vec2> vertices) {
    std::string text = "[";
    std::size_t line_start = 0;
    for (const Vec2& v : vertices) {
        const std::string pair = number_text(v.x) + ", " + number_text(v.y);
        if (&v != &vertices.front()) {
            const bool is_full = text.size() + pair.size() - line_start > kLineWidth;
            text += is_full ? ",\n     " : ",  ";
            if (is_full) line_start = text.size() - 5;
        }
        text += pair;
    }
    return text + "]";
}

std::vector<KeyInfo> map_keys() {
    std::vector<KeyInfo> all;
    add_key_infos<MapFile>(all, "");
    add_key_infos<RenderRecord>(all, "render.");
    add_key_infos<PlayerRecord>(all, "player.");
    add_key_infos<AnimationRecord>(all, "animations.");
    add_key_infos<SwitchRecord>(all, "switches.");
    add_key_infos<SoundRecord>(all, "sounds.");
    add_key_infos<SectorRecord>(all, "sectors.");
    add_flat_infos(all, "sectors.floor.");
    add_flat_infos(all, "sectors.ceiling.");
    add_trigger_infos(all, "sectors.triggers.");
    add_key_infos<LightEffectRecord>(all, "sectors.light_effect.");
    add_key_infos<DoomRecord>(all, "sectors.doom.");
    add_key_infos<PolygonRecord>(all, "sectors.polygon.");
    add_wall_infos(all, "sectors.wall.");
    add_key_infos<LoopRecord>(all, "sectors.loops.");
    add_key_infos<PolygonRecord>(all, "sectors.loops.polygon.");
    add_wall_infos(all, "sectors.loops.wall.");
    add_wall_infos(all, "sectors.loops.walls.");
    add_key_infos<PanelRecord>(all, "sectors.panels.");
    add_trigger_infos(all, "sectors.panels.triggers.");
    add_key_infos<DoomRecord>(all, "sectors.panels.doom.");
    add_key_infos<PrefabRecord>(all, "prefabs.");
    add_opening_infos(all);
    add_key_infos<ThingRecord>(all, "things.");
    add_key_infos<BobRecord>(all, "things.bob.");
    add_key_infos<SpriteFrameRecord>(all, "things.frames.");
    add_trigger_infos(all, "things.triggers.");
    add_key_infos<DoomRecord>(all, "things.doom.");
    add_key_infos<PointLightRecord>(all, "lights.");
    add_key_infos<LightEffectRecord>(all, "lights.effect.");
    add_key_infos<SunRecord>(all, "suns.");
    return all;
}

}  // namespace enfilade
