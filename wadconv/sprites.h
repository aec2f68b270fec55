// Sprites: which lumps make up each frame, seen from one or from eight directions.
// Source: Matthew S. Fell, "The Unofficial Doom Specs" (1994), §5.2.
#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "base/result.h"
#include "wadconv/picture.h"
#include "wadconv/wad.h"

namespace enfilade::wadconv {

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
