// Facets cover what they should, and neighbours leave no pixel out and cover none twice.
#include "render/outside/outside_renderer.h"

#include <gtest/gtest.h>

#include "base/hash.h"

namespace enfilade {
namespace {

constexpr int kFacetWidth = 97, kFacetHeight = 61;

View view_at(Vec2 eye, double degrees) {
    View view;
    view.eye = eye;
    view.eye_z = 1.5;
    view.forward = direction(Angle::from_degrees(degrees));
    return view;
}

/// How often each pixel is covered.
std::vector<int> covered(const std::vector<std::optional<Facet>>& facets) {
    std::vector<int> counts(kFacetWidth * kFacetHeight);
    for (const auto& facet : facets) {
        if (!facet) continue;
        for (int y = facet->first_row(); y < std::min(facet->end_row(), kFacetHeight); ++y) {
            const Facet::Span span = facet->span(y, kFacetWidth);
            for (int x = span.begin; x < span.end; ++x) ++counts[std::size_t(y * kFacetWidth + x)];
        }
    }
    return counts;
}

std::optional<Facet> ground(const OutsideCamera& camera, Vec2 a, Vec2 b, Vec2 c) {
    return Facet::triangle(camera, {FacetCorner{a, 0}, {b, 0}, {c, 0}}, {}, FacetSides::front);
}

/// The ground from `low` to `high` as eight triangles around a point of it.
std::vector<std::optional<Facet>> fan(const OutsideCamera& camera, Vec2 low, Vec2 high, Vec2 middle) {
    const Vec2 rim[] = {low,  {middle.x, low.y},  {high.x, low.y}, {high.x, middle.y},
                        high, {middle.x, high.y}, {low.x, high.y}, {low.x, middle.y}};
    std::vector<std::optional<Facet>> facets;
    for (int i = 0; i < 8; ++i) facets.push_back(ground(camera, middle, rim[i], rim[(i + 1) % 8]));
    return facets;
}

TEST(Facets, CoverAllOfTheGroundOnce) {
    Random random(7);
    for (int round = 0; round < 200; ++round) {
        const auto somewhere = [&] { return double(random.below(20000)) / 1000 - 10; };
        // Every fifth time rims run through the very middles of pixels: straight ahead of the eye.
        const bool is_tie = round % 5 == 0;
        const Vec2 eye{somewhere(), somewhere()};
        const double degrees = is_tie ? (round % 4) * 90 : somewhere() * 18;
        const OutsideFrom from = round % 2 ? OutsideFrom::above : OutsideFrom::behind;
        const OutsideCamera camera(from, view_at(eye, degrees), 12, kFacetWidth, kFacetHeight);
        const Vec2 middle = is_tie ? eye : Vec2{somewhere(), somewhere()};
        const Vec2 low = is_tie ? eye - Vec2{50, 50} : Vec2{-50, -50}, high = low + Vec2{100, 100};
        const auto whole =
            covered({ground(camera, {-50, -50}, {50, -50}, {50, 50}), ground(camera, {-50, -50}, {50, 50}, {-50, 50})});
        ASSERT_EQ(covered(fan(camera, low, high, middle)), whole) << round;
        ASSERT_EQ(std::count_if(whole.begin(), whole.end(), [](int n) { return n > 1; }), 0);
    }
}

TEST(Facets, OfWallsOfDifferentHeightMeetAtTheirEdge) {
    Random random(11);
    for (int round = 0; round < 200; ++round) {
        const auto somewhere = [&] { return double(random.below(20000)) / 1000 - 10; };
        const OutsideFrom from = round % 2 ? OutsideFrom::above : OutsideFrom::behind;
        const OutsideCamera camera(from, view_at({somewhere(), -8}, 90), 40, kFacetWidth, kFacetHeight);
        const Vec2 a{-40, 20}, edge{somewhere(), 20}, b{40, 20};
        const auto wall = [&](Vec2 left, Vec2 right, double bottom, double top) {
            return Facet::upright(camera, {left, top}, {right, bottom}, {}, FacetSides::both);
        };
        // A wall of one piece, and the same in two of which one is taller: where the whole is, each pixel once.
        const auto whole = covered({wall(a, b, -1, 2)}), parts = covered({wall(a, edge, -1, 2), wall(edge, b, -2, 3)});
        for (std::size_t i = 0; i < whole.size(); ++i)
            if (whole[i]) {
                ASSERT_EQ(parts[i], 1) << round;
            }
        ASSERT_EQ(std::count(parts.begin(), parts.end(), 2), 0) << round;
    }
}

TEST(Facets, AreLeftOutFromBehindWhereOnlyTheirFrontCounts) {
    const OutsideCamera camera(OutsideFrom::above, view_at({0, 0}, 0), 12, kFacetWidth, kFacetHeight);
    EXPECT_TRUE(ground(camera, {0, 0}, {4, 0}, {4, 4}));
    EXPECT_FALSE(ground(camera, {0, 0}, {4, 4}, {4, 0}));
    const FacetCorner low_left{{4, -2}, 0}, high_left{{4, -2}, 2}, low_right{{4, 2}, 0}, high_right{{4, 2}, 2};
    EXPECT_TRUE(Facet::upright(camera, high_left, low_right, {}, FacetSides::front));
    EXPECT_FALSE(Facet::upright(camera, high_right, low_left, {}, FacetSides::front));
    const auto back = Facet::upright(camera, high_right, low_left, {}, FacetSides::both);
    ASSERT_TRUE(back);
    EXPECT_EQ(covered({back}), covered({Facet::upright(camera, high_left, low_right, {}, FacetSides::front)}));
}

TEST(Facets, TellWhatIsInEachPixel) {
    const OutsideCamera camera(OutsideFrom::behind, view_at({0, 0}, 0), 20, kFacetWidth, kFacetHeight);
    const auto facet = Facet::triangle(
        camera, {FacetCorner{{-30, -50}, 0, {-30, -50}}, {{50, -50}, 0, {50, -50}}, {{50, 80}, 0, {50, 80}}}, {},
        FacetSides::front);
    ASSERT_TRUE(facet);
    const PicturePoint at = camera.project({5, 1}, 0);
    const int x = int(at.x / at.w), y = int(at.y / at.w);
    const FacetCorner found = facet->at(x, y);
    const PicturePoint back = camera.project(found.p, found.z);
    EXPECT_NEAR(back.x / back.w, x + 0.5, 1e-9);
    EXPECT_NEAR(back.y / back.w, y + 0.5, 1e-9);
    EXPECT_NEAR(found.z, 0, 1e-12);
    EXPECT_NEAR(found.uv.x, found.p.x, 1e-12);
    EXPECT_NEAR(found.uv.y, found.p.y, 1e-12);
}

}  // namespace
}  // namespace enfilade
