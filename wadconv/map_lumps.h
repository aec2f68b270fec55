// The maps in a pile of WADs: finding them, what they hold, and which comes next.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "wadconv/wad.h"

namespace enfilade::wadconv {

// What a Doom map's lumps hold, record by record and field by field, as on disk; nothing is checked against anything.
// Source: Matthew S. Fell, "The Unofficial Doom Specs" (1994), §4.

/// 32 map units of Doom are a metre: exact in binary, and on the vertex grid.
inline constexpr double kUnitsPerMetre = 32;

/// "No such side" in a linedef.
inline constexpr std::uint16_t kNoSide = 0xFFFF;

/// Bits of a linedef's flags that decide how it looks.
inline constexpr std::uint16_t kBlocking = 0x0001, kTwoSided = 0x0004, kUpperUnpegged = 0x0008, kLowerUnpegged = 0x0010;

/// Bits of a thing's flags: for which skills it stands (1 and 2, 3, 4 and 5), and that it does so in company only.
inline constexpr std::uint16_t kEasy = 0x0001, kMedium = 0x0002, kHard = 0x0004, kMultiplayer = 0x0010;

struct Vertex {
    std::int16_t x, y;  ///< [map units], y UP
};

struct Linedef {
    std::uint16_t start, end;  ///< vertex numbers
    std::uint16_t flags, special, tag;
    std::uint16_t right, left;  ///< side numbers, or kNoSide
};

struct Sidedef {
    std::int16_t x_offset, y_offset;   ///< [texels]
    std::string upper, lower, middle;  ///< texture names; "-" is none
    std::uint16_t sector;
};

struct DoomSector {
    std::int16_t floor, ceiling;  ///< [map units]
    std::string floor_flat, ceiling_flat;
    std::int16_t light;  ///< 0..255 in honest maps
    std::uint16_t special, tag;
};

struct DoomThing {
    std::int16_t x, y;    ///< [map units], y UP
    std::uint16_t angle;  ///< [degrees], 0 east, 90 north
    std::uint16_t type, flags;
};

struct DoomMap {
    std::string name;  ///< "E1M1", "MAP01"
    std::vector<Vertex> vertices;
    std::vector<Linedef> lines;
    std::vector<Sidedef> sides;
    std::vector<DoomSector> sectors;
    std::vector<DoomThing> things;
    std::size_t trailing_bytes = 0;  ///< left over in lumps that are no whole number of records long
};

/// The bytes of the five lumps a map is read from.
struct MapLumps {
    std::string name;
    std::span<const std::byte> things, lines, sides, vertices, sectors;
};

/// Most records of a kind: the format's own numbers have 16 bits. Records beyond are an Error.
inline constexpr std::size_t kMaxRecords = 65536;

Result<DoomMap> decode_map(const MapLumps& lumps);

/// True for "E1M1" … "E9M9" and "MAP00" … "MAP99".
bool is_map_name(std::string_view name);

/// The names of all maps in the pile: in the order of their first appearance, each once.
std::vector<std::string> map_names(const WadPile& pile);

/// The lumps of a map, from the last archive that has it. An Error where there is none of that name, where a lump is
/// missing, and where the map is in Hexen's format or in UDMF, which are told by their lumps BEHAVIOR and TEXTMAP.
Result<MapLumps> find_map(const WadPile& pile, std::string_view name);

// Which level comes after which.

/// The level that a level's exit leads to, in Doom's order; empty behind the last of an episode or of the game.
/// `map`: "E1M1" or "MAP01" (is_map_name).
std::string next_map(std::string_view map, bool by_secret_exit);

// What lies around Doom's sectors, line by line: what its actions look at when they look around.

/// A line of a sector with another sector, or the same, on its other side.
struct Neighbour {
    std::uint32_t line;
    std::uint32_t sector;
    bool is_front;  ///< the sector that is asked about is in front of the line, on its right
};

/// Lines marked two-sided with two sides and sectors that exist; of the others nothing is known.
class Neighbours {
public:
    /// Cost: the lines.
    explicit Neighbours(const DoomMap& doom);

    /// In the order of the lines; a line with the sector on both sides is there twice.
    std::span<const Neighbour> of(std::uint32_t sector) const;

    /// The darkest light around, not brighter than its own [0..255].
    std::int16_t darkest(std::uint32_t sector) const;

    /// The lowest floor, not higher than its own [map units].
    std::int16_t lowest_floor(std::uint32_t sector) const;

private:
    const DoomMap& doom_;
    std::vector<Neighbour> all_;
    std::vector<std::uint32_t> first_;  ///< those of sector s are all_[first_[s]] to all_[first_[s + 1]]
};

}  // namespace enfilade::wadconv
