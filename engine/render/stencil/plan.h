// What is seen through which chain of portals, worked out before anything is drawn: the tree of layers.
//
// A layer is everything that is drawn at one stencil level of one chain of links: one eye, and the sectors it sees
// through doorways alone. Sectors of one layer never overlap in the plane, so the depth buffer is enough for them;
// whatever lies behind a link, a mirror or a doorway into an overlapping room is a layer of its own.
#pragma once
#include <cstdint>
#include <variant>
#include <vector>

#include "map/textures.h"
#include "render/stencil/thing_on_screen.h"
#include "world/snapshot.h"

namespace enfilade::stencil {

/// Open rows [top, bottom) of one column.
struct OpenRows {
    int top = 0;
    int bottom = 0;
    bool is_closed() const { return top >= bottom; }
};

/// Which pixels something may be seen in: by column a range of rows. Closed columns are allowed anywhere.
struct Window {
    int begin = 0;  ///< columns [begin, begin + rows.size())
    std::vector<OpenRows> rows;

    int end() const { return begin + static_cast<int>(rows.size()); }
    OpenRows& at(int x) { return rows[static_cast<std::size_t>(x - begin)]; }
    const OpenRows& at(int x) const { return rows[static_cast<std::size_t>(x - begin)]; }
    /// Opens these rows of column x besides those that are open; what lies between opens, too.
    void open(int x, OpenRows more);
};

/// Columns and rows [begin, end) around a window [px].
struct Box {
    int begin_x = 0, end_x = 0, begin_y = 0, end_y = 0;
};
Box box_around(const Window& window);

/// Heights of a room, or of a part of a wall, above the eye [m].
struct Heights {
    double floor = 0;
    double ceiling = 0;
};

/// The parts a wall is made of, from the floor up: floor, lower step, opening, upper step, ceiling.
struct WallParts {
    Heights room;                       ///< of the wall's own sector
    Heights behind;                     ///< of the sector behind a portal, else `room`
    Heights opening;                    ///< what one sees through: floor >= ceiling for a solid wall or a closed portal
    bool lower = false, upper = false;  ///< the steps that are drawn
};
WallParts parts_of(const Map& map, const Snapshot& snapshot, const Wall& wall, double eye_z);

/// A sector of a layer, and the columns [begin, end) it may be seen in.
struct SeenSector {
    SectorId sector;
    int begin = 0, end = 0;
};

/// A portal that leads out of a layer.
struct Exit {
    static constexpr std::size_t kCut = static_cast<std::size_t>(-1);
    WallOnScreen wall;
    double nearest = 0;        ///< its largest inverse depth where it is seen [1/m]
    std::size_t layer = kCut;  ///< what is seen through it; kCut: a limit is reached, the recursion colour shows
};

/// A picture with holes, in the columns where one chain of portals shows it: a thing, or what hangs in a portal.
using Pane = std::variant<ThingOnScreen, WallOnScreen>;

struct Layer {
    Eye eye;
    WallId entry;  ///< the wall of this space through which one looks in; none for the first layer
    double entry_begin_px = 0, entry_end_px = 0;
    int level = 0;  ///< stencil value of its pixels
    Box box;        ///< no pixel of the layer is outside
    std::vector<SeenSector> sectors;
    std::vector<Exit> exits;  ///< nearest first
    std::vector<Pane> panes;  ///< along every ray the nearer before the farther
};

/// The stencil buffer holds 8 bits, so this is the deepest level there can be.
inline constexpr int kDeepestLevel = 255;

/// What the planner needs to know about the whole map, worked out once.
struct MapFacts {
    std::vector<char> overlaps;  ///< by sector: shares ground with another it is joined to by doorways
};

/// One frame's layers. layers[0] is what the eye's own space shows; every other is the layer of exactly one exit.
struct Plan {
    std::vector<Layer> layers;
    std::size_t visits = 0;  ///< sectors looked into, chains counted one by one
    std::size_t cut = 0;     ///< exits that were not followed because a limit was reached
    int deepest = 0;         ///< level of the deepest layer
};

/// Follows the view through all doorways, links and mirrors as long as a pixel may be open. A little more than what is
/// seen may be in the plan, never less. Cost: for each sector looked into its walls, and the columns it is seen in.
Plan make_plan(const Map& map, const MapFacts& facts, const TextureSet& textures, const Snapshot& snapshot,
               const Screen& screen, const View& view);

}  // namespace enfilade::stencil
