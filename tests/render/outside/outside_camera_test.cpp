// Where places of the world come to lie in pictures from outside.
#include "render/outside/outside_camera.h"

#include <gtest/gtest.h>

namespace enfilade {
namespace {

View looking_east() {
    View view;
    view.eye = {10, 20};
    view.eye_z = 1.5;
    return view;
}

Vec2 pixel(const OutsideCamera& camera, Vec2 p, double z) {
    const PicturePoint at = camera.project(p, z);
    EXPECT_GT(at.w, 0);
    return {at.x / at.w, at.y / at.w};
}

TEST(OutsideCamera, ShowsTheGroundAheadAboveTheEyeAsHighAsItReaches) {
    const OutsideCamera camera(OutsideFrom::above, looking_east(), 24, 400, 240);
    EXPECT_NEAR(pixel(camera, {10, 20}, 1.5).x, 200, 1e-9);
    EXPECT_NEAR(pixel(camera, {10, 20}, 1.5).y, 180, 1e-9);  // a quarter of the reach below the middle
    EXPECT_NEAR(pixel(camera, {34, 20}, 1.5).y, -60, 1e-9);  // 24 m are the picture's height
    EXPECT_GT(pixel(camera, {10, 22}, 1.5).x, 200);          // +y is to the right of +x
    EXPECT_LT(pixel(camera, {10, 20}, 2.5).y, 180);          // what is higher is up
}

TEST(OutsideCamera, TurnsWithTheView) {
    View view = looking_east();
    view.forward = {0, 1};
    const OutsideCamera camera(OutsideFrom::above, view, 24, 400, 240);
    EXPECT_NEAR(pixel(camera, {10, 44}, 1.5).y, -60, 1e-9);
}

TEST(OutsideCamera, StandsBehindTheEyeAndSeesItInTheMiddle) {
    const OutsideCamera camera(OutsideFrom::behind, looking_east(), 20, 400, 240);
    EXPECT_NEAR(pixel(camera, {10, 20}, 1.5).x, 200, 1e-9);
    EXPECT_NEAR(pixel(camera, {10, 20}, 1.5).y, 120, 1e-9);
    EXPECT_NEAR(camera.depth({10, 20}, 1.5), 4, 1e-12);  // a fifth of the reach
    EXPECT_LT(camera.project({0, 20}, 1.5).w, 0);
}

TEST(OutsideCamera, RunsUprightLinesInOneDirection) {
    for (const OutsideFrom from : {OutsideFrom::above, OutsideFrom::behind}) {
        const OutsideCamera camera(from, looking_east(), 24, 400, 240);
        const PicturePoint low = camera.project({14, 21}, 0), high = camera.project({14, 21}, 1), up = camera.upright();
        EXPECT_NEAR(high.x - low.x, up.x, 1e-9);
        EXPECT_NEAR(high.y - low.y, up.y, 1e-9);
        EXPECT_NEAR(high.w - low.w, up.w, 1e-12);
    }
}

TEST(OutsideCamera, TellsHowWideAPixelIs) {
    const OutsideCamera above(OutsideFrom::above, looking_east(), 24, 400, 240);
    EXPECT_NEAR(pixel(above, {10, 21}, 1.5).x - 200, 1 / above.metres_per_px(3), 1e-9);
    const OutsideCamera behind(OutsideFrom::behind, looking_east(), 20, 400, 240);
    EXPECT_NEAR(pixel(behind, {10, 21}, 1.5).x - 200, 1 / behind.metres_per_px(4), 1e-9);
}

TEST(OutsideCamera, LooksFromAnywhereAsTheViewDoes) {
    View view = looking_east();
    view.pitch_tangent = -0.5;
    const OutsideCamera camera(view, 400, 240);
    EXPECT_NEAR(pixel(camera, {14, 20}, -0.5).x, 200, 1e-9);
    EXPECT_NEAR(pixel(camera, {14, 20}, -0.5).y, 120, 1e-9);  // down by half of the way
    EXPECT_GT(pixel(camera, {14, 22}, -0.5).x, 200);
    EXPECT_LT(pixel(camera, {14, 20}, 0).y, 120);
}

}  // namespace
}  // namespace enfilade
