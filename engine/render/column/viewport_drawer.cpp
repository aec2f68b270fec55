#include "render/column/viewport_drawer.h"

#include <algorithm>

#include "render/built_in.h"
#include "render/column/kernels.h"
#include "render/openings.h"
#include "render/sprite.h"

namespace enfilade::column {
namespace {

constexpr double kBrightestDepth = 0;

RelativeHeights heights_above(const ColumnScene& scene, SectorId id, double eye_z) {
    if (!built_in::kMovers) return {scene.map[id].floor.z - eye_z, scene.map[id].ceiling.z - eye_z};
    const Heights heights = heights_at(scene.snapshot, id);
    return {heights.floor_z - eye_z, heights.ceiling_z - eye_z};
}

Lighting flat_lighting(const ColumnScene& scene, SectorId sector) {
    return lighting_in(scene.map, sector, light_now(scene.snapshot, sector), 1);
}

Rigid passage_of(const ColumnScene& scene, const Wall& portal) {
    return built_in::kLinks ? scene.map.passage(portal) : Rigid{};
}

}  // namespace

void ViewportDrawer::draw(const ColumnScene& scene, FrameState& state, Viewport& viewport) {
    start_viewport(scene, state, viewport);
    for (const WallColumns& stretch : nearest_.stretches()) draw_stretch(scene, state, stretch);
    push_children(state);
}

void ViewportDrawer::start_viewport(const ColumnScene& scene, FrameState& state, Viewport& viewport) {
    viewport_ = &viewport;
    pose_ = state.poses[static_cast<std::size_t>(viewport.pose)];
    nearest_.choose(scene.map, scene.screen, viewport, pose_,
                    state.projections.get(scene.map, viewport.sector, viewport.pose, pose_, scene.screen));
    here_ = heights_above(scene, viewport.sector, pose_.eye_z);
    is_floor_started_ = is_ceiling_started_ = false;
    room_columns_.note({scene, viewport, state.poses, pose_, here_, nearest_}, state.masked);
    openings_.assign(nearest_.count(), {});
    wall_index_ = NearestWalls::kNoWall;
}

void ViewportDrawer::draw_stretch(const ColumnScene& scene, FrameState& state, WallColumns stretch) {
    while (stretch.begin < stretch.end && viewport_->rows_at(stretch.begin).is_closed()) ++stretch.begin;
    while (stretch.begin < stretch.end && viewport_->rows_at(stretch.end - 1).is_closed()) --stretch.end;
    if (stretch.begin == stretch.end) return;
    if (stretch.wall != wall_index_) start_wall(scene, state, stretch.wall);
    for (int x = stretch.begin; x < stretch.end; x += WallLooks::kMost)
        draw_columns(scene, state, x, std::min(x + WallLooks::kMost, stretch.end));
}

void ViewportDrawer::draw_columns(const ColumnScene& scene, FrameState& state, int begin, int end) {
    look_at(nearest_.wall(wall_index_), scene.map[wall_], pose_, scene.screen, begin, end - begin, looks_);
    split_rows(scene.screen, looks_, &viewport_->rows_at(begin), here_, is_portal_ ? &behind_ : nullptr, rows_);
    if (rows_.has_ceiling) ceiling(scene).paint(scene, looks_, rows_.top, rows_.wall_top);
    if (rows_.has_floor) floor(scene).paint(scene, looks_, rows_.wall_bottom, rows_.bottom);
    if (!is_portal_) return middle_.paint(scene, looks_, rows_.wall_top, rows_.wall_bottom);
    if (!upper_open_ && rows_.has_upper) upper(scene).paint(scene, looks_, rows_.wall_top, rows_.opening_top);
    if (!lower_open_ && rows_.has_lower) lower(scene).paint(scene, looks_, rows_.opening_bottom, rows_.wall_bottom);
    open_behind(scene, state);
}

// Many viewports and walls show only some of their surfaces: each is made ready when the first of its rows is seen.

FlatPainter& ViewportDrawer::floor(const ColumnScene& scene) {
    const SectorId sector = viewport_->sector;
    if (!is_floor_started_)
        floor_.start(scene, pose_, floor_now(scene.map, scene.snapshot, sector), FlatSide::floor, here_.floor,
                     flat_lighting(scene, sector), scene.light_on_floor(sector), floor_id(sector));
    is_floor_started_ = true;
    return floor_;
}

FlatPainter& ViewportDrawer::ceiling(const ColumnScene& scene) {
    const SectorId sector = viewport_->sector;
    if (!is_ceiling_started_)
        ceiling_.start(scene, pose_, ceiling_now(scene.map, scene.snapshot, sector), FlatSide::ceiling, here_.ceiling,
                       flat_lighting(scene, sector), scene.light_on_ceiling(sector), ceiling_id(sector));
    is_ceiling_started_ = true;
    return ceiling_;
}

const WallPainter& ViewportDrawer::upper(const ColumnScene& scene) {
    if (!is_upper_started_) start_part(scene, upper_, scene.map[wall_].upper, WallPart::upper, &behind_);
    is_upper_started_ = true;
    return upper_;
}

const WallPainter& ViewportDrawer::lower(const ColumnScene& scene) {
    if (!is_lower_started_) start_part(scene, lower_, scene.map[wall_].lower, WallPart::lower, &behind_);
    is_lower_started_ = true;
    return lower_;
}

/// behind: null for a solid wall.
void ViewportDrawer::start_part(const ColumnScene& scene, WallPainter& painter, SurfaceId surface, WallPart part,
                                const RelativeHeights* behind) const {
    const Wall& wall = scene.map[wall_];
    painter.start(scene, wall, picture_now(scene.map, scene.snapshot, wall_, surface),
                  peg_height(scene.map[surface].peg, here_, behind), light_now(scene.snapshot, wall.sector),
                  wall_id(scene.map, wall_, part));
    painter.light_up(lamplight_, wall.length, pose_.eye_z);
}

void ViewportDrawer::start_wall(const ColumnScene& scene, FrameState& state, int wall_index) {
    wall_index_ = wall_index;
    wall_ = nearest_.wall(wall_index).wall;
    const Wall& wall = scene.map[wall_];
    const WallKind kind = kind_now(scene.map, scene.snapshot, wall_);
    is_portal_ = kind != WallKind::solid;
    masked_ = kNoMasked;
    lamplight_ = scene.light_on(wall_);
    is_upper_started_ = is_lower_started_ = false;
    if (!is_portal_) return start_part(scene, middle_, wall.texture, WallPart::middle, nullptr);
    if (built_in::kMirrors && kind == WallKind::mirror) {
        behind_ = here_;
        upper_open_ = lower_open_ = false;
        return;
    }
    behind_ = heights_above(scene, wall.behind, passage_of(scene, wall).apply_height(pose_.eye_z));
    upper_open_ = !has_upper_step(scene.map, wall);
    lower_open_ = !has_lower_step(scene.map, wall);
    if (built_in::kMasked && scene.map[wall.middle].texture) start_masked(scene, state);
}

/// A fence or window in the portal. Its picture is shown once from top to bottom, hanging from its peg or standing on
/// it; where it scrolls it runs through that place, which itself stays.
void ViewportDrawer::start_masked(const ColumnScene& scene, FrameState& state) {
    const Wall& wall = scene.map[wall_];
    const Surface surface = picture_now(scene.map, scene.snapshot, wall_, wall.middle);
    const bool stands = surface.peg == Peg::floor || surface.peg == Peg::opening_bottom;
    const double top = peg_height(surface.peg, here_, &behind_) + (stands ? surface.tile_m.y : 0);
    picture_.ceiling = top - scene.map[wall.middle].offset_tiles.y * surface.tile_m.y;
    picture_.floor = picture_.ceiling - surface.tile_m.y;
    WallPainter painter;
    painter.start(scene, wall, surface, top, light_now(scene.snapshot, wall.sector),
                  wall_id(scene.map, wall_, WallPart::middle));
    painter.light_up(lamplight_, wall.length, pose_.eye_z);
    if (surface.scroll.y == 0) painter.show_once();
    masked_ = state.masked.add(painter);
}

bool ViewportDrawer::has_masked() const { return built_in::kMasked && masked_ != kNoMasked; }

void ViewportDrawer::open_behind(const ColumnScene& scene, FrameState& state) {
    const int* const tops = upper_open_ ? rows_.wall_top : rows_.opening_top;
    const int* const bottoms = lower_open_ ? rows_.wall_bottom : rows_.opening_bottom;
    for (int i = 0; i < looks_.count; ++i) {
        const OpenRows open{tops[i], bottoms[i]};
        if (open.is_closed()) continue;
        const int x = looks_.begin + i;
        if (has_masked()) note_masked(scene, state, i, open);
        Viewport* const behind = viewport_behind(scene, state);
        if (behind == nullptr) {
            fill_cut(scene, x, open);
            continue;
        }
        behind->rows_at(x) = open;
        behind->boundary_at(x) = looks_.inverse_depth[i];
    }
}

void ViewportDrawer::note_masked(const ColumnScene& scene, FrameState& state, int i, OpenRows open) {
    const RowSplit picture = split_rows(RowsAt(scene.screen, looks_, i), open, picture_, nullptr);
    state.masked.note(masked_, looks_.begin + i, {picture.wall_top, picture.wall_bottom}, looks_.at(i));
}

/// Where a limit of the frame is reached there is nothing to be seen.
void ViewportDrawer::fill_cut(const ColumnScene& scene, int x, OpenRows open) const {
    fill_color(scene.canvas.run(x, open.top, open.bottom), pixel_of(scene.map.render.recursion_color));
    if (scene.facts == nullptr) return;
    for (int y = open.top; y < open.bottom; ++y) note(scene, x, y, kRecursionEnd, kBrightestDepth, 0, 0);
}

/// What is seen through the wall being drawn, or null where a limit of the frame is reached; asked once for each wall.
Viewport* ViewportDrawer::viewport_behind(const ColumnScene& scene, FrameState& state) {
    PortalOpening& opening = openings_[static_cast<std::size_t>(wall_index_)];
    if (opening.state == PortalOpening::State::unknown) {
        const ProjectedWall& projected = nearest_.wall(wall_index_);
        opening.viewport = child_of(scene, state, scene.map[projected.wall], projected);
        opening.state = opening.viewport ? PortalOpening::State::open : PortalOpening::State::cut;
    }
    return opening.viewport;
}

/// A viewport for what is seen through the portal, or null where a limit of the frame is reached.
Viewport* ViewportDrawer::child_of(const ColumnScene& scene, FrameState& state, const Wall& wall,
                                   const ProjectedWall& projected) {
    const bool is_link = built_in::kLinks && wall.link != Wall::kNoLink;
    const bool is_spent = viewport_->spent >= kLookBudget;
    StrayingLook straying = viewport_->straying;
    const bool comes_round = straying.comes_round_to(projected.wall, nearest_.is_missed(wall_index_));
    if (is_spent || comes_round || (is_link && pose_.links >= scene.map.render.max_depth)) {
        ++state.record->cut;
        state.record->is_cut_short |= is_spent;
        return nullptr;
    }
    Viewport& child =
        state.record->pool.take(std::max(projected.begin, viewport_->begin), std::min(projected.end, viewport_->end));
    child.sector = wall.behind;
    child.entry = wall.exit;
    child.depth = viewport_->depth + 1;
    child.spent =
        viewport_->spent + cost_of_look_into(scene.map[wall.behind], scene.snapshot.things.in(wall.behind).size());
    child.pose = viewport_->pose;
    child.doorway = {projected.wall, viewport_->pose, {}};
    if (projected.stands_in) child.doorway.missed_depth = projected.nearest;
    if (!is_link) child.straying = straying;
    if (is_link) {
        child.pose = static_cast<int>(state.poses.size());
        state.poses.push_back(beyond(pose_, passage_of(scene, wall)));
    }
    state.record->deepest = std::max(state.record->deepest, child.depth);
    return &child;
}

void ViewportDrawer::push_children(FrameState& state) {
    for (const PortalOpening& opening : openings_)
        if (opening.viewport != nullptr && opening.viewport->trim()) state.stack.push_back(opening.viewport);
}

}  // namespace enfilade::column
