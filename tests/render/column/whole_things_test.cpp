// Things that nothing cuts: what hides a part of them, and what does not.
#include <gtest/gtest.h>

#include <algorithm>

#include "render/column/agreement.h"
#include "render/column/column_renderer.h"
#include "space/trace.h"

namespace enfilade {
namespace {

using namespace test;

/// A thing with a picture of 64 x 64 opaque texels, a metre wide and high, that stands on its bottom middle.
ThingRecord block_at(Vec2 position, double z = 0) {
    ThingRecord thing;
    thing.position = position;
    thing.z = z;
    thing.size = 64;
    thing.frames = {{"block", 0, Vec2{32, 64}}};
    return thing;
}

/// A hall under the sky, a room behind a doorway in its east wall, whose floor is a metre higher.
MapFile two_rooms(ThingEdges edges) {
    MapFile file = map_of({box_room("hall", 0, 0, 10, 8, 0, 3), box_room("room", 10, 2, 20, 6, 1, 3)});
    split_and_join(file);
    sector(file, "hall").ceiling.parallax = true;
    file.render.things = edges;
    return file;
}

/// Pixels that show the thing from (2, 4), 1.5 m high, looking along x: 80 px to the metre a metre away.
std::size_t shown(const MapFile& file, Vec2 eye = {2, 4}) {
    const TexturedMap world(file);
    View view;
    view.sector = locate(world.map, eye);
    view.eye = eye;
    view.eye_z = 1.5;
    Frame frame;
    frame.resize(160, 100);
    FrameFacts facts;
    reset(facts, 160, 100);
    ColumnRenderer(world.map, world.textures).render(frame, &facts, world.snapshot, view);
    return static_cast<std::size_t>(std::ranges::count(facts.ids, thing_id(world.map, ThingId(std::size_t{0}))));
}

/// The same where the thing is cut, and where it is whole.
struct Shown {
    std::size_t cut, whole;
};
Shown shown(const ThingRecord& thing, Vec2 eye = {2, 4}) {
    const auto with = [&](ThingEdges edges) {
        MapFile file = two_rooms(edges);
        file.things = {thing};
        return shown(file, eye);
    };
    return {with(ThingEdges::cut), with(ThingEdges::whole)};
}

constexpr std::size_t kAll = 20 * 20;  ///< pixels of a block 4 m away

TEST(WholeThings, AreSeenFreeStandingAsOthersAre) {
    const Shown block = shown(block_at({6, 4}));
    EXPECT_EQ(block.cut, kAll);
    EXPECT_EQ(block.whole, kAll);
}

TEST(WholeThings, AreNotCutByTheFloorTheyHangInto) {
    const Shown block = shown(block_at({6, 4}, -0.5));
    EXPECT_EQ(block.cut, kAll / 2);
    EXPECT_EQ(block.whole, kAll);
}

TEST(WholeThings, AreNotCutByTheSky) {
    const Shown block = shown(block_at({6, 4}, 2.5));
    EXPECT_EQ(block.cut, kAll / 2);
    EXPECT_EQ(block.whole, kAll);
}

/// The wall y = 0 runs along the look; half of the block reaches beyond it.
TEST(WholeThings, AreNotCutByTheWallTheyLeanInto) {
    const Shown block = shown(block_at({6, 0x1p-20}), {2, 1});
    EXPECT_EQ(block.cut, kAll / 2);
    EXPECT_EQ(block.whole, kAll);
}

/// The doorway's step is a metre high: it hides what is lower, of things that stand behind it.
TEST(WholeThings, AreHiddenByStepsThatTheyStandBehind) {
    const Shown low = shown(block_at({10.5, 4}, 0)), raised = shown(block_at({10.5, 4}, 1));
    EXPECT_EQ(low.whole, 0u);
    EXPECT_GT(raised.whole, 0u);
    EXPECT_EQ(raised.whole, raised.cut);
}

/// In the room beside the doorway, behind the hall's wall.
TEST(WholeThings, AreHiddenByWallsThatTheyStandBehind) {
    const Shown half = shown(block_at({10.25, 2}, 1), {2, 2});
    EXPECT_GT(half.whole, 0u);
    EXPECT_EQ(half.whole, half.cut);
}

/// Half of it is on either side of the doorway, which runs along the look.
TEST(WholeThings, AreSeenOnceWhereTheyStandInADoorway) {
    MapFile file = map_of({box_room("a", 0, 0, 10, 4, 0, 3), box_room("b", 0, 4, 10, 8, 0, 3)});
    join_all(file);
    file.render.things = ThingEdges::whole;
    for (const double y : {3.75, 4.0, 4.25}) {
        file.things = {block_at({6, y})};
        EXPECT_EQ(shown(file, {2, 3.5}), kAll) << y;
        EXPECT_EQ(shown(file, {2, 4.5}), kAll) << y;
    }
}

}  // namespace
}  // namespace enfilade
