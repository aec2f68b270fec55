// The state as a value: hashed, compared, told apart.
#include "world/world.h"

#include <gtest/gtest.h>

#include "world/game.h"

namespace enfilade {
namespace {

using namespace test;

MapFile one_room() {
    MapFile file = map_of({box_room("room", 0, 0, 8, 8)});
    place_player(file, "room", {2, 2}, kEyeOnFloor, 30);
    return file;
}

TEST(World, StartsWhereTheMapSays) {
    Game game(one_room());
    EXPECT_EQ(game.point(), (Vec2{2, 2}));
    EXPECT_EQ(game.player().yaw, Angle::from_degrees(30));
    EXPECT_DOUBLE_EQ(game.player().eye_z, kEyeOnFloor);
    EXPECT_TRUE(game.player().on_ground);
}

TEST(World, StartsAboveTheFloorIfTheMapSaysSoAndFalls) {
    MapFile file = map_of({box_room("room", 0, 0, 8, 8, 0, 9)});
    place_player(file, "room", {2, 2}, 5 + kEyeOnFloor, 0);
    Game game(file);
    EXPECT_EQ(game.player().feet_z, 5);
    game.hold(kNoKeys, 120);
    EXPECT_EQ(game.player().feet_z, 0);
}

TEST(World, HasNoStartInAMapWithoutAPlayer) {
    EXPECT_FALSE(start_of(built(map_of({box_room("room", 0, 0, 8, 8)}))).has_value());
}

TEST(World, GoesOnFromACopyAsFromTheOriginal) {
    Game game(one_room());
    game.hold(kRunForward, 20);
    Game copy = game;
    game.hold(kRunForward, 50);
    copy.hold(kRunForward, 50);
    EXPECT_EQ(hash(copy.world), hash(game.world));
    EXPECT_EQ(difference(copy.world, game.world), "");
}

TEST(World, HashesEveryValueOfThePlayer) {
    const World plain = Game(one_room()).world;
    std::vector<World> changed(12, plain);
    changed[0].tick += 1;
    changed[1].player.place.sector = SectorId(7u);
    changed[2].player.place.point.x += kPointGrid;
    changed[3].player.place.point.y += kPointGrid;
    changed[4].player.feet_z += kPointGrid;
    changed[5].player.velocity.x = 1;
    changed[6].player.velocity.y = 1;
    changed[7].player.fall_speed = 1;
    changed[8].player.height = 1;
    changed[9].player.yaw.steps += 1;
    changed[10].player.pitch_steps += 1;
    changed[11].player.on_ground = false;
    for (std::size_t i = 0; i < changed.size(); ++i) EXPECT_NE(hash(changed[i]), hash(plain)) << i;
}

TEST(World, NamesWhatDiffers) {
    World a = Game(one_room()).world, b = a;
    b.player.feet_z = 0.5;
    b.player.on_ground = false;
    EXPECT_EQ(difference(a, b), "player.feet_z: 0 / 0.5\nplayer.on_ground: yes / no\n");
}

TEST(World, DoesNotHashWhatIsOnlyForDrawing) {
    World a = Game(one_room()).world, b = a;
    b.before.place.point.x += 1;
    EXPECT_EQ(hash(a), hash(b));
}

}  // namespace
}  // namespace enfilade
