// A camera that looks at the eye from outside: from above or from behind.
#pragma once
#include "render/view.h"

namespace enfilade {

enum class OutsideFrom : std::uint8_t { above, behind };

/// How many metres of ground a picture from above is high; the camera behind stands a fifth of it away [m].
inline constexpr double kUsualReach = 24, kLeastReach = 2, kMostReach = 4096;

/// A point of a picture in homogeneous coordinates: pixel (x / w, y / w). w <= 0: not before the camera; 0 with another
/// coordinate that is not: a direction.
struct PicturePoint {
    double x = 0, y = 0, w = 0;
};

/// Where a facet of the world comes to lie in the picture.
///
/// From above: without perspective, down at an angle of 60 degrees and turned with the view, so that what lies ahead of
/// the eye is up in the picture, and of walls one sees the side that faces the viewer. From behind: as if somebody
/// looked over the player's shoulders, from higher up.
class OutsideCamera {
public:
    /// reach: kLeastReach..kMostReach. width, height: 1..kMaxPictureSide [px]
    OutsideCamera(OutsideFrom from, const View& view, double reach_m, int width, int height);

    /// At the view's own eye, looking as it does; its sector does not count, nor does a tilt.
    OutsideCamera(const View& view, int width, int height);

    /// p, z: in the space of the view's eye [m].
    PicturePoint project(Vec2 p, double z) const;

    /// The direction to which upright lines run in the picture: project(p, z + 1) - project(p, z).
    PicturePoint upright() const;

    /// How far along the look the point lies [m]; grows away from the camera.
    double depth(Vec2 p, double z) const;

    /// What a pixel is wide at that depth [m].
    double metres_per_px(double depth_m) const { return is_parallel_ ? 1 / focal_px_ : depth_m / focal_px_; }

    /// Where it looks on the plan.
    Vec2 forward() const { return forward_; }

    /// To the right in the picture, level.
    Vec2 right() const { return right_; }

private:
    Vec2 place_;    ///< of the camera; without perspective, where the middle of the picture looks at
    double z_ = 0;  ///< [m]
    Vec2 forward_, right_;
    Vec2 pitch_;  ///< (cos, sin) of how far down it looks
    Vec2 middle_px_;
    double focal_px_ = 1;  ///< without perspective: pixels per metre
    bool is_parallel_ = false;
};

}  // namespace enfilade
