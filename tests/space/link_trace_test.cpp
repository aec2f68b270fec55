// Paths through linked portals: shifts, quarter turns, other turns, and corners where links meet.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/hash.h"
#include "math/predicates.h"
#include "math/vec.h"
#include "space/trace.h"
#include "support/exact.h"
#include "support/map_builder.h"
#include "support/trials.h"

namespace enfilade {
namespace {

using namespace test;

const SectorId kFirst(0u), kSecond(1u);

/// Two rooms far apart: east wall of the first onto a wall of the second.
Map linked_rooms(Vec2 to_a, Vec2 to_b) {
    MapFile file = map_of({box_room("a", 0, 0, 4, 4), box_room("b", 100, 50, 104, 54)});
    link(file, "a", {4, 0}, {4, 4}, "b", to_a, to_b);
    return built(file);
}
Map shifted_rooms() { return linked_rooms({100, 54}, {100, 50}); }
Map quarter_turned_rooms() { return linked_rooms({100, 50}, {104, 50}); }

TEST(TraceThroughLinks, CarriesTheRestOfThePathOver) {
    const Map map = shifted_rooms();
    const Trace path = trace(map, {kFirst, {1, 1}}, {7, 3});
    EXPECT_EQ(path.end, (Place{kSecond, {103, 53}}));
    EXPECT_EQ(path.passage.apply({7, 3}), path.end.point);
}

TEST(TraceThroughLinks, TurnsTheRestOfThePathByAQuarter) {
    const Map map = quarter_turned_rooms();
    const Trace path = trace(map, {kFirst, {1, 1}}, {7, 1});
    EXPECT_EQ(path.end.sector, kSecond);
    EXPECT_EQ(path.end.point, (Vec2{103, 53}));
}

TEST(TraceThroughLinks, ReturnsExactlyThroughShiftsAndQuarterTurns) {
    for (const Map& map : {shifted_rooms(), quarter_turned_rooms()}) {
        Random random(7);
        for (int i = 0; i < 2000; ++i) {
            const Place from{kFirst, snap_to_point_grid({random.uniform(0.5, 3.5), random.uniform(0.5, 3.5)})};
            const Vec2 to = snap_to_point_grid({random.uniform(5, 7), random.uniform(0, 4)});
            const Trace there = trace(map, from, to);
            const Trace back = trace(map, there.end, there.passage.apply(from.point));
            ASSERT_EQ(back.end, from);
        }
    }
}

// hard case C13
TEST(TraceThroughLinks, ComposesTheWayBackToTheIdentity) {
    const Map map = quarter_turned_rooms();
    const Trace there = trace(map, {kFirst, {1, 1}}, {7, 1});
    const Trace back = trace(map, there.end, there.passage.apply({1, 1}));
    EXPECT_TRUE(then(there.passage, back.passage).is_identity());
}

TEST(TraceThroughLinks, ComposesItsPassageInTheOrderOfTheWay) {
    MapFile file = map_of({box_room("a", 0, 0, 4, 4), box_room("b", 100, 50, 104, 54), box_room("c", 7, -90, 11, -86)});
    link(file, "a", {4, 0}, {4, 4}, "b", {100, 50}, {104, 50});
    link(file, "b", {104, 54}, {100, 54}, "c", {7, -86}, {7, -90});
    const Map map = built(file);
    const Trace path = trace(map, {kFirst, {1, 2.5}}, {9.5, 2.5});
    EXPECT_EQ(path.crossings.size(), 2u);
    EXPECT_EQ(path.passage.apply({9.5, 2.5}), path.end.point);
}

TEST(TraceThroughLinks, AsksMayPassWithTheHeightsOfTheRoomsOnTheWay) {
    MapFile file = map_of({box_room("a", 0, 0, 4, 4), box_room("b", 100, 50, 104, 54, 7, 9)});
    link(file, "a", {4, 0}, {4, 4}, "b", {100, 54}, {100, 50});
    link(file, "b", {104, 50}, {104, 54}, "a", {0, 4}, {0, 0});
    const Map map = built(file);
    std::vector<double> rises;
    trace(map, {kFirst, {1, 1}}, {13, 1}, [&](WallId, const Rigid& passage) {
        rises.push_back(passage.rise);
        return true;
    });
    EXPECT_EQ(rises, (std::vector<double>{0, 7, 0}));
}

// hard case C2
TEST(TraceThroughLinks, EndsBehindTheLinkWhenThePathEndsOnItsLine) {
    // The tie rule counts x = 4 as crossed, but x = 104, seen from within the other room, as outside.
    for (const Map& map : {shifted_rooms(), quarter_turned_rooms(), linked_rooms({104, 50}, {104, 54})})
        for (double y = 0; y <= 4; y += 0.25) {
            const Trace path = trace(map, {kFirst, {3, 2}}, {4, y});
            ASSERT_TRUE(contains(map, path.end.sector, path.end.point)) << y;
            ASSERT_LE(path.crossings.size(), 1u) << "not back through the same link";
            const Trace again = trace(map, path.end, path.end.point);
            ASSERT_TRUE(again.crossings.empty()) << "no ping-pong";
        }
}

/// As bodies go where every panel blocks.
Trace walk_through_links(const Map& map, const Place& from, Vec2 to) {
    return trace(map, from, to, {}, [](const MetPanel&) { return false; });
}

/// A panel in the place of a wall, in the room that the wall bounds.
Panel panel_on(const Map& map, WallId id) {
    Panel panel;
    panel.a = map[id].b;
    panel.b = map[id].a;
    panel.sector = map[id].sector;
    panel.blocks = true;
    return panel;
}

TEST(TraceThroughLinks, IsStoppedByAPanelOnTheLineItComesOutOf) {
    for (Map map : {shifted_rooms(), quarter_turned_rooms(), linked_rooms({104, 50}, {104, 54})}) {
        map.panels = {panel_on(map, map.walls[1].exit)};
        map.sectors[1].panel_count = map.sectors[1].active_panels = 1;
        for (double y = 0; y <= 4; y += 0.25)
            for (const double x : {4., 4 + kPointGrid, 5.}) {
                const Trace path = walk_through_links(map, {kFirst, {3, 2}}, {x, y});
                ASSERT_EQ(path.end.sector, kFirst) << x << " " << y;
                ASSERT_TRUE(path.is_stopped());
                ASSERT_TRUE(contains(map, kFirst, path.end.point));
            }
    }
}

/// How many lines x = 0, width, 2 width, … lie between two places of halves, the tie rule's (e, e^2) added to both.
int lines_between(int from, int to, int width) {
    const auto cell = [&](int x) { return (x >= 0 ? x : x - width + 1) / width; };
    return std::abs(cell(to) - cell(from));
}

// A room of 4 m x 3 m that goes on in itself on all sides, its links sharing all vertices. In the plane without links
// whole numbers tell the links on a way and where it ends: paths start, pass and end on links and on their ends.
// hard cases C2, C8, C9
TEST(TraceThroughLinks, CrossesThoseThatShareVerticesAsTheUnfoldedPlaneSays) {
    MapFile file = map_of({box_room("torus", 0, 0, 4, 3)});
    link(file, "torus", {4, 0}, {4, 3}, "torus", {0, 3}, {0, 0});
    link(file, "torus", {0, 0}, {4, 0}, "torus", {4, 3}, {0, 3});
    const Map map = built(file);
    Random random(8);
    std::uint64_t ends_on_links = 0;
    constexpr int kPaths = 100'000;
    for (int i = 0; i < kPaths; ++i) {
        const auto x = static_cast<int>(random.below(8)), y = static_cast<int>(random.below(6));
        const auto to_x = static_cast<int>(random.below(97)) - 48,
                   to_y = static_cast<int>(random.below(73)) - 36;  // [m/2]
        const Trace path = trace(map, {kFirst, {x / 2.0, y / 2.0}}, {to_x / 2.0, to_y / 2.0});
        ASSERT_FALSE(path.is_stopped());
        ASSERT_EQ(static_cast<int>(path.crossings.size()), lines_between(x, to_x, 8) + lines_between(y, to_y, 6)) << i;
        const Vec2 end{((to_x % 8 + 8) % 8) / 2.0, ((to_y % 6 + 6) % 6) / 2.0};
        ASSERT_EQ(path.end.point, end) << i;
        ASSERT_TRUE(trace(map, path.end, path.end.point).crossings.empty()) << i;
        ends_on_links += end.x == 0 || end.y == 0;
    }
    count_trials(kPaths, "paths");
    EXPECT_GT(ends_on_links, 20'000u);
}

/// A room of 12 m x 12 m turned by quarters, the middle third of a side being the other end of a link.
std::vector<Vec2> far_room(int quarters, Vec2 corner) {
    std::vector<Vec2> outline{{0, 8}, {0, 4}, {0, 0}, {12, 0}, {12, 12}, {0, 12}};
    for (Vec2& v : outline) {
        for (int i = 0; i < quarters; ++i) v = right_of(v);
        v = v + corner;
    }
    return outline;
}

// The four sides of a room are links that share its vertices and lead to different rooms by different turns. A path
// exactly through a vertex takes the one that the tie rule selects, as whole numbers of any size carry it out.
// hard case C8
TEST(TraceThroughLinks, TakesOfTwoThatShareAVertexTheOneThatExactArithmeticTells) {
    const std::vector<Vec2> corners{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
    MapFile file = map_of({box_room("hub", 0, 0, 4, 4)});
    for (std::size_t side = 0; side < 4; ++side) {
        const std::string name = std::to_string(side);
        const std::vector<Vec2> outline = far_room(static_cast<int>(2 * side) % 3, {100.0 * double(side + 1), -50});
        file.sectors.push_back(room(name, outline));
        link(file, "hub", corners[side], corners[(side + 1) % 4], name, outline[0], outline[1]);
    }
    const Map map = built(file);
    Random random(9);
    const auto quarters = [&](int least, std::uint64_t count) { return (least + double(random.below(count))) / 4; };
    constexpr int kPaths = 20'000;
    int ends_at_vertex = 0;
    for (int i = 0; i < kPaths; ++i) {
        const std::size_t number = random.below(4);
        const Vec2 vertex = corners[number], from{quarters(1, 15), quarters(1, 15)};
        const Vec2 to = vertex + (vertex - from) * quarters(1, 4);
        const test::ExactPoint start = test::exact_moved(from), end = test::exact_moved(to);
        const bool is_left = test::cross(end - start, test::exact(vertex) - start).sign() > 0;
        const Trace path = trace(map, {kFirst, from}, to);
        ASSERT_EQ(path.crossings.size(), 1u) << from.x << ' ' << from.y;
        ASSERT_EQ(map[map[path.crossings[0].portal].behind].name, std::to_string(is_left ? (number + 3) % 4 : number));
        ASSERT_TRUE(contains(map, path.end.sector, path.end.point));
        ends_at_vertex += is_left;
    }
    count_trials(kPaths, "paths");
    EXPECT_GT(ends_at_vertex, kPaths / 4);
    EXPECT_LT(ends_at_vertex, kPaths * 3 / 4);
}

// hard case C9
TEST(TraceThroughLinks, StopsAfterManyRoundsThroughARoomLinkedToItself) {
    MapFile file = map_of({box_room("loop", 0, 0, 4, 4)});
    link(file, "loop", {4, 0}, {4, 4}, "loop", {0, 4}, {0, 0});
    const Map map = built(file);
    EXPECT_EQ(trace(map, {kFirst, {1, 2}}, {401, 2}).crossings.size(), 100u);
    const Trace endless = trace(map, {kFirst, {1, 2}}, {30000, 2});
    EXPECT_EQ(endless.crossings.size(), std::size_t{kMaxLinksOnPath});
    EXPECT_TRUE(endless.stopped);
}

/// Octagons with sides of 29/8 m, alternately along the axes and along (20, 21): the turns of the links between them
/// are multiples of 90 degrees and others. Every side is a link to some side of some octagon, so there is no wall at
/// all, and around the corners the angles add up to anything.
class Universe {
public:
    explicit Universe(std::uint64_t seed) : random_(seed) {
        std::vector<SectorRecord> rooms;
        for (int i = 0; i < kRooms; ++i) rooms.push_back(room(std::to_string(i), outline(i)));
        MapFile file = map_of(std::move(rooms));
        std::vector<int> sides(kRooms * 8);
        for (int i = 0; i < kRooms * 8; ++i) sides[std::size_t(i)] = i;
        for (std::size_t i = sides.size(); i > 1; --i) std::swap(sides[i - 1], sides[random_.below(i)]);
        for (std::size_t i = 0; i < sides.size(); i += 2) link_sides(file, sides[i], sides[i + 1]);
        map = built(file);
    }

    /// Somewhere in a room: anywhere, on a line from corner to corner, or a grid step beside that.
    Place place() {
        while (true) {
            const SectorId sector(static_cast<std::size_t>(random_.below(kRooms)));
            const Vec2 p = target(static_cast<int>(sector.index));
            if (contains(map, sector, p)) return {sector, p};
        }
    }

    Vec2 target(int room) {
        const auto corner = [&] { return outline(room)[random_.below(8)]; };
        const Vec2 middle = snap_to_point_grid((corner() + corner()) * 0.5);
        const auto beside = [&] { return (static_cast<double>(random_.below(5)) - 2) * kPointGrid; };
        if (random_.below(2) == 0) return {middle.x + beside(), middle.y + beside()};
        const double reach = 12;
        return middle + snap_to_point_grid(Vec2{random_.uniform(-reach, reach), random_.uniform(-reach, reach)});
    }

    Map map;

private:
    static constexpr int kRooms = 3;

    static std::vector<Vec2> outline(int room) {
        const Vec2 sides[] = {{29, 0}, {20, 21}, {0, 29}, {-20, 21}, {-29, 0}, {-20, -21}, {0, -29}, {20, -21}};
        std::vector<Vec2> corners{{room * 100.0, room * -37.0}};
        for (int i = 0; i < 7; ++i) corners.push_back(corners.back() + sides[i] * 0.125);
        return corners;
    }

    static void link_sides(MapFile& file, int from, int to) {
        const auto a = outline(from / 8), b = outline(to / 8);
        link(file, std::to_string(from / 8), a[std::size_t(from % 8)], a[std::size_t((from + 1) % 8)],
             std::to_string(to / 8), b[std::size_t(to % 8)], b[std::size_t((to + 1) % 8)]);
    }

    Random random_;
};

// hard case I11
TEST(TraceThroughLinks, AlwaysEndsInsideInAUniverseOfLinks) {
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        Universe universe(seed);
        count_trials(20000, "paths");
        for (int i = 0; i < 20000; ++i) {
            const Place from = universe.place();
            const Trace path = trace(universe.map, from, universe.target(static_cast<int>(from.sector.index)));
            ASSERT_TRUE(contains(universe.map, path.end.sector, path.end.point)) << "seed " << seed << ", path " << i;
        }
    }
}

TEST(TraceThroughLinks, NeverCrossesAPanelInAUniverseOfLinks) {
    const auto is_fenced = [](WallId id) { return id.index % 3 == 0; };
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
        Universe universe(seed);
        Map& map = universe.map;
        for (Sector& sector : map.sectors) {
            sector.first_panel = static_cast<std::uint32_t>(map.panels.size());
            for (std::uint32_t w = sector.first_wall; w < sector.first_wall + sector.wall_count; ++w)
                if (is_fenced(WallId(w))) map.panels.push_back(panel_on(map, WallId(w)));
            sector.panel_count = sector.active_panels =
                static_cast<std::uint32_t>(map.panels.size()) - sector.first_panel;
        }
        for (int i = 0; i < 10000; ++i) {
            const Place from = universe.place();
            const Trace path = walk_through_links(map, from, universe.target(static_cast<int>(from.sector.index)));
            ASSERT_TRUE(contains(map, path.end.sector, path.end.point)) << "seed " << seed << ", path " << i;
            for (const Crossing& crossing : path.crossings)
                ASSERT_FALSE(is_fenced(crossing.portal) || is_fenced(map[crossing.portal].exit))
                    << "seed " << seed << ", path " << i;
        }
    }
}

// hard case C6
TEST(TraceThroughLinks, WalksAHundredThousandMovesInARowWithoutLeavingTheWorld) {
    Universe universe(42);
    Place at = universe.place();
    count_trials(100000, "paths");
    for (int i = 0; i < 100000; ++i) {
        const Vec2 to = universe.target(static_cast<int>(at.sector.index));
        at = trace(universe.map, at, to).end;
        ASSERT_TRUE(contains(universe.map, at.sector, at.point)) << "move " << i;
    }
}

TEST(TraceThroughLinks, ComesBackFromOtherTurnsWithinAFewGridSteps) {
    // Two roundings each way, each by at most half a step along both axes.
    const double bound = 3 * kPointGrid;
    MapFile file = map_of(
        {room("a", {{0, 0}, {29, 0}, {29, 29}, {0, 29}}), room("b", {{100, 0}, {120, 21}, {120, 50}, {100, 50}})});
    link(file, "a", {29, 0}, {29, 29}, "b", {100, 0}, {120, 21});
    const Map map = built(file);
    Random random(3);
    for (int i = 0; i < 100000; ++i) {
        const Place from{kFirst, snap_to_point_grid({random.uniform(20, 29), random.uniform(10, 19)})};
        const Vec2 to = snap_to_point_grid({random.uniform(29.1, 33), random.uniform(10, 19)});
        const Trace there = trace(map, from, to);
        ASSERT_EQ(there.end.sector, kSecond);
        const Place back = trace(map, there.end, snap_to_point_grid(there.passage.apply(from.point))).end;
        ASSERT_EQ(back.sector, kFirst);
        ASSERT_LE(std::fabs(back.point.x - from.point.x), bound);
        ASSERT_LE(std::fabs(back.point.y - from.point.y), bound);
    }
}

TEST(SightLine, PassesThePortalsOfAPathAndMeetsTheSameWall) {
    MapFile file = map_of({box_room("a", 0, 0, 4, 4), box_room("b", 100, 50, 104, 54, 3, 6), box_room("c", 4, 4, 8, 8),
                           box_room("d", 0, 4, 4, 8)});
    cut_pillar(sector(file, "b"), 101, 51, 102, 52);
    link(file, "a", {4, 0}, {4, 4}, "b", {100, 50}, {104, 50});
    join_all(file);
    const Map map = built(file);
    Random random(9);
    SightLine line;
    for (int i = 0; i < 2000; ++i) {
        const Place from{kFirst, snap_to_point_grid({random.uniform(0.5, 3.5), random.uniform(0.5, 3.5)})};
        const Vec2 to = snap_to_point_grid({random.uniform(-2, 9), random.uniform(-2, 9)});
        const Trace path = trace(map, from, to);
        look_along(map, from, to, line);
        ASSERT_EQ(line.met, path.stopped);
        ASSERT_GE(line.passed.size(), path.crossings.size());  // a body stops before the wall, maybe before a portal
        for (std::size_t k = 0; k < path.crossings.size(); ++k)
            ASSERT_EQ(line.passed[k].portal, path.crossings[k].portal);
    }
}

TEST(SightLine, SaysWhereAlongTheWayPortalsAreAndHowMuchTheyRaise) {
    MapFile file = map_of({box_room("a", 0, 0, 4, 4), box_room("b", 100, 50, 104, 54, 3, 6)});
    link(file, "a", {4, 0}, {4, 4}, "b", {100, 50}, {104, 50});
    SightLine line;
    look_along(built(file), {kFirst, {2, 1}}, {6, 2}, line);
    ASSERT_EQ(line.passed.size(), 1u);
    EXPECT_EQ(line.passed[0].at, 0.5);
    EXPECT_EQ(line.passed[0].rise, 0);
    EXPECT_EQ(line.rise, 3);
    EXPECT_EQ(line.from, (Vec2{103, 48}));
    EXPECT_FALSE(line.met);
}

}  // namespace
}  // namespace enfilade
