// The one projection, used by all renderers: from a place, a look and a picture size to rays.
#pragma once
#include <limits>
#include <optional>
#include <string>

#include "base/id.h"
#include "base/result.h"
#include "formats/dials.h"
#include "formats/views_csv.h"
#include "map/map.h"
#include "math/angle.h"
#include "math/vec.h"
#include "world/snapshot.h"
#include "world/world.h"

namespace enfilade {

/// True pitch and roll: the picture itself is turned, as a head is, so that upright walls converge.
struct Tilt {
    Vec2 pitch{1, 0};  ///< (cos, sin) of the angle, up positive; -90..90 degrees
    Vec2 roll{1, 0};   ///< (cos, sin) of the angle by which the head leans to its right
};

/// Where the eye is and how it looks.
struct View {
    SectorId sector;           ///< contains `eye` under the tie rule
    Vec2 eye;                  ///< on the point grid [m]
    double eye_z = 0;          ///< [m]
    Vec2 forward{1, 0};        ///< unit vector: direction(yaw)
    double flip = 1;           ///< -1: seen in a mirror, left and right swapped
    double pitch_tangent = 0;  ///< tan(pitch), up positive; the picture is sheared, walls stay upright
    double fov_degrees = 90;   ///< horizontal, 1..179
    double stretch = 1;        ///< vertical stretch of the picture; Doom's is 1.2
    Vec2 ray_offset{};         ///< right of and below the middle of each pixel, where its ray passes [px]
    std::optional<Tilt> tilt;  ///< instead of pitch_tangent, which then is 0; the column renderer cannot
};

/// View::ray_offset of a map's pictures.
constexpr Vec2 ray_offset(RayPoint point) { return point == RayPoint::corner ? Vec2{-0.5, -0.5} : Vec2{}; }

/// Smallest and largest horizontal field of view [degrees].
inline constexpr double kMinFov = 1, kMaxFov = 179;

/// At least the tangent of half of kMaxFov: no ray of a picture that is not tilted has a steeper slope. A ray of a
/// tilted one that has is followed along another of four directions, each a quarter of a turn on.
inline constexpr double kMostSlope = 115;

/// A ray by where it is one metre along the line of sight, the middle of the picture: so many metres along the view's
/// `forward` in the plane, to its right and up.
struct Ray {
    double ahead = 1;  ///< not tilted: always 1
    double right = 0;
    double up = 0;
};

/// The tie rule for rows: which heights a ray passes is asked of one that climbs this much more per metre. Round
/// coordinates put the very edge of a surface on the middle of a row, where what rounding makes of a slope would fray
/// the edge; nobody sees a millionth of a millimetre in a kilometre.
inline constexpr double kTieClimb = 0x1p-40;

/// How a ray climbs: `rise` in `run` along the line of sight. Of a row of a picture both are in [px], and the quotient
/// is never formed.
struct RowClimb {
    double rise = 0;
    double run = 1;  ///< > 0
};

/// A ray that climbs less is all but level: where it meets a level plane depends on the tie rule, or shows in no
/// picture. 16 million times kTieClimb [m/m].
inline constexpr double kAlmostLevel = 0x1p-16;

/// The depth at which a ray counts as meeting a level plane `height` above the eye [m]; infinite for a level ray. What
/// is above the eye a ray that is all but level meets where the tie rule for rows says.
inline double depth_on_plane(double climb, const RowClimb& tied, double height) {
    if (height > 0 && climb < kAlmostLevel && tied.rise > 0) return height * tied.run / tied.rise;
    return climb == 0 ? std::numeric_limits<double>::infinity() : height / climb;
}

/// Pixels to rays. A ray that is not tilted goes from the eye along forward + slope(x) * right in the plane and climbs
/// climb(y) metres per metre of depth; depth is the distance along `forward`.
///
/// Everything is computed from the index, never stepped, so that a part of a picture equals that part of the whole.
class Projection {
public:
    /// width, height in 1..kMaxPictureSide [px].
    Projection(const View& view, int width, int height);

    int width() const { return width_; }
    int height() const { return height_; }

    /// Tangent of the angle between `forward` and the ray of pixel column x, right positive; between columns, too: the
    /// left border of the picture is half a column before the first. That the quotient is of whole and half numbers
    /// makes the middle of three columns of a picture three times as wide bit-equal to the one column.
    double slope(double x) const { return (x - middle_column_) / half_width_ * half_fov_tangent_; }

