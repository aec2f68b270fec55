// The camera that looks from outside, the marks that its picture has, and the picture itself.
#include "render/outside/outside_renderer.h"

#include <algorithm>
#include <cmath>

namespace enfilade {
namespace {

constexpr double kDownFromAbove = 60, kDownFromBehind = 30;  ///< how far down the cameras look [degrees]

/// How far before the eye, in parts of the reach, the picture from above has its middle: one sees more of what is
/// ahead.
constexpr double kAhead = 0.25;

/// The camera behind stands so far away, in parts of the reach, and sees so far to either side.
constexpr double kBehind = 0.2, kFovBehind = 75;  // [1], [degrees]

}  // namespace

OutsideCamera::OutsideCamera(OutsideFrom from, const View& view, double reach_m, int width, int height)
    : forward_(view.forward),
      right_(right_of(view.forward)),
      middle_px_{width / 2.0, height / 2.0},
      is_parallel_(from == OutsideFrom::above) {
    pitch_ = direction(Angle::from_degrees(is_parallel_ ? kDownFromAbove : kDownFromBehind));
    if (is_parallel_) {
        focal_px_ = height / (reach_m * pitch_.y);
        place_ = view.eye + forward_ * (kAhead * reach_m);
        z_ = view.eye_z;
    } else {
        focal_px_ = middle_px_.x / tangent(Angle::from_degrees(kFovBehind / 2));
        place_ = view.eye - forward_ * (kBehind * reach_m * pitch_.x);
        z_ = view.eye_z + kBehind * reach_m * pitch_.y;
    }
}

OutsideCamera::OutsideCamera(const View& view, int width, int height)
    : place_(view.eye),
      z_(view.eye_z),
      forward_(view.forward),
      right_(right_of(view.forward)),
      middle_px_{width / 2.0, height / 2.0},
      focal_px_(middle_px_.x / tangent(Angle::from_degrees(view.fov_degrees / 2))) {
    const double length = std::sqrt(1 + view.pitch_tangent * view.pitch_tangent);
    pitch_ = {1 / length, -view.pitch_tangent / length};
}

double OutsideCamera::depth(Vec2 p, double z) const {
    return dot(p - place_, forward_) * pitch_.x - (z - z_) * pitch_.y;
}

PicturePoint OutsideCamera::project(Vec2 p, double z) const {
    const Vec2 way = p - place_;
    const double ahead = dot(way, forward_), right = dot(way, right_);
    const double up = ahead * pitch_.y + (z - z_) * pitch_.x;
    const double w = is_parallel_ ? 1 : ahead * pitch_.x - (z - z_) * pitch_.y;
    return {middle_px_.x * w + focal_px_ * right, middle_px_.y * w - focal_px_ * up, w};
}

PicturePoint OutsideCamera::upright() const {
    const double w = is_parallel_ ? 0 : -pitch_.y;
    return {middle_px_.x * w, middle_px_.y * w - focal_px_ * pitch_.x, w};
}

// Marks: the eye, what it sees, and portals.

namespace {

/// How thick lines are, whichever is more: in the picture [px] and in the world [m].
constexpr double kLinePx = 2, kLineM = 0.02;

/// How far the pyramid reaches, whichever is more.
constexpr double kEyePx = 22, kEyeM = 0.4;

/// How much darker the pyramid's sides and bottom are than its top.
constexpr Shade kSide = 190, kBottom = 128;

class Marks {
public:
    Marks(const OutsideScene& scene, std::vector<Facet>& facets) : scene_(scene), facets_(facets) {}

    /// At least so many pixels and metres, at that place [m].
    double size_at(Vec2 p, double z, double px, double m) const {
        const double depth = std::max(scene_.camera.depth(p, z), 0.0);
        return std::max(px * scene_.camera.metres_per_px(depth), m);
    }

    /// A line on the ground at height z.
    void add_level_line(Vec2 a, Vec2 b, double z, std::uint32_t color) {
        const Vec2 way = b - a;
        const double length = std::sqrt(dot(way, way));
        if (length == 0) return;
        const Vec2 aside = right_of(way) * (0.5 / length);
        const Vec2 begin = aside * size_at(a, z, kLinePx, kLineM), end = aside * size_at(b, z, kLinePx, kLineM);
        add_triangle({a - begin, z}, {b - end, z}, {b + end, z}, color);
        add_triangle({a - begin, z}, {b + end, z}, {a + begin, z}, color);
    }

    void add_upright(Vec2 a, Vec2 b, double bottom, double top, std::uint32_t color) {
        keep(Facet::upright(scene_.camera, {a, top}, {b, bottom}, look_of(color), FacetSides::both));
    }

    /// A frame on a wall.
    void add_frame(Vec2 a, Vec2 b, double bottom, double top, std::uint32_t color) {
        const Vec2 way = b - a;
        const double line = size_at((a + b) * 0.5, (bottom + top) / 2, kLinePx, kLineM);
        const Vec2 post = way * std::min(line / std::sqrt(dot(way, way)), 0.5);
        add_upright(a, b, bottom, std::min(bottom + line, top), color);
        add_upright(a, b, std::max(top - line, bottom), top, color);
        add_upright(a, a + post, bottom, top, color);
        add_upright(b - post, b, bottom, top, color);
    }

