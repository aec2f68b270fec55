// The map over the picture.
#include "app/play/game.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/map_builder.h"

namespace enfilade {
namespace {

constexpr Color kBlank = 0xFF000000;

class AutomapOfTwoRooms : public ::testing::Test {
protected:
    AutomapOfTwoRooms() {
        MapFile file = test::map_of({test::box_room("left", 0, 0, 4, 4), test::box_room("right", 4, 0, 8, 4)});
        test::join_all(file);
        map_ = test::built(file);
        frame_.resize(200, 200);
    }

    /// Pixels of that colour, the player standing in the left room and looking along +x.
    long pixels(const Automap& automap, Color color) {
        std::ranges::fill(frame_.pixels, kBlank);
        Overlay overlay(frame_, font_);
        automap.draw(overlay, map_, {SectorId(0u), {2, 2}}, {1, 0});
        return std::ranges::count(frame_.pixels, color);
    }

    static constexpr Color kWall = 0xFFE0E0E0;
    Map map_;
    Frame frame_;
    Font font_;
};

TEST_F(AutomapOfTwoRooms, DrawsNothingWhileClosed) {
    Automap automap(map_);
    automap.visit(SectorId(0u));
    EXPECT_EQ(pixels(automap, kBlank), 200 * 200);
}

TEST_F(AutomapOfTwoRooms, ShowsNoRoomThatWasNotVisited) {
    Automap automap(map_);
    automap.toggle();
    EXPECT_EQ(pixels(automap, kWall), 0);
}

TEST_F(AutomapOfTwoRooms, ShowsTheWallsOfVisitedRooms) {
    Automap automap(map_);
    automap.toggle();
    automap.visit(SectorId(0u));
    const long one_room = pixels(automap, kWall);
    automap.visit(SectorId(1u));
    EXPECT_GT(one_room, 0);
    EXPECT_GT(pixels(automap, kWall), one_room);
}

TEST_F(AutomapOfTwoRooms, ShowsRoomsThatWereOnlySeenDimly) {
    Automap automap(map_);
    automap.toggle();
    automap.see(SectorId(0u));
    EXPECT_EQ(pixels(automap, kWall), 0);
    EXPECT_GT(pixels(automap, 0xFF8C8C8Cu), 0);
}

TEST_F(AutomapOfTwoRooms, KeepsARoomVisitedThatIsSeenAgain) {
    Automap automap(map_);
    automap.toggle();
    automap.visit(SectorId(0u));
    automap.see(SectorId(0u));
    EXPECT_GT(pixels(automap, kWall), 0);
}

TEST_F(AutomapOfTwoRooms, ShowsWallsLargerAfterZoomingIn) {
    Automap automap(map_);
    automap.toggle();
    automap.visit(SectorId(0u));
    const long before = pixels(automap, kWall);
    automap.zoom(3);
    EXPECT_GT(pixels(automap, kWall), before);
}

TEST_F(AutomapOfTwoRooms, LooksUpWithThePlayer) {
    Automap automap(map_);
    automap.toggle();
    automap.visit(SectorId(0u));
    automap.visit(SectorId(1u));
    std::ranges::fill(frame_.pixels, kBlank);
    Overlay overlay(frame_, font_);
    automap.draw(overlay, map_, {SectorId(0u), {2, 2}}, {1, 0});  // the other room lies ahead: in the upper half
    const auto middle = frame_.pixels.begin() + 200 * 100;
    EXPECT_GT(std::count(frame_.pixels.begin(), middle, kWall), std::count(middle, frame_.pixels.end(), kWall));
}

// hard case I10
TEST_F(AutomapOfTwoRooms, IsMovedAndComesBack) {
    Automap automap(map_);
    automap.toggle();
    automap.visit(SectorId(0u));
    pixels(automap, kWall);
    const auto before = frame_.pixels;
    automap.pan(1, 0);
    pixels(automap, kWall);
    const auto moved = frame_.pixels;
    EXPECT_NE(moved, before);
    // An eighth of the height to the right: what was seen lies 25 px further left.
    for (int y = 0; y < 200; ++y)
        for (int x = 0; x < 170; ++x) ASSERT_EQ(moved[std::size_t(y * 200 + x)], before[std::size_t(y * 200 + x + 25)]);
    automap.follow();
    pixels(automap, kWall);
    EXPECT_EQ(frame_.pixels, before);
}

TEST_F(AutomapOfTwoRooms, HasOtherColorsForEyesThatNeedThem) {
    Automap automap(map_);
    automap.toggle();
    automap.visit(SectorId(0u));
    std::ranges::fill(frame_.pixels, kBlank);
    Overlay overlay(frame_, font_);
    automap.draw(overlay, map_, {SectorId(0u), {2, 2}}, {1, 0}, {AutomapColors::safe, {}, {}});
    EXPECT_GT(std::ranges::count(frame_.pixels, 0xFFFFFFFFu), 0);
    EXPECT_EQ(std::ranges::count(frame_.pixels, kWall), 0);
}

TEST_F(AutomapOfTwoRooms, HasALegendWhereItIsAskedFor) {
    Automap automap(map_);
    automap.toggle();
    const auto ink = [&](std::string_view keys) {
        std::ranges::fill(frame_.pixels, kBlank);
        Overlay overlay(frame_, font_);
        automap.draw(overlay, map_, {SectorId(0u), {2, 2}}, {1, 0}, {AutomapColors::usual, {}, keys});
        return std::ranges::count_if(frame_.pixels, [](Color color) { return color != kBlank; });
    };
    EXPECT_GT(ink("keys"), ink("") + 500);
}

TEST(AutomapOfADoor, ShowsItInAColorOfItsOwn) {
    MapFile file = test::map_of({test::box_room("hall", 0, 0, 4, 4), test::box_room("door", 4, 0, 5, 4)});
    test::join_all(file);
    Map map = test::built(file);
    const auto orange = [](const Map& of) {
        Automap automap(of);
        automap.toggle();
        automap.visit(SectorId(0u));
        Frame frame;
        frame.resize(100, 100);
        std::ranges::fill(frame.pixels, kBlank);
        const Font font;
        Overlay overlay(frame, font);
        automap.draw(overlay, of, {SectorId(0u), {2, 2}}, {1, 0});
        return std::ranges::count(frame.pixels, 0xFF4060FFu);
    };
    EXPECT_EQ(orange(map), 0);
    map.targets.emplace_back(1u);
    Trigger& trigger = map.triggers.emplace_back();
    trigger.targets = {static_cast<std::uint32_t>(map.targets.size() - 1), 1};
    EXPECT_GT(orange(map), 0);
}

TEST(AutomapOfALinkedRoom, LaysTheRoomOutBehindItsDoor) {
    // The east wall of "main" leads into "far", 100 m away: on the map it lies right behind that wall.
    MapFile file = test::map_of({test::box_room("main", 0, 0, 4, 4), test::box_room("far", 104, 0, 108, 4)});
    test::link(file, "main", {4, 0}, {4, 4}, "far", {104, 4}, {104, 0});
    const Map map = test::built(file);
    Automap automap(map);
    automap.toggle();
    automap.visit(SectorId(1u));
    Frame frame;
    frame.resize(100, 100);
    std::ranges::fill(frame.pixels, kBlank);
    const Font font;
    Overlay overlay(frame, font);
    automap.draw(overlay, map, {SectorId(0u), {2, 2}}, {1, 0});
    EXPECT_GT(std::ranges::count(frame.pixels, 0xFFE0E0E0u), 0);
}

}  // namespace
}  // namespace enfilade