    /// The column, or the place between columns, that slope() is 0 of.
    double middle_column() const { return middle_column_; }

    /// Height gained per metre of depth by the rays of pixel row y, up positive: (horizon - (y + 1/2)) / focal_y.
    double climb(int y) const { return row_from_horizon(y) / focal_y_; }

    /// How far the rays of row y pass above the horizon [px].
    double row_from_horizon(int y) const { return horizon_ - (y + 0.5); }

    /// How they climb by the tie rule for rows.
    RowClimb row_climb(int y) const { return {row_from_horizon(y) + kTieClimb * focal_y_, focal_y_}; }

    /// The ray of pixel (x, y), tilted where the view is; else {1, slope(x), climb(y)}. With a tilt of 0, 0 the same
    /// bits.
    Ray ray(int x, int y) const { return tilted({1, slope(x), climb(y)}); }

    /// From how it lies in the picture to how it lies in the world. Linear.
    Ray tilted(const Ray& in_picture) const;
    bool is_tilted() const { return tilt_.has_value(); }

    double half_fov_tangent() const { return half_fov_tangent_; }
    double focal_y() const { return focal_y_; }  ///< [px]
    /// From the top, which is half a row above the rays of row 0; may lie outside the picture [px].
    double horizon() const { return horizon_; }

private:
    int width_, height_;
    double half_width_, middle_column_;  ///< [px]
    double half_fov_tangent_;
    double focal_y_;
    double horizon_;
    std::optional<Tilt> tilt_;
};

// The eye as one chain of portals sees it.

/// An eye in the space behind a chain of links. Plain doorways transform nothing, so all sectors reached through
/// doorways alone share pose 0, the view itself.
struct Pose {
    Vec2 eye;          ///< on the point grid
    double eye_z = 0;  ///< [m]
    Vec2 forward;      ///< unit vector
    Vec2 right;        ///< screen right; to the left of `forward` when seen through an odd number of mirrors
    double flip = 1;
    int links = 0;  ///< links and mirrors passed so far

    /// Direction in the plane of the ray with this slope; its length along `forward` is 1.
    Vec2 direction(double slope) const { return forward + right * slope; }
};

inline Pose pose_of(const View& view) {
    return {view.eye, view.eye_z, view.forward, right_of(view.forward) * view.flip, view.flip, 0};
}

/// The same eye behind one more link. It is put onto the point grid so that side tests stay exact there too.
inline Pose beyond(const Pose& pose, const Rigid& passage) {
    const Vec2 forward = passage.turn(pose.forward);
    const double flip = pose.flip * passage.flip;
    return {snap_to_point_grid(passage.apply(pose.eye)),
            passage.apply_height(pose.eye_z),
            forward,
            right_of(forward) * flip,
            flip,
            pose.links + 1};
}

// From a place in a map, as somebody gives it in numbers, to a view that is inside the map.

/// How the eye sees, apart from where it is.
struct Lens {
    double fov_degrees = 90;  ///< horizontal, kMinFov..kMaxFov
    double stretch = 1;       ///< vertical stretch of the picture, > 0
    Vec2 ray_offset{};        ///< View::ray_offset [px]
    bool true_pitch = false;  ///< pitch turns the picture instead of shifting its horizon
    double roll_degrees = 0;  ///< with true_pitch: how far the head leans to its right
};

/// As the map wants to be seen.
Lens lens_for(const RenderRecord& render, double fov_degrees = 90);

/// The view, its eye put onto the point grid. An error where the named sector does not exist or does not hold the eye,
/// or where no sector does; of several that overlap, the one that comes first in the map is taken.
Result<View> view_from(const Map& map, const ViewRow& row, const Lens& lens);

/// "the eye at z = 9 is not below the ceiling of sector 'hall' at 3 m", or not above its floor; none where it is
/// between them.
std::optional<std::string> hidden_eye(const Map& map, const Snapshot& snapshot, const View& view);

/// What the player sees at the start, or an error where the map has no player.
Result<View> view_at_start(const Map& map, const Lens& lens);

/// What an eye of the world sees (world/world.h).
View view_from(const Eye& eye, const Lens& lens);

}  // namespace enfilade
