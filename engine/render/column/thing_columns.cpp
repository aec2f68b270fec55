#include "render/column/thing_columns.h"

#include <algorithm>
#include <cmath>

namespace enfilade::column {
namespace {

/// A position on a picture ends before its right edge, where its left edge would begin again.
constexpr double kBelowOne = 1 - 0x1p-53;

/// The first column whose ray passes, at this depth, at x_v or to the right of it; the picture's width if none does.
/// The division only guesses.
int first_column_from(const Screen& screen, double x_v, double depth) {
    const auto is_from = [&](int x) { return screen.slopes[x] * depth >= x_v; };
    const double guess = std::ceil(x_v / depth * screen.column_scale + 0.5 * (screen.width - 1));
    int x = !(guess > 0) ? 0 : guess >= screen.width ? screen.width : static_cast<int>(guess);
    while (x > 0 && is_from(x - 1)) --x;
    while (x < screen.width && !is_from(x)) ++x;
    return x;
}

/// The part of the picture between the room's floor and ceiling.
RelativeHeights within(const RelativeHeights& room, double bottom, double top) {
    return {std::max(bottom, room.floor), std::min(top, room.ceiling)};
}

}  // namespace

bool ThingColumns::is_nearer(const Board& a, const Board& b) {
    const std::int64_t a_steps = depth_steps(a.depth), b_steps = depth_steps(b.depth);
    return a_steps != b_steps ? a_steps < b_steps : a.painter < b.painter;
}

void ThingColumns::note(const ThingsView& view, MaskedColumns& masked) {
    const auto things = view.scene.snapshot.things.in(view.viewport.sector);
    if (things.empty()) return;
    boards_.clear();
    for (const Presence& presence : things) add(view, presence, masked);
    // All of a picture has one depth, so the order is the same in all columns; of equals the first is the nearer one.
    std::sort(boards_.begin(), boards_.end(), is_nearer);
    for (const Board& board : boards_) note_board(view, board, masked);
}

void ThingColumns::add(const ThingsView& view, const Presence& presence, MaskedColumns& masked) {
    const Scene& scene = view.scene;
    const Vec2 to_it = presence.position - view.pose.eye;
    Board board;
    board.depth = dot(view.pose.forward, to_it);
    if (board.depth < kNearestSprite) return;
    const SpritePicture picture = picture_of(scene.map, scene.textures, scene.snapshot, presence, view.pose.eye);
    if (!picture.texture) return;
    board.width = picture.size_m.x;
    board.mirrored = view.pose.flip < 0;
    const double left_of_it = board.mirrored ? board.width - picture.origin_m.x : picture.origin_m.x;
    board.left_v = dot(view.pose.right, to_it) - left_of_it;
    board.begin = std::max(view.viewport.begin, first_column_from(scene.screen, board.left_v, board.depth));
    board.end = std::min(view.viewport.end, first_column_from(scene.screen, board.left_v + board.width, board.depth));
    if (board.begin >= board.end) return;
    const double top = picture.foot_z - view.pose.eye_z + picture.origin_m.y;
    board.rows = within(view.here, top - picture.size_m.y, top);
    WallPainter painter;
    painter.start_picture(scene, scene.textures[picture.texture], top, picture.size_m.y, picture.light,
                          thing_id(scene.map, presence.thing));
    board.painter = masked.add(painter);
    boards_.push_back(board);
}

void ThingColumns::note_board(const ThingsView& view, const Board& board, MaskedColumns& masked) const {
    for (int x = board.begin; x < board.end; ++x) {
        const OpenRows open = view.viewport.rows_at(x);
        if (open.is_closed()) continue;
        const double entry = 1 / view.viewport.boundary_at(x), exit = 1 / view.nearest.inverse_depth_at(x);
        if (!is_met_between(board.depth, entry, exit)) continue;
        const double from_left = (view.scene.screen.slopes[x] * board.depth - board.left_v) / board.width;
        const WallHit hit{board.depth, std::clamp(board.mirrored ? 1 - from_left : from_left, 0.0, kBelowOne)};
        const RowSplit rows = split_rows(view.scene.screen, open, board.depth, board.rows, nullptr);
        masked.note(board.painter, x, {rows.wall_top, rows.wall_bottom}, hit);
    }
}

}  // namespace enfilade::column
