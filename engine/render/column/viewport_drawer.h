// Draws one viewport: its sector's surfaces where they are open, and the viewports seen through its portals.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "render/column/painters.h"
#include "render/column/scene.h"
#include "render/column/sector_projection.h"
#include "render/column/viewport.h"
#include "render/sprite.h"
#include "render/view.h"

namespace enfilade::column {

// What cannot be drawn in order: fences and things are noted while the viewports are drawn, together with the rows that
// were open, and laid over the finished picture back to front. A frame without such pictures keeps nothing here.

// A viewport while what stands in its room is looked for.

struct RoomView {
    const ColumnScene& scene;
    const Viewport& viewport;
    const std::vector<Pose>& poses;  ///< by Viewport::pose
    const Pose& pose;
    const RelativeHeights& here;
    const NearestWalls& nearest;
};

/// The part of a picture that is between the room's floor and ceiling.
inline RelativeHeights within(const RelativeHeights& room, double bottom, double top) {
    return {bottom > room.floor ? bottom : room.floor, top < room.ceiling ? top : room.ceiling};
}

class MaskedColumns {
public:
    /// For a picture of this width [px].
    void clear(int width);

    /// A picture that columns may be noted of; to be added when the first is.
    int add(const WallPainter& painter);
    static constexpr int kNotAdded = -1;

    /// Rows of column x that show the picture, if any. Of two that share a column the nearer one is to be noted first:
    /// a viewport is drawn before those seen through its portals, so its own pictures come before theirs. Those beyond
    /// kMostPictures, the farthest of what shares the column, are left out.
    void note(int painter, int x, OpenRows rows, const WallHit& hit);

    /// Nothing more is to be noted of column x.
    bool is_full(int x) const { return noted_[static_cast<std::size_t>(x)] >= kMostPictures; }

    /// How many columns of pictures are to be laid over the picture.
    std::size_t count() const;

    /// Lays all of them over the picture, of each column the last noted first.
    void draw(const ColumnScene& scene) const;

private:
    struct MaskedColumn {
        int painter;
        int x;
        OpenRows rows;
        WallHit hit;
    };

    std::size_t draw_neighbours(const ColumnScene& scene, const std::vector<MaskedColumn>& layer, std::size_t i) const;

    std::vector<WallPainter> painters_;
    /// By how many were noted of their column before. Those of one layer hide nothing of each other, so that neighbours
    /// are drawn at once.
    std::vector<std::vector<MaskedColumn>> layers_;
    std::vector<std::uint32_t> noted_;  ///< by column: pictures
};

// Which columns and rows of a viewport show panels, and in which order.

/// The panels of one viewport, column by column from left to right. Panels cross nothing, so of two that share a column
/// the same one is the nearer in all of them: a row of those that cover the present column is kept in order, and a
/// panel is put in where it begins and taken out where it ends.
class PanelColumns {
public:
    /// Finds the panels that are somewhere on the screen. False: there are none.
    bool gather(const RoomView& view);

    /// What some columns show of a panel.
    struct PanelLooks {
        int panel;  ///< number of this search
        WallLooks looks;
    };

    /// Looks for the panels that are seen before the wall in columns.begin, and in those right of it up to where others
    /// are seen. Returns the first column that needs another look, at most columns.end. columns: 1..WallLooks::kMost;
    /// columns.begin grows from call to call after gather().
    int look(const RoomView& view, const WallColumns& columns);

    /// What the last look found, the nearest first; their depths never fall.
    std::span<const PanelLooks> shown() const { return {shown_.data(), shown_count_}; }

    /// Notes what column x shows of the panel.
    void note(const RoomView& view, const PanelLooks& shown, int x, MaskedColumns& masked);

private:
    /// A panel that is somewhere on the screen.
    struct PanelBoard {
        Segment facing;       ///< turned so that it faces the eye
        ProjectedWall place;  ///< `swapped` says whether its left end is the panel's b
        RelativeHeights rows;
        PanelId panel;
        int painter = MaskedColumns::kNotAdded;
    };

    void add(const RoomView& view, PanelId id);
    static int painter_of(const RoomView& view, const PanelBoard& board, MaskedColumns& masked);
    bool is_before(int a, int b) const;
    void move_to(int x);
    bool is_before_wall(const RoomView& view, const PanelBoard& board, const WallColumns& shared) const;
    void show(const RoomView& view, int index, const WallColumns& shared);

    std::vector<PanelBoard> boards_;  ///< by where they begin, from left to right
    std::size_t next_ = 0;            ///< the first that begins to the right of the present column
    std::vector<int> row_;            ///< those that cover the present column, the nearest first
    std::vector<PanelLooks> shown_;   ///< keeps its memory
    std::size_t shown_count_ = 0;
};

// Which columns and rows of a viewport show things, and in which order.

/// The things of one viewport at a time.
class ThingColumns {
public:
    /// Finds the things that are somewhere on the screen and puts them in order, the nearest first. False: there are
    /// none.
    bool gather(const RoomView& view);

    std::size_t count() const { return boards_.size(); }

    /// Of the i-th of them. All of a picture has one depth, so the order is the same in all columns.
    std::int64_t steps(std::size_t i) const { return boards_[i].steps; }

    /// Notes what column x shows of the i-th of them, if it does.
    void note(const RoomView& view, std::size_t i, int x, MaskedColumns& masked);

