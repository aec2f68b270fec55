// Random walks through one-way portals: everybody gets through, nobody gets stuck or gets out of the world, and nobody
// comes back but by a way back.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "math/predicates.h"
#include "world/one_way_maps.h"
#include "world/random_walks.h"

namespace enfilade {
namespace {

using namespace test;

/// One person in one pair of rooms, checked after every tick.
class Passage {
public:
    Passage(const OneWayPair& pair, Random& random)
        : pair_(pair), rooms_(pair), random_(random), game_(placed()), keys_(random.bits()) {
        for (const Wall& wall : game_.map.walls)
            if (wall.kind == WallKind::portal) exit_ = &game_.map[wall.exit];
    }

    /// Random keys for some ticks; `goal`: towards it instead, in the coordinates of the pair.
    void go(int ticks, const Vec2* goal = nullptr) {
        for (int i = 0; i < ticks && !testing::Test::HasFatalFailure(); ++i) {
            TickInput keys = keys_.next();
            if (goal) turn_to(*goal, keys);
            if (pair_.head < kStandingHeight) keys.buttons |= kButtonCrouch;
            game_.hold(keys);
            check();
        }
    }

    void walk_through(int ticks) {
        const Vec2 before{-1.5, 0}, beyond{1, 0};
        for (int i = 0; i < ticks && !is_through(); ++i) {
            const Vec2 here = local();
            const bool is_aside = std::fabs(here.y) > pair_.width / 2 - kBodyRadius && here.x > -0.75;
            go(1, is_aside ? &before : &beyond);
        }
    }

    bool is_through() const { return game_.room() == "far"; }
    bool is_free() const {
        const Instant at = now(game_.map, game_.world);
        return around(at, body_of(at, game_.player())).walls.empty();
    }
    Vec2 local() const { return rooms_.local(game_.map, game_.player().place); }

private:
    MapFile placed() {
        rooms_.place({random_.uniform(-3.5, -1.5), random_.uniform(-2.5, 2.5)}, random_.uniform(0, 360));
        return rooms_.file();
    }

    void turn_to(Vec2 goal, TickInput& keys) const {
        const Player& player = game_.player();
        const Angle turn = rooms_.yaw_to(game_.map, player.place, goal) - player.yaw;
        keys.yaw_steps = static_cast<std::int32_t>(turn.steps);
        keys.forward = 127;
        keys.strafe = 0;
    }

    void check() {
        ASSERT_TRUE(game_.is_contained());
        if (was_through_ && !pair_.way_back) {
            ASSERT_TRUE(is_through()) << "nobody comes back";
        }
        was_through_ = is_through();
        if (pair_.way_back) {
            ASSERT_EQ(bool(game_.world.history.way_back(static_cast<double>(game_.world.tick))), is_through());
        }
        if (!was_through_ || pair_.way_back) return;
        const Vec2 p = game_.point();
        ASSERT_FALSE(segment_is_nearer(exit_->a, exit_->b, p, kept_)) << "nobody gets deeper into the exit";
        const Vec2 to_exit = nearest_point({exit_->a, exit_->b}, p) - p;
        const double distance = snap_to_point_grid(std::sqrt(dot(to_exit, to_exit))) - 2 * kPointGrid;
        kept_ = std::max(kept_, std::min(distance, kBodyRadius));
    }

    OneWayPair pair_;
    OneWayMap rooms_;
    Random& random_;
    Game game_;
    RandomKeys keys_;
    const Wall* exit_ = nullptr;
    double kept_ = 0;  ///< from the exit, the most so far [m]
    bool was_through_ = false;
};

// With ENFILADE_LONG a hundred thousand walks.
TEST(OneWayWalks, AllGetThroughAndOutOfTheExit) {
    const int walks = std::getenv("ENFILADE_LONG") ? 100'000 : 1500;
    for (int i = 0; i < walks && !HasFatalFailure(); ++i) {
        Random random(static_cast<std::uint64_t>(i));
        const OneWayPair pair = any_pair(random);
        SCOPED_TRACE(testing::Message() << "walk " << i);
        Passage passage(pair, random);
        passage.go(30);
        passage.walk_through(400);
        ASSERT_TRUE(passage.is_through()) << passage.local().x << ", " << passage.local().y;
        passage.go(30);
        const Vec2 away{2, 0};
        passage.go(90, &away);
        ASSERT_TRUE(passage.is_free()) << passage.local().x << ", " << passage.local().y;
    }
}

/// The same ways with a way back, to and fro.
TEST(OneWayWalks, GoBackAndForthByAWayBack) {
    const int walks = std::getenv("ENFILADE_LONG") ? 100'000 : 500;
    int came_back = 0;
    for (int i = 0; i < walks && !HasFatalFailure(); ++i) {
        Random random(static_cast<std::uint64_t>(i));
        OneWayPair pair = any_pair(random);
        pair.way_back = true;
        SCOPED_TRACE(testing::Message() << "walk " << i);
        Passage passage(pair, random);
        for (int turn = 0; turn < 3; ++turn) {
            passage.walk_through(400);
            ASSERT_TRUE(passage.is_through()) << passage.local().x << ", " << passage.local().y;
            passage.go(20);
            const Vec2 before{-1, 0};
            for (int tick = 0; tick < 120 && passage.is_through(); ++tick) passage.go(1, &before);
            came_back += !passage.is_through();
            if (passage.is_through()) break;
        }
        const Vec2 away = passage.is_through() ? Vec2{2, 0} : Vec2{-2, 0};
        passage.go(90, &away);
        ASSERT_TRUE(passage.is_free()) << passage.local().x << ", " << passage.local().y;
    }
    EXPECT_GT(came_back, walks) << "the others stand below a step that is too high, or behind a jamb";
}

}  // namespace
}  // namespace enfilade
