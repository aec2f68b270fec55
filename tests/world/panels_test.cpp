// Panels that block bodies and set things off: free-standing fences, railings and lines on the floor.
#include <gtest/gtest.h>

#include <cmath>

#include "math/predicates.h"
#include "world/body.h"
#include "world/door_and_link.h"
#include "world/game.h"
#include "world/instant.h"
#include "world/soak.h"
#include "world/trigger_actions.h"

namespace enfilade {
namespace {

using namespace test;

PanelRecord panel(Vec2 a, Vec2 b) {
    PanelRecord record;
    record.a = a;
    record.b = b;
    record.top = 1;
    record.texture = spec("-");
    return record;
}

PanelRecord fence(Vec2 a, Vec2 b) {
    PanelRecord record = panel(a, b);
    record.blocks = true;
    return record;
}

PanelRecord line(Vec2 a, Vec2 b, TriggerRecord trigger) {
    PanelRecord record = panel(a, b);
    record.triggers = {std::move(trigger)};
    return record;
}

TriggerRecord dims(Activation on, double light, std::vector<std::string> targets = {}) {
    TriggerRecord trigger = trigger_on(on, TriggerAction::light, std::move(targets));
    trigger.light = light;
    return trigger;
}

TriggerRecord one_way(TriggerRecord trigger) {
    trigger.one_way = true;
    return trigger;
}

/// A hall of 10 x 10 m with these panels, and the player in it.
MapFile hall_with_panels(std::vector<PanelRecord> panels, Vec2 player, double yaw = 0) {
    MapFile file = map_of({box_room("hall", 0, 0, 10, 10)});
    file.sectors[0].panels = std::move(panels);
    place_player(file, "hall", player, kEyeOnFloor, yaw);
    return file;
}

/// No panel of the player's sector that blocks is nearer than the body's radius, exactly.
bool touches_no_fence(const Game& game) {
    const Sector& sector = game.map[game.player().place.sector];
    for (std::uint32_t i = sector.first_panel; i < sector.first_panel + sector.panel_count; ++i) {
        const Panel& panel = game.map.panels[i];
        if (panel.blocks && segment_is_nearer(panel.a, panel.b, game.point(), kBodyRadius)) return false;
    }
    return true;
}

double light(const Game& game, std::uint32_t sector = 0) {
    return plain_light_of(now(game.map, game.world), SectorId(sector));
}

TEST(Fence, StopsABodysRadiusAwayOnEitherSide) {
    for (const auto& [a, b] : {std::pair(Vec2{5, 2}, Vec2{5, 8}), std::pair(Vec2{5, 8}, Vec2{5, 2})}) {
        Game west(hall_with_panels({fence(a, b)}, {3, 5}, 0)), east(hall_with_panels({fence(a, b)}, {7, 5}, 180));
        west.hold(kRunForward, 200);
        east.hold(kRunForward, 200);
        EXPECT_EQ(west.point(), (Vec2{5 - kBodyRadius, 5}));
        EXPECT_EQ(east.point(), (Vec2{5 + kBodyRadius, 5}));
    }
}

TEST(Fence, IsPassedWhereItDoesNotBlock) {
    Game game(hall_with_panels({panel({5, 2}, {5, 8})}, {3, 5}));
    game.hold(kForward, 200);
    EXPECT_EQ(game.point().x, 10 - kBodyRadius);
}

TEST(Fence, BlocksAtWhateverHeightItIs) {
    PanelRecord high = fence({5, 2}, {5, 8});
    high.bottom = 50;
    high.top = 51;
    Game game(hall_with_panels({high}, {3, 5}));
    game.hold(kForward, 200);
    EXPECT_EQ(game.point().x, 5 - kBodyRadius);
}

TEST(Fence, LetsSlideAlongAtTheSpeedThatIsLeft) {
    Game game(hall_with_panels({fence({5, 1}, {5, 9})}, {4, 2}, 30));
    game.hold(kForward, 60);
    const double y = game.point().y;
    EXPECT_EQ(game.point().x, 5 - kBodyRadius);
    game.hold(kForward, 30);
    EXPECT_EQ(game.point().x, 5 - kBodyRadius) << "not a grid step off while sliding";
    EXPECT_NEAR(game.point().y - y, kWalkSpeed / 2 * 30 * kTickSeconds, 1e-3);
}

TEST(Fence, IsWalkedRoundAtEitherEnd) {
    for (const double y : {8.2, 1.8}) {
        Game game(hall_with_panels({fence({5, 2}, {5, 8})}, {3, y}));
        game.hold(kForward, 200);
        EXPECT_EQ(game.point().x, 10 - kBodyRadius) << y;
    }
}

TEST(Fence, StopsWhoComesStraightAtItsEnd) {
    Game game(hall_with_panels({fence({5, 5}, {8, 5})}, {3, 5}));
    game.hold(kForward, 200);
    EXPECT_EQ(game.point(), (Vec2{5 - kBodyRadius, 5}));
}

// hard case C18
TEST(Fence, IsNotMovedThroughByTenThousandTicksOfPushing) {
    Game game(hall_with_panels({fence({5, 2}, {5, 8})}, {3, 5}));
    game.hold(kRunForward, 200);
    const Vec2 before = game.point();
    game.hold(kRunForward, 10000);
    EXPECT_EQ(game.point(), before);
}

// hard case C15
TEST(Fence, IsNotPassedInOneTickOfAnyLength) {
    Game game(hall_with_panels({fence({5, 0}, {5, 10})}, {3, 5}));
    for (const Vec2 velocity : {Vec2{1e6, 0}, Vec2{1e6, 3e5}, Vec2{600, -601}}) {
        const Body body = body_of(game.map, game.player());
        Body gone = body;
        gone.place = walk(game.map, body, velocity, kTickSeconds).end;
        EXPECT_LE(gone.place.point.x, 5 - kBodyRadius);
        EnteredPortals entered;
        const Reach found = around(game.map, gone, &entered);
        EXPECT_TRUE(fits(game.map, gone, found, entered));
    }
}

TEST(Fence, KeepsWhoIsSqueezedBesideItOnTheirSide) {
    // Half a metre between the fence and the wall: the body is narrower there, until it comes out.
    Game game(hall_with_panels({fence({5, 0}, {5, 8})}, {2, 2}));
    game.world.player.place.point = {4.999, 2};
    for (const TickInput& keys : {kForward, kLeft, kForward, kRight}) {
        game.hold(keys, 50);
        ASSERT_LT(game.point().x, 5);
    }
    MapFile gap = hall_with_panels({fence({0.5, 0}, {0.5, 8})}, {0.25, 2}, 90);
    Game narrow(gap);
    for (int i = 0; i < 60; ++i) {
        narrow.hold({.forward = 127, .strafe = static_cast<std::int8_t>(i % 2 == 0 ? 127 : -127)});
        ASSERT_LT(narrow.point().x, 0.5);
    }
    narrow.hold(kForward, 200);
    EXPECT_GT(narrow.point().y, 9) << "came out";
}

// hard case C3
TEST(Fence, IsLeftByWhoStartsOnItsLine) {
    for (const Vec2 start : {Vec2{5, 5}, Vec2{5, 2}, Vec2{5, 8}, Vec2{5, 2.1}}) {
        Game game(hall_with_panels({fence({5, 2}, {5, 8})}, start));
        EXPECT_TRUE(touches_no_fence(game)) << start.y;
        EXPECT_TRUE(game.is_contained());
    }
}

TEST(Fence, IsNotCrossedByWhoIsMovedOffAWallAtTheStart) {
    Game game(hall_with_panels({fence({0.25, 0}, {0.25, 10})}, {0.0625, 5}));
    EXPECT_LT(game.point().x, 0.25);
}

TEST(Fence, IsLeftByWhoIsTeleportedOntoIt) {
    MapFile file = hall_with_panels(
        {fence({5, 2}, {5, 8}), line({2, 0}, {2, 10}, trigger_on(Activation::cross, TriggerAction::teleport, {"pad"}))},
        {1, 5});
    ThingRecord pad;
    pad.name = "pad";
    pad.position = {5, 5};
    pad.yaw_degrees = 180;
    file.things = {pad};
    Game game(file);
    game.hold(kForward, 30);
    EXPECT_GT(game.point().x, 4);
    EXPECT_TRUE(touches_no_fence(game));
}

TEST(Fence, StopsWhoIsCarriedByTheFloor) {
    MapFile file = hall_with_panels({fence({5, 0}, {5, 10})}, {3, 5});
    file.sectors[0].floor.scroll = {3, 1};
    file.sectors[0].floor.carries = true;
    Game game(file);
    game.hold(kNoKeys, 300);
    EXPECT_EQ(game.point(), (Vec2{5 - kBodyRadius, 10 - kBodyRadius}));
}

/// Two rooms of 4 x 4 m with a doorway at x = 4 and a panel on it, in either room; or else the doorway blocks.
MapFile rooms_with_fence(const char* in) {
    MapFile file = map_of({box_room("first", 0, 0, 4, 4), box_room("second", 4, 0, 8, 4)});
    join(file, "first", "second", {4, 0}, {4, 4});
    if (in)
        sector(file, in).panels = {fence({4, 0}, {4, 4})};
    else
        wall(file, "first", {4, 0}, {4, 4}).blocks = true;
    place_player(file, "first", {2, 2}, kEyeOnFloor);
    return file;
}

TEST(Fence, OnADoorwayStopsLikeADoorwayThatBlocks) {
    for (const char* in : {"first", "second"}) {
        Game portal(rooms_with_fence(nullptr)), panel(rooms_with_fence(in));
        RandomKeys keys(1);
        for (int i = 0; i < 3000; ++i) {
            const TickInput input = keys.next();
            portal.hold(input);
            panel.hold(input);
            ASSERT_EQ(panel.player().place, portal.player().place) << in << ", tick " << i;
        }
    }
}

/// Two rooms of 4 x 4 m with a slanted fence just behind the doorway between them at x = 4.
MapFile room_with_fence_behind_door() {
    MapFile file = map_of({box_room("near", 0, 0, 4, 4), box_room("far", 4, 0, 8, 4)});
    file.sectors[1].panels = {fence({4.25, 1}, {4.5, 1.75}), fence({4.125, 3}, {4.125, 3.5})};
    join_all(file);
    return file;
}

/// The same with the far room somewhere else, turned by a quarter and linked.
MapFile room_with_fence_behind_link() {
    MapFile file = map_of({box_room("near", 0, 0, 4, 4), box_room("far", 100, 50, 104, 54)});
    file.sectors[1].panels = {fence({103, 50.25}, {102.25, 50.5}), fence({101, 50.125}, {100.5, 50.125})};
    link(file, "near", {4, 0}, {4, 4}, "far", {100, 50}, {104, 50});
    return file;
}

// hard case C19
TEST(Fence, StopsTheHalfThatIsBehindALink) {
    expect_same_walks(room_with_fence_behind_door(), room_with_fence_behind_link(),
                      [](const Game& game) { ASSERT_TRUE(touches_no_fence(game)); });
}

TEST(Fence, OnALinkedDoorwayIsNeverPassed) {
    for (const bool in_near : {true, false}) {
        MapFile file =
            map_of({box_room("near", 0, 0, 5, 5), room("far", {{103, 50}, {107, 53}, {104, 57}, {100, 54}})});
        link(file, "near", {5, 0}, {5, 5}, "far", {107, 53}, {104, 57});
        sector(file, "near").panels = {fence({5, 0}, {5, 5})};
        if (!in_near) {
            sector(file, "near").panels.clear();
            sector(file, "far").panels = {fence({104, 57}, {107, 53})};
        }
        place_player(file, "near", {2, 2}, kEyeOnFloor);
        Game game(file);
        RandomKeys keys(in_near);
        for (int i = 0; i < 3000; ++i) {
            game.hold(keys.next());
            ASSERT_EQ(game.room(), "near");
            ASSERT_LE(game.point().x, 5 - kBodyRadius);
        }
    }
}

TEST(Fence, BoxIsNeverLeft) {
    // Five slanted sides, joined at their ends, and one that stands in the middle.
    const std::vector<Vec2> corners{{3, 3}, {6, 2.5}, {8, 5}, {5.5, 8}, {2, 6}};
    std::vector<PanelRecord> box{fence({4, 4}, {6, 5.5})};
    for (std::size_t i = 0; i < 5; ++i) box.push_back(fence(corners[i], corners[(i + 1) % 5]));
    Game game(hall_with_panels(box, {5, 3.5}));
    RandomKeys keys(3);
    for (int i = 0; i < 20000; ++i) {
        game.hold(keys.next());
        ASSERT_TRUE(touches_no_fence(game)) << "tick " << i;
        for (std::size_t c = 0; c < 5; ++c)
            ASSERT_GT(side_of_line(corners[c], corners[(c + 1) % 5], game.point()), 0) << "tick " << i;
    }
}

/// A hall of 8 x 8 cells of 1.25 m with fences between some of them.
struct Maze {
    static constexpr int kCells = 8;
    static constexpr double kCell = 1.25;  // [m]
    bool is_shut[2][kCells][kCells]{};     ///< by axis: from the cell to the next one along x, along y
    std::vector<PanelRecord> fences;

