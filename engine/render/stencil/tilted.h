// What a tilted picture needs in place of columns, which tell an upright one what each ray meets first: an order of all
// that stands in a layer, and walls where rounding left none.
#pragma once
#include <cstddef>
#include <functional>
#include <vector>

#include "render/segment.h"
#include "render/stencil/plan.h"

namespace enfilade::stencil {

// In which order the rays of one eye meet upright edges, all around it: decided exactly, on the plane.

/// Where a look all around begins and ends: edges that cross this direction from the eye are cut in two there, so that
/// no edges hide each other in a ring.
inline constexpr Vec2 kCut{1, 0};

/// An edge, or what is left of it to one side of kCut.
struct SweptPart {
    std::size_t edge;
    bool begins_at_cut = false, ends_at_cut = false;  ///< seen from the eye, b being to the right of a
};

/// Whether the one edge is met before the other by the rays that meet both; asked of edges only that share a ray.
using IsMetBefore = std::function<bool(std::size_t edge, std::size_t other)>;

/// Whether an edge's ends are rounded, so that it may be met a hair to the wrong side of others. They are all in order
/// whatever is said of it.
using IsRounded = std::function<bool(std::size_t edge)>;

/// All edges so that along every ray the nearer comes before the farther. Given: their right sides face the eye under
/// the tie rule, and they do not cross each other. Ends and eye on either grid.
/// Cost: for n edges n log n side tests, and for each a look along those that share a ray with its ends.
std::vector<SweptPart> in_order_of_rays(
    const std::vector<Segment>& edges, Vec2 eye, const IsMetBefore& is_met_before,
    const IsRounded& is_rounded = [](std::size_t) { return false; });

// Layers of tilted pictures.

/// All upright edges of one layer of a tilted picture. Their ranks (WallOnScreen::rank) grow along every ray; one that
/// would take part in a ring of edges, each before the next, is there twice, cut in two (in_order_of_rays()).
struct TiltedLayer {
    std::vector<WallOnScreen> walls;
    std::vector<Pane> panes;  ///< by rank
};

/// The walls of the layer's sectors that face the eye beyond the doorway one looks in through, and what stands and
/// hangs in those sectors. Walls, panels and what hangs in portals are ordered exactly.
/// Cost: for n of them n log n side tests.
TiltedLayer tilted_order(const Layer& layer, const FrameInput& input);

// What stands in where rounding behind a link left a tilted picture without the wall that is met there.

/// Behind a link the eye is rounded onto its grid, and the tie rule moves it there in that space's own way. Then some
/// of the rays that are in the doorway's picture stray: they come past the doorway itself. All others are in the room
/// behind it and meet a wall of it first. A stray ray might meet none, as walls of the room may turn their backs on the
/// eye; or it meets one of another outline of the room, and other rooms' walls on the way there. What is seen there, as
/// in the reference, is nonetheless a wall of the room, before everything else: the nearest that is met, or where there
/// is none, in each piece of a degree or so, the one that comes nearest to its middle (render/segment.h).
/// layer: all of its sectors are known. Given from left to right.
/// Cost: where rays stray, the walls of all sectors of the layer, and those of the room for each piece.
std::vector<WallOnScreen> tilted_stand_ins(const Layer& layer, const Map& map);

// Things, panels and hanging pictures of a layer.

/// A picture with holes, and the room that it stands or hangs in.
struct PaneInRoom {
    SectorId room;
    std::size_t number;  ///< parts of one picture have the same; of two that are equally near the smaller is the nearer
    Pane pane;
};

inline bool is_thing(const Pane& pane) { return std::holds_alternative<ThingOnScreen>(pane); }

/// All that stands or hangs in the layer's sectors, as far as it is shown (shown_left_v, shown_right_v): each thing in
/// every sector only as far as it is there, and in two where it goes through a panel. So none goes through another.
/// Cost: for each panel a look at each thing.
std::vector<PaneInRoom> tilted_panes(const Layer& layer, const FrameInput& input);

/// How deep a thing is inside its room [m]: what stands in the very plane of a doorway is in the room behind it,
/// whatever rounding did (render/sprite.h).
double depth_in_room(const ThingOnScreen& thing);

}  // namespace enfilade::stencil
