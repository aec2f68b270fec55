// The eye as one chain of portals sees it.
#pragma once
#include "map/map.h"
#include "math/grid.h"
#include "render/view.h"

namespace enfilade {

/// An eye in the space behind a chain of links. Plain doorways transform nothing, so all sectors reached through
/// doorways alone share pose 0, the view itself.
struct Pose {
    Vec2 eye;  ///< on the point grid
    double eye_z = 0;
    Vec2 forward;
    Vec2 right;  ///< screen right; to the left of `forward` when seen through an odd number of mirrors
    double flip = 1;
    int links = 0;  ///< links and mirrors passed so far
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

}  // namespace enfilade
