// What is seen through which chain of portals, worked out before anything is drawn: the tree of layers.
//
// A layer is everything that is drawn at one stencil level of one chain of links: one eye, and the sectors it sees
// through doorways alone. Sectors of one layer never overlap in the plane, so the depth buffer is enough for them;
// whatever lies behind a link, a mirror or a doorway into an overlapping room is a layer of its own.
#pragma once
#include <vector>

#include "map/textures.h"
#include "render/stencil/pane.h"
#include "render/stencil/panorama.h"
#include "render/stencil/room_look.h"
#include "world/snapshot.h"

namespace enfilade::stencil {

/// A portal that leads out of a layer.
struct Exit {
    static constexpr std::size_t kCut = static_cast<std::size_t>(-1);
    WallId wall;
    double nearest = 0;        ///< its largest inverse depth where it is seen [1/m]
    std::size_t layer = kCut;  ///< what is seen through it; kCut: a limit is reached, the recursion colour shows
};

struct Layer {
    Pose pose;
    WallId entry;                     ///< the wall of this space through which one looks in; none for the first layer
    WallOnScreen opened;              ///< the same from its other side, in view space
    int level = 0;                    ///< layers that it is seen through
    ScreenBox box;                    ///< no pixel of the layer is outside
    std::vector<SectorId> sectors;    ///< looked into
    std::vector<WallOnScreen> walls;  ///< upright: by runs of columns, which meet one in each room they go through
    std::vector<WallOnScreen> stand_ins;  ///< tilted: before all else (tilted.h)
    std::vector<Exit> exits;              ///< nearest first
    std::vector<Pane> panes;              ///< upright: along every ray the nearer before the farther
};

/// The stencil buffer holds 8 bits: so many levels it tells apart from level 0.
inline constexpr int kDeepestLevel = 255;

/// How often levels have to be kept aside to draw a chain as deep as this (layer_painter.h): each time the deepest
/// becomes level 1.
inline constexpr std::size_t times_kept(int deepest) {
    return deepest > kDeepestLevel ? static_cast<std::size_t>((deepest - 2) / (kDeepestLevel - 1)) : 0;
}

/// What the planner needs to know about the whole map, worked out once.
struct MapFacts {
    std::vector<char> overlaps;  ///< by sector: shares ground with another it is joined to by doorways
};

/// A look into a sector, in the columns and rows of the picture; tilted, of one face of its panorama.
struct SeenRoom {
    SectorId sector;
    int depth = 0;  ///< portals looked through
    ClipWindow window;
};

/// One frame's layers. layers[0] is what the eye's own space shows; every other is the layer of exactly one exit.
struct Plan {
    std::vector<Layer> layers;
    std::vector<SeenRoom> rooms;  ///< looked into, chains counted one by one
    std::size_t cut = 0;          ///< exits that were not followed because a limit was reached
    bool is_cut_short = false;    ///< that was a limit on the work of a frame for at least one of them
    int deepest = 0;              ///< level of the deepest layer
};

/// What there is to see.
struct FrameInput {
    const Map& map;
    const MapFacts& facts;
    const TextureSet& textures;
    const Snapshot& snapshot;
};

/// Follows the view through all doorways, links and mirrors as long as a pixel may be open. A little more than what is
/// seen may be in the plan, never less. screen: of the picture, or if it is tilted, of its panorama.
/// Cost: for each sector looked into its walls, and the columns it is seen in.
Plan make_plan(const FrameInput& input, const Screen& screen, const RayField& rays, const View& view);

}  // namespace enfilade::stencil
