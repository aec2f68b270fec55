// Patches: Doom's pictures in columns of posts, from which sprites and wall textures are made.
// Source: Matthew S. Fell, "The Unofficial Doom Specs" (1994), §5.1.
#pragma once
#include <cstdint>
#include <span>

#include "base/result.h"
#include "wadconv/picture.h"

namespace enfilade::wadconv {

/// The first eight bytes of a patch.
struct PatchHeader {
    std::uint32_t width = 0, height = 0;  ///< 1..kMaxPictureSide [texels]
    /// The texel that sits at a sprite's position, from the picture's top left [texels].
    std::int32_t left = 0, top = 0;
};

/// An Error where the sizes are out of range or the columns' table does not fit the lump.
Result<PatchHeader> read_patch_header(std::span<const std::byte> lump);

/// The whole picture; what no post covers is a hole. A post that begins not below the one before it counts from that
/// one
/// ("tall patches", for pictures of more than 254 rows); texels below the picture are left out.
/// An Error names the column whose posts lead out of the lump or never end. Cost: the texels.
Result<Picture> read_patch(std::span<const std::byte> lump);

}  // namespace enfilade::wadconv
