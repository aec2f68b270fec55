#include "render/column/panel_columns.h"

#include <algorithm>

#include "render/picture_now.h"

namespace enfilade::column {

bool PanelColumns::gather(const RoomView& view, MaskedColumns& masked) {
    boards_.clear();
    row_.clear();
    next_ = 0;
    const Sector& sector = view.scene.map[view.viewport.sector];
    for (std::uint32_t i = sector.first_panel; i < sector.first_panel + sector.panel_count; ++i)
        add(view, PanelId(i), masked);
    std::sort(boards_.begin(), boards_.end(), [](const Board& a, const Board& b) {
        return a.place.begin != b.place.begin ? a.place.begin < b.place.begin : a.painter < b.painter;
    });
    return !boards_.empty();
}

void PanelColumns::add(const RoomView& view, PanelId id, MaskedColumns& masked) {
    const Scene& scene = view.scene;
    const Panel& panel = scene.map[id];
    if (!panel.surface.texture) return;
    const Segment seen = facing(panel, view.pose.eye);
    if (panel.one_sided && seen.a != panel.a) return;
    Board board{seen, project(seen, view.pose, scene.screen), {}, 0};
    if (board.place.begin >= view.viewport.end || board.place.end <= view.viewport.begin) return;
    if (board.place.begin >= board.place.end) return;
    if (view.viewport.entry && !is_panel_beyond(seen, scene.map[view.viewport.entry])) return;
    if (seen.a != panel.a) board.place.swapped = !board.place.swapped;
    const double top = panel.top - view.pose.eye_z;
    board.rows = within(view.here, panel.bottom - view.pose.eye_z, top);
    WallPainter painter;
    painter.start_panel(scene, panel, top, light_now(scene.snapshot, panel.sector), panel_id(scene.map, id));
    painter.light_up(scene.light_on(id), panel.length, view.pose.eye_z);
    board.painter = masked.add(painter);
    boards_.push_back(board);
}

/// Of panels on one line the first in the map is the nearer.
bool PanelColumns::is_before(int a, int b) const {
    const Board& one = boards_[static_cast<std::size_t>(a)];
    const Board& other = boards_[static_cast<std::size_t>(b)];
    const bool is_first = one.painter < other.painter;
    const bool nearer = is_nearer(one.facing, other.facing);
    return nearer && (is_first || !is_nearer(other.facing, one.facing));
}

void PanelColumns::move_to(int x) {
    std::erase_if(row_, [&](int board) { return boards_[static_cast<std::size_t>(board)].place.end <= x; });
    for (; next_ < boards_.size() && boards_[next_].place.begin <= x; ++next_) {
        if (boards_[next_].place.end <= x) continue;
        const int board = static_cast<int>(next_);
        const auto nearer_than_it = [&](int other) { return is_before(other, board); };
        row_.insert(std::find_if_not(row_.begin(), row_.end(), nearer_than_it), board);
    }
}

bool PanelColumns::is_before_wall(const RoomView& view, const Board& board, int x) const {
    const Wall& wall = view.scene.map[view.nearest.wall(view.nearest.at(x)).wall];
    const double to_wall = view.nearest.inverse_depth_at(view.scene.screen, x);
    const double to_panel = inverse_depth(board.place, view.scene.screen.slopes[x]);
    return are_telling(to_panel, to_wall) ? to_panel > to_wall : is_nearer(board.facing, wall);
}

std::span<const PanelColumns::Look> PanelColumns::at(const RoomView& view, int x) {
    move_to(x);
    looks_.clear();
    double depth = 0;
    for (const int index : row_) {
        const Board& board = boards_[static_cast<std::size_t>(index)];
        if (!is_before_wall(view, board, x)) break;  // so are those behind it
        Look look{index, hit(board.place, view.scene.screen.slopes[x])};
        depth = look.hit.depth = std::max(depth, look.hit.depth);  // in order whatever rounding did
        looks_.push_back(look);
    }
    return looks_;
}

void PanelColumns::note(const RoomView& view, const Look& look, int x, MaskedColumns& masked) const {
    const Board& board = boards_[static_cast<std::size_t>(look.panel)];
    const RowSplit rows = split_rows(view.scene.screen, view.viewport.rows_at(x), look.hit.depth, board.rows, nullptr);
    masked.note(board.painter, x, {rows.wall_top, rows.wall_bottom}, look.hit);
}

}  // namespace enfilade::column
