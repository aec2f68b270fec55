#include "render/column/viewport_drawer.h"

#include <algorithm>

#include "render/built_in.h"
#include "render/look_budget.h"
#include "render/open_steps.h"
#include "render/picture_now.h"

namespace enfilade::column {
namespace {

constexpr double kBrightestDepth = 0;

RelativeHeights heights_above(const Scene& scene, SectorId id, double eye_z) {
    if (!built_in::kMovers) return {scene.map[id].floor.z - eye_z, scene.map[id].ceiling.z - eye_z};
    const Heights heights = heights_at(scene.snapshot, id);
    return {heights.floor_z - eye_z, heights.ceiling_z - eye_z};
}

Rigid passage_of(const Scene& scene, const Wall& portal) {
    return built_in::kLinks ? scene.map.passage(portal) : Rigid{};
}

}  // namespace

void ViewportDrawer::draw(const Scene& scene, FrameState& state, Viewport& viewport) {
    start_viewport(scene, state, viewport);
    for (int x = viewport.begin; x < viewport.end; ++x)
        if (!viewport.rows_at(x).is_closed()) draw_column(scene, state, x);
    push_children(state);
}

void ViewportDrawer::start_viewport(const Scene& scene, FrameState& state, Viewport& viewport) {
    viewport_ = &viewport;
    pose_ = state.poses[static_cast<std::size_t>(viewport.pose)];
    nearest_.choose(scene.map, scene.screen, viewport, pose_,
                    state.projections.get(scene.map, viewport.sector, viewport.pose, pose_, scene.screen));
    here_ = heights_above(scene, viewport.sector, pose_.eye_z);
    const Lighting lighting = lighting_in(scene.map, viewport.sector, light_now(scene.snapshot, viewport.sector), 1);
    floor_.start(scene, pose_, floor_now(scene.map, scene.snapshot, viewport.sector), FlatSide::floor, here_.floor,
                 lighting, scene.light_on_floor(viewport.sector), floor_id(viewport.sector));
    ceiling_.start(scene, pose_, ceiling_now(scene.map, scene.snapshot, viewport.sector), FlatSide::ceiling,
                   here_.ceiling, lighting, scene.light_on_ceiling(viewport.sector), ceiling_id(viewport.sector));
    furniture_.note({scene, viewport, pose_, here_, nearest_}, state.masked);
    openings_.assign(nearest_.count(), {});
    wall_index_ = NearestWalls::kNoWall;
}

void ViewportDrawer::draw_column(const Scene& scene, FrameState& state, int x) {
    const int wall_index = nearest_.at(x);
    if (wall_index != wall_index_) start_wall(scene, state, wall_index);
    const WallHit look = hit(nearest_.wall(wall_index), scene.screen.slopes[x]);
    const OpenRows open = viewport_->rows_at(x);
    const RowSplit rows = split_rows(scene.screen, open, look.depth, here_, is_portal_ ? &behind_ : nullptr);
    ceiling_.paint(scene, x, open.top, rows.wall_top, look.depth);
    floor_.paint(scene, x, rows.wall_bottom, open.bottom, look.depth);
    if (!is_portal_) {
        middle_.paint(scene, x, rows.wall_top, rows.wall_bottom, look);
        return;
    }
    if (!upper_open_) upper_.paint(scene, x, rows.wall_top, rows.opening_top, look);
    if (!lower_open_) lower_.paint(scene, x, rows.opening_bottom, rows.wall_bottom, look);
    open_behind(scene, state, x, rows, look);
}

void ViewportDrawer::start_wall(const Scene& scene, FrameState& state, int wall_index) {
    wall_index_ = wall_index;
    const WallId id = nearest_.wall(wall_index).wall;
    const Wall& wall = scene.map[id];
    const double light = light_now(scene.snapshot, wall.sector);
    const WallKind kind = kind_now(scene.map, scene.snapshot, id);
    is_portal_ = kind != WallKind::solid;
    masked_ = kNoMasked;
    glow_ = scene.light_on(id);
    if (!is_portal_) {
        middle_.start(scene, wall, picture_now(scene.map, scene.snapshot, id, wall.texture),
                      peg_height(wall.texture.peg, here_, nullptr), light, wall_id(scene.map, id, WallPart::middle));
        middle_.light_up(glow_, wall.length, pose_.eye_z);
        return;
    }
    if (built_in::kMirrors && kind == WallKind::mirror) {
        behind_ = here_;
        upper_open_ = lower_open_ = false;
        return;
    }
    behind_ = heights_above(scene, wall.behind, passage_of(scene, wall).apply_height(pose_.eye_z));
    upper_open_ = !has_upper_step(scene.map, wall);
    lower_open_ = !has_lower_step(wall);
    upper_.start(scene, wall, picture_now(scene.map, scene.snapshot, id, wall.upper),
                 peg_height(wall.upper.peg, here_, &behind_), light, wall_id(scene.map, id, WallPart::upper));
    lower_.start(scene, wall, picture_now(scene.map, scene.snapshot, id, wall.lower),
                 peg_height(wall.lower.peg, here_, &behind_), light, wall_id(scene.map, id, WallPart::lower));
    upper_.light_up(glow_, wall.length, pose_.eye_z);
    lower_.light_up(glow_, wall.length, pose_.eye_z);
    if (built_in::kMasked && wall.middle.texture) start_masked(scene, state, id);
}

/// A fence or window in the portal. Its picture is shown once from top to bottom, hanging from its peg or standing on
/// it; where it scrolls it runs through that place, which itself stays.
void ViewportDrawer::start_masked(const Scene& scene, FrameState& state, WallId id) {
    const Wall& wall = scene.map[id];
    const Surface surface = picture_now(scene.map, scene.snapshot, id, wall.middle);
    const bool stands = surface.peg == Peg::floor || surface.peg == Peg::opening_bottom;
    const double top = peg_height(surface.peg, here_, &behind_) + (stands ? surface.tile_m.y : 0);
    picture_.ceiling = top - wall.middle.offset_tiles.y * surface.tile_m.y;
    picture_.floor = picture_.ceiling - surface.tile_m.y;
    WallPainter painter;
    painter.start(scene, wall, surface, top, light_now(scene.snapshot, wall.sector),
                  wall_id(scene.map, id, WallPart::middle));
    painter.light_up(glow_, wall.length, pose_.eye_z);
    if (wall.scroll.y == 0) painter.show_once();
    masked_ = state.masked.add(painter);
}

bool ViewportDrawer::has_masked() const { return built_in::kMasked && masked_ != kNoMasked; }

void ViewportDrawer::open_behind(const Scene& scene, FrameState& state, int x, const RowSplit& rows,
                                 const WallHit& look) {
    const OpenRows open{upper_open_ ? rows.wall_top : rows.opening_top,
                        lower_open_ ? rows.wall_bottom : rows.opening_bottom};
    if (open.is_closed()) return;
    if (has_masked()) {
        const RowSplit picture = split_rows(scene.screen, open, look.depth, picture_, nullptr);
        state.masked.note(masked_, x, {picture.wall_top, picture.wall_bottom}, look);
    }
    const ProjectedWall& projected = nearest_.wall(wall_index_);
    Opening& opening = openings_[static_cast<std::size_t>(wall_index_)];
    if (opening.state == Opening::State::unknown) {
        opening.viewport = child_of(scene, state, scene.map[projected.wall], projected);
        opening.state = opening.viewport ? Opening::State::open : Opening::State::cut;
    }
    if (opening.state == Opening::State::cut) {
        fill_color(scene.canvas.run(x, open.top, open.bottom), pixel_of(scene.map.render.recursion_color));
        if (scene.facts == nullptr) return;
        for (int y = open.top; y < open.bottom; ++y) note(scene, x, y, kRecursionEnd, kBrightestDepth, 0, 0);
        return;
    }
    opening.viewport->rows_at(x) = open;
    opening.viewport->boundary_at(x) = nearest_.inverse_depth_at(x);
}

/// A viewport for what is seen through the portal, or null where a limit of the frame is reached.
Viewport* ViewportDrawer::child_of(const Scene& scene, FrameState& state, const Wall& wall,
                                   const ProjectedWall& projected) {
    const bool is_link = built_in::kLinks && wall.link != Wall::kNoLink;
    const bool is_spent = viewport_->spent >= kLookBudget;
    if (is_spent || (is_link && pose_.links >= scene.map.render.max_depth)) {
        ++state.cut;
        state.is_cut_short |= is_spent;
        return nullptr;
    }
    Viewport& child =
        state.pool.take(std::max(projected.begin, viewport_->begin), std::min(projected.end, viewport_->end));
    child.sector = wall.behind;
    child.entry = wall.exit;
    child.depth = viewport_->depth + 1;
    child.spent = viewport_->spent + cost_of_look_into(scene.map[wall.behind]);
    child.pose = viewport_->pose;
    if (is_link) {
        child.pose = static_cast<int>(state.poses.size());
        state.poses.push_back(beyond(pose_, passage_of(scene, wall)));
    }
    state.deepest = std::max(state.deepest, child.depth);
    return &child;
}

void ViewportDrawer::push_children(FrameState& state) {
    for (const Opening& opening : openings_)
        if (opening.viewport != nullptr && opening.viewport->trim()) state.stack.push_back(opening.viewport);
}

}  // namespace enfilade::column
