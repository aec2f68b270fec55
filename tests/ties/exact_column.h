// Which surface the rays of one pixel column meet, by whole numbers of any size. It judges the renderers and shares
// with them the map, its numbers of surfaces, and the doubles that the rule itself is told in (math/vec.h), no more.
//
// The rule:
//   The eye E is on the grid of 2^-32 m and counts as E + (e, e^2), where e is a formal positive infinitesimal: it is
//   carried along as a polynomial, never as a number.
//   A column has a slope s, a double. With the direction f of the look and r = (-f.y, f.x) * flip, the normal of its
//   rays is n = f * s - r, each part computed in double and rounded to whole steps of 2^-55. A vertex V is left of the
//   ray where n.(V - E) > 0, right of it where that is < 0. The ray runs perpendicular to n, forward.
//   The ray meets a wall whose ends are on either side of it, and on whose right side the eye is; of these the first
//   beyond the wall by which it came into the room.
//   Behind a link the eye is carried, put onto the grid, and moved by (e, e^2) anew; f is turned, n is made anew. So
//   rounding can leave a ray beside the doorway it came through, or no wall to meet: it is lost, and nothing is said
//   of it.
//   The rays of a row climb rise / focal_y metres per metre of depth. Where they meet a wall, of a -> b, they are at a
//   height h above the eye or higher if rise * C >= h * focal_y * A, C = cross(b - a, E - a), A = n.(a - b) * flip.
//   Where C = 0, the wall is met an instant after the start: if h < 0, or h = 0 and rise >= 0.
//   What ends a ray, and where looks are cut, is told in maps/FORMAT.md. Things, panels and pictures in portals are not
//   known here.
#pragma once
#include <optional>
#include <vector>

#include "map/map.h"
#include "render/frame.h"
#include "render/view.h"
#include "support/exact.h"
#include "world/instant.h"

namespace enfilade::test {

/// c0 + c1 e + c2 e^2.
struct Polynomial {
    Integer c0, c1, c2;

    int sign() const;
};

/// The eye behind a chain of links, and the rays of the column there.
struct ExactSpace {
    Vec2 eye;                    ///< [m]
    double eye_z;                ///< [m]
    Vec2 forward;                ///< unit vector
    double flip;                 ///< -1: seen in a mirror
    std::int64_t links;          ///< passed so far
    Integer eye_x, eye_y;        ///< [2^-32 m]
    Integer normal_x, normal_y;  ///< [2^-55]
    Integer ahead_x, ahead_y;    ///< the way of the rays, as long as the normal
};

/// A wall that is met.
struct ExactHit {
    ExactSpace space;
    SectorId sector;          ///< the one the ray was in
    WallId wall;              ///< none: lost
    Integer cross, across;    ///< C [2^-64 m^2] and A [2^-87 m]
    std::uint64_t spent = 0;  ///< rooms on the way, each its walls, panels and 32 more
};

/// The rays of a column.
class ExactColumn {
public:
    /// heights: by sector. All but the view are kept by reference. The view is not tilted.
    ExactColumn(const Map& map, const std::vector<Heights>& heights, const View& view, double slope);

    /// What the ray meets that climbs rise / focal_y; none: it is lost.
    std::optional<PixelSurface> surface(double rise, double focal_y);

private:
    const ExactHit& hit(std::size_t i);
    ExactHit first_wall(const ExactSpace& space, SectorId sector, WallId entry) const;
    std::optional<PixelSurface> end_at(const ExactHit& hit, double rise, double focal_y) const;

    const Map& map_;
    const std::vector<Heights>& heights_;
    double slope_;
    View view_;
    std::vector<ExactHit> hits_;
};

}  // namespace enfilade::test
