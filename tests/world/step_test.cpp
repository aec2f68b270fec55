// What one feels when walking: pace, stairs, ledges, low ceilings, the eye.
#include "world/step.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "base/files.h"
#include "base/hash.h"
#include "formats/text_parts.h"
#include "world/game.h"
#include "world/player_fault.h"

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace enfilade {
namespace {

using namespace test;

double speed_of(const Player& player) { return std::sqrt(dot(player.velocity, player.velocity)); }

/// Rooms of 1 x 4 m in a row along x, with these floors and a ceiling at 8 m, behind a hall of 4 x 4 m with floor 0.
MapFile stairs(const std::vector<double>& floors, double ceiling_z = 8) {
    std::vector<SectorRecord> rooms{box_room("hall", 0, 0, 4, 4, 0, ceiling_z)};
    for (std::size_t i = 0; i < floors.size(); ++i) {
        const double x = 4 + static_cast<double>(i);
        rooms.push_back(box_room("step " + std::to_string(i + 1), x, 0, x + 1, 4, floors[i], ceiling_z));
    }
    MapFile file = map_of(std::move(rooms));
    join_all(file);
    place_player(file, "hall", {2, 2}, kEyeOnFloor, 0);
    return file;
}

/// A hall of height 3, and behind x = 4 a room of 4 x 4 m with another floor and ceiling.
MapFile hall_and(double floor_z, double ceiling_z) {
    MapFile file = map_of({box_room("hall", 0, 0, 4, 4, 0, 3), box_room("far", 4, 0, 8, 4, floor_z, ceiling_z)});
    join_all(file);
    place_player(file, "hall", {2, 2}, kEyeOnFloor, 0);
    return file;
}

MapFile big_hall() {
    MapFile file = map_of({box_room("hall", 0, 0, 200, 200)});
    place_player(file, "hall", {100, 100}, kEyeOnFloor, 0);
    return file;
}

TEST(Step, ReachesTheFullPaceAndNoMore) {
    Game game(big_hall());
    game.hold(kForward, 120);
    EXPECT_NEAR(speed_of(game.player()), kWalkSpeed, 1e-6);
    game.hold(kRunForward, 120);
    EXPECT_NEAR(speed_of(game.player()), kRunSpeed, 1e-6);
}

TEST(Step, IsNoFasterDiagonally) {
    Game game(big_hall());
    game.hold({.forward = 127, .strafe = 127}, 120);
    EXPECT_NEAR(speed_of(game.player()), kWalkSpeed, 1e-6);
}

TEST(Step, GoesHalfThePaceForHalfTheKey) {
    Game game(big_hall());
    game.hold({.forward = 64}, 120);
    EXPECT_NEAR(speed_of(game.player()), kWalkSpeed * 64 / 127, 1e-6);
}

TEST(Step, StrafesToTheRightOfTheLook) {
    Game game(big_hall());
    game.hold(kRight, 60);
    EXPECT_GT(game.point().y, 101) << "y runs down: right of +x is +y";
    EXPECT_EQ(game.point().x, 100);
}

// hard case C23
TEST(Step, ComesToAStandstillInsteadOfCreepingForEver) {
    Game game(big_hall());
    game.hold(kRunForward, 120);
    game.hold(kNoKeys, 60);
    EXPECT_EQ(game.player().velocity, (Vec2{}));
    const Player at_rest = game.player();
    game.hold(kNoKeys, 10);
    EXPECT_EQ(game.player(), at_rest);
}

#if defined(__SSE2__)
/// Denormal numbers count as zero, for arguments and for results, as long as this lives.
class DenormalsFlushed {
public:
    DenormalsFlushed() : before_(_mm_getcsr()) { _mm_setcsr(before_ | 0x8040); }
    ~DenormalsFlushed() { _mm_setcsr(before_); }
    DenormalsFlushed(const DenormalsFlushed&) = delete;
    DenormalsFlushed& operator=(const DenormalsFlushed&) = delete;

private:
    unsigned before_;
};

/// Runs and lets go, again and again, each time for longer than speeds need to become denormal.
Hash states_of_running_out() {
    Hash states;
    for (const double yaw : {0.0, 33.0, 90.0, 137.0}) {
        MapFile file = big_hall();
        file.player->yaw_degrees = yaw;
        Game game(file);
        game.hold(kRunForward, 60);
        for (int i = 0; i < 8000; ++i) {
            game.hold(kNoKeys);
            states.add(hash(game.world));
        }
    }
    return states;
}

// hard case C23
TEST(Step, GivesTheSameStatesWhereDenormalNumbersAreFlushed) {
    const std::uint64_t kept = states_of_running_out().value();
    const DenormalsFlushed flushed;
    EXPECT_EQ(states_of_running_out().value(), kept);
}
#endif

TEST(Step, LooksUpAndDownOnlySoFar) {
    Game game(big_hall());
    game.hold({.pitch_steps = 1 << 30}, 9);
    EXPECT_EQ(game.player().pitch_steps, kMaxPitchSteps);
    game.hold({.pitch_steps = -(1 << 30)}, 9);
    EXPECT_EQ(game.player().pitch_steps, -kMaxPitchSteps);
}

// hard case C29
TEST(Step, TurnsAnyNumberOfTimes) {
    Game game(big_hall());
    game.hold({.yaw_steps = 1 << 30}, 4 * 1000 + 1);
    EXPECT_EQ(game.player().yaw, Angle::from_degrees(90));
}

TEST(Step, ClimbsStairsAndComesDownAgain) {
    Game game(stairs({0.5, 1, 1.5, 2, 2.5, 3}));
    game.hold(kForward, 160);
    EXPECT_EQ(game.room(), "step 6");
    EXPECT_EQ(game.player().feet_z, 3);
    game.hold(kBack, 200);
    EXPECT_EQ(game.room(), "hall");
    EXPECT_EQ(game.player().feet_z, 0);
}

TEST(Step, StaysOnTheGroundWalkingDownStairs) {
    Game game(stairs({0.5, 1, 1.5, 2, 2.5, 3}));
    game.hold(kForward, 160);
    for (int i = 0; i < 120; ++i) {
        game.hold(kBack);
        ASSERT_TRUE(game.player().on_ground) << "tick " << i;
    }
}

// hard case C20
TEST(Step, ClimbsExactlyTheHighestStep) {
    for (const double floor : {kMaxStep, kMaxStep + 0x1p-9}) {
        Game game(hall_and(floor, 3));
        game.hold(kForward, 100);
        EXPECT_EQ(game.room() == "far", floor <= kMaxStep) << floor;
    }
}

TEST(Step, ClimbsADecimalStepThatIsTooHighByABinaryFraction) {
    // 1.8 - 1.05 is 0.75 and a bit more, in double.
    Game game(stairs({0.3, 1.05, 1.8}));
    game.hold(kForward, 120);
    EXPECT_EQ(game.room(), "step 3");
}

TEST(Step, DoesNotPassAClosedDoor) {
    Game game(hall_and(0, 0));
    game.hold(kRunForward, 200);
    EXPECT_EQ(game.point(), (Vec2{4 - kBodyRadius, 2}));
}

TEST(Step, DoesNotPassBelowALowCeilingUpright) {
    Game game(hall_and(0, kStandingHeight - 0x1p-9));
    game.hold(kForward, 100);
    EXPECT_EQ(game.room(), "hall");
    Game just_fits(hall_and(0, kStandingHeight));
    just_fits.hold(kForward, 100);
    EXPECT_EQ(just_fits.room(), "far");
}

TEST(Step, CrouchesBelowALowCeilingAndCannotStandUpThere) {
    Game game(hall_and(0, 1.25));
    game.hold(kCrouchForward, 200);
    ASSERT_EQ(game.room(), "far");
    EXPECT_EQ(game.player().height, kCrouchedHeight);
    game.hold(kNoKeys, 60);
    EXPECT_EQ(game.player().height, 1.25) << "stands up as far as it goes";
    EXPECT_LT(game.player().eye_z, 1.25);
    game.hold(kBack, 200);
    ASSERT_EQ(game.room(), "hall");
    EXPECT_EQ(game.player().height, kStandingHeight);
}

TEST(Step, CannotStandUpWithHalfABodyBelowALowCeiling) {
    Game game(hall_and(0, 1.25));
    game.hold(kCrouchForward, 60);
    ASSERT_EQ(game.room(), "hall");
    ASSERT_GT(game.point().x, 4 - kBodyRadius);
    game.hold(kNoKeys, 60);
    EXPECT_EQ(game.player().height, 1.25);
}

TEST(Step, DoesNotClimbWhereTheCeilingInFrontOfTheStepIsTooLow) {
    // Both rooms are high enough by themselves, but on the step one still has the head below the first ceiling.
    MapFile file = map_of({box_room("hall", 0, 0, 4, 4, 0, 2), box_room("far", 4, 0, 8, 4, 0.5, 3)});
    join_all(file);
    place_player(file, "hall", {2, 2}, kEyeOnFloor, 0);
    Game game(file);
    game.hold(kForward, 100);
    EXPECT_EQ(game.room(), "hall");
}

TEST(Step, SlidesAlongAStepUntilTheHeadIsOutFromUnderABeam) {
    // The beam and the step do not meet, but the body is wide enough to be below the one and at the other.
    MapFile file = map_of({box_room("beam", 0, 0, 4, 2, 0, 2), box_room("hall", 0, 2, 4, 10, 0, 3),
                           box_room("porch", 4, 0, 8, 2.3125, 0, 3), box_room("step", 4, 2.3125, 8, 10, 0.5, 3)});
    split_and_join(file);
    place_player(file, "hall", {3, 2.125}, kEyeOnFloor, 5);
    Game game(file);
    game.hold(kForward, 20);
    EXPECT_EQ(game.room(), "hall") << "stopped by the step";
    game.hold(kForward, 100);
    EXPECT_EQ(game.room(), "step");
}

TEST(Step, FallsFromALedgeAndLands) {
    MapFile file = map_of({box_room("ledge", 0, 0, 4, 4, 3, 8), box_room("yard", 4, 0, 12, 4, 0, 8)});
    join_all(file);
    place_player(file, "ledge", {2, 2}, 3 + kEyeOnFloor, 0);
    Game game(file);
    game.hold(kForward, 30);
    ASSERT_EQ(game.player().feet_z, 3);
    int ticks_in_air = 0;
    double last = 3;
    for (int i = 0; i < 120; ++i) {
        game.hold(kForward);
        ASSERT_LE(game.player().feet_z, last);
        last = game.player().feet_z;
        ticks_in_air += !game.player().on_ground;
    }
    EXPECT_EQ(game.player().feet_z, 0);
    EXPECT_NEAR(ticks_in_air * kTickSeconds, std::sqrt(2 * 3 / 16.0), 2 * kTickSeconds);
}

TEST(Step, StandsOnALedgeAsLongAsAnyOfTheBodyDoes) {
    MapFile file = map_of({box_room("ledge", 0, 0, 4, 4, 3, 8), box_room("yard", 4, 0, 12, 4, 0, 8)});
    join_all(file);
    place_player(file, "yard", {4 + kBodyRadius - kPointGrid, 2}, 3 + kEyeOnFloor, 0);
    Game game(file);
    game.hold(kNoKeys, 60);
    EXPECT_EQ(game.player().feet_z, 3);
}

// hard case C20
TEST(Step, TakesAStepBehindALinkLikeTheSameStepWithoutOne) {
    for (const double step : {kMaxStep, kMaxStep + 0x1p-9})
        for (const double base : {0.0, 5.0}) {
            MapFile linked =
                map_of({box_room("hall", 0, 0, 4, 4, 0, 3), box_room("far", 104, 0, 108, 4, base, base + 3),
                        box_room("up", 108, 0, 112, 4, base + step, base + 3)});
            join(linked, "far", "up", {108, 0}, {108, 4});
            link(linked, "hall", {4, 0}, {4, 4}, "far", {104, 4}, {104, 0});
            place_player(linked, "hall", {2, 2}, kEyeOnFloor, 0);
            Game game(linked);
            game.hold(kForward, 150);
            EXPECT_EQ(game.room(), step <= kMaxStep ? "up" : "far");
            EXPECT_EQ(game.player().feet_z, step <= kMaxStep ? base + step : base);
        }
}

TEST(Step, MovesTheEyeSmoothlyOverSteps) {
    Game game(stairs({0.7, 1.4, 0.7, 0}));
    double last = game.player().eye_z;
    for (int i = 0; i < 120; ++i) {
        game.hold(kForward);
        ASSERT_LT(std::fabs(game.player().eye_z - last), 0.2) << "tick " << i;
        last = game.player().eye_z;
    }
    EXPECT_EQ(game.room(), "step 4");
}

TEST(Step, KeepsTheEyeBelowATunnelsCeilingRightAfterAStepDown) {
    MapFile file = map_of({box_room("ledge", 0, 0, 4, 4, 0.75, 4), box_room("gap", 4, 0, 4.875, 4, 0, 4),
                           box_room("tunnel", 4.875, 0, 20, 4, 0, 1.8)});
    join_all(file);
    place_player(file, "ledge", {2, 2}, 0.75 + kEyeOnFloor, 0);
    Game game(file);
    for (int i = 0; i < 90; ++i) {
        game.hold(kRunForward);
        ASSERT_LT(game.player().eye_z, game.room() == "tunnel" ? 1.8 : 4);
    }
    EXPECT_EQ(game.room(), "tunnel");
}

TEST(Step, MovesTheEyeToItsHeightAboveTheFloor) {
    Game game(stairs({0.7, 1.4}));
    game.hold(kForward, 300);
    EXPECT_DOUBLE_EQ(game.player().eye_z, 1.4 + 1.55);
    game.hold(kCrouch, 60);
    EXPECT_DOUBLE_EQ(game.player().eye_z, 1.4 + 0.85);
}

TEST(Step, StandsUpInARoomThatIsTooLowWithoutTheEyeLeavingIt) {
    MapFile file = map_of({box_room("crawlspace", 0, 0, 4, 4, 0, 0.5)});
    place_player(file, "crawlspace", {2, 2}, 0.4, 0);
    Game game(file);
    game.hold(kForward, 60);
    EXPECT_GT(game.player().eye_z, 0);
    EXPECT_LT(game.player().eye_z, 0.5);
    EXPECT_GT(game.point().x, 3) << "and can walk";
}

/// Treads of a quarter of a metre between walls that are narrower than a body, each step higher than the last.
MapFile fine_stair(double riser) {
    std::vector<SectorRecord> steps;
    for (int i = 0; i < 8; ++i)
        steps.push_back(
            box_room("step" + std::to_string(i), 0.25 * i, 0, 0.25 * (i + 1), 0.625, riser * i, 8 + riser * i));
    MapFile file = map_of(std::move(steps));
    join_all(file);
    return file;
}

// Lifted onto one step one comes free of the next, which was too high to climb and is below the body, too.
// hard case C22
TEST(Step, LeavesNobodyInTheStepsOfAStairThatIsFinerThanABody) {
    for (const double riser : {0.125, 0.5, 0.625, 0.75, 1.0}) {
        for (int step = 0; step < 8; ++step) {
            MapFile file = fine_stair(riser);
            place_player(file, "step" + std::to_string(step), {0.25 * step + 0.125, 0.3125},
                         riser * step + kEyeOnFloor);
            Game game(file);
            PlayerWatch watch;
            EXPECT_EQ(watch.fault_of(game.map, game.world), "") << riser << ", put onto step " << step;
            for (const TickInput& keys : {kForward, kBack, kCrouchForward})
                for (int tick = 0; tick < 60; ++tick) {
                    game.hold(keys);
                    ASSERT_EQ(watch.fault_of(game.map, game.world), "") << riser << ", from step " << step;
                }
        }
    }
}

// One falls past the lintel of a low room, whose floor is higher than where one would get to in that tick.
TEST(Step, LeavesNobodyBelowTheFloorThatIsReachedAsOneFallsPastALintel) {
    int fallen = 0;
    for (int start = 0; start < 20; ++start) {
        MapFile file = map_of({box_room("shaft", 0, 0, 0.25, 4, 0, 8), box_room("low", 0.25, 0, 4, 4, 0.5, 2.2578125)});
        join_all(file);
        place_player(file, "shaft", {0.1875, 2}, 3 + 0.0625 * start + kEyeOnFloor);
        Game game(file);
        PlayerWatch watch;
        for (int tick = 0; tick < 90; ++tick) {
            game.hold(kNoKeys);
            ASSERT_EQ(watch.fault_of(game.map, game.world), "") << start << ", tick " << tick;
        }
        fallen += game.player().feet_z == 0.5;
    }
    EXPECT_GT(fallen, 0);
}

// hard case C22
TEST(Step, SurvivesASpawnInAClosedSector) {
    MapFile file = map_of({box_room("door", 0, 0, 4, 4, 1, 1)});
    place_player(file, "door", {2, 2}, 1, 0);
    Game game(file);
    game.hold(kForward, 60);
    EXPECT_TRUE(game.is_contained());
    EXPECT_EQ(game.player().eye_z, 1);
}

// hard cases C22, I11
TEST(Step, StaysInTheWorldFromEverySpawnOnALatticeOfTies) {
    MapFile file = map_of({box_room("nw", 0, 0, 2, 2), box_room("ne", 2, 0, 4, 2), box_room("sw", 0, 2, 2, 4),
                           box_room("se", 2, 2, 4, 4)});
    join_all(file);
    place_player(file, "nw", {1, 1}, kEyeOnFloor);
    Game game(file);
    for (int x = 0; x < 8; ++x)
        for (int y = 0; y < 8; ++y) {
            const Vec2 start{x / 2.0, y / 2.0};
            game.world.player = player_at(game.map, {locate(game.map, start), start, kEyeOnFloor, {}});
            for (const TickInput& keys : {kForward, kLeft, kBack, kRight}) {
                game.hold(keys, 20);
                ASSERT_TRUE(game.is_contained()) << x << "," << y;
            }
        }
}

/// "| what | measure" in the manual for authors.
TEST(PlayerMeasures, AreThoseOfTheManual) {
    const auto bytes = read_file(ENFILADE_SOURCE_DIR "/maps/FORMAT.md");
    const std::string manual(as_text(bytes.value()));
    const std::string radius = std::to_string(std::lround(kBodyRadius * 100));
    for (const std::string& row : {"| radius | 0." + radius + " m",
                                   "| height | " + number_text(kStandingHeight) + " m standing, " +
                                       number_text(kCrouchedHeight) + " m crouched |",
                                   "| highest step | " + number_text(kMaxStep) + " m",
                                   "| speed | " + number_text(kWalkSpeed) + " m/s walking, " + number_text(kRunSpeed) +
                                       " m/s running, " + number_text(kCrouchSpeed) + " m/s crouched |"})
        EXPECT_THAT(manual, ::testing::HasSubstr(row));
}

}  // namespace
}  // namespace enfilade
