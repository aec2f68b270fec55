// Doom's pictures: the palette's colours and holes.
#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "base/files.h"
#include "base/result.h"
#include "formats/png.h"
#include "wadconv/wad.h"

namespace enfilade::wadconv {

/// A texel through which one sees what lies behind.
inline constexpr std::int16_t kHole = -1;

/// Palette numbers by row, top row first.
struct Picture {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<std::int16_t> texels;  ///< width * height, 0..255 or kHole

    Picture() = default;
    Picture(std::uint32_t w, std::uint32_t h) : width(w), height(h), texels(std::size_t{w} * h, kHole) {}

    std::int16_t& at(std::uint32_t x, std::uint32_t y) { return texels[std::size_t{y} * width + x]; }
    std::int16_t at(std::uint32_t x, std::uint32_t y) const { return texels[std::size_t{y} * width + x]; }
};

/// Largest width and height of a picture [texels]. The widest in use are skies of 1024.
inline constexpr std::uint32_t kMaxPictureSide = 4096;

/// The 256 colours 0xAABBGGRR of PLAYPAL's first palette.
using Palette = std::array<std::uint32_t, 256>;

/// Colours from the first 768 bytes of PLAYPAL; fewer are an Error.
Result<Palette> read_palette(std::span<const std::byte> playpal);

/// Brightness that COLORMAP's 32 light levels leave on average, full light first: the mean over the palette's colours
/// of level's sum of channels / full sum. Fewer than 32 maps of 256 bytes are an Error.
Result<std::array<double, 32>> measure_colormap(std::span<const std::byte> colormap, const Palette& palette);

/// COLORMAP as the picture that map/textures.h wants: the palette's colours, and below them its 32 light levels.
/// Fewer than 32 maps of 256 bytes are an Error.
Result<Picture> color_table_picture(std::span<const std::byte> colormap);

/// Mirrored left to right.
Picture mirrored(const Picture& picture);

/// As PNG; equal pictures give equal bytes.
Bytes to_png(const Picture& picture, const Palette& palette);

// Patches: Doom's pictures in columns of posts, from which sprites and wall textures are made.
// Source: Matthew S. Fell, "The Unofficial Doom Specs" (1994), §5.1.

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

// Sprites: which lumps make up each frame, seen from one or from eight directions.
// Source: Matthew S. Fell, "The Unofficial Doom Specs" (1994), §5.2.

/// One frame of a sprite from one direction.
struct SpriteView {
    const Lump* lump = nullptr;  ///< null: there is none
    bool is_mirrored = false;
};

/// One frame of a sprite. views[0] serves all directions; views[1] is the front, and so on turning by eighths.
struct DoomSpriteFrame {
    std::array<SpriteView, 9> views;

    bool has_all_directions() const;  ///< views 1 to 8 are all there
};

/// All frames of all sprites, by "POSSA": the sprite's four letters and the frame's.
using SpriteFrames = std::map<std::string, DoomSpriteFrame>;

/// Sorts the lumps of the sprites' section. "POSSA2A8" is frame A from direction 2, and mirrored from 8. Names that
/// are not of that form are left out; of two lumps for the same view the later name counts.
SpriteFrames sort_sprites(const WadPile& pile);

/// A frame made ready: all its views on canvases of one size, with the thing's position at the same texel of each.
struct SpriteCanvas {
    std::uint32_t width = 0, height = 0;
    std::int32_t origin_x = 0, origin_y = 0;  ///< the texel at the thing's position
    bool has_rotations = false;               ///< eight views, else one
};

/// The smallest canvas for the frame, from the headers alone. A frame that lacks some of its eight directions is shown
/// from the one it has. An Error where a header is broken, or there is no view at all.
Result<SpriteCanvas> measure_frame(const DoomSpriteFrame& frame);

/// The picture of one view, 1..8 with rotations, else 0, on its canvas.
Result<Picture> draw_view(const DoomSpriteFrame& frame, const SpriteCanvas& canvas, std::size_t view);

}  // namespace enfilade::wadconv
