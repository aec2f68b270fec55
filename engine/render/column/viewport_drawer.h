// Draws one viewport: its sector's surfaces where they are open, and the viewports seen through its portals.
#pragma once
#include <vector>

#include "render/column/masked_columns.h"
#include "render/column/painters.h"
#include "render/column/sector_projection.h"
#include "render/column/viewport.h"

namespace enfilade::column {

/// What grows while a frame is drawn: poses met, viewports taken, viewports waiting.
struct FrameState {
    std::vector<Pose> poses;  ///< by Viewport::pose
    ViewportPool pool;
    ViewportStack stack;
    ProjectionCache projections;
    MaskedColumns masked;
    int deepest = 0;
    std::size_t cut = 0;
    bool is_cut_short = false;
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
