// Doom's WAD archives: a file with a directory of named lumps, and a pile of such files where the upper ones win.
// Source: Matthew S. Fell, "The Unofficial Doom Specs" (1994), §2.
#pragma once
#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/files.h"
#include "base/result.h"

namespace enfilade::wadconv {

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

}  // namespace enfilade::wadconv