    explicit Maze(std::uint64_t seed) {
        Random random(seed);
        for (int y = 0; y < kCells; ++y)
            for (int x = 0; x < kCells; ++x)
                for (int axis = 0; axis < 2; ++axis) {
                    if ((axis == 0 ? x : y) + 1 == kCells || random.below(5) >= 2) continue;
                    is_shut[axis][x][y] = true;
                    const Vec2 end = Vec2{x + 1., y + 1.} * kCell;
                    const Vec2 start = end - (axis == 0 ? Vec2{0, kCell} : Vec2{kCell, 0});
                    fences.push_back(random.below(2) == 0 ? fence(start, end) : fence(end, start));
                }
    }

    /// Adds all cells that can be got to from one, itself included.
    void flood(int x, int y, std::vector<bool>& reached) const {
        if (x < 0 || y < 0 || x == kCells || y == kCells || reached[index(x, y)]) return;
        reached[index(x, y)] = true;
        if (!is_shut[0][x][y]) flood(x + 1, y, reached);
        if (!is_shut[1][x][y]) flood(x, y + 1, reached);
        if (x > 0 && !is_shut[0][x - 1][y]) flood(x - 1, y, reached);
        if (y > 0 && !is_shut[1][x][y - 1]) flood(x, y - 1, reached);
    }

