// The same walks through a doorway and through a link, which must agree: a near room of 4 x 4 m from (0, 0), and a far
// one beyond x = 4 or, turned by a quarter, at (100, 50).
#pragma once
#include <gtest/gtest.h>

#include "world/game.h"

namespace enfilade::test {

/// The rooms lie at other places of the number line, so sums are rounded otherwise: a grid step now and then [m].
inline constexpr double kOtherRounding = 64 * kPointGrid;

/// Walks at the doorway from all along the near room; check(game) after each tick of either.
template <class Check>
void expect_same_walks(MapFile door, MapFile link, Check check) {
    for (double y = 0.5; y < 3.75; y += 0.0625) {
        place_player(door, "near", {2, y}, kEyeOnFloor, 5);
        place_player(link, "near", {2, y}, kEyeOnFloor, 5);
        Game plain(door), linked(link);
        for (int i = 0; i < 150; ++i) {
            SCOPED_TRACE(testing::Message() << "from " << y << ", tick " << i);
            plain.hold(kForward);
            linked.hold(kForward);
            const Vec2 p = plain.point();
            const Vec2 expected = plain.room() == "far" ? Vec2{102 - (p.y - 2), 50 + (p.x - 4)} : p;
            ASSERT_EQ(linked.room(), plain.room());
            ASSERT_NO_FATAL_FAILURE(check(plain));
            ASSERT_NO_FATAL_FAILURE(check(linked));
            ASSERT_NEAR(linked.point().x, expected.x, kOtherRounding);
            ASSERT_NEAR(linked.point().y, expected.y, kOtherRounding);
        }
    }
}

}  // namespace enfilade::test
