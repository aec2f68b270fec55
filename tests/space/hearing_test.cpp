// How sound comes to a listener: how far, and from where.
#include "space/hearing.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <queue>

#include "base/hash.h"
#include "space/mosaic.h"
#include "space/trace.h"
#include "support/map_builder.h"
#include "support/trials.h"

namespace enfilade {
namespace {

using namespace test;

/// Sums of a few square roots.
constexpr double kRounding = 1e-9;

constexpr double kFar = 1000;  ///< farther than anything in these maps [m]

double distance(Vec2 a, Vec2 b) { return std::hypot(b.x - a.x, b.y - a.y); }

SectorId named(const Map& map, const std::string& name) {
    for (std::size_t i = 0; i < map.sectors.size(); ++i)
        if (map.sectors[i].name == name) return SectorId(i);
    return {};
}

/// What is heard at `ear` of `source`; a length of -1 is nothing.
SoundWay heard(const Map& map, const Place& ear, const Place& source, double reach = kFar,
               const MayPass& may_pass = {}) {
    Hearing hearing(map);
    hearing.listen(ear, reach, may_pass);
    return hearing.from(source).value_or(SoundWay{-1, {}});
}

void expect_from(const SoundWay& way, Vec2 towards) {
    const double length = std::hypot(towards.x, towards.y);
    EXPECT_NEAR(way.from.x, towards.x / length, kRounding);
    EXPECT_NEAR(way.from.y, towards.y / length, kRounding);
}

TEST(Hearing, OfARoomIsAsFarAsTheStraightLine) {
    const Map map = built(map_of({box_room("hall", 0, 0, 9, 7)}));
    const SoundWay way = heard(map, {SectorId(0u), {1, 1}}, {SectorId(0u), {7, 6}});
    EXPECT_NEAR(way.length_m, distance({1, 1}, {7, 6}), kRounding);
    expect_from(way, {6, 5});
}

TEST(Hearing, OfOnesOwnPlaceHasNoDirection) {
    const Map map = built(map_of({box_room("hall", 0, 0, 9, 7)}));
    const SoundWay way = heard(map, {SectorId(0u), {4, 3}}, {SectorId(0u), {4, 3}});
    EXPECT_EQ(way.length_m, 0);
    EXPECT_EQ(way.from, (Vec2{0, 0}));
}

TEST(Hearing, InACornerOfTheRoomStillWorks) {
    const Map map = built(map_of({box_room("hall", 0, 0, 9, 7)}));
    EXPECT_NEAR(heard(map, {SectorId(0u), {0, 0}}, {SectorId(0u), {8, 6}}).length_m, 10, 1e-4);  // kOffTheCorner
}

/// An L: two arms, 2 m wide, around the inner corner (2, 2).
SectorRecord bent_room() { return room("bend", {{0, 0}, {8, 0}, {8, 2}, {2, 2}, {2, 8}, {0, 8}}); }

TEST(Hearing, AroundACornerHasTwoLegs) {
    const Map map = built(map_of({bent_room()}));
    const SoundWay way = heard(map, {SectorId(0u), {1, 7}}, {SectorId(0u), {7, 1}});
    EXPECT_NEAR(way.length_m, 2 * distance({1, 7}, {2, 2}), kRounding);
    expect_from(way, Vec2{2, 2} - Vec2{1, 7});
}

/// The same L in two parts, the part below y = 2 moved away: joined by an invisible line where it was, else by a link.
MapFile bend_in_parts(Vec2 away) {
    const auto lower = [&](double x, double y) { return Vec2{x, y} + away; };
    MapFile file = map_of({room("upper", {{0, 0}, {8, 0}, {8, 2}, {2, 2}, {0, 2}}),
                           room("lower", {lower(0, 2), lower(2, 2), lower(2, 8), lower(0, 8)})});
    if (away == Vec2{})
        join_all(file);
    else
        link(file, "upper", {2, 2}, {0, 2}, "lower", lower(0, 2), lower(2, 2));
    return file;
}

// hard cases I6, I7, I10, I12
TEST(Hearing, IsTheSameInAWorldMovedTurnedMirroredOrCut) {
    const Vec2 by{-16384, 4096}, away{100, -50};
    const auto bent = [](auto move) {
        MapFile file = map_of({bent_room()});
        for (Vec2& v : file.sectors[0].loops[0].vertices) v = move(v);
        return file;
    };
    const auto stay = [](Vec2 v) { return v; };
    const auto shift = [&](Vec2 v) { return v + by; };
    const auto transpose = [](Vec2 v) { return Vec2{v.y, v.x}; };
    MapFile turned_over = bent(transpose);
    std::reverse(turned_over.sectors[0].loops[0].vertices.begin(), turned_over.sectors[0].loops[0].vertices.end());
    const Map whole = built(bent(stay)), moved = built(bent(shift)), turned = built(bent(right_of)),
              mirrored = built(turned_over), cut = built(bend_in_parts({})), linked = built(bend_in_parts(away));
    const SectorId only(0u), lower(1u);
    Random random(6);
    for (int i = 0; i < 500; ++i) {
        const Vec2 ear{random.uniform(2, 8), random.uniform(0, 2)}, source{random.uniform(0, 2), random.uniform(2, 8)};
        const Vec2 p = snap_to_point_grid(ear), q = snap_to_point_grid(source);
        const double far = heard(whole, {only, p}, {only, q}).length_m;
        ASSERT_GE(far, 0);
        ASSERT_NEAR(heard(moved, {only, shift(p)}, {only, shift(q)}).length_m, far, kRounding);
        ASSERT_NEAR(heard(turned, {only, right_of(p)}, {only, right_of(q)}).length_m, far, kRounding);
        ASSERT_NEAR(heard(mirrored, {only, transpose(p)}, {only, transpose(q)}).length_m, far, kRounding);
        ASSERT_NEAR(heard(cut, {only, p}, {lower, q}).length_m, far, kRounding);
        ASSERT_NEAR(heard(linked, {only, p}, {lower, q + away}).length_m, far, kRounding);
        ASSERT_NEAR(heard(whole, {only, q}, {only, p}).length_m, far, kRounding) << "and back";
    }
    count_trials(500 * 7, "sounds");
}

TEST(Hearing, GoesRoundAPillarOnTheShorterSide) {
    MapFile file = map_of({box_room("hall", 0, 0, 10, 10)});
    cut_pillar(file.sectors[0], 4, 3, 6, 8);
    const SoundWay way = heard(built(file), {SectorId(0u), {3, 5}}, {SectorId(0u), {7, 5}});
    EXPECT_NEAR(way.length_m, 2 * distance({3, 5}, {4, 3}) + 2, kRounding);
    expect_from(way, Vec2{4, 3} - Vec2{3, 5});
}

TEST(Hearing, OfTwoEqualWaysAlwaysTakesTheSame) {
    MapFile file = map_of({box_room("hall", 0, 0, 10, 10)});
    cut_pillar(file.sectors[0], 4, 4, 6, 6);
    const Map map = built(file);
    const SoundWay first = heard(map, {SectorId(0u), {3, 5}}, {SectorId(0u), {7, 5}});
    for (int i = 0; i < 5; ++i) EXPECT_EQ(heard(map, {SectorId(0u), {3, 5}}, {SectorId(0u), {7, 5}}).from, first.from);
}

/// Rooms to the left and right of a doorway 1 m long, from (8, 3) to (9, 4).
MapFile door_between_rooms() {
    MapFile file = map_of({box_room("left", 0, 0, 8, 6), box_room("door", 8, 3, 9, 4), box_room("right", 9, 0, 17, 6)});
    split_and_join(file);
    return file;
}

TEST(Hearing, ComesThroughADoorwayFromItsEdge) {
    const Map map = built(door_between_rooms());
    const SoundWay way = heard(map, {named(map, "left"), {7, 1}}, {named(map, "right"), {10, 1}});
    EXPECT_NEAR(way.length_m, 2 * distance({7, 1}, {8, 3}) + 1, kRounding);
    expect_from(way, {1, 2});
}

TEST(Hearing, DoesNotPassAClosedDoor) {
    const Map map = built(door_between_rooms());
    const SectorId door = named(map, "door");
    const auto is_open = [&](WallId wall, const Rigid&) { return map[wall].behind != door; };
    EXPECT_EQ(heard(map, {named(map, "left"), {7, 3.5}}, {named(map, "right"), {10, 3.5}}, kFar, is_open).length_m, -1);
}

TEST(Hearing, HearsTheClosedDoorItself) {
    const Map map = built(door_between_rooms());
    const SectorId door = named(map, "door");
    Hearing hearing(map);
    hearing.listen({named(map, "left"), {5, 3.5}}, kFar,
                   [&](WallId wall, const Rigid&) { return map[wall].behind != door; });
    ASSERT_TRUE(hearing.from(door).has_value());
    EXPECT_NEAR(hearing.from(door)->length_m, 3, kRounding);
    expect_from(*hearing.from(door), {1, 0});
    EXPECT_THAT(hearing.sectors(), testing::ElementsAre(named(map, "left"), door));
}

TEST(Hearing, IsInTheMiddleOfItsOwnSector) {
    const Map map = built(door_between_rooms());
    Hearing hearing(map);
    hearing.listen({named(map, "left"), {5, 3.5}}, kFar);
    EXPECT_EQ(hearing.from(named(map, "left"))->length_m, 0);
}

TEST(Hearing, EndsAtItsReach) {
    const Map map = built(door_between_rooms());
    const Place ear{named(map, "left"), {2, 3.5}}, source{named(map, "right"), {10, 3.5}};
    EXPECT_EQ(heard(map, ear, source, 8).length_m, -1);
    EXPECT_NEAR(heard(map, ear, source, 8.001).length_m, 8, kRounding);
}

TEST(Hearing, OfAMirrorIsThatOfAWall) {
    MapFile file = map_of({box_room("hall", 0, 0, 4, 4)});
    wall(file, "hall", {4, 0}, {4, 4}).mirror = true;
    const Map map = built(file);
    EXPECT_NEAR(heard(map, {SectorId(0u), {1, 1}}, {SectorId(0u), {1, 3}}).length_m, 2, kRounding);
}

TEST(Hearing, HearsWhatIsOnAWall) {
    const Map map = built(map_of({box_room("hall", 0, 0, 4, 4)}));
    EXPECT_NEAR(heard(map, {SectorId(0u), {1, 2}}, {SectorId(0u), {4, 2}}).length_m, 3, kRounding);
}

/// The same two rooms and doorway, but the right one lies elsewhere, turned: what was seen along +x goes on along +y.
MapFile door_to_elsewhere() {
    MapFile file =
        map_of({box_room("left", 0, 0, 8, 6), box_room("door", 8, 3, 9, 4), box_room("right", 100, 200, 106, 208)});
    split_and_join(file);
    SectorRecord& right = sector(file, "right");
    right.loops[0] = loop_of({{100, 200}, {102, 200}, {103, 200}, {106, 200}, {106, 208}, {100, 208}});
    link(file, "door", {9, 3}, {9, 4}, "right", {102, 200}, {103, 200});
    return file;
}

// hard case I10
TEST(Hearing, ThroughALinkIsAsInTheUnfoldedWorld) {
    const Map flat = built(door_between_rooms()), linked = built(door_to_elsewhere());
    // (9 + x, y) of the flat world is (106 - y, 200 + x) of the linked one.
    for (const Vec2 ear : {Vec2{7, 1}, Vec2{1, 3.5}, Vec2{4, 5.5}})
        for (const Vec2 source : {Vec2{10, 1}, Vec2{16, 3.5}, Vec2{9.5, 5}}) {
            const SoundWay plain = heard(flat, {named(flat, "left"), ear}, {named(flat, "right"), source});
            const Vec2 there{106 - source.y, 200 + (source.x - 9)};
            const SoundWay way = heard(linked, {named(linked, "left"), ear}, {named(linked, "right"), there});
            EXPECT_NEAR(way.length_m, plain.length_m, kRounding);
            expect_from(way, plain.from);
        }
}

TEST(Hearing, GoesThroughALinkAndBackAsFar) {
    const Map map = built(door_to_elsewhere());
    const Place here{named(map, "left"), {7, 1}}, there{named(map, "right"), {105.5, 201}};
    EXPECT_NEAR(heard(map, here, there).length_m, heard(map, there, here).length_m, kRounding);
}

// hard case R24
TEST(Hearing, EndsInARoomThatOpensIntoItself) {
    MapFile file = map_of({box_room("loop", 0, 0, 1, 1)});
    link(file, "loop", {1, 0}, {1, 1}, "loop", {0, 1}, {0, 0});
    const Map map = built(file);
    EXPECT_NEAR(heard(map, {SectorId(0u), {0.125, 0.5}}, {SectorId(0u), {0.875, 0.5}}).length_m, 0.25, kRounding);
}

// An oracle that shares no code: the shortest way over a graph of all places where ways can bend, joined wherever
// trace() goes straight from one to the other.
class MosaicHearing : public testing::TestWithParam<int> {};

/// Shifts a corner a little into each of the four quarters around it, so that it lies in a room.
std::vector<Place> bending_places(const Map& map) {
    std::vector<Place> places;
    constexpr double kStep = 0x1p-12;
    for (const Wall& wall : map.walls)
        for (const Vec2 way : {Vec2{1, 1}, Vec2{1, -1}, Vec2{-1, 1}, Vec2{-1, -1}})
            if (const Vec2 p = wall.a + way * kStep; const SectorId sector = locate(map, p))
                places.push_back({sector, p});
    return places;
}

std::vector<double> shortest_from(const Map& map, const Place& start, const std::vector<Place>& places) {
    std::vector<double> lengths(places.size(), kFar);
    using Waiting = std::pair<double, std::size_t>;
    std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> waiting;
    const auto spread = [&](const Place& from, double length) {
        for (std::size_t i = 0; i < places.size(); ++i) {
            const double there = length + distance(from.point, places[i].point);
            if (there >= lengths[i] || trace(map, from, places[i].point).stopped) continue;
            lengths[i] = there;
            waiting.push({there, i});
        }
    };
    spread(start, 0);
    while (!waiting.empty()) {
        const auto [length, i] = waiting.top();
        waiting.pop();
        if (length == lengths[i]) spread(places[i], length);
    }
    return lengths;
}

/// Bent mosaics, and lattices, where shadows run through further corners; on those one also listens on whole metres.
TEST_P(MosaicHearing, IsAsFarAsTheShortestWayOverAllCorners) {
    const auto seed = static_cast<std::uint64_t>(GetParam());
    const bool is_lattice = seed % 2 == 0;
    const Mosaic mosaic =
        lay_mosaic({.columns = 5, .rows = 5, .jitter = is_lattice ? 0 : 0.75, .labels = 5, .solid = 0.3}, seed);
    const Map& map = mosaic.map;
    Random random(seed);
    const auto somewhere = [&] {
        for (;;) {
            const auto coordinate = [&] { return random.uniform(0, 20); };
            const auto meter = [&] { return static_cast<double>(1 + random.below(19)); };
            const Vec2 p = is_lattice && random.below(2) == 0 ? Vec2{meter(), meter()}
                                                              : snap_to_point_grid(Vec2{coordinate(), coordinate()});
            if (const SectorId sector = locate(map, p)) return Place{sector, p};
        }
    };
    std::vector<Place> places = bending_places(map);
    const std::size_t corners = places.size();
    for (int i = 0; i < 20; ++i) places.push_back(somewhere());
    for (int i = 0; i < 2; ++i) {
        const Place ear = somewhere();
        const std::vector<double> expected = shortest_from(map, ear, places);
        Hearing hearing(map);
        hearing.listen(ear, kFar);
        for (std::size_t s = corners; s < places.size(); ++s) {
            const auto way = hearing.from(places[s]);
            // The oracle bends 2^-12 m beside the corners, a few times.
            EXPECT_NEAR(way ? way->length_m : kFar, expected[s], 0.01) << ear.point.x << " " << ear.point.y;
        }
    }
}

/// Places and whole sectors all over the map, some of them out of reach.
std::vector<SoundSource> scattered_sources(const Map& map, Random& random) {
    std::vector<SoundSource> sources;
    for (int i = 0; i < 6; ++i) {
        const SectorId sector(random.below(map.sectors.size()));
        sources.push_back({sector, {}, random.uniform(1, 25)});
        const Sector& other = map.sectors[random.below(map.sectors.size())];
        const Vec2 p = snap_to_point_grid(
            Vec2{random.uniform(other.min.x, other.max.x), random.uniform(other.min.y, other.max.y)});
        if (const SectorId inside = locate(map, p)) sources.push_back({inside, p, random.uniform(1, 25)});
    }
    return sources;
}

/// What is heard of the source, a length of -1 where that is nothing.
SoundWay heard_of(const Hearing& hearing, const SoundSource& source) {
    const auto way = source.point ? hearing.from(Place{source.sector, *source.point}) : hearing.from(source.sector);
    return way && way->length_m < source.reach_m ? *way : SoundWay{-1, {}};
}

/// Exactly: length and direction. How many of the sources are heard.
int expect_same_ways(const Hearing& some, const Hearing& all, std::span<const SoundSource> sources) {
    int heard_sources = 0;
    for (const SoundSource& source : sources) {
        const SoundWay found = heard_of(some, source), expected = heard_of(all, source);
        EXPECT_EQ(found.length_m, expected.length_m);
        EXPECT_EQ(found.from, expected.from);
        heard_sources += expected.length_m >= 0;
    }
    return heard_sources;
}

/// The maps above, with some of the portals shut.
TEST_P(MosaicHearing, ForSomeSourcesIsAsForAll) {
    const auto seed = static_cast<std::uint64_t>(GetParam());
    const Mosaic mosaic =
        lay_mosaic({.columns = 6, .rows = 6, .jitter = seed % 2 == 0 ? 0 : 0.75, .labels = 9, .solid = 0.2}, seed);
    const Map& map = mosaic.map;
    const auto is_open = [&](WallId wall, const Rigid&) { return (wall.index + map[wall].exit.index) % 5 != 0; };
    Random random(seed);
    Hearing some(map), all(map);
    int heard_sources = 0;
    for (int i = 0; i < 20; ++i) {
        const std::vector<SoundSource> sources = scattered_sources(map, random);
        const Place ear{sources[1].sector, sources[1].point.value_or(map[sources[1].sector].min)};
        some.listen(ear, sources, is_open);
        all.listen(ear, kFar, is_open);
        heard_sources += expect_same_ways(some, all, sources);
    }
    EXPECT_GT(heard_sources, 20);
}

TEST(Hearing, ForSomeSourcesBehindALinkIsAsForAll) {
    const Map map = built(door_to_elsewhere());
    const SectorId left = named(map, "left"), right = named(map, "right");
    const std::vector<SoundSource> sources{{right, {}, 20}, {right, Vec2{105.5, 201}, 20}, {left, Vec2{1, 5}, 20}};
    Hearing some(map), all(map);
    all.listen({left, {7, 1}}, kFar);
    for (const SoundSource& source : sources) {
        some.listen({left, {7, 1}}, std::span(&source, 1));
        EXPECT_EQ(expect_same_ways(some, all, std::span(&source, 1)), 1);
    }
}

TEST(Hearing, HearsNothingOfWhereItWasOnceItForgot) {
    const Map map = built(door_between_rooms());
    const SectorId left = named(map, "left"), right = named(map, "right");
    Hearing hearing(map);
    hearing.listen({left, {7, 1}}, kFar);
    hearing.listen({left, {1, 1}}, kFar, {}, 1);
    hearing.forget();
    EXPECT_FALSE(hearing.from(left) || hearing.from(right) || hearing.from(Place{left, {6, 1}}));
    EXPECT_TRUE(hearing.sectors().empty());
    hearing.listen({right, {16, 1}}, kFar);
    EXPECT_NEAR(hearing.from(Place{right, {14, 1}})->length_m, 2, kRounding);
}

/// Piece by piece it comes to the same, and the one before counts until then.
TEST_P(MosaicHearing, GoesOnWhereItWasCutOff) {
    const auto seed = static_cast<std::uint64_t>(GetParam());
    const Mosaic mosaic = lay_mosaic({.columns = 6, .rows = 6, .jitter = 0.75, .labels = 9, .solid = 0.2}, seed);
    Random random(seed);
    const std::vector<SoundSource> sources = scattered_sources(mosaic.map, random);
    const Place first{sources[1].sector, sources[1].point.value_or(mosaic.map[sources[1].sector].min)};
    const Place second{sources[0].sector, mosaic.map.walls[mosaic.map[sources[0].sector].first_wall].a};
    Hearing whole(mosaic.map), pieces(mosaic.map);
    pieces.listen(first, kFar);
    pieces.listen(second, kFar, {}, 1);
    whole.listen(first, kFar);
    expect_same_ways(pieces, whole, sources);
    for (std::size_t i = 0; i < Hearing::kMostBeams / 16; ++i) pieces.listen(second, kFar, {}, 16);
    whole.listen(second, kFar);
    EXPECT_GT(expect_same_ways(pieces, whole, sources), 0);
}

INSTANTIATE_TEST_SUITE_P(Seeds, MosaicHearing, testing::Range(1, 25));

}  // namespace
}  // namespace enfilade
