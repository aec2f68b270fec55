// Doom's WAD archives, and the maps in them.
#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/files.h"
#include "base/result.h"

namespace enfilade::wadconv {

// Doom's WAD archives: a file with a directory of named lumps, and a pile of such files where the upper ones win.
// Source: Matthew S. Fell, "The Unofficial Doom Specs" (1994), §2.

/// A name and the bytes it stands for. Bytes belong to the Wad and live as long as it does.
struct Lump {
    std::string name;  ///< upper case, at most 8 characters; what is not printable reads as '?'
    std::span<const std::byte> bytes;
};

/// The bytes of an eight-character name field, up to its first zero, as a lump name.
std::string lump_name(std::span<const std::byte> field);

/// Most lumps an archive may have. FreeDoom has 3655, the largest known megawads some ten thousand.
inline constexpr std::size_t kMaxLumps = 131072;

/// One archive. Moves, but does not copy: its lumps look into its bytes.
class Wad {
public:
    /// Every lump lies inside the file, or there is an Error that names the lump. Lumps may overlap: archives that
    /// share equal lumps are legal. Cost: the directory; lumps are not looked into.
    static Result<Wad> read(std::string file, Bytes bytes);

    Wad(Wad&&) = default;
    Wad& operator=(Wad&&) = default;

    const std::string& file() const { return file_; }
    const std::vector<Lump>& lumps() const { return lumps_; }

private:
    Wad(std::string file, Bytes bytes) : file_(std::move(file)), bytes_(std::move(bytes)) {}

    std::string file_;
    Bytes bytes_;
    std::vector<Lump> lumps_;  ///< in the order of the directory
};

/// An IWAD with any number of PWADs on top. Of lumps with the same name the last one counts, as in Doom.
class WadPile {
public:
    using Names = std::map<std::string_view, const Lump*>;

    explicit WadPile(std::vector<Wad> wads);

    const std::vector<Wad>& wads() const { return wads_; }

    /// The lump of that name outside the flats' and sprites' sections, else the sprite (some textures are composed of
    /// sprites), else null. Names are upper case.
    const Lump* find(std::string_view name) const;

    /// The lumps between F_START and F_END, and between S_START and S_END (also FF_ and SS_), sorted by name.
    const Names& flats() const { return flats_; }
    const Names& sprites() const { return sprites_; }

private:
    std::vector<Wad> wads_;
    Names lumps_, flats_, sprites_;
};

// The maps in a pile of WADs: finding them, what they hold, and which comes next.

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

    /// A side as a line names it; null where there is none of that number, or its sector is not there: numbers in a WAD
    /// lead anywhere.
    const Sidedef* side_of(std::uint16_t number) const {
        return number < sides.size() && sides[number].sector < sectors.size() ? &sides[number] : nullptr;
    }
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