    /// Notes every column of all of them.
    void note_all(const RoomView& view, MaskedColumns& masked);

private:
    /// A picture that is somewhere on the screen.
    struct ThingBoard {
        int begin, end;      ///< columns, within the viewport
        double depth;        ///< [m]
        std::int64_t steps;  ///< of the depth
        SpriteSpan span;
        RelativeHeights rows;
        double top;  ///< of the picture, above the eye [m]
        SpritePicture picture;
        ThingId thing;
        Vec2 place;          ///< of the thing
        std::size_t number;  ///< among those of the room
        int painter = MaskedColumns::kNotAdded;
    };

    static bool is_nearer(const ThingBoard& a, const ThingBoard& b);
    static RayDepth depth_of_entry(const RoomView& view, int x);
    static bool is_entry_farther(const RoomView& view, const ThingBoard& board, int x);
    static bool is_exit_farther(const RoomView& view, const ThingBoard& board, const ProjectedWall& wall, int x);
    static bool is_aside(const RoomView& view, const Presence& presence, double depth, double aside);
    void add(const RoomView& view, const Presence& presence);
    static int painter_of(const RoomView& view, const ThingBoard& board, MaskedColumns& masked);
    static bool is_met(const RoomView& view, const ThingBoard& board, int x);

    std::vector<ThingBoard> boards_;
};

// What stands in a room: its things and panels, in one order in every column.

/// Notes the things and panels of one viewport at a time. A viewport without them costs a look at two empty lists.
class RoomColumns {
public:
    /// Notes every column of every picture, of each column the nearest first; of a thing and a panel at one depth, in
    /// steps (render/exact_ray.h), the thing. To be called before the viewport's masked walls are noted: they stand at
    /// the end of the room, behind all that is in it.
    void note(const RoomView& view, MaskedColumns& masked);

private:
    int note_some(const RoomView& view, const WallColumns& columns, MaskedColumns& masked);
    void note_column(const RoomView& view, int x, MaskedColumns& masked);

    ThingColumns things_;
    PanelColumns panels_;
};

// The viewport.

/// What is known of a part of a picture when it has been drawn.
struct ViewportRecord {
    ViewportPool pool;
    int deepest = 0;            ///< portals looked through in the longest chain
    std::size_t cut = 0;        ///< viewports not drawn because a limit was reached
    bool is_cut_short = false;  ///< that was kLookBudget for at least one of them

    /// Forgets the last picture, but keeps its memory.
    void start() {
        pool.take_all_back();
        deepest = 0;
        cut = 0;
        is_cut_short = false;
    }
};

/// What grows while a picture is drawn, part after part: poses met, walls projected; and in one part of it, viewports
/// taken, viewports waiting.
struct FrameState {
    std::vector<Pose> poses;  ///< by Viewport::pose
    ProjectionCache projections;
    ViewportStack stack;
    MaskedColumns masked;
    ViewportRecord* record = nullptr;  ///< of the part that is drawn
};

/// Holds the scratch memory for one viewport at a time.
class ViewportDrawer {
public:
    /// Draws `viewport` and pushes onto state.stack what is open behind its portals.
    void draw(const ColumnScene& scene, FrameState& state, Viewport& viewport);

private:
    void start_viewport(const ColumnScene& scene, FrameState& state, Viewport& viewport);
    void draw_stretch(const ColumnScene& scene, FrameState& state, WallColumns stretch);
    void draw_columns(const ColumnScene& scene, FrameState& state, int begin, int end);
    void start_wall(const ColumnScene& scene, FrameState& state, int wall_index);
    void start_part(const ColumnScene& scene, WallPainter& painter, SurfaceId surface, WallPart part,
                    const RelativeHeights* behind) const;
    void start_masked(const ColumnScene& scene, FrameState& state);
    FlatPainter& floor(const ColumnScene& scene);
    FlatPainter& ceiling(const ColumnScene& scene);
    const WallPainter& upper(const ColumnScene& scene);
    const WallPainter& lower(const ColumnScene& scene);
    void open_behind(const ColumnScene& scene, FrameState& state);
    void note_masked(const ColumnScene& scene, FrameState& state, int i, OpenRows open);
    void fill_cut(const ColumnScene& scene, int x, OpenRows open) const;
    Viewport* viewport_behind(const ColumnScene& scene, FrameState& state);
    bool has_masked() const;
    Viewport* child_of(const ColumnScene& scene, FrameState& state, const Wall& wall, const ProjectedWall& projected);
    void push_children(FrameState& state);

    // The viewport being drawn.
    Viewport* viewport_ = nullptr;
    Pose pose_;
    RelativeHeights here_;
    NearestWalls nearest_;
    FlatPainter floor_, ceiling_;
    bool is_floor_started_ = false, is_ceiling_started_ = false;
    RoomColumns room_columns_;

    /// A portal wall of the viewport, and where what is seen through it is gathered.
    struct PortalOpening {
        enum class State : unsigned char { unknown, open, cut } state = State::unknown;
        Viewport* viewport = nullptr;
    };
    std::vector<PortalOpening> openings_;  ///< by number of nearest_

    // The wall being drawn.
    static constexpr int kNoMasked = -1;
    int wall_index_ = NearestWalls::kNoWall;
    WallId wall_;
    const LightGrid* lamplight_ = nullptr;  ///< of point lights on it
    bool is_portal_ = false;
    bool upper_open_ = false, lower_open_ = false;  ///< a step that is not drawn: one sees over it
    RelativeHeights behind_;
    int masked_ = kNoMasked;   ///< its picture with holes in FrameState::masked
    RelativeHeights picture_;  ///< lower and upper end of that picture
    WallPainter middle_, upper_, lower_;
    bool is_upper_started_ = false, is_lower_started_ = false;

    // The columns being drawn.
    WallLooks looks_;
    RowSplits rows_;
};

}  // namespace enfilade::column
