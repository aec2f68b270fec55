// What the lists of a map's keys share: ranges, checks, and the list of lists.
#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "formats/key.h"
#include "formats/map_file.h"
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

/// Speeds of pictures that move [m/s]: faster ones only flicker.
inline constexpr Range kScrollSpeeds{-1024, 1024};

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
