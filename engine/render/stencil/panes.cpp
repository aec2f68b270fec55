// Pictures with holes that stand or hang in rooms, and in which order each column meets them.
#include "render/stencil/plan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace enfilade::stencil {
namespace {

/// A picture behind the eye, seen when one looks down past one's feet, has its left end to the right.
WallOnScreen place_of(const SpriteSpan& span, double depth) {
    WallOnScreen place;
    place.left_v = {span.left_v, depth};
    place.right_v = {span.right_v(), depth};
    if (depth < 0) std::swap(place.left_v, place.right_v);
    place.shown_left_v = place.left_v;
    place.shown_right_v = place.right_v;
    place.cross = span.width * std::fabs(depth);
    place.swapped = span.mirrored != (depth < 0);
    return place;
}

}  // namespace

std::optional<ThingOnScreen> in_view(const Map& map, const TextureSet& textures, const Snapshot& snapshot,
                                     const Presence& presence, const Pose& pose, const RelativeHeights& room) {
    const Vec2 to_it = presence.position - pose.eye;
    ThingOnScreen thing;
    thing.depth = dot(pose.forward, to_it);
    if (std::fabs(thing.depth) < kNearestSprite) return {};
    const SpritePicture picture = picture_of(map, textures, snapshot, presence, pose.eye);
    if (!picture.texture) return {};
    thing.place = place_of(span_of(picture, dot(pose.right, to_it), pose.flip), thing.depth);
    thing.thing = presence.thing;
    thing.position = presence.position;
    thing.id = thing_id(map, presence.thing);
    thing.texture = picture.texture;
    thing.lighting = picture.lighting;
    thing.top = picture.foot_z - pose.eye_z + picture.origin_m.y;
    thing.height = picture.size_m.y;
    thing.shown = {std::max(thing.top - thing.height, room.floor), std::min(thing.top, room.ceiling)};
    if (thing.shown.is_empty()) return {};
    return thing;
}

bool put_on_screen(ThingOnScreen& thing, const Screen& screen) {
    if (thing.depth < kNearestSprite) return false;
    const ColumnRays rays{screen.slopes, screen.per_slope()};
    thing.place.begin = first_column_from(thing.place.left_v.x, thing.depth, rays);
    thing.place.end = first_column_from(thing.place.right_v.x, thing.depth, rays);
    return thing.place.begin < thing.place.end;
}

PanelOnScreen in_view(const Map& map, const Snapshot& snapshot, PanelId id, const Pose& pose) {
    const Panel& panel = map[id];
    const Segment seen = facing(panel, pose.eye);
    const RelativeHeights room = heights_of(snapshot, panel.sector, pose.eye_z);
    PanelOnScreen shown{id, in_view(seen, pose), {}};
    if (seen.a != panel.a) shown.place.swapped = !shown.place.swapped;
    shown.shown = {std::max(panel.bottom - pose.eye_z, room.floor), std::min(panel.top - pose.eye_z, room.ceiling)};
    return shown;
}

// What stands in a room, in the order in which each column meets it.

void RoomPanes::note(Layer& layer, const RoomLook& room) {
    find_boards(layer.pose, room);
    if (boards_.empty()) return;
    const ClipWindow& window = room.visit().window;
    run_.clear();
    for (int x = window.begin, begin = window.begin; x <= window.end(); ++x) {
        met_.clear();
        if (x < window.end() && !window.at(x).is_closed() && !is_full(x)) meet(layer.pose, room, x);
        if (met_ == run_) continue;
        add_run(layer, begin, x, room.visit().depth);
        begin = x;
        std::swap(met_, run_);
    }
}

void RoomPanes::find_boards(const Pose& pose, const RoomLook& room) {
    const SectorId home = room.visit().sector;
    const bool is_whole = thing_edges(input_.map.render, false) == ThingEdges::whole;
    const RelativeHeights heights = is_whole ? kNoRoom : heights_of(input_.snapshot, home, pose.eye_z);
    boards_.clear();
    for (const Presence& presence : input_.snapshot.things.in(home)) {
        auto thing = in_view(input_.map, input_.textures, input_.snapshot, presence, pose, heights);
        if (thing && put_on_screen(*thing, screen_)) boards_.push_back({*thing, {{}, {}}, {}, thing->depth});
    }
    things_ = boards_.size();
    std::stable_sort(boards_.begin(), boards_.end(), [](const PaneBoard& a, const PaneBoard& b) {
        return depth_steps(a.depth) < depth_steps(b.depth);
    });
    const Sector& sector = input_.map[home];
    for (std::uint32_t i = sector.first_panel; i < sector.first_panel + sector.panel_count; ++i)
        add_panel(pose, room, PanelId(i));
}

