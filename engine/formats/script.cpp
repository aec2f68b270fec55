#include "formats/script.h"

#include <array>

#include "formats/map_keys.h"

namespace enfilade {

template <>
const KeyList<StartRecord>& keys_of();
template <>
const KeyList<LegRecord>& keys_of();
template <>
const KeyList<Dials>& keys_of();
template <>
const KeyList<ScriptFile>& keys_of();
template <>
void check_record(Reading&, TomlNode, std::span<const TomlEntry>, StartRecord&);
template <>
void check_record(Reading&, TomlNode, std::span<const TomlEntry>, LegRecord&);
template <>
void check_record(Reading&, TomlNode, std::span<const TomlEntry>, ScriptFile&);

namespace {

// Scripts have one dialect only.
constexpr auto kAlways = Dialect::tutorial;

constexpr Range kLegSeconds{0, kMaxLegSeconds};

/// More values than a script of kMaxScriptBytes that is written by hand could hold.
constexpr std::size_t kMaxScriptValues = std::size_t{1} << 18;

constexpr std::array kStartKeys{
    key<&StartRecord::sector>("sector", kAlways),
    key<&StartRecord::x>("x", kAlways, Need::optional, kPositions),
    key<&StartRecord::y>("y", kAlways, Need::optional, kPositions),
    key<&StartRecord::z>("z", kAlways, Need::optional, kHeights),
    key<&StartRecord::yaw_degrees>("yaw", kAlways, Need::optional, kAngles),
    key<&StartRecord::pitch_degrees>("pitch", kAlways, Need::optional, kPitches),
};

/// "to = [x, y]" or "to = [x, y, z]".
void read_target(Reading& reading, const NamedValue& value, Range range, LegRecord& leg) {
    const bool is_array = value.node.kind() == TomlKind::array;
    const std::size_t size = is_array ? value.node.size() : 0;
    if (size != 2 && size != 3) return wrong_type(reading, value, "an array of two or three numbers, x, y, z");
    Vec2& to = leg.to.emplace();
    read_value(reading, {value.name, value.node.at(0)}, range, to.x);
    read_value(reading, {value.name, value.node.at(1)}, range, to.y);
    if (size == 3) read_value(reading, {value.name, value.node.at(2)}, kHeights, leg.to_z);
}

void read_point(Reading& reading, const NamedValue& value, Range range, LegRecord& leg) {
    read_value(reading, value, range, leg.look_at.emplace());
}

constexpr std::array kLegKeys{
    key<&LegRecord::seconds>("seconds", kAlways, Need::optional, kLegSeconds),
    key<&LegRecord::seconds>("wait", kAlways, Need::optional, kLegSeconds),
    Key<LegRecord>{"to", kAlways, Need::optional, kPositions, read_target},
    key<&LegRecord::look_degrees>("look", kAlways, Need::optional, kAngles),
    key<&LegRecord::turn_degrees>("turn", kAlways, Need::optional, {-36000, 36000}),
    Key<LegRecord>{"look_at", kAlways, Need::optional, kPositions, read_point},
    key<&LegRecord::pitch_degrees>("pitch", kAlways, Need::optional, kPitches),
    key<&LegRecord::press>("press", kAlways),
    key<&LegRecord::ease>("ease", kAlways),
};

/// "size = [width, height]".
void read_size(Reading& reading, const NamedValue& value, Range range, ScriptFile& script) {
    if (value.node.kind() != TomlKind::array || value.node.size() != 2)
        return wrong_type(reading, value, "an array of two whole numbers, width and height");
    read_value(reading, {value.name, value.node.at(0)}, range, script.width);
    read_value(reading, {value.name, value.node.at(1)}, range, script.height);
}

void read_samples(Reading& reading, const NamedValue& value, Range range, ScriptFile& script) {
    read_value(reading, value, range, script.dials.samples);
}

/// A number, or a word for one.
void read_accuracy(Reading& reading, const NamedValue& value, Range range, ScriptFile& script) {
    if (value.node.kind() != TomlKind::string) return read_value(reading, value, range, script.dials.texel_error);
    if (const Result<void> valid = set_accuracy(script.dials, value.node.text()); !valid.ok())
        reading.error(value.node.place(), "unknown-word", "'accuracy': " + valid.error().what);
}

/// A file's path, whose place is kept so that a message can point at it.
template <auto path, auto place>
constexpr Key<ScriptFile> path_key(std::string_view name, Need need) {
    auto with_place = file_key<path, Files::anywhere>(name, kAlways, need);
    with_place.read = [](Reading& reading, const NamedValue& value, Range, ScriptFile& script) {
        script.*place = value.node.place();
        read_file_name(reading, value, Files::anywhere, script.*path);
    };
    return with_place;
}

constexpr std::array kDialKeys{
    key<&Dials::span>("span", kAlways, Need::optional, {1, kMostSpan}),
    key<&Dials::number>("number", kAlways),
    key<&Dials::sampling>("sampling", kAlways),
    key<&Dials::light>("light", kAlways),
    key<&Dials::fog>("fog", kAlways),
    key<&Dials::light_grid>("light_grid", kAlways, Need::optional, {1, kMostLightPoints}),
    key<&Dials::portals>("portals", kAlways),
    key<&Dials::links>("links", kAlways, Need::optional, {0, kMostLinks}),
};

constexpr std::array kScriptKeys{
    path_key<&ScriptFile::map, &ScriptFile::map_place>("map", Need::required),
    Key<ScriptFile>{"size", kAlways, Need::optional, {1, kMaxPictureSide}, read_size},
    key<&ScriptFile::rate>("rate", kAlways, Need::optional, {1, kMaxFrameRate}),
    key<&ScriptFile::renderer>("renderer", kAlways),
    key<&ScriptFile::fov_degrees>("fov", kAlways, Need::optional, {1, 179}),
    Key<ScriptFile>{"samples", kAlways, Need::optional, {1, kMostSamples}, read_samples},
    Key<ScriptFile>{"accuracy", kAlways, Need::optional, {0, kMostTexelError}, read_accuracy},
    key<&ScriptFile::dials>("dials", kAlways),
    path_key<&ScriptFile::tape, &ScriptFile::tape_place>("tape", Need::optional),
    key<&ScriptFile::start>("start", kAlways),
    key<&ScriptFile::legs>("legs", kAlways),
};

constexpr KeyList<StartRecord> kStartList{"'start'", kStartKeys};
constexpr KeyList<LegRecord> kLegList{"a leg", kLegKeys};
constexpr KeyList<Dials> kDialList{"'dials'", kDialKeys};
constexpr KeyList<ScriptFile> kScriptList{"a script", kScriptKeys};

/// `wait` is a leg of its own: nothing moves in it.
void check_wait(Reading& reading, std::span<const TomlEntry> entries) {
    const TomlEntry* wait = find_entry(entries, "wait");
    if (!wait) return;
    for (std::string_view other : {"seconds", "to", "look", "turn", "look_at", "pitch"})
        if (find_entry(entries, other))
            reading.error(wait->key_place, "wait-and-move",
                          "a leg with 'wait' stands still; give " + in_quotes(other) + " in a leg of its own");
}

void check_length(Reading& reading, const ScriptFile& script) {
    double seconds = 0;
    for (const LegRecord& leg : script.legs) {
        seconds += leg.seconds;
        if (seconds <= kMaxScriptSeconds) continue;
        reading.error(leg.place, "too-long", "all legs together may take a day at most; they are longer from here on");
        return;
    }
}

}  // namespace

template <>
const KeyList<StartRecord>& keys_of() {
    return kStartList;
}

template <>
const KeyList<LegRecord>& keys_of() {
    return kLegList;
}

template <>
const KeyList<Dials>& keys_of() {
    return kDialList;
}

template <>
const KeyList<ScriptFile>& keys_of() {
    return kScriptList;
}

template <>
void check_record(Reading& reading, TomlNode table, std::span<const TomlEntry> entries, StartRecord&) {
    if (!find_entry(entries, "x") != !find_entry(entries, "y"))
        missing_key(reading, table.place(), "'start'", find_entry(entries, "x") ? "y" : "x");
}

template <>
void check_record(Reading& reading, TomlNode table, std::span<const TomlEntry> entries, LegRecord&) {
    check_wait(reading, entries);
    refuse_both(reading, entries, "look", "turn", "given-twice");
    refuse_both(reading, entries, "look", "look_at", "given-twice");
    refuse_both(reading, entries, "turn", "look_at", "given-twice");
    const bool only_presses = entries.size() == 1 && find_entry(entries, "press");
    if (!find_entry(entries, "seconds") && !find_entry(entries, "wait") && !only_presses)
        missing_key(reading, table.place(), "a leg", "seconds");
}

template <>
void check_record(Reading& reading, TomlNode, std::span<const TomlEntry> entries, ScriptFile& script) {
    const TomlEntry* tape = find_entry(entries, "tape");
    const TomlEntry* legs = find_entry(entries, "legs");
    if (!tape && script.legs.empty()) missing_key(reading, legs ? legs->key_place : TextPlace{}, "a script", "legs");
    for (std::string_view other : {"start", "legs"})
        if (const TomlEntry* entry = find_entry(entries, other); entry && tape)
            reading.error(entry->key_place, "tape-and-legs",
                          "a tape says where the camera goes; 'tape' and " + in_quotes(other) + " exclude each other");
    check_length(reading, script);
}

std::vector<KeyInfo> script_keys() {
    std::vector<KeyInfo> all;
    add_key_infos<ScriptFile>(all, "");
    add_key_infos<StartRecord>(all, "start.");
    add_key_infos<LegRecord>(all, "legs.");
    add_key_infos<Dials>(all, "dials.");
    return all;
}

bool is_script(std::string_view text) {
    if (text.size() > kMaxScriptBytes) return false;
    Findings ignored;
    const auto document = TomlDocument::parse(text, {kMaxScriptBytes, kMaxScriptValues}, ignored);
    return document && document->root().find("map").kind() == TomlKind::string;
}

ScriptReading read_script(std::string_view text) {
    ScriptReading result;
    const auto document = TomlDocument::parse(text, {kMaxScriptBytes, kMaxScriptValues}, result.findings);
    if (!document) return result;
    Reading reading{result.findings, kAlways};
    read_record(reading, document->root(), result.script);
    sort_by_place(result.findings);
    return result;
}

}  // namespace enfilade
