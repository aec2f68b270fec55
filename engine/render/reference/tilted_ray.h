// How a ray of a tilted picture is followed: in the plane of its own, like a ray of a picture that is not tilted and
// looks where the ray goes.
#pragma once
#include "render/view.h"

namespace enfilade {

/// A ray in the way it is followed: from a view that is turned by whole quarters, so that the ray goes ahead.
struct RayCourse {
    int quarters = 0;        ///< to the right, 0..3; 0 where the picture is not tilted
    double slope = 0;        ///< to the right, per metre ahead
    double climb = 0;        ///< up, per metre ahead; finite
    double depth_scale = 1;  ///< depth along the line of sight, per metre ahead
};

/// The course of a ray. A ray straight up or down leans ahead by a hair. Rays that are not tilted keep their bits.
RayCourse ray_course(const Ray& ray);

/// The view from which the ray is followed.
View turned(const View& view, int quarters);

}  // namespace enfilade