    void add_triangle(const FacetCorner& a, const FacetCorner& b, const FacetCorner& c, std::uint32_t color) {
        keep(Facet::triangle(scene_.camera, {a, b, c}, look_of(color), FacetSides::both));
    }

private:
    static FacetLook look_of(std::uint32_t color) {
        FacetLook look;
        look.color = color;
        return look;
    }
    void keep(const std::optional<Facet>& facet) {
        if (facet) facets_.push_back(*facet);
    }

    const OutsideScene& scene_;
    std::vector<Facet>& facets_;
};

void add_portal_mark(const OutsideScene& scene, Marks& marks, const UnfoldedRoom& room, const Wall& wall) {
    const Heights own = heights_at(scene.snapshot, room.sector);
    double bottom = own.floor_z, top = own.ceiling_z;
    if (wall.kind != WallKind::mirror) {
        const Heights behind = heights_at(scene.snapshot, wall.behind);
        const double rise = scene.map.passage(wall).rise;
        bottom = std::max(bottom, behind.floor_z - rise);
        top = std::min(top, behind.ceiling_z - rise);
    }
    if (!(bottom < top)) return;
    const Vec2 a = room.to_eye.apply(wall.a), b = room.to_eye.apply(wall.b);
    bottom = room.to_eye.apply_height(bottom), top = room.to_eye.apply_height(top);
    if (wall.link == Wall::kNoLink) return marks.add_level_line(a, b, bottom, kDoorwayMark);
    marks.add_frame(a, b, bottom, top, wall.kind == WallKind::mirror ? kMirrorMark : kLinkMark);
}

}  // namespace

void add_portal_marks(const OutsideScene& scene, const SeenRooms& rooms, std::vector<Facet>& facets) {
    Marks marks(scene, facets);
    for (std::size_t i = 0; i < rooms.rooms().size(); ++i) {
        const UnfoldedRoom& room = rooms.rooms()[i];
        const Sector& sector = scene.map[room.sector];
        for (std::uint32_t w = 0; w < sector.wall_count; ++w) {
            const WallId wall(sector.first_wall + w);
            if (rooms.passes(scene.map, i, wall)) add_portal_mark(scene, marks, room, scene.map[wall]);
        }
    }
}

void add_eye_marks(const OutsideScene& scene, const SeenRooms& rooms, std::vector<Facet>& facets) {
    Marks marks(scene, facets);
    const Vec2 eye = scene.view.eye;
    const double z = scene.view.eye_z;
    marks.add_level_line(eye, rooms.end_of_first(), z, kEyeMark);
    marks.add_level_line(eye, rooms.end_of_last(), z, kEyeMark);
    const double size = marks.size_at(eye, z, kEyePx, kEyeM);
    const auto corner = [&](double side, double up) {
        const double across = std::min(rooms.half_fov_tangent(), 1.0) * size / 2;
        return FacetCorner{eye + scene.view.forward * size + right_of(scene.view.forward) * (side * across),
                           z + up * across * 0.6};
    };
    const FacetCorner apex{eye, z}, lower_left = corner(-1, -1), lower_right = corner(1, -1),
                                    upper_left = corner(-1, 1), upper_right = corner(1, 1);
    marks.add_triangle(apex, upper_left, upper_right, kEyeMark);
    marks.add_triangle(apex, lower_left, upper_left, shaded(kEyeMark, kSide));
    marks.add_triangle(apex, upper_right, lower_right, shaded(kEyeMark, kSide));
    marks.add_triangle(apex, lower_right, lower_left, shaded(kEyeMark, kBottom));
    marks.add_triangle(upper_left, upper_right, lower_right, shaded(kEyeMark, kSide));
    marks.add_triangle(upper_left, lower_right, lower_left, shaded(kEyeMark, kSide));
}

namespace {

constexpr std::uint32_t kBackground = 0xFF281C14;  ///< a dark blue

}  // namespace

OutsideRenderer::OutsideRenderer(const Map& map, const TextureSet& textures)
    : map_(map), textures_(textures), pieces_(map, textures) {}

void OutsideRenderer::render(Frame& frame, const Snapshot& snapshot, const View& view, const OutsideLook& look,
                             std::size_t workers) {
    const OutsideCamera camera = look.camera ? OutsideCamera(*look.camera, frame.width, frame.height)
                                             : OutsideCamera(look.from, view, look.reach_m, frame.width, frame.height);
    const View& middle = look.camera ? *look.camera : view;
    const OutsideScene scene{map_, textures_, snapshot, view, camera, pieces_};
    rooms_.look(map_, snapshot, view, look.seen_width, look.seen_height);
    facets_.clear();
    add_eye_marks(scene, rooms_, facets_);
    add_portal_marks(scene, rooms_, facets_);
    rooms_.add_surroundings(map_, middle.sector, middle.eye, look.reach_m);
    for (std::size_t room = 0; room < rooms_.rooms().size(); ++room) add_room_facets(scene, rooms_, room, facets_);
    std::ranges::fill(frame.pixels, kBackground);
    frame.is_cut_short = false;
    paint_facets(frame, facets_, rooms_, camera, workers);
}

}  // namespace enfilade
