#include "render/view.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "formats/text_parts.h"
#include "math/vec.h"
#include "space/trace.h"

namespace enfilade {

Projection::Projection(const View& view, int width, int height)
    : width_(width),
      height_(height),
      half_width_(width / 2.0),
      middle_column_((width - 1) / 2.0 - view.ray_offset.x),
      tilt_(view.tilt) {
    ENFILADE_CHECK(width >= 1 && width <= kMaxPictureSide && height >= 1 && height <= kMaxPictureSide);
    ENFILADE_CHECK(!view.tilt || view.pitch_tangent == 0);
    ENFILADE_CHECK(view.fov_degrees >= kMinFov && view.fov_degrees <= kMaxFov);
    ENFILADE_CHECK(std::fabs(view.ray_offset.x) <= width / 2.0 && std::fabs(view.ray_offset.y) <= height / 2.0);
    half_fov_tangent_ = tangent(Angle::from_degrees(view.fov_degrees / 2));
    focal_y_ = width / 2.0 / half_fov_tangent_ * view.stretch;
    horizon_ = height / 2.0 + view.pitch_tangent * focal_y_ - view.ray_offset.y;
}

Ray Projection::tilted(const Ray& in_picture) const {
    if (!tilt_) return in_picture;
    const Vec2 roll = tilt_->roll, pitch = tilt_->pitch;
    const double right = in_picture.right * roll.x + in_picture.up * roll.y;
    const double up = in_picture.up * roll.x - in_picture.right * roll.y;
    return {in_picture.ahead * pitch.x - up * pitch.y, right, in_picture.ahead * pitch.y + up * pitch.x};
}

namespace {

Result<SectorId> sector_named(const Map& map, const std::string& name) {
    const auto found = std::ranges::find(map.sectors, name, &Sector::name);
    if (found == map.sectors.end()) {
        std::vector<std::string_view> known;
        for (const Sector& sector : map.sectors) known.push_back(sector.name);
        return Error{"", "the map has no sector named " + in_quotes(name) + nearest_suggestion(name, known)};
    }
    return SectorId(std::size_t(found - map.sectors.begin()));
}

Result<SectorId> sector_of(const Map& map, const ViewRow& row, Vec2 eye) {
    if (row.sector.empty()) {
        const SectorId found = locate(map, eye);
        if (found) return found;
        return Error{"", "expected a view inside the map; no sector holds the point " + point_text(eye)};
    }
    auto named = sector_named(map, row.sector);
    if (named.ok() && !contains(map, named.value(), eye))
        return Error{"", "sector " + in_quotes(row.sector) + " does not hold the point " + point_text(eye) +
                             "; give a point inside it, or leave the sector out to have it found"};
    return named;
}

View looking(Vec2 forward, Angle pitch, const Lens& lens) {
    View view;
    view.forward = forward;
    if (lens.true_pitch)
        view.tilt = Tilt{direction(pitch), direction(Angle::from_degrees(lens.roll_degrees))};
    else
        view.pitch_tangent = tangent(pitch);
    view.fov_degrees = lens.fov_degrees;
    view.stretch = lens.stretch;
    view.ray_offset = lens.ray_offset;
    return view;
}

}  // namespace

Lens lens_for(const RenderRecord& render, double fov_degrees) {
    return {fov_degrees, render.stretch, ray_offset(render.rays)};
}

Result<View> view_from(const Map& map, const ViewRow& row, const Lens& lens) {
    View view = looking(direction(Angle::from_degrees(row.yaw_degrees)), Angle::from_degrees(row.pitch_degrees), lens);
    view.eye = snap_to_point_grid(Vec2{row.x, row.y});
    view.eye_z = row.z;
    const auto sector = sector_of(map, row, view.eye);
    if (!sector.ok()) return sector.error();
    view.sector = sector.value();
    return view;
}

std::optional<std::string> hidden_eye(const Map& map, const Snapshot& snapshot, const View& view) {
    const Heights room = heights_at(snapshot, view.sector);
    if (view.eye_z > room.floor_z && view.eye_z < room.ceiling_z) return {};
    const bool is_above = view.eye_z >= room.ceiling_z;
    return "the eye at z = " + number_text(view.eye_z) + " is " +
           (is_above ? "not below the ceiling" : "not above the floor") + " of sector " +
           in_quotes(map[view.sector].name) + " at " + number_text(is_above ? room.ceiling_z : room.floor_z) + " m";
}

Result<View> view_at_start(const Map& map, const Lens& lens) {
    if (!map.player) return Error{"", "the map has no player to look from; give a place with --view X,Y,Z,YAW,PITCH"};
    View view = looking(direction(map.player->yaw), {}, lens);
    view.sector = map.player->sector;
    view.eye = map.player->position;
    view.eye_z = map.player->eye_z;
    return view;
}

View view_from(const Eye& eye, const Lens& lens) {
    View view = looking(direction(eye.yaw), Angle{static_cast<std::uint32_t>(eye.pitch_steps)}, lens);
    view.sector = eye.place.sector;
    view.eye = eye.place.point;
    view.eye_z = eye.z;
    return view;
}

}  // namespace enfilade
