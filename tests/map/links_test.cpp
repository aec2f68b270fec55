// What links and mirrors do to points: exactly what the author drew, and back again.
#include <gmock/gmock.h>

#include <algorithm>

#include "math/predicates.h"
#include "support/map_builder.h"

namespace enfilade {
namespace {

using namespace test;
/// A hall whose east wall a -> b is linked to the given wall of a triangular or other room `far`, both ways.
struct Linked {
    MapFile file;
    Vec2 a, b, far_a, far_b;

    Map built() const { return test::built(file); }
    static WallId at(const Map& map, Vec2 from, Vec2 to) {
        for (std::size_t i = 0; i < map.walls.size(); ++i)
            if (map.walls[i].a == from && map.walls[i].b == to) return WallId(i);
        return {};
    }
    Rigid there(const Map& map) const { return map.passage(map[at(map, a, b)]); }
    Rigid back(const Map& map) const { return map.passage(map[at(map, far_a, far_b)]); }
};

/// The hall is 0..4 x 0..4 m and the link its east wall; `far` is a room whose first edge is the other end.
Linked linked_to(std::vector<Vec2> far_outline, double far_floor = 0) {
    Linked l{map_of({box_room("hall", 0, 0, 4, 4), room("far", far_outline, far_floor, far_floor + 2)}),
             {4, 0},
             {4, 4},
             far_outline[0],
             far_outline[1]};
    link(l.file, "hall", l.a, l.b, "far", l.far_a, l.far_b);
    return l;
}

/// A room with its first edge 4 m long, turned by quarter turns to the right and put at `corner`.
std::vector<Vec2> turned_square(int quarters, Vec2 corner) {
    std::vector<Vec2> square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
    for (Vec2& v : square) {
        for (int i = 0; i < quarters; ++i) v = right_of(v);
        v = v + corner;
    }
    return square;
}

TEST(Link, CarriesEachEndOntoTheOtherForEveryQuarterTurn) {
    for (int quarters = 0; quarters < 4; ++quarters) {
        const Linked l = linked_to(turned_square(quarters, {100.125, -7 + kVertexGrid}));
        const Map map = l.built();
        const Rigid m = l.there(map);
        EXPECT_EQ(m.apply(l.a), l.far_b) << quarters;
        EXPECT_EQ(m.apply(l.b), l.far_a) << quarters;
        EXPECT_EQ(m.c * m.c + m.s * m.s, 1) << quarters;
    }
}

TEST(Link, CarriesWhatLiesBehindItIntoTheRoomBehind) {
    for (int quarters = 0; quarters < 4; ++quarters) {
        const Linked l = linked_to(turned_square(quarters, {100, 50}));
        const Map map = l.built();
        const Vec2 carried = l.there(map).apply({4.5, 1});  // half a metre beyond the wall
        EXPECT_EQ(side_of_line(l.far_a, l.far_b, carried), 1) << quarters;
    }
}

// hard case T13
TEST(Link, BackIsTheInverseOfTheLinkThere) {
    const Linked l = linked_to(turned_square(1, {9, 9}));
    const Map map = l.built();
    EXPECT_EQ(l.back(map), inverse(l.there(map)));
}

TEST(Link, TurnsByTheAngleBetweenTheWalls) {
    // The east wall, (0, 5), onto (3, 4), and reversed: the turn that takes (0, 5) to (-3, -4) has cos = -0.8, sin =
    // 0.6.
    MapFile file = map_of({box_room("hall", 0, 0, 4, 5), room("far", {{20, 0}, {23, 4}, {10, 10}})});
    link(file, "hall", {4, 0}, {4, 5}, "far", {20, 0}, {23, 4});
    const Map map = built(file);
    const Rigid m = map.links[0];
    EXPECT_EQ(m.c, -0.8);
    EXPECT_EQ(m.s, 0.6);
    EXPECT_EQ(m.apply({4, 2.5}), (Vec2{21.5, 2}));
}

// hard case C10
TEST(Link, OfAnyAngleComesBackAsItsInverse) {
    // Far from the origin the shift rounds, and differently each way: derived again from the walls, the way back
    // would miss by an ulp.
    for (const double far : {0.0, 300.0, 7001.5, 30000.25}) {
        const Vec2 a{far, 7}, b = a + Vec2{20, 21};
        MapFile file = map_of({room("hall", {{4, 0}, {4, 29}, {0, 3}}), room("far", {a, b, {far - 30, 50}})});
        link(file, "hall", {4, 0}, {4, 29}, "far", a, b);
        const Map map = built(file);
        ASSERT_EQ(map.links.size(), 2u);
        EXPECT_EQ(map.links[1], inverse(map.links[0])) << far;
    }
}

// hard case T13
TEST(Link, MayLeadOneWay) {
    Linked l = linked_to(turned_square(0, {50, 0}));
    WallRecord& other = wall(l.file, "far", l.far_a, l.far_b);
    other.next.clear();
    other.via.clear();
    const Map map = l.built();
    EXPECT_EQ(map.links.size(), 1u);
    EXPECT_EQ(map[Linked::at(map, l.far_a, l.far_b)].kind, WallKind::solid);
}

// hard case T13
TEST(Link, MayHaveSeveralWaysInAndOneBack) {
    Linked l = linked_to(turned_square(0, {50, 0}));
    WallRecord& second = wall(l.file, "hall", {4, 4}, {0, 4});
    second.next = "far";
    second.via = wall(l.file, "far", l.far_a, l.far_b).name;
    const Map map = l.built();
    EXPECT_EQ(map.links.size(), 3u);
    EXPECT_EQ(l.back(map), inverse(l.there(map)));
}

// Three rooms lead into one wall, by different turns; back leads the way of the one that the wall names.
// hard case T13
TEST(Link, OfThreeWaysIntoOneWallIsEachWithoutLossThereAndBack) {
    MapFile file = map_of({room("far", turned_square(1, {50, 7}))});
    for (int i = 0; i < 3; ++i)
        file.sectors.push_back(room(std::to_string(i), turned_square(i, {-100.0 * i, 30.0 * i})));
    const Vec2 far_a = file.sectors[0].loops[0].vertices[0], far_b = file.sectors[0].loops[0].vertices[1];
    for (int i = 2; i >= 0; --i) {
        const LoopRecord& loop = file.sectors[static_cast<std::size_t>(i + 1)].loops[0];
        link(file, std::to_string(i), loop.vertices[0], loop.vertices[1], "far", far_a, far_b);
    }
    const Map map = test::built(file);
    const Wall& exit = map[Linked::at(map, far_a, far_b)];
    ASSERT_EQ(map[exit.behind].name, "0");
    for (int i = 0; i < 3; ++i) {
        const std::vector<Vec2>& outline = file.sectors[static_cast<std::size_t>(i + 1)].loops[0].vertices;
        const Wall& wall = map[Linked::at(map, outline[0], outline[1])];
        const Rigid there = map.passage(wall);
        EXPECT_EQ(there.apply(wall.a), far_b) << i;
        EXPECT_EQ(there.apply(wall.b), far_a) << i;
        EXPECT_TRUE(then(there, inverse(there)).is_identity()) << i;
        EXPECT_EQ(inverse(there) == map.passage(exit), i == 0) << i;
    }
}

TEST(Link, MarksAWallThatItComesOutOfAndThatDoesNotLeadBack) {
    Linked l = linked_to(turned_square(0, {50, 0}));
    const Map both = l.built();
    EXPECT_TRUE(std::none_of(both.walls.begin(), both.walls.end(), [](const Wall& w) { return w.one_way_exit; }));
    WallRecord& other = wall(l.file, "far", l.far_a, l.far_b);
    other.next.clear();
    other.via.clear();
    const Map one_way = l.built();
    for (const Wall& w : one_way.walls) EXPECT_EQ(w.one_way_exit, w.a == l.far_a && w.b == l.far_b);
    wall(l.file, "hall", l.a, l.b).blocks = true;
    const Map blocked = l.built();
    EXPECT_TRUE(std::none_of(blocked.walls.begin(), blocked.walls.end(), [](const Wall& w) { return w.one_way_exit; }));
}

TEST(Link, MarksAnExitWithAWayBackThatOthersComeOutOfToo) {
    Linked l = linked_to(turned_square(0, {50, 0}));
    WallRecord& second = wall(l.file, "hall", {4, 4}, {0, 4});
    second.next = "far";
    second.via = wall(l.file, "far", l.far_a, l.far_b).name;
    const Map map = l.built();
    EXPECT_TRUE(map[Linked::at(map, l.far_a, l.far_b)].one_way_exit);
}

// hard case T13
TEST(Link, ToItselfIsAHalfTurnAboutItsMiddle) {
    MapFile file = map_of({box_room("hall", 0, 0, 4, 4)});
    link(file, "hall", {4, 0}, {4, 4}, "hall", {4, 0}, {4, 4});
    WallRecord& self = wall(file, "hall", {4, 0}, {4, 4});
    self.via = self.name;
    const Map map = built(file);
    ASSERT_EQ(map.links.size(), 1u);
    EXPECT_EQ(map.links[0].apply({3, 1}), (Vec2{5, 3}));
    EXPECT_TRUE(then(map.links[0], map.links[0]).is_identity());
}

TEST(Link, PutsFloorOnFloor) {
    const Linked l = linked_to(turned_square(0, {50, 0}), 7.5);
    const Map map = l.built();
    EXPECT_EQ(l.there(map).rise, 7.5);
    EXPECT_EQ(l.back(map).rise, -7.5);
}

TEST(Link, TakesItsRiseFromEitherSide) {
    for (const bool on_the_far_side : {false, true}) {
        Linked l = linked_to(turned_square(0, {50, 0}), 7.5);
        if (on_the_far_side)
            wall(l.file, "far", l.far_a, l.far_b).rise = -7;
        else
            wall(l.file, "hall", l.a, l.b).rise = 7;
        const Map map = l.built();
        EXPECT_EQ(l.there(map).rise, 7);
        EXPECT_EQ(l.back(map).rise, -7);
    }
}

/// The codes of a link between the hall's 4 m and a wall of this length.
std::string codes_for_length(double length) {
    Linked l = linked_to({{50, 0}, {50 + length, 0}, {50, 3}});
    std::string codes;
    for (const Finding& finding : findings_of(l.file))
        if (finding.severity == Severity::error) codes += finding.code + " ";
    return codes;
}

// hard case T12
TEST(Link, ForgivesOneStepOfTheGridInItsLength) {
    EXPECT_EQ(codes_for_length(4 + kVertexGrid), "");
    EXPECT_EQ(codes_for_length(4 - kVertexGrid), "");
}

// hard case T12
TEST(Link, RefusesLengthsThatDifferByTwoSteps) {
    EXPECT_EQ(codes_for_length(4 + 2 * kVertexGrid), "link-lengths link-lengths ");
    EXPECT_EQ(codes_for_length(5), "link-lengths link-lengths ");
}

// hard case T12
TEST(Link, ComparesSlantedLengthsExactly) {
    // 3-4-5 against 5; and a wall whose length is sqrt(25 m^2 + one squared step), which is not one step longer.
    for (const Vec2 end : {Vec2{3, 4}, Vec2{5, kVertexGrid}}) {
        MapFile file = map_of({box_room("hall", 0, 0, 4, 5), room("far", {{20, 0}, Vec2{20, 0} + end, {10, 10}})});
        link(file, "hall", {4, 0}, {4, 5}, "far", {20, 0}, Vec2{20, 0} + end);
        EXPECT_EQ(text_of(findings_of(file)).find("error"), std::string::npos) << text_of(findings_of(file));
    }
}

// hard case T12
TEST(Link, DrawsTheLineBetweenOneStepAndMoreExactly) {
    // (5 m, y) is longer than 5 m by y^2 / 10 m, nearly: 0.996 steps of the grid for y = 101 steps, 1.016 for 102.
    for (const int steps : {101, 102}) {
        const Vec2 end = Vec2{20, 0} + Vec2{5, steps * kVertexGrid};
        MapFile file = map_of({box_room("hall", 0, 0, 4, 5), room("far", {{20, 0}, end, {10, 10}})});
        link(file, "hall", {4, 0}, {4, 5}, "far", {20, 0}, end);
        EXPECT_EQ(has_errors(findings_of(file)), steps == 102) << text_of(findings_of(file));
    }
}

// hard case T12
TEST(Link, BetweenSlightlyDifferentLengthsKeepsDirectionsAtTheirLength) {
    const Linked l = linked_to({{50, 0}, {53, -2.6455078125}, {60, 3}});  // (3, -2.6455) is 3.99981 m long
    const Map map = l.built();
    const Rigid m = l.there(map);
    // Two rounded quotients of numbers near 1: each is within half a unit in the last place, 2^-54.
    EXPECT_NEAR(m.c * m.c + m.s * m.s, 1, 4 * 0x1p-53);
}

TEST(Mirror, ReflectsAboutItsOwnLineAndLeadsNowhereElse) {
    for (int quarters = 0; quarters < 4; ++quarters) {
        const auto outline = turned_square(quarters, {8, 16});
        MapFile file = map_of({room("hall", outline)});
        wall(file, "hall", outline[0], outline[1]).mirror = true;
        const Map map = built(file);
        const Wall& mirror = map.walls[0];
        EXPECT_EQ(mirror.kind, WallKind::mirror);
        EXPECT_EQ(mirror.behind, SectorId(0u));
        EXPECT_EQ(mirror.exit, WallId(0u));
        const Rigid m = map.passage(mirror);
        EXPECT_EQ(m.apply(mirror.a), mirror.a);
        EXPECT_EQ(m.apply(mirror.b), mirror.b);
        const Vec2 inward = right_of(mirror.b - mirror.a);
        EXPECT_EQ(m.apply(mirror.a + inward), mirror.a - inward);
        EXPECT_TRUE(then(m, m).is_identity());
    }
}

TEST(Mirror, OnASlantReflectsWithTheExactFractions) {
    MapFile file = map_of({room("hall", {{0, 0}, {3, 4}, {-5, 5}})});
    wall(file, "hall", {0, 0}, {3, 4}).mirror = true;
    const Map map = built(file);
    EXPECT_EQ(map.links[0].c, (9 - 16) / 25.0);
    EXPECT_EQ(map.links[0].s, 24 / 25.0);
}

}  // namespace
}  // namespace enfilade
