// In which order rays meet edges all around an eye: in a ring, in rows, and at corners.
#include "render/stencil/plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/hash.h"
#include "math/angle.h"
#include "math/vec.h"

namespace enfilade::stencil {
namespace {

constexpr Vec2 kEye{0x1p-32, 0};

std::vector<SweptPart> swept(const std::vector<Segment>& edges) {
    return in_order_of_rays(edges, kEye, [&](std::size_t i, std::size_t j) { return is_nearer(edges[i], edges[j]); });
}

/// How far away the ray meets the edge; none: it does not.
std::optional<double> distance(const Segment& edge, Vec2 way) {
    const Vec2 a = edge.a - kEye, b = edge.b - kEye;
    if (cross(a, way) < 0 || cross(way, b) <= 0) return {};
    return cross(a, b) / cross(way, b - a);
}

bool is_in(const SweptPart& part, Vec2 way) {
    return !(part.begins_at_cut && way.y < 0) && !(part.ends_at_cut && way.y > 0);
}

/// Along 360 rays; no edge ends on one.
void expect_nearer_first(const std::vector<Segment>& edges) {
    const std::vector<SweptPart> parts = swept(edges);
    for (int degree = 0; degree < 360; ++degree) {
        const Vec2 way = direction(Angle::from_degrees(degree + 0.3));
        double reached = 0;
        std::size_t met = 0, expected = 0;
        for (const SweptPart& part : parts) {
            const auto there = distance(edges[part.edge], way);
            if (!there || !is_in(part, way)) continue;
            EXPECT_GE(*there, reached) << degree;
            reached = *there;
            ++met;
        }
        for (const Segment& edge : edges) expected += distance(edge, way).has_value();
        EXPECT_EQ(met, expected) << degree;
    }
}

/// From one radius to another, so many degrees on.
Segment spoke(double begin, double degrees, double from, double to) {
    return {snap_to_vertex_grid(direction(Angle::from_degrees(begin)) * from),
            snap_to_vertex_grid(direction(Angle::from_degrees(begin + degrees)) * to)};
}

TEST(Sweep, CutsOneEdgeOfARingOfWhichEachIsBeforeTheNext) {
    for (const double turned : {20.0, 46.0, 70.0}) {
        std::vector<Segment> ring;
        for (int i = 0; i < 4; ++i) ring.push_back(spoke(turned + 90 * i, 100, 1, 3));
        EXPECT_EQ(swept(ring).size(), 5u);
        expect_nearer_first(ring);
        std::reverse(ring.begin(), ring.end());
        expect_nearer_first(ring);
    }
}

TEST(Sweep, PutsEdgesOfAnyLengthInOrder) {
    Random random(1);
    std::vector<Segment> edges;
    for (int i = 1; i <= 200; ++i) {  // each within a ring of its own: a chord comes no nearer than half its radius
        const double radius = std::exp2(i / 16.0), degrees = random.uniform(1, 15);
        edges.push_back(spoke(random.uniform(0, 360), degrees, radius, radius));
    }
    for (std::size_t i = edges.size(); i > 1; --i) std::swap(edges[i - 1], edges[random.below(i)]);
    expect_nearer_first(edges);
}

/// The eye counts as a hair further down than the corner, so the cut meets only the edge below it.
TEST(Sweep, CutsOneEdgeOfACornerInTheDirectionOfTheCut) {
    std::vector<std::size_t> whole;
    for (const SweptPart& part : swept({{{2, -1}, {2, 0}}, {{2, 0}, {2, 1}}}))
        if (!part.begins_at_cut && !part.ends_at_cut) whole.push_back(part.edge);
    EXPECT_EQ(whole, std::vector<std::size_t>{0});
}

}  // namespace
}  // namespace enfilade::stencil
