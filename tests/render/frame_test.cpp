// Frames and the facts beside them; the numbers of surfaces.
#include "render/frame.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "support/map_builder.h"

namespace enfilade {
namespace {

Frame two_by_three(std::uint32_t color) {
    Frame frame;
    frame.resize(2, 3);
    frame.pixels.assign(6, color);
    return frame;
}

TEST(Frame, HasAPixelForEveryPlace) {
    Frame frame;
    frame.resize(117, 83);
    EXPECT_EQ(frame.pixels.size(), 117u * 83u);
}

TEST(Frame, BeginsOnACacheLineWhereverTheHeapHasRoom) {
    std::vector<Frame> frames(20);
    std::vector<std::vector<std::byte>> between;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        between.emplace_back(1 + 24 * i);
        frames[i].resize(3 + 50 * static_cast<int>(i), 7);
        EXPECT_EQ(reinterpret_cast<std::uintptr_t>(frames[i].pixels.data()) % kCacheLineBytes, 0u) << i;
    }
}

TEST(Frame, IsTheSameAfterAWayThroughAnImage) {
    Frame frame = two_by_three(0xFF102030u);
    frame.pixels[5] = 0xFF000007u;
    EXPECT_EQ(hash_of(frame_of(image_of(frame))), hash_of(frame));
}

TEST(FrameFacts, SayNothingIsDrawnAfterReset) {
    FrameFacts facts;
    facts.writes = {1, 2, 3};
    reset(facts, 3, 2);
    EXPECT_EQ(facts.ids, std::vector<PixelSurface>(6, kNothing));
    EXPECT_EQ(facts.writes, std::vector<std::uint8_t>(6, 0));
    EXPECT_TRUE(std::isinf(facts.depths[5]));
}

TEST(FrameHash, TellsPixelsApart) {
    Frame other = two_by_three(0xFF000000u);
    other.pixels[4] = 0xFF000001u;
    EXPECT_NE(hash_of(two_by_three(0xFF000000u)), hash_of(other));
}

TEST(FrameHash, TellsShapesOfTheSamePixelsApart) {
    Frame other = two_by_three(0xFF000000u);
    other.resize(3, 2);
    EXPECT_NE(hash_of(two_by_three(0xFF000000u)), hash_of(other));
}

TEST(SurfaceIds, AreDifferentForEverySurfaceOfAMap) {
    const Map map = test::built(test::map_of({test::box_room("a", 0, 0, 2, 2), test::box_room("b", 5, 0, 7, 2)}));
    std::set<PixelSurface> ids{kNothing, kRecursionEnd};
    for (std::size_t i = 0; i < map.sectors.size(); ++i) {
        EXPECT_TRUE(ids.insert(floor_id(SectorId(i))).second);
        EXPECT_TRUE(ids.insert(ceiling_id(SectorId(i))).second);
    }
    for (std::size_t i = 0; i < map.walls.size(); ++i)
        for (WallPart part : {WallPart::middle, WallPart::upper, WallPart::lower})
            EXPECT_TRUE(ids.insert(wall_id(map, WallId(i), part)).second);
}

TEST(SurfaceIds, LeadBackToTheirOwners) {
    MapFile file = test::map_of({test::box_room("a", 0, 0, 2, 2), test::box_room("b", 5, 0, 7, 2)});
    file.things.resize(2);
    for (ThingRecord& thing : file.things) thing.position = {1, 1};
    PanelRecord panel;
    panel.a = {5.5, 1}, panel.b = {6, 1}, panel.top = 1, panel.texture = test::spec("grille");
    test::sector(file, "b").panels.push_back(panel);
    const Map map = test::built(file);
    const auto expect = [&](PixelSurface id, SurfaceKind kind, std::uint32_t index, WallPart part = WallPart::middle) {
        const auto owner = owner_of(map, id);
        ASSERT_TRUE(owner);
        EXPECT_EQ(owner->kind, kind);
        EXPECT_EQ(owner->index, index);
        EXPECT_EQ(owner->part, part);
    };
    for (std::uint32_t i = 0; i < 2; ++i) {
        expect(floor_id(SectorId(i)), SurfaceKind::floor, i);
        expect(ceiling_id(SectorId(i)), SurfaceKind::ceiling, i);
        expect(thing_id(map, ThingId(i)), SurfaceKind::thing, i);
    }
    for (std::uint32_t i = 0; i < 8; ++i)
        for (const WallPart part : {WallPart::middle, WallPart::upper, WallPart::lower})
            expect(wall_id(map, WallId(i), part), SurfaceKind::wall, i, part);
    expect(panel_id(map, PanelId(0u)), SurfaceKind::panel, 0);
    EXPECT_FALSE(owner_of(map, panel_id(map, PanelId(1u))));
    EXPECT_FALSE(owner_of(map, kNothing));
    EXPECT_FALSE(owner_of(map, kRecursionEnd));
}

}  // namespace
}  // namespace enfilade
