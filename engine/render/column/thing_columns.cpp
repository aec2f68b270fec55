#include "render/column/thing_columns.h"

#include <algorithm>

namespace enfilade::column {
bool ThingColumns::is_nearer(const Board& a, const Board& b) {
    const std::int64_t a_steps = depth_steps(a.depth), b_steps = depth_steps(b.depth);
    return a_steps != b_steps ? a_steps < b_steps : a.painter < b.painter;
}

bool ThingColumns::gather(const RoomView& view, MaskedColumns& masked) {
    boards_.clear();
    for (const Presence& presence : view.scene.snapshot.things.in(view.viewport.sector)) add(view, presence, masked);
    std::sort(boards_.begin(), boards_.end(), is_nearer);  // of equals the first is the nearer one
    return !boards_.empty();
}

void ThingColumns::add(const RoomView& view, const Presence& presence, MaskedColumns& masked) {
    const Scene& scene = view.scene;
    const Vec2 to_it = presence.position - view.pose.eye;
    Board board;
    board.depth = dot(view.pose.forward, to_it);
    if (board.depth < kNearestSprite) return;
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
    const double top = picture.foot_z - view.pose.eye_z + picture.origin_m.y;
    const bool is_whole = thing_edges(scene.map.render, false) == ThingEdges::whole;
    board.rows = {top - picture.size_m.y, top};
    if (!is_whole) board.rows = within(view.here, board.rows.floor, board.rows.ceiling);
    board.place = presence.position;
    WallPainter painter;
    painter.start_picture(scene, scene.textures[picture.texture], top, picture.size_m.y, picture.lighting,
                          thing_id(scene.map, presence.thing));
    painter.light_up(scene.light_on(presence.thing), 0, 0);  // the same everywhere
    board.painter = masked.add(painter);
    boards_.push_back(board);
}

bool ThingColumns::is_met(const RoomView& view, const Board& board, int x) {
    const Scene& scene = view.scene;
    const double entry = 1 / view.viewport.boundary_at(x),
                 exit = 1 / view.nearest.inverse_depth_at(view.scene.screen, x);
    if (thing_edges(scene.map.render, false) == ThingEdges::cut) return is_met_between(board.depth, entry, exit);
    const WallId wall = view.nearest.wall(view.nearest.at(x)).wall;
    return is_seen_in(scene.map, scene.snapshot, {view.pose.eye, view.pose.forward, board.place, board.depth},
                      {view.viewport.entry, wall, entry, exit});
}

void ThingColumns::note(const RoomView& view, std::size_t i, int x, MaskedColumns& masked) const {
    const Board& board = boards_[i];
    const OpenRows open = view.viewport.rows_at(x);
    if (x < board.begin || x >= board.end || open.is_closed()) return;
    if (!is_met(view, board, x)) return;
    const double from_left = (view.scene.screen.slopes[x] * board.depth - board.left_v) / board.width;
    const WallHit hit{board.depth, std::clamp(board.mirrored ? 1 - from_left : from_left, 0.0, kLastPlace)};
    const RowSplit rows = split_rows(view.scene.screen, open, board.depth, board.rows, nullptr);
    masked.note(board.painter, x, {rows.wall_top, rows.wall_bottom}, hit);
}

void ThingColumns::note_all(const RoomView& view, MaskedColumns& masked) const {
    for (std::size_t i = 0; i < boards_.size(); ++i)
        for (int x = boards_[i].begin; x < boards_[i].end; ++x) note(view, i, x, masked);
}

}  // namespace enfilade::column
