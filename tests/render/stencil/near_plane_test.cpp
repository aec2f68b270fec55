// What a near plane tilted into the plane of a portal would do to depth, in numbers: the figures in
// render/stencil/stencil_renderer.h, and why the stencil renderer has none.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "math/angle.h"
#include "math/vec.h"

namespace enfilade::test {
namespace {

constexpr double kHalfFov = 1;  ///< its tangent: 90 degrees wide
constexpr double kStep24 = 0x1p-24;

/// An upright portal as a camera sees it, x to its right and y ahead.
struct PortalPlane {
    double distance;  ///< of the eye [m]
    Vec2 normal;      ///< away from the eye, length 1
};

PortalPlane portal_plane(double distance_m, double slant_degrees) {
    const Vec2 slant = direction(Angle::from_degrees(slant_degrees));
    return {distance_m, {slant.y, slant.x}};
}

/// Depth in [0, 1] of a perspective projection without a far plane whose near plane was tilted into the portal's
/// (Lengyel, "Oblique View Frustum Depth Projection and Clipping", 2005): scale * (n.v - distance) / v.y, the scale
/// such that the far corner of the picture is at 1.
class ObliqueDepth {
public:
    explicit ObliqueDepth(const PortalPlane& plane) : plane_(plane), scale_(1 / dot(plane.normal, Vec2{kHalfFov, 1})) {}

    /// Of the middle of the picture.
    double at(double metres) const { return scale_ * (plane_.normal.y - plane_.distance / metres); }

    /// The nearest that is told apart from something so many metres away by a buffer of such steps; maybe never.
    double next_after(double metres, double step) const {
        const double left = plane_.normal.y - (at(metres) + step) / scale_;
        return left > 0 ? plane_.distance / left : std::numeric_limits<double>::infinity();
    }

private:
    PortalPlane plane_;
    double scale_;
};

double oblique_step(double distance_m, double slant_degrees, double metres) {
    return ObliqueDepth(portal_plane(distance_m, slant_degrees)).next_after(metres, kStep24) - metres;
}

TEST(ObliqueNearPlane, IsAsGoodAsAnyWhereThePortalIsAMetreAwayAndSquare) {
    EXPECT_NEAR(oblique_step(1, 0, 10), 6.0e-6, 0.1e-6);
    EXPECT_NEAR(oblique_step(1, 0, 100), 6.0e-4, 0.1e-4);
}

TEST(ObliqueNearPlane, LosesLittleToASlant) {
    for (const double slant : {15.0, 45.0, 60.0, 75.0})
        EXPECT_LE(oblique_step(1, slant, 10), 1.42 * oblique_step(1, 0, 10)) << slant;
}

// hard case G4
TEST(ObliqueNearPlane, LosesDepthInProportionToTheDistanceOfThePortal) {
    EXPECT_NEAR(oblique_step(0x1p-4, 0, 100) / oblique_step(1, 0, 100), 16, 0.1);
    EXPECT_NEAR(oblique_step(0x1p-8, 0, 100) / oblique_step(1, 0, 100), 256, 1);
}

// hard case G4
TEST(ObliqueNearPlane, PutsAllOfAHallAtOneDepthForAnEyeAHairBeforeThePortal) {
    EXPECT_NEAR(oblique_step(0x1p-10, 0, 100), 0.61, 0.01);
    EXPECT_NEAR(oblique_step(0x1p-16, 0, 10), 0.41, 0.01);
    EXPECT_EQ(oblique_step(kPointGrid, 0, 1), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace enfilade::test
