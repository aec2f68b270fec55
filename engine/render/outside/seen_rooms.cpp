#include "render/outside/outside_renderer.h"

#include <algorithm>
#include <cmath>

#include "math/predicates.h"
#include "math/vec.h"
#include "render/openings.h"

namespace enfilade {
namespace {

/// The view with its horizon shifted instead of its picture turned.
View upright(View view) {
    if (!view.tilt) return view;
    constexpr double kSteepest = 8;  // steeper than any sheared picture that one would look at [1]
    const Vec2 pitch = view.tilt->pitch;
    view.pitch_tangent =
        pitch.x * kSteepest <= std::fabs(pitch.y) ? std::copysign(kSteepest, pitch.y) : pitch.y / pitch.x;
    view.tilt.reset();
    return view;
}

/// Between what heights one sees through, in those of the wall's own sector.
Heights open_heights(const Map& map, const Snapshot& snapshot, const Wall& wall) {
    Heights open = heights_at(snapshot, wall.sector);
    if (wall.kind == WallKind::mirror) return open;
    const Heights behind = heights_at(snapshot, wall.behind);
    const double rise = map.passage(wall).rise;
    if (has_lower_step(map, wall)) open.floor_z = std::max(open.floor_z, behind.floor_z - rise);
    if (has_upper_step(map, wall)) open.ceiling_z = std::min(open.ceiling_z, behind.ceiling_z - rise);
    return open;
}

/// The look as it goes on after a mirror; none where rounding lets it miss the mirror.
std::optional<PathSegment> segment_in_mirror(const Map& map, const PathSegment& segment, WallId mirror) {
    const Wall& wall = map[mirror];
    const Rigid passage = map.passage(wall);
    const Vec2 from = snap_to_point_grid(passage.apply(segment.from)),
               to = snap_to_point_grid(passage.apply(segment.to));
    if (!comes_in_through(wall, from, to)) return {};
    return PathSegment{wall.sector, from, to, mirror};
}

SectorId sector_behind(const Wall& wall) { return wall.kind == WallKind::mirror ? wall.sector : wall.behind; }

}  // namespace

void SeenRooms::look(const Map& map, const Snapshot& snapshot, const View& view, int width, int height) {
    view_ = upright(view);
    const Projection projection(view_, width, height);
    half_fov_tangent_ = projection.half_fov_tangent();
    middle_column_ = projection.middle_column();
    lowest_ = projection.climb(height - 1);
    highest_ = projection.climb(0);
    rooms_.clear(), first_behind_.clear(), behind_.clear(), parts_.clear();
    slopes_.resize(static_cast<std::size_t>(width));
    first_.assign(1, 0);
    find_or_add(map, {view.sector, {}});
    for (int x = 0; x < width; ++x) {
        slopes_[static_cast<std::size_t>(x)] = projection.slope(x);
        follow(map, snapshot, x);
        first_.push_back(parts_.size());
    }
}

void SeenRooms::follow(const Map& map, const Snapshot& snapshot, int column) {
    const double slope = slopes_[static_cast<std::size_t>(column)];
    const Vec2 way = view_.forward + right_of(view_.forward) * (slope * view_.flip);
    const double farthest = kWorldLimit / std::sqrt(1 + slope * slope);  // so that the end is where points may be [m]
    PathSegment segment{view_.sector, view_.eye, snap_to_point_grid(view_.eye + way * farthest), {}};
    SeenPart part{0, {}, 0, lowest_, highest_};
    double begin = 0;  // of the segment, in parts of the whole look
    int links = 0;
    for (std::uint32_t spent = 0; spent < kLookBudget; spent += cost_of_look_into(map[segment.sector], 0)) {
        part.exit = way_out(map, segment);
        const double met =
            part.exit ? fraction_along_path(segment.from, segment.to, map[part.exit].a, map[part.exit].b).value() : 1;
        const double at = begin + (1 - begin) * met;
        part.exit_depth = at * farthest;
        parts_.push_back(part);
        if (!part.exit || kind_now(map, snapshot, part.exit) == WallKind::solid) return;
        if (map[part.exit].link != Wall::kNoLink && ++links > map.render.max_depth) return;
        const auto next = go_on(map, snapshot, segment, part);
        if (!next) return;
        segment = *next;
        if (segment.hop) begin = at;
    }
}

std::optional<PathSegment> SeenRooms::go_on(const Map& map, const Snapshot& snapshot, const PathSegment& segment,
                                            SeenPart& part) {
    const Wall& wall = map[part.exit];
    const Heights open = open_heights(map, snapshot, wall);
    const double eye_z = view_.eye_z - rooms_[part.room].to_eye.rise;
    part.low = std::max(part.low, (open.floor_z - eye_z) / part.exit_depth);
    part.high = std::min(part.high, (open.ceiling_z - eye_z) / part.exit_depth);
    if (!(part.low < part.high)) return {};
    const auto next = wall.kind == WallKind::mirror ? segment_in_mirror(map, segment, part.exit)
                                                    : segment_behind(map, segment, part.exit);
    if (!next) return {};
    part.room = room_behind(map, part.room, part.exit);
    return part.room == kNone ? std::nullopt : next;
}

std::uint32_t SeenRooms::room_behind(const Map& map, std::uint32_t room, WallId id) {
    const std::size_t slot = first_behind_[room] + id.index - map[rooms_[room].sector].first_wall;
    if (behind_[slot] != kNone) return behind_[slot];
    const Wall& wall = map[id];
    const std::uint32_t found =
        find_or_add(map, {sector_behind(wall), then(inverse(map.passage(wall)), rooms_[room].to_eye)});
    return behind_[slot] = found;
}

std::uint32_t SeenRooms::find_or_add(const Map& map, const UnfoldedRoom& room) {
    const auto is_it = [&](const UnfoldedRoom& r) { return r.sector == room.sector && r.to_eye == room.to_eye; };
    const auto found = std::ranges::find_if(rooms_, is_it);
    if (found != rooms_.end()) return static_cast<std::uint32_t>(found - rooms_.begin());
    const std::size_t walls = behind_.size() + map[room.sector].wall_count;
    if (rooms_.size() == kMostRooms || (!rooms_.empty() && walls > kMostWalls)) return kNone;
    rooms_.push_back(room);
    first_behind_.push_back(static_cast<std::uint32_t>(behind_.size()));
    behind_.resize(behind_.size() + map[room.sector].wall_count, kNone);
    return static_cast<std::uint32_t>(rooms_.size() - 1);
}

void SeenRooms::add_surroundings(const Map& map, SectorId first, Vec2 middle, double reach) {
    find_or_add(map, {first, {}});
    const double radius = snap_to_point_grid(std::min(reach, kWorldLimit));
    for (std::uint32_t room = 0; room < rooms_.size(); ++room) {
        if (!rooms_[room].to_eye.is_identity()) continue;
        const Sector& sector = map[rooms_[room].sector];
        for (std::uint32_t w = sector.first_wall; w < sector.first_wall + sector.wall_count; ++w) {
            const Wall& wall = map.walls[w];
            const bool is_plain = wall.kind == WallKind::portal && wall.link == Wall::kNoLink;
            if (is_plain && segment_is_nearer(wall.a, wall.b, middle, radius)) room_behind(map, room, WallId(w));
        }
    }
}

bool SeenRooms::shows(std::size_t room, WallId wall, Vec2 p, double z) const {
    const Vec2 way = p - view_.eye;
    const double depth = dot(way, view_.forward), side = dot(way, right_of(view_.forward)) * view_.flip;
    if (!(depth > 0) || std::fabs(side) > depth * half_fov_tangent_) return false;
    const auto columns = static_cast<double>(slopes_.size());
    const double column =
        std::clamp(side / depth / half_fov_tangent_ * columns / 2 + middle_column_ + 0.5, 0.0, columns - 1);
    const auto x = static_cast<std::size_t>(column);
    const double climb = (z - view_.eye_z) / depth;
    double entry_depth = 0;
    for (std::size_t i = first_[x]; i < first_[x + 1]; ++i) {
        const SeenPart& part = parts_[i];
        const bool is_there = wall ? part.exit == wall : depth >= entry_depth && depth < part.exit_depth;
        if (part.room == room && is_there) return climb >= part.low && climb <= part.high;
        entry_depth = part.exit_depth;
    }
    return false;
}

Vec2 SeenRooms::end_of(std::size_t column) const {
    const Vec2 way = view_.forward + right_of(view_.forward) * (slopes_[column] * view_.flip);
    return view_.eye + way * parts_[first_[column + 1] - 1].exit_depth;
}

}  // namespace enfilade
