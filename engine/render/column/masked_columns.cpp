#include "render/column/viewport_drawer.h"

#include <algorithm>

#include "render/built_in.h"
#include "render/sprite.h"

namespace enfilade::column {

void MaskedColumns::clear(int width) {
    painters_.clear();
    for (std::vector<MaskedColumn>& layer : layers_) layer.clear();
    noted_.assign(static_cast<std::size_t>(width), 0);
}

int MaskedColumns::add(const WallPainter& painter) {
    painters_.push_back(painter);
    return static_cast<int>(painters_.size()) - 1;
}

void MaskedColumns::note(int painter, int x, OpenRows rows, const WallHit& hit) {
    if (is_full(x)) return;
    const std::size_t layer = noted_[static_cast<std::size_t>(x)]++;
    if (rows.is_closed()) return;
    if (layer >= layers_.size()) layers_.resize(layer + 1);
    layers_[layer].push_back({painter, x, rows, hit});
}

std::size_t MaskedColumns::count() const {
    std::size_t columns = 0;
    for (const std::vector<MaskedColumn>& layer : layers_) columns += layer.size();
    return columns;
}

void MaskedColumns::draw(const ColumnScene& scene) const {
    for (auto layer = layers_.rbegin(); layer != layers_.rend(); ++layer)
        for (std::size_t i = 0; i < layer->size();) i = draw_neighbours(scene, *layer, i);
}

/// Draws those side by side of one picture, from the i-th on. Returns the number of the next one.
std::size_t MaskedColumns::draw_neighbours(const ColumnScene& scene, const std::vector<MaskedColumn>& layer,
                                           std::size_t i) const {
    const MaskedColumn& first = layer[i];
    WallLooks looks;
    int tops[WallLooks::kMost], bottoms[WallLooks::kMost];
    looks.begin = first.x;
    const auto goes_on = [&](const MaskedColumn& next) {
        return looks.count < WallLooks::kMost && next.painter == first.painter && next.x == first.x + looks.count;
    };
    for (; i < layer.size() && goes_on(layer[i]); ++i, ++looks.count) {
        const MaskedColumn& column = layer[i];
        looks.depth[looks.count] = column.hit.depth;
        looks.along[looks.count] = column.hit.along;
        looks.farthest = std::max(looks.farthest, column.hit.depth);
        tops[looks.count] = column.rows.top;
        bottoms[looks.count] = column.rows.bottom;
    }
    painters_[static_cast<std::size_t>(first.painter)].lay_over(scene, looks, tops, bottoms);
    return i;
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

/// Panels and walls cross nowhere: which is the nearer is the same in all columns that they share. In the middle of
/// those inverse depths mostly tell; where they do not, the ends do.
bool PanelColumns::is_before_wall(const RoomView& view, const PanelBoard& board, const WallColumns& shared) const {
    const ProjectedWall& wall = view.nearest.wall(shared.wall);
    const double slope = view.scene.screen.slopes[static_cast<std::size_t>((shared.begin + shared.end) / 2)];
    const double to_wall = inverse_depth_seen(wall, slope), to_panel = inverse_depth(board.place, slope);
    const double doubt = inverse_depth_doubt(board.place, slope) + inverse_depth_doubt(wall, slope);
    return are_telling(to_panel, to_wall, doubt) ? to_panel > to_wall
                                                 : is_nearer(board.facing, view.scene.map[wall.wall]);
}

int PanelColumns::look(const RoomView& view, const WallColumns& columns) {
    move_to(columns.begin);
    WallColumns shared = columns;
    if (next_ < boards_.size()) shared.end = std::min(shared.end, boards_[next_].place.begin);
    for (const int index : row_) shared.end = std::min(shared.end, boards_[static_cast<std::size_t>(index)].place.end);
    shown_count_ = 0;
    for (const int index : row_) {
        const PanelBoard& board = boards_[static_cast<std::size_t>(index)];
        if (shown_count_ == kMostPictures || !is_before_wall(view, board, shared)) break;  // so are those behind it
        show(view, index, shared);
    }
    return shared.end;
}

void PanelColumns::show(const RoomView& view, int index, const WallColumns& shared) {
    if (shown_count_ == shown_.size()) shown_.emplace_back();
    PanelLooks& shown = shown_[shown_count_++];
    shown.panel = index;
    const PanelBoard& board = boards_[static_cast<std::size_t>(index)];
    look_at(board.place, board.facing, view.pose, view.scene.screen, shared.begin, shared.end - shared.begin,
            shown.looks);
}

void PanelColumns::note(const RoomView& view, const PanelLooks& shown, int x, MaskedColumns& masked) {
    if (masked.is_full(x)) return;
    PanelBoard& board = boards_[static_cast<std::size_t>(shown.panel)];
    if (board.painter == MaskedColumns::kNotAdded) board.painter = painter_of(view, board, masked);
    const int i = x - shown.looks.begin;
    const RowSplit rows =
        split_rows(RowsAt(view.scene.screen, shown.looks, i), view.viewport.rows_at(x), board.rows, nullptr);
    masked.note(board.painter, x, {rows.wall_top, rows.wall_bottom}, shown.looks.at(i));
}

bool ThingColumns::is_nearer(const ThingBoard& a, const ThingBoard& b) {
    return a.steps != b.steps ? a.steps < b.steps : a.number < b.number;
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
    board.span = span_of(picture, dot(view.pose.right, to_it), view.pose.flip);
    const ColumnRays rays{scene.screen.slopes, scene.screen.column_scale};
    board.begin = std::max(view.viewport.begin, first_column_from(board.span.left_v, board.depth, rays));
    board.end = std::min(view.viewport.end, first_column_from(board.span.right_v(), board.depth, rays));
    if (board.begin >= board.end) return;
    board.top = picture.foot_z - view.pose.eye_z + picture.origin_m.y;
    board.steps = depth_steps(board.depth);
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

RayDepth ThingColumns::depth_of_entry(const RoomView& view, int x) {
    const Doorway& doorway = view.viewport.doorway;
    if (doorway.missed_depth) return {*doorway.missed_depth};
    const Pose& pose = view.poses[static_cast<std::size_t>(doorway.pose)];
    return exact_depth(view.scene.map[doorway.wall], pose, view.scene.screen, x);
}

bool ThingColumns::is_entry_farther(const RoomView& view, const ThingBoard& board, int x) {
    if (view.viewport.entry.is_none()) return false;
    const double nearness = view.viewport.boundary_at(x) * border_after(board.steps);
    if (std::fabs(nearness - 1) > 2 * kDepthDoubt) return nearness < 1;
    return is_farther(depth_of_entry(view, x), board.steps);
}

bool ThingColumns::is_exit_farther(const RoomView& view, const ThingBoard& board, const ProjectedWall& wall, int x) {
    const RayTables& screen = view.scene.screen;
    if (wall.stands_in) return is_farther(RayDepth{wall.nearest}, board.steps);
    const double span = edge_span(wall, screen.slopes[static_cast<std::size_t>(x)]);
    const double beyond = wall.cross - span * border_after(board.steps);
    if (span >= wall.sure_span && std::fabs(beyond) > 2 * kDepthDoubt * wall.cross) return beyond > 0;
    return is_farther(exact_depth(view.scene.map[wall.wall], view.pose, screen, x), board.steps);
}

bool ThingColumns::is_met(const RoomView& view, const ThingBoard& board, int x) {
    const ColumnScene& scene = view.scene;
    const ProjectedWall& exit = view.nearest.wall(view.nearest.at(x));
    const RoomCrossing room{view.viewport.entry, exit.wall, is_entry_farther(view, board, x),
                            is_exit_farther(view, board, exit, x)};
    if (thing_edges(scene.map.render, false) == ThingEdges::cut) return room.holds_thing();
    return is_seen_in(scene.map, scene.snapshot, {view.pose.eye, view.pose.forward, board.place, board.depth}, room);
}

void ThingColumns::note(const RoomView& view, std::size_t i, int x, MaskedColumns& masked) {
    ThingBoard& board = boards_[i];
    const OpenRows open = view.viewport.rows_at(x);
    if (x < board.begin || x >= board.end || open.is_closed() || masked.is_full(x)) return;
    if (!is_met(view, board, x)) return;
    const double met_x_v = view.scene.screen.slopes[static_cast<std::size_t>(x)] * board.depth;
    if (board.painter == MaskedColumns::kNotAdded) board.painter = painter_of(view, board, masked);
    const WallHit hit{board.depth, std::clamp(board.span.along(met_x_v), 0.0, kLastPlace)};
    const RowSplit rows = split_rows(RowsAt(view.scene.screen, board.depth), open, board.rows, nullptr);
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
    for (const WallColumns& stretch : view.nearest.stretches())
        for (int x = stretch.begin; x < stretch.end;) x = note_some(view, {x, stretch.end, stretch.wall}, masked);
}

/// Notes the first of the columns, and with them as many as see the same panels. Returns the first that is left.
/// What a closed column would see is not looked for: hostile maps have many of them.
int RoomColumns::note_some(const RoomView& view, const WallColumns& columns, MaskedColumns& masked) {
    const int most = std::min(columns.end, columns.begin + WallLooks::kMost);
    int closed = columns.begin;
    while (closed < most && !view.viewport.rows_at(closed).is_closed()) ++closed;
    if (closed == columns.begin) return columns.begin + 1;
    const int end = panels_.look(view, {columns.begin, closed, columns.wall});
    for (int x = columns.begin; x < end; ++x) note_column(view, x, masked);
    return end;
}

void RoomColumns::note_column(const RoomView& view, int x, MaskedColumns& masked) {
    std::size_t thing = 0;
    for (const PanelColumns::PanelLooks& panel : panels_.shown()) {
        if (masked.is_full(x)) return;
        const int i = x - panel.looks.begin;
        const auto sure = sure_depth_steps(panel.looks.depth[i]);
        const std::int64_t steps = sure ? *sure : depth_steps(panel.looks.exact_depth(i));
        for (; thing < things_.count() && things_.steps(thing) <= steps; ++thing) things_.note(view, thing, x, masked);
        panels_.note(view, panel, x, masked);
    }
    for (; thing < things_.count(); ++thing) things_.note(view, thing, x, masked);
}

}  // namespace enfilade::column
