// What all lists of keys share, all keys of a map, and the lists of what changes: triggers, effects of light, sounds.
#include "formats/map_keys.h"

#include <algorithm>
#include <array>
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

// Triggers, light effects, bobs, animations, switches and sounds.

namespace {

/// A single string is an array of one, because most triggers have one target.
void read_targets(Reading& reading, const NamedValue& value, Range range, TriggerRecord& trigger) {
    if (value.node.kind() == TomlKind::string)
        read_value(reading, value, range, trigger.targets.emplace_back());
    else
        read_value(reading, value, range, trigger.targets);
}

void write_targets(TableText& table, const Key<TriggerRecord>& key, const TriggerRecord& trigger,
                   const TriggerRecord&) {
    if (trigger.targets.size() == 1)
        table.add(key.name, value_text(trigger.targets.front()));
    else if (!trigger.targets.empty())
        table.add(key.name, value_text(trigger.targets));
}

/// Of an exit, the target is the map it leads to.
void check_exit(Reading& reading, const NamedValue& target) {
    if (target.node.kind() == TomlKind::string && !target.node.text().empty())
        expect_file_name(reading, target, Files::below_folder);
    for (std::size_t i = 0; target.node.kind() == TomlKind::array && i < target.node.size(); ++i)
        check_exit(reading, {target.name, target.node.at(i)});
}

constexpr std::array kTriggerKeys{
    key<&TriggerRecord::on>("on", kNew, Need::required),
    key<&TriggerRecord::action>("do", kNew, Need::required),
    Key<TriggerRecord>{"target", kNew, Need::optional, {}, read_targets, write_targets},
    key<&TriggerRecord::once>("once", kNew),
    key<&TriggerRecord::one_way>("one_way", kNew),
    key<&TriggerRecord::key>("key", kNew),
    key<&TriggerRecord::after>("after", kNew, Need::optional, kSeconds),
    key<&TriggerRecord::z>("z", kNew, Need::optional, kHeights),
    key<&TriggerRecord::to>("to", kNew),
    key<&TriggerRecord::like>("like", kNew),
    key<&TriggerRecord::by>("by", kNew, Need::optional, kHeights),
    key<&TriggerRecord::speed>("speed", kNew, Need::optional, kSpeeds),
    key<&TriggerRecord::wait>("wait", kNew, Need::optional, kSeconds),
    key<&TriggerRecord::step>("step", kNew, Need::optional, kStairs),
    key<&TriggerRecord::reverses>("reverses", kNew),
    key<&TriggerRecord::crushes>("crushes", kNew),
    key<&TriggerRecord::crush_speed>("crush_speed", kNew, Need::optional, kSpeeds),
    file_key<&TriggerRecord::texture>("texture", kNew),
    key<&TriggerRecord::heals>("heals", kNew),
    key<&TriggerRecord::light>("light", kNew, Need::optional, kLight),
    key<&TriggerRecord::light_of>("light_of", kNew),
    key<&TriggerRecord::effect>("effect", kNew),
    key<&TriggerRecord::sound>("sound", kNew),
};

constexpr std::array kLightEffectKeys{
    key<&LightEffectRecord::kind>("kind", kNew, Need::required),
    key<&LightEffectRecord::dark>("dark", kNew, Need::optional, kLight),
    key<&LightEffectRecord::dark_s>("dark_s", kNew, Need::optional, kPictureSeconds),
    key<&LightEffectRecord::bright_s>("bright_s", kNew, Need::optional, kPictureSeconds),
    key<&LightEffectRecord::in_step>("in_step", kNew),
    key<&LightEffectRecord::lasts>("lasts", kNew),
    key<&LightEffectRecord::step>("step", kNew, Need::optional, kLight),
    key<&LightEffectRecord::clock_hz>("clock_hz", kNew, Need::optional, kClocks),
};

constexpr std::array kBobKeys{
    key<&BobRecord::amplitude>("amplitude", kNew, Need::required, kAmplitudes),
    key<&BobRecord::period>("period", kNew, Need::optional, kPeriods),
    key<&BobRecord::phase>("phase", kNew, Need::optional, kPhases),
    key<&BobRecord::shape>("shape", kNew),
};

constexpr std::array kAnimationKeys{
    file_key<&AnimationRecord::frames>("frames", kNew, Need::required),
    key<&AnimationRecord::seconds>("seconds", kNew, Need::optional, kPictureSeconds),
};

constexpr std::array kSwitchKeys{
    file_key<&SwitchRecord::off>("off", kNew, Need::required),
    file_key<&SwitchRecord::on>("on", kNew, Need::required),
};

constexpr std::array kSoundKeys{
    key<&SoundRecord::name>("name", kNew, Need::required),
    file_key<&SoundRecord::file>("file", kNew, Need::required),
    key<&SoundRecord::volume>("volume", kNew, Need::optional, {0, 1}),
    key<&SoundRecord::reach>("reach", kNew, Need::optional, kSoundReaches),
    key<&SoundRecord::loops>("loops", kNew),
};

constexpr KeyList<TriggerRecord> kTriggerList{"a trigger", kTriggerKeys};
constexpr KeyList<LightEffectRecord> kLightEffectList{"a light effect", kLightEffectKeys};
constexpr KeyList<BobRecord> kBobList{"'bob'", kBobKeys};
constexpr KeyList<AnimationRecord> kAnimationList{"an animation", kAnimationKeys};
constexpr KeyList<SwitchRecord> kSwitchList{"a switch", kSwitchKeys};
constexpr KeyList<SoundRecord> kSoundList{"a sound", kSoundKeys};

}  // namespace

template <>
const KeyList<TriggerRecord>& keys_of() {
    return kTriggerList;
}

template <>
const KeyList<LightEffectRecord>& keys_of() {
    return kLightEffectList;
}

template <>
const KeyList<BobRecord>& keys_of() {
    return kBobList;
}

template <>
const KeyList<AnimationRecord>& keys_of() {
    return kAnimationList;
}

template <>
const KeyList<SwitchRecord>& keys_of() {
    return kSwitchList;
}

template <>
const KeyList<SoundRecord>& keys_of() {
    return kSoundList;
}

template <>
void check_record(Reading& reading, TomlNode, std::span<const TomlEntry> entries, TriggerRecord& trigger) {
    const TomlEntry* target = find_entry(entries, "target");
    if (target && trigger.action == TriggerAction::leave_map) check_exit(reading, {target->key, target->value});
    refuse_both(reading, entries, "z", "to", "two-heights");
    refuse_both(reading, entries, "z", "like", "two-heights");
    refuse_both(reading, entries, "to", "like", "two-heights");
    refuse_both(reading, entries, "light", "light_of", "two-lights");
}

template <>
void check_record(Reading& reading, TomlNode table, std::span<const TomlEntry>, AnimationRecord& animation) {
    if (animation.frames.empty()) missing_key(reading, table.place(), "an animation", "frames");
}

}  // namespace enfilade
