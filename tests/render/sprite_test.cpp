// The rules by which things are seen.
#include "render/sprite.h"

#include <gtest/gtest.h>

#include <cmath>

#include "math/vec.h"
#include "support/map_builder.h"

namespace enfilade {
namespace {

using namespace test;

Presence standing_at(Vec2 position) { return {ThingId(0u), {}, position}; }

Angle degrees(double d) { return Angle::from_degrees(d); }

// Yaw 0 looks along +x and growing yaws turn right, so a thing that looks along +x has its left at -y.
TEST(ViewOfAThing, GoesRoundFromTheFrontToItsLeft) {
    const Presence thing = standing_at({10, 10});
    const Vec2 eyes[] = {{14, 10}, {13, 7}, {10, 6}, {7, 7}, {6, 10}, {7, 13}, {10, 14}, {13, 13}};
    for (std::size_t view = 0; view < 8; ++view) EXPECT_EQ(view_from(eyes[view], thing, degrees(0)), view);
}

TEST(ViewOfAThing, TurnsWithIt) {
    for (int eighths = 0; eighths < 8; ++eighths)
        EXPECT_EQ(view_from({14, 10}, standing_at({10, 10}), degrees(45 * eighths)), std::size_t(eighths));
}

// With yaw 22.5 the eye straight along x is on the line between two views; half a step of the grid decides.
TEST(ViewOfAThing, ChangesExactlyOnTheLineBetweenTwoEighths) {
    const Presence thing = standing_at({10, 10});
    EXPECT_EQ(view_from({30000, 10 - kPointGrid}, thing, degrees(22.5)), 1u);
    EXPECT_EQ(view_from({30000, 10 + kPointGrid}, thing, degrees(22.5)), 0u);
}

TEST(ViewOfAThing, OnTheLineIsTheOneTheTieRuleSays) {
    const Presence thing = standing_at({10, 10});
    EXPECT_EQ(view_from({30000, 10}, thing, degrees(22.5)), 0u);   // the eye counts as a little farther down
    EXPECT_EQ(view_from({10, -30000}, thing, degrees(22.5)), 2u);  // and to the right
}

TEST(ViewOfAThing, HasAnAnswerFromItsVeryPlace) { EXPECT_LT(view_from({10, 10}, standing_at({10, 10}), {}), 8u); }

TEST(ViewOfAThing, BehindALinkTurnsWithTheLink) {
    const Rigid quarter{0, 1, 1, {}, 0};  // turns +x to +y
    EXPECT_EQ(view_from({10, 14}, {ThingId(0u), quarter, {10, 10}}, degrees(0)), 0u);
}

/// Whether a thing at this depth is in the room between two others.
bool is_between(double depth, double entry, double exit) {
    const std::int64_t steps = depth_steps(depth);
    return RoomCrossing{{}, {}, depth_steps(entry) > steps, depth_steps(exit) > steps}.holds_thing();
}

TEST(DepthOfAThing, AtADoorwayIsInTheRoomBehind) {
    EXPECT_FALSE(is_between(5, 0, 5));
    EXPECT_TRUE(is_between(5, 5, 9));
}

TEST(DepthOfAThing, ThatRoundingMovedOffADoorwayIsStillInTheRoomBehind) {
    constexpr double kRounding = 1e-11;  // of depths carried through a link [m]
    for (double d : {5 - kRounding, 5 + kRounding}) {
        EXPECT_FALSE(is_between(d, 0, 5));
        EXPECT_TRUE(is_between(d, 5, 9));
    }
}

TEST(DepthOfAThing, IsInOneOfTwoRoomsThatFollowEachOther) {
    for (double d = 4.999; d < 5.001; d += 1e-7) EXPECT_NE(is_between(d, 0, 5.0000003), is_between(d, 5.0000003, 9));
}

/// From (0, 0) along x.
Middle middle_at(Vec2 place) { return {{0, 0}, {1, 0}, place, place.x}; }

TEST(MiddleOfAThing, IsBehindAWallThatEndsBeforeIt) {
    // Its line runs past the middle on either side.
    EXPECT_TRUE(is_behind(middle_at({5, 0}), {2, 1}, {4, 0.5}));
    EXPECT_TRUE(is_behind(middle_at({5, 0}), {2, -1}, {4, -0.5}));
    EXPECT_TRUE(is_behind(middle_at({5, 0}), {5, -1}, {5, 1}));
}

TEST(MiddleOfAThing, IsBeforeAWallThatBeginsBehindIt) {
    EXPECT_FALSE(is_behind(middle_at({5, 0}), {6, 1}, {8, 0.5}));
    EXPECT_FALSE(is_behind(middle_at({5, 0}), {5.001, -1}, {6, 1}));
}

TEST(MiddleOfAThing, IsOnOneSideOfAWallThatRunsPastIt) {
    for (const Vec2 place : {Vec2{5, 1}, Vec2{5, -1}, Vec2{5, 0}}) {
        const bool is_left = is_behind(middle_at(place), {0, 0}, {9, 0});
        EXPECT_EQ(is_left, place.y < 0) << place.y;
        EXPECT_NE(is_left, is_behind(middle_at(place), {9, 0}, {0, 0})) << place.y;
    }
}

TEST(PictureOfAThing, IsAsLargeAsItsTexelsSay) {
    MapFile file = map_of({box_room("room", 0, 0, 4, 4, 1, 4)});
    ThingRecord barrel;
    barrel.position = {1, 1};
    barrel.size = 16;
    barrel.frames = {{"barrel", 0, Vec2{32, 60}}};
    file.things = {barrel};
    const Map map = built(file);
    const Snapshot snapshot = at_rest(map);
    const SpritePicture picture =
        picture_of(map, textures_for(file), snapshot, snapshot.things.in(SectorId(0u))[0], {3, 3});
    EXPECT_EQ(picture.size_m, (Vec2{4, 4}));
    EXPECT_EQ(picture.origin_m, (Vec2{2, 3.75}));
    EXPECT_EQ(picture.foot_z, 1);
}

/// A card 4 m wide whose origin is a metre from its left edge, at (10, 10), that faces +x at the start and turns.
MapFile spinning_card() {
    MapFile file = map_of({box_room("room", 0, 0, 20, 20, 0, 4)});
    ThingRecord card;
    card.position = {10, 10};
    card.size = 16;
    card.turn = 90;
    card.frames = {{"card", 0, Vec2{16, 64}}};
    file.things = {card};
    return file;
}

SpritePicture card_at(double time_s, Vec2 eye) {
    const MapFile file = spinning_card();
    const Map map = built(file);
    Snapshot snapshot = at_rest(map);
    snapshot.time_s = time_s;
    return picture_of(map, textures_for(file), snapshot, snapshot.things.in(SectorId(0u))[0], eye);
}

TEST(SpinningCard, IsNarrowedAsItTurnsAway) {
    EXPECT_EQ(card_at(0, {18, 10}).size_m, (Vec2{4, 4}));
    const SpritePicture turned = card_at(0.5, {18, 10});
    EXPECT_NEAR(turned.size_m.x, 4 * std::sqrt(0.5), 1e-12);
    EXPECT_NEAR(turned.origin_m.x, std::sqrt(0.5), 1e-12);
    EXPECT_EQ(turned.size_m.y, 4);
    EXPECT_FALSE(turned.is_mirrored);
}

TEST(SpinningCard, IsNotSeenFromItsVeryEdge) {
    EXPECT_FALSE(card_at(1, {18, 10}).texture);
    EXPECT_TRUE(card_at(1, {10, 18}).texture);
}

TEST(SpinningCard, IsMirroredFromBehind) {
    EXPECT_TRUE(card_at(2, {18, 10}).is_mirrored);
    EXPECT_FALSE(card_at(2, {2, 10}).is_mirrored);
    EXPECT_EQ(card_at(2, {18, 10}).size_m.x, 4);
}

}  // namespace
}  // namespace enfilade
