#include "render/column/viewport_drawer.h"

#include <algorithm>

#include "render/built_in.h"
#include "render/sprite.h"

namespace enfilade::column {

void MaskedColumns::clear(int width) {
    painters_.clear();
    columns_.clear();
    noted_.assign(static_cast<std::size_t>(width), 0);
}

int MaskedColumns::add(const WallPainter& painter) {
    painters_.push_back(painter);
    return static_cast<int>(painters_.size()) - 1;
}

void MaskedColumns::draw(const ColumnScene& scene) const {
    for (auto column = columns_.rbegin(); column != columns_.rend(); ++column)
        painters_[static_cast<std::size_t>(column->painter)].lay_over(scene, column->x, column->rows.top,
                                                                      column->rows.bottom, column->hit);
}

bool PanelColumns::gather(const RoomView& view) {
    boards_.clear();
    row_.clear();
    next_ = 0;
    const Sector& sector = view.scene.map[view.viewport.sector];
    for (std::uint32_t i = sector.first_panel; i < sector.first_panel + sector.panel_count; ++i) add(view, PanelId(i));
    std::sort(boards_.begin(), boards_.end(), [](const PanelBoard& a, const PanelBoard& b) {
        return a.place.begin != b.place.begin ? a.place.begin < b.place.begin : a.panel < b.panel;
    });
    return !boards_.empty();
}

void PanelColumns::add(const RoomView& view, PanelId id) {
    const ColumnScene& scene = view.scene;
    const Panel& panel = scene.map[id];
    if (!panel.surface.texture) return;
    const Segment seen = facing(panel, view.pose.eye);
    if (panel.one_sided && seen.a != panel.a) return;
    PanelBoard board{seen, project(seen, view.pose, scene.screen), {}, id};
    if (board.place.begin >= view.viewport.end || board.place.end <= view.viewport.begin) return;
    if (board.place.begin >= board.place.end) return;
    if (view.viewport.entry && !is_panel_beyond(seen, scene.map[view.viewport.entry])) return;
    if (seen.a != panel.a) board.place.swapped = !board.place.swapped;
    board.rows = within(view.here, panel.bottom - view.pose.eye_z, panel.top - view.pose.eye_z);
    if (board.rows.is_empty()) return;
    boards_.push_back(board);
}

int PanelColumns::painter_of(const RoomView& view, const PanelBoard& board, MaskedColumns& masked) {
    const ColumnScene& scene = view.scene;
    const Panel& panel = scene.map[board.panel];
    WallPainter painter;
    painter.start_panel(scene, panel, panel.top - view.pose.eye_z, light_now(scene.snapshot, panel.sector),
                        panel_id(scene.map, board.panel));
    painter.light_up(scene.light_on(board.panel), panel.length, view.pose.eye_z);
    return masked.add(painter);
}

/// Of panels on one line the first in the map is the nearer.
bool PanelColumns::is_before(int a, int b) const {
    const PanelBoard& one = boards_[static_cast<std::size_t>(a)];
    const PanelBoard& other = boards_[static_cast<std::size_t>(b)];
    const bool is_first = one.panel < other.panel;
    const bool nearer = is_nearer(one.facing, other.facing);
    return nearer && (is_first || !is_nearer(other.facing, one.facing));
}

void PanelColumns::move_to(int x) {
    std::erase_if(row_, [&](int board) { return boards_[static_cast<std::size_t>(board)].place.end <= x; });
    for (; next_ < boards_.size() && boards_[next_].place.begin <= x; ++next_) {
        if (boards_[next_].place.end <= x) continue;
        const int board = static_cast<int>(next_);
        const auto nearer_than_it = [&](int other) { return is_before(other, board); };
        row_.insert(std::partition_point(row_.begin(), row_.end(), nearer_than_it), board);
    }
}

bool PanelColumns::is_before_wall(const RoomView& view, const PanelBoard& board, int x) const {
    const ProjectedWall& wall = view.nearest.wall(view.nearest.at(x));
    const double slope = view.scene.screen.slopes[x];
    const double to_wall = view.nearest.inverse_depth_at(view.scene.screen, x);
    const double to_panel = inverse_depth(board.place, slope);
    const double doubt = inverse_depth_doubt(board.place, slope) + inverse_depth_doubt(wall, slope);
    return are_telling(to_panel, to_wall, doubt) ? to_panel > to_wall
                                                 : is_nearer(board.facing, view.scene.map[wall.wall]);
}

std::span<const PanelColumns::PanelColumn> PanelColumns::at(const RoomView& view, int x) {
    move_to(x);
    shown_.clear();
    double depth = 0;
    for (const int index : row_) {
        const PanelBoard& board = boards_[static_cast<std::size_t>(index)];
        if (shown_.size() == kMostPictures || !is_before_wall(view, board, x)) break;  // so are those behind it
        PanelColumn shown{index, hit(board.place, view.scene.screen.slopes[x])};
        depth = shown.hit.depth = std::max(depth, shown.hit.depth);  // in order whatever rounding did
        shown_.push_back(shown);
    }
    return shown_;
}

void PanelColumns::note(const RoomView& view, const PanelColumn& shown, int x, MaskedColumns& masked) {
    if (masked.is_full(x)) return;
    PanelBoard& board = boards_[static_cast<std::size_t>(shown.panel)];
    if (board.painter == MaskedColumns::kNotAdded) board.painter = painter_of(view, board, masked);
    const RowSplit rows = split_rows(view.scene.screen, view.viewport.rows_at(x), shown.hit.depth, board.rows, nullptr);
    masked.note(board.painter, x, {rows.wall_top, rows.wall_bottom}, shown.hit);
}

bool ThingColumns::is_nearer(const ThingBoard& a, const ThingBoard& b) {
    const std::int64_t a_steps = depth_steps(a.depth), b_steps = depth_steps(b.depth);
    return a_steps != b_steps ? a_steps < b_steps : a.number < b.number;
}

bool ThingColumns::gather(const RoomView& view) {
    boards_.clear();
    for (const Presence& presence : view.scene.snapshot.things.in(view.viewport.sector)) add(view, presence);
    std::sort(boards_.begin(), boards_.end(), is_nearer);  // of equals the first is the nearer one
    return !boards_.empty();
}

/// Whether no picture of the thing gets into the viewport, or so far that a column's width of rounding were between: a
/// narrow look into a crowd asks for hardly any of its pictures.
bool ThingColumns::is_aside(const RoomView& view, const Presence& presence, double depth, double aside) {
    const ColumnScene& scene = view.scene;
    const double reach = scene.map[scene.map[presence.thing].sprite].reach_m;
    const int before = view.viewport.begin - 1, behind = view.viewport.end;
    return (before >= 0 && aside + reach < scene.screen.slopes[before] * depth) ||
           (behind < scene.screen.width && aside - reach > scene.screen.slopes[behind] * depth);
}

void ThingColumns::add(const RoomView& view, const Presence& presence) {
    const ColumnScene& scene = view.scene;
    const Vec2 to_it = presence.position - view.pose.eye;
    ThingBoard board;
    board.depth = dot(view.pose.forward, to_it);
    if (board.depth < kNearestSprite || is_aside(view, presence, board.depth, dot(view.pose.right, to_it))) return;
    const SpritePicture picture = picture_of(scene.map, scene.textures, scene.snapshot, presence, view.pose.eye);
    if (!picture.texture) return;
    board.width = picture.size_m.x;
    board.mirrored = (view.pose.flip < 0) != picture.is_mirrored;
    const double left_of_it = board.mirrored ? board.width - picture.origin_m.x : picture.origin_m.x;
    board.left_v = dot(view.pose.right, to_it) - left_of_it;
    const ColumnRays rays{scene.screen.slopes, scene.screen.column_scale};
    board.begin = std::max(view.viewport.begin, first_column_from(board.left_v, board.depth, rays));
    board.end = std::min(view.viewport.end, first_column_from(board.left_v + board.width, board.depth, rays));
    if (board.begin >= board.end) return;
    board.top = picture.foot_z - view.pose.eye_z + picture.origin_m.y;
    board.rows = {board.top - picture.size_m.y, board.top};
    const bool is_whole = thing_edges(scene.map.render, false) == ThingEdges::whole;
    if (!is_whole) board.rows = within(view.here, board.rows.floor, board.rows.ceiling);
    if (board.rows.is_empty()) return;
    board.picture = picture;
    board.thing = presence.thing;
    board.place = presence.position;
    board.number = boards_.size();
    boards_.push_back(board);
}

int ThingColumns::painter_of(const RoomView& view, const ThingBoard& board, MaskedColumns& masked) {
    const ColumnScene& scene = view.scene;
    WallPainter painter;
    painter.start_picture(scene, scene.textures[board.picture.texture], board.top, board.picture.size_m.y,
                          board.picture.lighting, thing_id(scene.map, board.thing));
    painter.light_up(scene.light_on(board.thing), 0, 0);  // the same everywhere
    return masked.add(painter);
}

bool ThingColumns::is_met(const RoomView& view, const ThingBoard& board, int x) {
    const ColumnScene& scene = view.scene;
    const double entry = 1 / view.viewport.boundary_at(x),
                 exit = 1 / view.nearest.inverse_depth_at(view.scene.screen, x);
    if (thing_edges(scene.map.render, false) == ThingEdges::cut) return is_met_between(board.depth, entry, exit);
    const WallId wall = view.nearest.wall(view.nearest.at(x)).wall;
    return is_seen_in(scene.map, scene.snapshot, {view.pose.eye, view.pose.forward, board.place, board.depth},
                      {view.viewport.entry, wall, entry, exit});
}

void ThingColumns::note(const RoomView& view, std::size_t i, int x, MaskedColumns& masked) {
    ThingBoard& board = boards_[i];
    const OpenRows open = view.viewport.rows_at(x);
    if (x < board.begin || x >= board.end || open.is_closed() || masked.is_full(x)) return;
    if (!is_met(view, board, x)) return;
    const double from_left = (view.scene.screen.slopes[x] * board.depth - board.left_v) / board.width;
    if (board.painter == MaskedColumns::kNotAdded) board.painter = painter_of(view, board, masked);
    const WallHit hit{board.depth, std::clamp(board.mirrored ? 1 - from_left : from_left, 0.0, kLastPlace)};
    const RowSplit rows = split_rows(view.scene.screen, open, board.depth, board.rows, nullptr);
    masked.note(board.painter, x, {rows.wall_top, rows.wall_bottom}, hit);
}

void ThingColumns::note_all(const RoomView& view, MaskedColumns& masked) {
    for (std::size_t i = 0; i < boards_.size(); ++i)
        for (int x = boards_[i].begin; x < boards_[i].end; ++x) note(view, i, x, masked);
}

void RoomColumns::note(const RoomView& view, MaskedColumns& masked) {
    const bool has_things = built_in::kThings && things_.gather(view);
    if (!built_in::kPanels || !panels_.gather(view)) {
        if (has_things) things_.note_all(view, masked);
        return;
    }
    // A panel may be before a thing in one column and behind it in the next.
    for (int x = view.viewport.begin; x < view.viewport.end; ++x)
        if (!view.viewport.rows_at(x).is_closed()) note_column(view, x, masked);
}

void RoomColumns::note_column(const RoomView& view, int x, MaskedColumns& masked) {
    std::size_t thing = 0;
    for (const PanelColumns::PanelColumn& panel : panels_.at(view, x)) {
        if (masked.is_full(x)) return;
        for (; thing < things_.count() && depth_steps(things_.depth(thing)) <= depth_steps(panel.hit.depth); ++thing)
            things_.note(view, thing, x, masked);
        panels_.note(view, panel, x, masked);
    }
    for (; thing < things_.count(); ++thing) things_.note(view, thing, x, masked);
}

}  // namespace enfilade::column