    static std::size_t index(int x, int y) { return std::size_t(x + kCells * y); }
    static std::size_t cell_of(Vec2 p) { return index(static_cast<int>(p.x / kCell), static_cast<int>(p.y / kCell)); }
};

TEST(Fence, MazeIsLeftThroughItsGapsOnly) {
    std::size_t visits = 0;
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
        const Maze maze(seed);
        const int x = static_cast<int>(seed), y = 3;
        Game game(hall_with_panels(maze.fences, Vec2{x + 0.5, y + 0.5} * Maze::kCell));
        std::vector<bool> reached(Maze::kCells * Maze::kCells), visited(reached.size());
        maze.flood(x, y, reached);
        RandomKeys keys(seed);
        for (int i = 0; i < 4000; ++i) {
            game.hold(keys.next());
            ASSERT_TRUE(touches_no_fence(game)) << seed << ", tick " << i;
            const std::size_t cell = Maze::cell_of(game.point());
            ASSERT_TRUE(reached[cell]) << seed << ", tick " << i;
            visits += !visited[cell];
            visited[cell] = true;
        }
    }
    EXPECT_GT(visits, 40u);
}

/// Octagons of links with a fence across each, along a side, and in the corner between two sides.
Map fenced_octagons(std::uint64_t seed) {
    Map map = octagons_of_links(seed);
    for (Sector& sector : map.sectors) {
        sector.first_panel = static_cast<std::uint32_t>(map.panels.size());
        const auto corner = [&](std::uint64_t i) { return map.walls[sector.first_wall + (seed + i) % 8].a; };
        for (const auto& [a, b] : {std::pair(corner(0), corner(3)), std::pair(corner(4), corner(5)),
                                   std::pair(corner(6), (corner(6) + corner(7)) * 0.5)})
            map.panels.push_back({.a = snap_to_vertex_grid(a),
                                  .b = snap_to_vertex_grid(b),
                                  .length = 1,
                                  .sector = SectorId(0u),
                                  .surface = {},
                                  .blocks = true,
                                  .triggers = {}});
        sector.panel_count = sector.active_panels = 3;
    }
    return map;
}

TEST(Fence, HoldsWhereEveryDoorwayIsALink) {
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
        const Map map = fenced_octagons(seed);
        Random random(seed);
        soak(map, start_somewhere(map, random), seed, 2000);
    }
}

