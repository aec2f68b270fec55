// The eye as one chain of links sees it.
#pragma once
#include "map/map.h"
#include "math/grid.h"
#include "render/view.h"

namespace enfilade::stencil {

/// An eye in the space behind a chain of links.
struct Eye {
    Vec2 place;  ///< on the point grid
    double z = 0;
    Vec2 forward;
    Vec2 right;  ///< screen right; to the left of `forward` when seen through an odd number of mirrors
    double flip = 1;
    int links = 0;  ///< links and mirrors passed so far
};

inline Eye eye_of(const View& view) {
    return {view.eye, view.eye_z, view.forward, right_of(view.forward) * view.flip, view.flip, 0};
}

/// The same eye behind one more link. It is put onto the point grid, so that side tests stay exact there too.
inline Eye beyond(const Eye& eye, const Rigid& passage) {
    const Vec2 forward = passage.turn(eye.forward);
    const double flip = eye.flip * passage.flip;
    return {snap_to_point_grid(passage.apply(eye.place)),
            passage.apply_height(eye.z),
            forward,
            right_of(forward) * flip,
            flip,
            eye.links + 1};
}

}  // namespace enfilade::stencil
