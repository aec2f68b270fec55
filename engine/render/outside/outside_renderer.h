// A picture of the world from outside, above the eye or behind it: what the eye sees, where it sees it, and through
// which portals. Rooms behind links and in mirrors are where they appear to be.
#pragma once
#include "render/outside/facet_painter.h"

namespace enfilade {

// What is drawn into a picture from outside to explain it: the eye, the edges of what it sees, and the portals that it
// looks through.

/// Colours of the automap, so that one learns them once [0xAABBGGRR].
inline constexpr std::uint32_t kLinkMark = 0xFFFF80C0, kMirrorMark = 0xFFFFE080, kDoorwayMark = 0xFF909090,
                               kEyeMark = 0xFF40FF40;

/// Adds the frames of all portals that looks pass: links and mirrors whole, plain doorways by their sills.
/// Only right after rooms.look().
void add_portal_marks(const OutsideScene& scene, const SeenRooms& rooms, std::vector<Facet>& facets);

/// Adds the eye, a pyramid that opens the way it looks, and the two edges of its field of view.
void add_eye_marks(const OutsideScene& scene, const SeenRooms& rooms, std::vector<Facet>& facets);

/// What to draw.
struct OutsideLook {
    OutsideFrom from = OutsideFrom::above;
    double reach_m = kUsualReach;              ///< kLeastReach..kMostReach [m]
    int seen_width = 1280, seen_height = 800;  ///< of the picture whose view is shown, 1..kMaxPictureSide [px]
    const View* camera = nullptr;              ///< not null: from there instead, with what is around its sector
};

/// Draws pictures of one map from outside, one at a time. What is seen is bright, the rest of the rooms dim; where
/// rooms lie on one another, what is seen comes before what is not. Roofs and walls that face away are left out.
class OutsideRenderer {
public:
    /// map, textures: outlive it.
    OutsideRenderer(const Map& map, const TextureSet& textures);

    /// Sets every pixel of the frame, whose size is the picture's. `view` is what the eye sees.
    /// workers: threads, >= 1; the picture does not depend on them.
    /// Cost: SeenRooms::look(), the walls of the rooms around, and the pixels that they cover.
    void render(Frame& frame, const Snapshot& snapshot, const View& view, const OutsideLook& look, std::size_t workers);

private:
    const Map& map_;
    const TextureSet& textures_;
    MapPieces pieces_;
    SeenRooms rooms_;
    std::vector<Facet> facets_;
};

}  // namespace enfilade