TEST(PanelTrigger, GoesOffForWhoPassesEitherWay) {
    for (const double yaw : {0., 180.}) {
        Game game(
            hall_with_panels({line({5, 2}, {5, 8}, dims(Activation::cross, 0.25))}, {yaw == 0 ? 4. : 6., 5}, yaw));
        EXPECT_EQ(light(game), 1);
        game.hold(kForward, 60);
        EXPECT_EQ(light(game), 0.25);
    }
}

TEST(PanelTrigger, DoesNotGoOffForWhoPassesBesideIt) {
    Game game(hall_with_panels({line({5, 2}, {5, 4.75}, dims(Activation::cross, 0.25))}, {4, 5}));
    game.hold(kForward, 60);
    EXPECT_EQ(light(game), 1);
}

TEST(PanelTrigger, ThatIsOneWayGoesOffFromItsRightOnly) {
    // From (5, 2) to (5, 8) the right is where x is smaller.
    for (const bool from_right : {true, false}) {
        const PanelRecord wire = line({5, 2}, {5, 8}, one_way(dims(Activation::cross, 0.25)));
        Game game(hall_with_panels({wire}, {from_right ? 4. : 6., 5}, from_right ? 0 : 180));
        game.hold(kForward, 60);
        EXPECT_EQ(light(game), from_right ? 0.25 : 1);
    }
}

