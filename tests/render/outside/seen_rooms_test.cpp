// What of which room a picture shows, and where it appears to be.
#include "render/outside/outside_renderer.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/map_builder.h"

namespace enfilade {
namespace {

using test::box_room;

constexpr int kWidth = 160, kHeight = 100;

/// In the middle of the first room, 1 m high, looking along +x.
View view_east(Vec2 eye) {
    View view;
    view.sector = SectorId(0u);
    view.eye = eye;
    view.eye_z = 1;
    return view;
}

SeenRooms seen(const Map& map, const View& view) {
    SeenRooms rooms;
    rooms.look(map, at_rest(map), view, kWidth, kHeight);
    return rooms;
}

/// "left" and "right" with a doorway from (4, 1) to (4, 3).
MapFile two_rooms() {
    MapFile file = test::map_of({box_room("left", 0, 0, 4, 4), test::room("right", {{4, 1}, {8, 1}, {8, 3}, {4, 3}})});
    test::split_and_join(file);
    return file;
}

TEST(SeenRooms, ShowWhatLiesBetweenTheEdgesOfTheView) {
    const Map map = test::built(two_rooms());
    const SeenRooms rooms = seen(map, view_east({2, 2}));
    ASSERT_EQ(rooms.rooms().size(), 2u);
    EXPECT_EQ(rooms.rooms()[1].sector, SectorId(1u));
    EXPECT_TRUE(rooms.rooms()[1].to_eye.is_identity());
    EXPECT_TRUE(rooms.shows(0, {}, {3, 2.9}, 1));  // half a right angle to either side
    EXPECT_FALSE(rooms.shows(0, {}, {3, 3.1}, 1));
    EXPECT_FALSE(rooms.shows(0, {}, {1, 2}, 1));  // behind the eye
    EXPECT_TRUE(rooms.shows(1, {}, {5, 2}, 1));
    EXPECT_FALSE(rooms.shows(0, {}, {5, 2}, 1));  // that point is in the other room
    EXPECT_FALSE(rooms.shows(1, {}, {3, 2}, 1));
}

TEST(SeenRooms, ShowNoMoreThanThePictureIsHigh) {
    const Map map = test::built(two_rooms());
    const SeenRooms rooms = seen(map, view_east({2, 2}));
    // 100 rows of 160 columns at 90 degrees: 0.625 up and down per metre, less half a pixel.
    EXPECT_TRUE(rooms.shows(0, {}, {3, 2}, 0.4));
    EXPECT_FALSE(rooms.shows(0, {}, {3, 2}, 0.37));
}

TEST(SeenRooms, ShowTheWallsThatTheyMeetAndNoOthers) {
    const Map map = test::built(two_rooms());
    const SeenRooms rooms = seen(map, view_east({2, 2}));
    for (std::size_t i = 0; i < map.walls.size(); ++i) {
        const Wall& wall = map.walls[i];
        const bool is_end_of_right = wall.sector == SectorId(1u) && wall.a.x == 8 && wall.b.x == 8;
        if (is_end_of_right) {
            EXPECT_TRUE(rooms.shows(1, WallId(i), {8, 2}, 1));
        }
        if (wall.kind == WallKind::solid && !is_end_of_right) {
            EXPECT_FALSE(rooms.shows(wall.sector.index, WallId(i), {8, 2}, 1)) << i;
        }
    }
}

TEST(SeenRooms, HideTheGroundBehindASill) {
    MapFile file = two_rooms();
    test::sector(file, "left").floor.z = 0.5;
    for (LoopRecord& loop : test::sector(file, "right").loops)
        for (WallRecord& wall : loop.walls) wall.lower = test::spec("step");
    const Map map = test::built(file);
    const SeenRooms rooms = seen(map, view_east({2, 2}));
    // The eye is 0.5 m above the near floor's rim, 2 m away: the far floor, 1 m below the eye, is seen from 4 m on.
    EXPECT_FALSE(rooms.shows(1, {}, {5.9, 2}, 0));
    EXPECT_TRUE(rooms.shows(1, {}, {6.1, 2}, 0));
}

TEST(SeenRooms, LookOverAStepUp) {
    MapFile file = two_rooms();
    test::sector(file, "right").floor.z = 0.5;
    test::wall(file, "left", {4, 1}, {4, 3}).lower = test::spec("step");
    const Map map = test::built(file);
    const SeenRooms rooms = seen(map, view_east({2, 2}));
    EXPECT_FALSE(rooms.shows(1, {}, {4.5, 2}, 0.3));
    EXPECT_TRUE(rooms.shows(1, {}, {4.5, 2}, 0.5));
}

TEST(SeenRooms, LayALinkedRoomBehindItsDoor) {
    MapFile file = test::map_of({box_room("main", 0, 0, 4, 4), box_room("far", 104, 50, 108, 54, 7, 9)});
    test::link(file, "main", {4, 0}, {4, 4}, "far", {104, 54}, {104, 50});
    const Map map = test::built(file);
    const SeenRooms rooms = seen(map, view_east({2, 2}));
    ASSERT_EQ(rooms.rooms().size(), 2u);
    const Rigid& to_eye = rooms.rooms()[1].to_eye;
    EXPECT_EQ(to_eye.apply({104, 50}), (Vec2{4, 0}));
    EXPECT_EQ(to_eye.apply({108, 54}), (Vec2{8, 4}));
    EXPECT_EQ(to_eye.apply_height(7), 0);
    EXPECT_TRUE(rooms.shows(1, {}, {6, 2}, 1));
}

TEST(SeenRooms, LayTheRoomInAMirrorBehindTheMirror) {
    MapFile file = test::map_of({box_room("main", 0, 0, 4, 4)});
    test::wall(file, "main", {4, 0}, {4, 4}).mirror = true;
    const Map map = test::built(file);
    const SeenRooms rooms = seen(map, view_east({2, 2}));
    ASSERT_EQ(rooms.rooms().size(), 2u);
    EXPECT_EQ(rooms.rooms()[1].to_eye.apply({1, 0.5}), (Vec2{7, 0.5}));
    EXPECT_TRUE(rooms.shows(1, {}, {6, 2}, 1));
    EXPECT_DOUBLE_EQ(rooms.end_of_first().x, 2 + 2 * 160 / 159.0) << "in the mirror, on the north wall";
}

TEST(SeenRooms, EndWhereTheMapEndsChainsOfLinks) {
    MapFile file = test::map_of({box_room("main", 0, 0, 4, 4)});
    test::link(file, "main", {4, 0}, {4, 4}, "main", {0, 4}, {0, 0});
    file.render.max_depth = 5;
    const Map map = test::built(file);
    EXPECT_EQ(seen(map, view_east({2, 2})).rooms().size(), 6u);
}

TEST(SeenRooms, AddTheSurroundingsUnseen) {
    const Map map = test::built(two_rooms());
    View west = view_east({2, 2});
    west.forward = {-1, 0};
    SeenRooms rooms = seen(map, west);
    EXPECT_EQ(rooms.rooms().size(), 1u);
    rooms.add_surroundings(map, SectorId(0u), {2, 2}, 1.5);
    EXPECT_EQ(rooms.rooms().size(), 1u) << "the doorway is 2 m away";
    rooms.add_surroundings(map, SectorId(0u), {2, 2}, 2.5);
    ASSERT_EQ(rooms.rooms().size(), 2u);
    EXPECT_FALSE(rooms.shows(1, {}, {5, 2}, 1));
}

TEST(SeenRooms, TakeATurnedPictureForTheShearedOne) {
    const Map map = test::built(two_rooms());
    View turned = view_east({2, 2}), sheared = turned;
    turned.tilt = Tilt{direction(Angle::from_degrees(-20)), {1, 0}};
    sheared.pitch_tangent = tangent(Angle::from_degrees(-20));
    const SeenRooms a = seen(map, turned), b = seen(map, sheared);
    for (double z = 0; z < 2; z += 0.01) EXPECT_EQ(a.shows(0, {}, {3, 2}, z), b.shows(0, {}, {3, 2}, z)) << z;
}

/// A pillar of so many walls, thin as a comb.
LoopRecord comb(int walls) {
    std::vector<Vec2> vertices;
    for (int i = 0; i < walls - 2; ++i) vertices.push_back({1 + i / 1024.0, i % 2 ? 1.125 : 1.0});
    vertices.push_back({vertices.back().x, 1.25});
    vertices.push_back({1, 1.25});
    std::reverse(vertices.begin(), vertices.end());  // a hole
    return test::loop_of(vertices);
}

TEST(SeenRooms, EndWhereRoomsHaveTooManyWalls) {
    MapFile file = test::map_of({box_room("main", 0, 0, 4, 4)});
    test::link(file, "main", {4, 0}, {4, 4}, "main", {0, 4}, {0, 0});
    test::link(file, "main", {0, 0}, {4, 0}, "main", {4, 4}, {0, 4});
    test::sector(file, "main").loops.push_back(comb(500));
    file.render.max_depth = 1024;
    const Map map = test::built(file);
    SeenRooms rooms = seen(map, view_east({2, 2}));
    EXPECT_EQ(rooms.rooms().size(), SeenRooms::kMostWalls / 504);
    rooms.add_surroundings(map, SectorId(0u), {2, 2}, 100);
    EXPECT_EQ(rooms.rooms().size(), SeenRooms::kMostWalls / 504);
}

}  // namespace
}  // namespace enfilade
