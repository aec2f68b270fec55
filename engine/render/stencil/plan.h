// What is seen through which chain of portals, worked out before anything is drawn: the tree of layers.
//
// A layer is everything that is drawn at one stencil level of one chain of links: one eye, and the sectors it sees
// through doorways alone. Sectors of one layer never overlap in the plane, so the depth buffer is enough for them;
// whatever lies behind a link, a mirror or a doorway into an overlapping room is a layer of its own. What stands in a
// layer is put in order here, too: by columns in an upright picture, by rays in a tilted one.
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <variant>
#include <vector>

#include "map/textures.h"
#include "render/frame.h"
#include "render/segment.h"
#include "render/sprite.h"
#include "render/stencil/panorama.h"
#include "render/stencil/wall_on_screen.h"
#include "world/snapshot.h"

namespace enfilade::stencil {

// Pictures with holes that stand or hang in rooms: things, panels, and what hangs in portals.

// Where a thing's picture stands on the screen, as seen in one sector of one layer.

/// A picture that is met in a room. Its place is like a wall's that faces the eye squarely: all of it has one depth.
struct ThingOnScreen {
    WallOnScreen place;
    ThingId thing;
    Vec2 position;  ///< of the thing, in the sector's space
    PixelSurface id = kNothing;
    TextureId texture;
    Lighting lighting;
    double depth = 0;            ///< along `forward`; in tilted pictures maybe behind the eye, below 0 [m]
    double top = 0, height = 0;  ///< of the whole picture; top: above the eye [m]
    RelativeHeights shown;       ///< the part of it that no floor or ceiling cuts off, above the eye
};

/// In no column yet. none: too near, or no picture, or all of it is cut off. room: above the eye; what cuts the
/// picture.
std::optional<ThingOnScreen> in_view(const Map& map, const TextureSet& textures, const Snapshot& snapshot,
                                     const Presence& presence, const Pose& pose, const RelativeHeights& room);

/// The room of a thing that nothing cuts.
inline constexpr RelativeHeights kNoRoom{-std::numeric_limits<double>::infinity(),
                                         std::numeric_limits<double>::infinity()};

/// Finds the columns of a thing ahead of the eye. False: there are none.
bool put_on_screen(ThingOnScreen& thing, const Screen& screen);

/// A panel, from the side on which the eye is.
struct PanelOnScreen {
    PanelId panel;
    WallOnScreen place;
    RelativeHeights shown;       ///< the part of it that is inside the room, above the eye
    bool is_in_doorway = false;  ///< on the line of the doorway that one sees it through, whose room hides it
};

/// In no column yet; shown.is_empty(): not at all.
PanelOnScreen in_view(const Map& map, const Snapshot& snapshot, PanelId panel, const Pose& pose);

/// The picture that hangs in a portal.
struct Hanging {
    WallOnScreen place;
};

/// A picture with holes, in those columns of its place in which one chain of portals shows it.
using Pane = std::variant<ThingOnScreen, PanelOnScreen, Hanging>;

inline const WallOnScreen& place_of(const Pane& pane) {
    return std::visit([](const auto& it) -> const WallOnScreen& { return it.place; }, pane);
}
inline WallOnScreen& place_of(Pane& pane) {
    return std::visit([](auto& it) -> WallOnScreen& { return it.place; }, pane);
}

// Layers, and the plan of them.

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
    std::vector<WallOnScreen> stand_ins;  ///< tilted: before all else (tilted_stand_ins())
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

// What stands in a room, in the order in which each column meets it.

/// Finds the things and panels of one visit at a time. A room without them costs a look at two empty lists.
class RoomPanes {
public:
    RoomPanes(const FrameInput& input, const Screen& screen) : input_(input), screen_(screen) {}

    /// For a new frame: nothing is passed yet.
    void start() { passed_.assign(static_cast<std::size_t>(screen_.width), 0); }

    /// Adds what stands in the room that is looked into, and is seen, to the layer's panes: for every run of columns
    /// that meet the same pictures in the same order these pictures, the nearest first;
    /// of a thing and a panel at one depth, in steps (render/sprite.h), the thing.
    /// Those beyond kMostPictures in a column, the farthest, are left out: of two rooms the nearer is to be noted
    /// first.
    void note(Layer& layer, const RoomLook& room);

    /// One more in column x, of a portal. False: it is left out.
    bool pass(int x) { return !is_full(x) && ++passed_[static_cast<std::size_t>(x)] > 0; }

private:
    struct PaneBoard {
        Pane pane;
        Segment facing{{}, {}};  ///< panels only
        PanelId panel;           ///< none: a thing
        double depth = 0;        ///< things only [m]
    };

    bool is_full(int x) const { return passed_[static_cast<std::size_t>(x)] >= kMostPictures; }
    void add_met(std::size_t board, int x);
    void find_boards(const Pose& pose, const RoomLook& room);
    void add_panel(const Pose& pose, const RoomLook& room, PanelId id);
    void meet(const Pose& pose, const RoomLook& room, int x);
    bool is_met(const Pose& pose, const RoomLook& room, const PaneBoard& thing, int x) const;
    void meet_panels(const RoomLook& room, int x);
    bool is_before(const PaneBoard& a, const PaneBoard& b) const;
    bool is_before_wall(const RoomLook& room, const PaneBoard& panel, int x) const;
    void add_run(Layer& layer, int begin, int end, int rank);

    const FrameInput& input_;
    const Screen& screen_;
    std::vector<PaneBoard> boards_;        ///< things first, the nearest of them first; then panels
    std::size_t things_ = 0;               ///< how many of them are things
    std::vector<std::size_t> met_, run_;   ///< by the present column, and by those before it: numbers of boards
    std::vector<std::size_t> met_panels_;  ///< by the present column
    std::vector<std::uint32_t> passed_;    ///< pictures, by column
};

// What a tilted picture needs in place of columns, which tell an upright one what each ray meets first: an order of all
// that stands in a layer, and walls where rounding left none.

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