void RoomPanes::add_panel(const Pose& pose, const RoomLook& room, PanelId id) {
    const Panel& panel = input_.map[id];
    if (!panel.surface.texture) return;
    const Segment seen = facing(panel, pose.eye);
    if (panel.one_sided && seen.a != panel.a) return;
    if (room.visit().entry && !is_panel_beyond(seen, input_.map[room.visit().entry])) return;
    PanelOnScreen shown = in_view(input_.map, input_.snapshot, id, pose);
    shown.is_in_doorway = room.visit().entry && are_on_one_line(seen, input_.map[room.visit().entry]);
    if (shown.shown.is_empty() || !put_on_screen(shown.place, pose, screen_)) return;
    boards_.push_back({shown, seen, id, 0});
}

/// Which boards column x meets between the entry to the room and the wall behind, the nearest first.
void RoomPanes::meet(const Pose& pose, const RoomLook& room, int x) {
    const double slope = screen_.slopes[static_cast<std::size_t>(x)];
    meet_panels(room, x);
    std::size_t thing = 0;
    const auto meet_things = [&](std::int64_t until) {
        for (; thing < things_ && depth_steps(boards_[thing].depth) <= until; ++thing) {
            const WallOnScreen& place = place_of(boards_[thing].pane);
            const bool covers = x >= place.begin && x < place.end;
            if (covers && is_met(pose, room, boards_[thing], x)) add_met(thing, x);
        }
    };
    double depth = 0;
    for (const std::size_t panel : met_panels_) {
        depth = std::max(depth, 1 / place_of(boards_[panel].pane).inverse_depth(slope));  // in order despite rounding
        meet_things(depth_steps(depth));
        add_met(panel, x);
    }
    meet_things(std::numeric_limits<std::int64_t>::max());
}

void RoomPanes::add_met(std::size_t board, int x) {
    if (pass(x)) met_.push_back(board);
}

bool RoomPanes::is_met(const Pose& pose, const RoomLook& room, const PaneBoard& thing, int x) const {
    const WallId entry = room.visit().entry, exit = room.nearest_at(x);
    const double slope = screen_.slopes[static_cast<std::size_t>(x)];
    const double from = entry ? 1 / room.visit().doorway.inverse_depth(slope) : 0, to = 1 / room.inverse_depth_at(x);
    const std::int64_t steps = depth_steps(thing.depth);
    const RoomCrossing crossing{entry, exit, depth_steps(from) > steps, depth_steps(to) > steps};
    if (exit.is_none() || thing_edges(input_.map.render, false) == ThingEdges::cut) return crossing.holds_thing();
    const Vec2 place = std::get<ThingOnScreen>(thing.pane).position;
    return is_seen_in(input_.map, input_.snapshot, {pose.eye, pose.forward, place, thing.depth}, crossing);
}

void RoomPanes::meet_panels(const RoomLook& room, int x) {
    met_panels_.clear();
    for (std::size_t i = things_; i < boards_.size(); ++i) {
        const WallOnScreen& place = place_of(boards_[i].pane);
        if (x < place.begin || x >= place.end || !is_before_wall(room, boards_[i], x)) continue;
        const auto nearer_than_it = [&](std::size_t other) { return is_before(boards_[other], boards_[i]); };
        met_panels_.insert(std::partition_point(met_panels_.begin(), met_panels_.end(), nearer_than_it), i);
    }
}

/// Of panels on one line the first in the map is the nearer.
bool RoomPanes::is_before(const PaneBoard& a, const PaneBoard& b) const {
    return is_nearer(a.facing, b.facing) && (a.panel < b.panel || !is_nearer(b.facing, a.facing));
}

bool RoomPanes::is_before_wall(const RoomLook& room, const PaneBoard& panel, int x) const {
    const WallId wall = room.nearest_at(x);
    if (wall.is_none()) return true;
    const double to_wall = room.inverse_depth_at(x);
    const double slope = screen_.slopes[static_cast<std::size_t>(x)];
    const double to_panel = place_of(panel.pane).inverse_depth(slope);
    const double doubt = place_of(panel.pane).doubt(slope) + room.doubt_at(x);
    return are_telling(to_panel, to_wall, doubt) ? to_panel > to_wall : is_nearer(panel.facing, input_.map[wall]);
}

/// The boards of run_ in the columns [begin, end), in which all of them are met.
void RoomPanes::add_run(Layer& layer, int begin, int end, int rank) {
    for (const std::size_t board : run_)
        for (const WallOnScreen& part : parts_of_run(place_of(boards_[board].pane), layer.pose, screen_, begin, end)) {
            layer.panes.push_back(boards_[board].pane);
            WallOnScreen& place = place_of(layer.panes.back());
            place = part;
            place.rank = rank;
            place.is_pane = true;
        }
}

}  // namespace enfilade::stencil
