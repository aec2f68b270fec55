// Of a WAD's textures: what they are put together from, and which of them follow one another.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"
#include "formats/effect_records.h"
#include "wadconv/picture.h"
#include "wadconv/wad.h"

namespace enfilade::wadconv {

// TEXTURE1, TEXTURE2 and PNAMES: how wall textures are composed of patches.
// Source: Matthew S. Fell, "The Unofficial Doom Specs" (1994), §8.4.

struct PatchUse {
    std::string patch;          ///< the lump's name
    std::int32_t x = 0, y = 0;  ///< where its top left goes [texels]
};

struct TextureDef {
    std::string name;
    std::uint32_t width = 0, height = 0;  ///< 1..kMaxPictureSide [texels]
    std::vector<PatchUse> patches;        ///< drawn in this order
};

/// All textures of TEXTURE1 and then TEXTURE2, in the file's order; of textures of one name the first counts, as in
/// Doom. The very first is Doom's "no texture". A pile without TEXTURE1 has none.
Result<std::vector<TextureDef>> read_texture_defs(const WadPile& pile);

/// The finished picture. Columns that a single patch covers hang from row 0 at the highest, and where several patches
/// cover a column a patch that begins above row 0 is moved down instead of cut: both as in Doom (id Software,
/// r_data.c, 1993), so that FreeDoom's textures look as they do there. What no patch covers is a hole.
/// An Error names the patch that is missing or broken.
Result<Picture> compose(const TextureDef& def, const WadPile& pile);

/// About how many texels compose() will touch; a missing patch counts nothing.
std::uint64_t composing_cost(const TextureDef& def, const WadPile& pile);

// Pictures that change: which walls and flats follow one another, and which are the two faces of a switch.
// Source: the lists of Matthew S. Fell, "The Unofficial Doom Specs" (1994), §8.4.1 and §4.3.3; lumps ANIMATED and
// SWITCHES as the Boom reference (1998) describes them.

/// A wall texture or flat: its name in the WAD, and its picture's in the map.
struct NamedPicture {
    std::string lump, picture;
};

/// All walls and all flats, each in an order in which animations run from one to another.
struct PictureOrder {
    std::vector<NamedPicture> walls, flats;
};

/// The pile's animations, of those pictures it has: from ANIMATED, else Doom's own. No picture is in two of them.
/// A lump that breaks off, or names what is not there, gives what it can.
std::vector<AnimationRecord> list_animations(const WadPile& pile, const PictureOrder& order);

/// The pile's switches: from SWITCHES, else every wall SW1… that has a SW2….
std::vector<SwitchRecord> list_switches(const WadPile& pile, const PictureOrder& order);

}  // namespace enfilade::wadconv
