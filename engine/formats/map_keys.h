// What the lists of a map's keys share: ranges, checks, texts that mean more than they say (colours, names of files,
// textures), and the list of lists.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "formats/key.h"
#include "formats/map_file.h"
#include "formats/text_parts.h"
#include "math/vec.h"

namespace enfilade {

/// Vertices are rounded to the grid before they are checked; half a step beyond the limit still rounds to it [m].
inline constexpr Range kVertices{-kWorldLimit - kVertexGrid / 2, kWorldLimit + kVertexGrid / 2};

/// Positions in the plane [m].
inline constexpr Range kPositions{-kWorldLimit, kWorldLimit};

/// Heights, absolute and differences: as far as the world reaches sideways [m].
inline constexpr Range kHeights{-kWorldLimit, kWorldLimit};

/// Sizes of pictures, in their own pixels [texels per metre]; see kMinTile.
inline constexpr Range kTexelsPerMetre{0x1p-16, 0x1p16};

/// Angles: enough turns for anybody, few enough to stay exact [degrees or radians].
inline constexpr Range kAngles{-0x1p30, 0x1p30};

/// How far up and down a camera can look, short of straight up [degrees].
inline constexpr Range kPitches{-89, 89};

inline constexpr Range kLight{0, 1};

/// Colours, 0xRRGGBB.
inline constexpr Range kColors{0, 0xFFFFFF};

/// Speeds of pictures that move [m/s], and of layers that turn over a sky [degrees/s]: faster ones only flicker.
inline constexpr Range kScrollSpeeds{-1024, 1024};

/// Times in the world: a day at most [s].
inline constexpr Range kSeconds{0, 86400};

/// Slow enough to be seen to move, fast enough to look instant [m/s].
inline constexpr Range kSpeeds{0x1p-6, 1024};

/// Heights of stairs, up and down [m].
inline constexpr Range kStairs{-64, 64};

/// A picture of an animation must stay for a moment [s].
inline constexpr Range kPictureSeconds{0x1p-6, 86400};

/// How often lights may change [1/s]: slower ones have longer times, faster ones nobody sees.
inline constexpr Range kClocks{1, 240};

/// How far a sound may reach [m]; the ways to all it reaches are looked at.
inline constexpr Range kSoundReaches{0x1p-4, 1024};

/// What bobs less than a step of the vertex grid does not seem to [m].
inline constexpr Range kAmplitudes{0x1p-10, 1024};

/// A period is some ticks at least, else it is not the same from all sides; and a day at most [s].
inline constexpr Range kPeriods{0.125, 86400};

/// How much of a period is over at the start [1].
inline constexpr Range kPhases{0, 1};

/// Origins of sprites may lie outside the picture, but not further than the largest picture is wide [texels].
inline constexpr Range kOrigins{-0x1p14, 0x1p14};

/// Faster than twenty times round in a second nobody sees it turn [degrees/s].
inline constexpr Range kTurnSpeeds{-7200, 7200};

/// A thing's radius and height [m].
inline constexpr Range kThingSizes{0, 1024};

/// How far a light may reach [m]: all surfaces it reaches hold a few thousand numbers each.
inline constexpr Range kLightReaches{0x1p-4, 64};

/// Twice as bright as painted is as bright as anything gets.
inline constexpr Range kBrightnesses{0, 2};

/// What floors cost in a second and things give [points of health].
inline constexpr Range kHealth{0, 1000};

/// How far pictures are stretched upwards [1].
inline constexpr Range kStretches{0.125, 8};

/// Links followed in one chain [1].
inline constexpr Range kDepths{0, 1024};

/// Where fog hides half of everything; 0: there is none [m].
inline constexpr Range kFogReaches{0, kWorldLimit};

/// Pictures over one sky: each is a pass over its pixels, and more than a few hide one another.
inline constexpr std::size_t kMostFlatLayers = 4;

/// The member of that name, or null.
const TomlEntry* find_entry(std::span<const TomlEntry> entries, std::string_view key);

/// Notes missing-key: "RECORD needs 'KEY', found none".
void missing_key(Reading& reading, TextPlace place, std::string_view record, std::string_view key);

/// Notes an error at the later of two keys that must not both be given.
void refuse_both(Reading& reading, std::span<const TomlEntry> entries, std::string_view one, std::string_view other,
                 std::string_view code);

/// Notes tile-and-size if the specification says metres per tile: `size` was given as well.
void refuse_tile_and_size(Reading& reading, const TextureSpec& spec);

/// "[x0, y0,  x1, y1, …]", broken into lines where it gets long.
std::string vertices_text(std::span<const Vec2> vertices);

// Keys for colours: "#rrggbb", or the number 0xrrggbb.

/// The colour as 0xRRGGBB, or none and bad-color is noted.
std::optional<std::uint32_t> read_color(Reading& reading, const NamedValue& value);

/// "#rrggbb"
std::string color_text(std::uint32_t color);

/// A key for a field that is a colour.
template <auto member>
constexpr auto color_key(std::string_view name, Dialect since) {
    using Record = typename MemberPointer<decltype(member)>::Record;
    return Key<Record>{name,
                       since,
                       Need::optional,
                       {},
                       [](Reading& reading, const NamedValue& value, Range, Record& record) {
                           if (const auto color = read_color(reading, value)) record.*member = *color;
                       },
                       [](TableText& table, const Key<Record>& key, const Record& record, const Record& defaults) {
                           if (record.*member != defaults.*member)
                               table.add(key.name, string_text(color_text(record.*member)));
                       }};
}

// Keys for names of files. A key that names a file is one of these, and a test asks so of every key with a string.

// Which texts of a hostile file may become names of other files.

/// Nothing where the text names a file below a folder: parts with a single '/' between them, none of them "." or "..",
/// and no character that a terminal would obey (base/text.h). So a file has one name only, apart from upper and
/// lower case, and no name leads elsewhere. Otherwise what was expected, without a place.
Result<void> refuse_as_file_name(std::string_view text);

/// Nothing where the text is a path that may lead anywhere: no character that a terminal would obey. For what people
/// set up by hand, as the folder of their pictures.
Result<void> refuse_as_path(std::string_view text);

/// Whether a string's value may name a file, by the rules above; if not, bad-file-name is noted at it.
/// files : below_folder or anywhere
bool expect_file_name(Reading& reading, const NamedValue& value, Files files);

/// Reads the name of a file, or notes what is wrong with it and leaves the field as it is.
void read_file_name(Reading& reading, const NamedValue& value, Files files, std::string& field);
void read_file_name(Reading& reading, const NamedValue& value, Files files, std::vector<std::string>& field);

/// A key for a field that is the name of a file, or several.
template <auto member, Files files = Files::below_folder>
constexpr auto file_key(std::string_view name, Dialect since, Need need = Need::optional) {
    auto checked = key<member>(name, since, need);
    checked.files = files;
    checked.read = [](Reading& reading, const NamedValue& value, Range, auto& record) {
        read_file_name(reading, value, files, record.*member);
    };
    return checked;
}

// The texture specification of a map, "NAME [SU,SV [OU,OV] [OUm,OVm]]", as text and as numbers.

/// Smallest and largest size of a tile that is read, whatever its sign [metres per tile]: between them texel
/// coordinates stay exact enough to count single texels anywhere in the world.
inline constexpr double kMinTile = 0x1p-16, kMaxTile = 0x1p16;

/// Largest offset that is read [texels, metres]: more than the largest picture has, or the world.
inline constexpr double kMaxTextureOffset = 0x1p20;

/// The numbers a specification stands for, without a place, or what is wrong with it. A half-given pair is an error;
/// negative tiles mirror the picture. "NAME - OU,OV" gives an offset alone: the tile is then 1, 1 or set by `size`. An
/// offset in metres has the letter at both numbers: "NAME 3,3 -1.5m,0m" goes on where 1.5 m of the picture were shown.
/// A name is a file's name, perhaps in a folder below, never "..".
Result<TextureSpec> parse_texture_spec(std::string_view text);

/// The shortest specification that reads back as the same numbers.
std::string to_text(const TextureSpec& spec);

// Each kind of record has its list in the file named after it.
template <>
const KeyList<WallRecord>& keys_of();
template <>
const KeyList<LoopRecord>& keys_of();
template <>
const KeyList<FlatRecord>& keys_of();
template <>
const KeyList<FlatLayerRecord>& keys_of();
template <>
const KeyList<PanelRecord>& keys_of();
template <>
const KeyList<SectorRecord>& keys_of();
template <>
const KeyList<PolygonRecord>& keys_of();
template <>
const KeyList<OpeningRecord>& keys_of();
template <>
const KeyList<PrefabRecord>& keys_of();
template <>
const KeyList<DoomRecord>& keys_of();
template <>
const KeyList<SpriteFrameRecord>& keys_of();
template <>
const KeyList<ThingRecord>& keys_of();
template <>
const KeyList<PointLightRecord>& keys_of();
template <>
const KeyList<SunRecord>& keys_of();
template <>
const KeyList<PlayerRecord>& keys_of();
template <>
const KeyList<RenderRecord>& keys_of();
template <>
const KeyList<MapFile>& keys_of();
template <>
const KeyList<TriggerRecord>& keys_of();
template <>
const KeyList<LightEffectRecord>& keys_of();
template <>
const KeyList<BobRecord>& keys_of();
template <>
const KeyList<AnimationRecord>& keys_of();
template <>
const KeyList<SwitchRecord>& keys_of();
template <>
const KeyList<SoundRecord>& keys_of();

template <>
void check_record(Reading&, TomlNode, std::span<const TomlEntry>, WallRecord&);
template <>
void check_record(Reading&, TomlNode, std::span<const TomlEntry>, OpeningRecord&);
template <>
void check_record(Reading&, TomlNode, std::span<const TomlEntry>, FlatRecord&);
template <>
void check_record(Reading&, TomlNode, std::span<const TomlEntry>, PanelRecord&);
template <>
void check_record(Reading&, TomlNode, std::span<const TomlEntry>, ThingRecord&);
template <>
void check_record(Reading&, TomlNode, std::span<const TomlEntry>, PlayerRecord&);

template <>
void check_record(Reading&, TomlNode, std::span<const TomlEntry>, TriggerRecord&);
template <>
void check_record(Reading&, TomlNode, std::span<const TomlEntry>, AnimationRecord&);

/// Every key of a map file, in the order of the lists.
std::vector<KeyInfo> map_keys();

}  // namespace enfilade