TEST(PanelTrigger, GoesOffInOrderWithPortals) {
    // Within one tick: out of the first panel, through the portal, and through the last.
    MapFile file = map_of({box_room("a", 0, 0, 4, 4), box_room("b", 4, 0, 8, 4)});
    join_all(file);
    sector(file, "a").panels = {line({4, 1}, {4, 3}, dims(Activation::cross, 0.1, {"a"}))};
    wall(file, "a", {4, 0}, {4, 4}).triggers = {dims(Activation::cross, 0.2, {"a"})};
    sector(file, "b").panels = {line({4, 1}, {4, 3}, dims(Activation::cross, 0.3, {"a"})),
                                line({4.0625, 0}, {4.0625, 4}, dims(Activation::cross, 0.4, {"a"}))};
    place_player(file, "a", {3, 2}, kEyeOnFloor);
    Game game(file);
    const Walk walked = walk(game.map, body_of(game.map, game.player()), {100, 0}, kTickSeconds);
    pass(game.map, game.world, walked.crossings);
    std::vector<double> levels;
    for (const Firing& firing : game.world.history.firings()) levels.push_back(*game.map[firing.trigger].light);
    EXPECT_EQ(levels, (std::vector{0.1, 0.2, 0.3, 0.4}));
}

TEST(PanelTrigger, IsUsedFromEitherSide) {
    for (const double yaw : {0., 180.}) {
        Game game(hall_with_panels({line({5, 2}, {5, 8}, dims(Activation::use, 0.25))}, {yaw == 0 ? 4. : 6., 5}, yaw));
        game.hold(kUse);
        EXPECT_EQ(light(game), 0.25);
    }
}

TEST(PanelTrigger, ThatIsOneWayIsUsedFromItsRightOnly) {
    for (const bool from_right : {true, false}) {
        const PanelRecord lever = line({5, 2}, {5, 8}, one_way(dims(Activation::use, 0.25)));
        Game game(hall_with_panels({lever}, {from_right ? 4. : 6., 5}, from_right ? 0 : 180));
        game.hold(kUse);
        EXPECT_EQ(light(game), from_right ? 0.25 : 1);
    }
}

TEST(PanelTrigger, OutOfReachIsNotUsed) {
    Game game(hall_with_panels({line({5, 2}, {5, 8}, dims(Activation::use, 0.25))}, {5 - kArm - 0.25, 5}));
    game.hold(kUse);
    EXPECT_EQ(light(game), 1);
}

TEST(PanelTrigger, IsUsedBeforeTheWallBehindIt) {
    MapFile file = hall_with_panels({line({9.5, 2}, {9.5, 8}, dims(Activation::use, 0.25))}, {9, 5});
    wall(file, "hall", {10, 0}, {10, 10}).triggers = {dims(Activation::use, 0.5, {"hall"})};
    Game game(file);
    game.hold(kUse);
    EXPECT_EQ(light(game), 0.25);
    EXPECT_EQ(game.world.history.firings().size(), 1u);
}

TEST(PanelTrigger, IsNotUsedThroughAWall) {
    MapFile file = hall_with_panels({line({6.5, 2}, {6.5, 8}, dims(Activation::use, 0.25))}, {5, 5});
    cut_pillar(file.sectors[0], 6, 4, 6.25, 6);
    Game game(file);
    game.hold(kUse);
    EXPECT_EQ(light(game), 1);
}

TEST(PanelTrigger, IsUsedThroughAFence) {
    Game game(hall_with_panels({fence({5, 2}, {5, 8}), line({5.5, 2}, {5.5, 8}, dims(Activation::use, 0.25))}, {4, 5}));
    game.hold(kUse);
    EXPECT_EQ(light(game), 0.25);
}

TEST(PanelTrigger, OfAFenceIsUsed) {
    PanelRecord grate = fence({5, 2}, {5, 8});
    grate.triggers = {dims(Activation::use, 0.25)};
    Game game(hall_with_panels({grate}, {4, 5}));
    game.hold(kUse);
    EXPECT_EQ(light(game), 0.25);
}

TEST(PanelTrigger, GoesOffAtTheStart) {
    EXPECT_EQ(light(Game(hall_with_panels({line({5, 2}, {5, 8}, dims(Activation::start, 0.25))}, {4, 5}))), 0.25);
}

TEST(PanelTrigger, WorksOnceWhereItSaysSo) {
    TriggerRecord once = dims(Activation::cross, 0.25);
    once.once = true;
    Game game(hall_with_panels({line({5, 2}, {5, 8}, once)}, {4, 5}));
    for (int i = 0; i < 4; ++i) game.hold(i % 2 == 0 ? kForward : kBack, 60);
    EXPECT_EQ(game.world.history.firings().size(), 1u);
}

}  // namespace
}  // namespace enfilade
