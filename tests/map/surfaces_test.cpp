// Texture specs as tiles, offsets and pegs; contrast by direction.
#include <gmock/gmock.h>

#include <cmath>

#include "support/map_builder.h"

namespace enfilade {
namespace {

using namespace test;

/// One room; its first wall is what the test is about. Pictures are 64 x 64.
MapFile one_room() { return map_of({box_room("hall", 0, 0, 4, 4)}); }

Surface first_surface(const WallRecord& record) {
    MapFile file = one_room();
    file.sectors[0].loops[0].walls[0] = record;
    const Map map = built(file);
    return map[map.walls[0].texture];
}

WallRecord textured(const TextureSpec& spec) {
    WallRecord wall;
    wall.texture = spec;
    return wall;
}

TEST(Surface, IsOneTileAMetreUnlessTheSpecSaysMore) {
    EXPECT_EQ(first_surface(textured(spec("brick"))).tile_m, (Vec2{1, 1}));
    EXPECT_EQ(first_surface(textured({"brick", Vec2{2, 0.5}, {}, {}})).tile_m, (Vec2{2, 0.5}));
}

TEST(Surface, TakesItsTileFromTheTexelsPerMetre) {
    WallRecord wall = textured(spec("brick"));
    wall.size = 32;
    EXPECT_EQ(first_surface(wall).tile_m, (Vec2{2, 2}));
}

TEST(Surface, TakesTheMapsTexelsPerMetreWhereNothingElseIsSaid) {
    MapFile file = one_room();
    file.size = 32;
    std::vector<WallRecord>& walls = file.sectors[0].loops[0].walls;
    walls[1].size = 16;
    walls[2].texture->tile_m = Vec2{3, 5};
    const Map map = built(file);
    EXPECT_EQ(map[map.walls[0].texture].tile_m, (Vec2{2, 2}));
    EXPECT_EQ(map[map.walls[1].texture].tile_m, (Vec2{4, 4}));
    EXPECT_EQ(map[map.walls[2].texture].tile_m, (Vec2{3, 5}));
    EXPECT_EQ(map[map.sectors[0].floor.surface].tile_m, (Vec2{2, 2}));
}

TEST(Surface, KeepsTheFractionOfItsOffsetInTiles) {
    EXPECT_EQ(first_surface(textured({"brick", {}, {16, -16}, {}})).offset_tiles, (Vec2{0.25, 0.75}));
    EXPECT_EQ(first_surface(textured({"brick", {}, {64 * 1000 + 32, -64}, {}})).offset_tiles, (Vec2{0.5, 0}));
}

TEST(Surface, GoesOnAfterMetresWhateverItsTile) {
    EXPECT_EQ(first_surface(textured({"brick", Vec2{2, 4}, {16, 0}, {}, Vec2{-0.5, 1}})).offset_tiles, (Vec2{0, 0.25}));
    WallRecord wall = textured({"brick", {}, {}, {}, Vec2{-0.5, 0}});
    wall.size = 32;
    EXPECT_EQ(first_surface(wall).offset_tiles, (Vec2{0.75, 0}));
}

TEST(Surface, MirrorsWithANegativeTile) {
    EXPECT_EQ(first_surface(textured({"brick", Vec2{-1, 1}, {}, {}})).tile_m, (Vec2{-1, 1}));
}

TEST(Surface, OfADashHasNoTexture) {
    EXPECT_FALSE(first_surface(textured(spec("-"))).texture);
    EXPECT_TRUE(first_surface(textured(spec("brick"))).texture);
}

TEST(Surface, KeepsItsPeg) {
    WallRecord wall = textured(spec("brick"));
    wall.texture_peg = Peg::floor;
    EXPECT_EQ(first_surface(wall).peg, Peg::floor);
}

TEST(Surface, IsKeptOnceHoweverManyWallsAndFlatsShowIt) {
    const auto count_in = [](std::size_t rooms) {
        MapFile file = map_of({});
        for (std::size_t i = 0; i < rooms; ++i) {
            const double x = 8.0 * static_cast<double>(i);
            file.sectors.push_back(box_room("room" + std::to_string(i), x, 0, x + 4, 4));
        }
        return built(file).surfaces.size();
    };
    EXPECT_EQ(count_in(1), count_in(100));
}

TEST(Surface, OfAWallThatScrollsIsNotThatOfOneThatStays) {
    MapFile file = one_room();
    file.sectors[0].loops[0].walls[1].scroll = {1, -2};
    const Map map = built(file);
    EXPECT_EQ(map[map.walls[0].texture].scroll, (Vec2{}));
    EXPECT_EQ(map[map.walls[1].texture].scroll, (Vec2{1, -2}));
    EXPECT_EQ(map.walls[0].texture, map.walls[2].texture);
}

TEST(Surface, FindsItsPictureInEitherCase) {
    MapFile file = one_room();
    file.sectors[0].loops[0].walls[0].texture = spec("BRICK");
    file.sectors[0].loops[0].walls[1].texture = spec("brick");
    const Map map = built(file);
    EXPECT_EQ(map[map.walls[0].texture].texture, map[map.walls[1].texture].texture);
}

/// The pictures of a portal, the first of two that join two rooms.
struct PortalPictures {
    TextureId texture, upper, lower, middle;
};

PortalPictures portal_with(const WallRecord& looks) {
    MapFile file = map_of({box_room("left", 0, 0, 4, 4), box_room("right", 4, 0, 8, 4, 0.5, 1.5)});
    WallRecord& portal = wall(file, "left", {4, 0}, {4, 4});
    portal = looks;
    join_all(file);
    const Map map = built(file);
    const Wall& built_portal = map.walls[1];
    return {map[built_portal.texture].texture, map[built_portal.upper].texture, map[built_portal.lower].texture,
            map[built_portal.middle].texture};
}

TEST(Surface, OfAPortalServesBothSteps) {
    const PortalPictures portal = portal_with(textured(spec("brick")));
    EXPECT_TRUE(portal.upper);
    EXPECT_EQ(portal.upper, portal.lower);
    EXPECT_FALSE(portal.texture);
}

TEST(Surface, OfAStepComesBeforeThePortals) {
    WallRecord looks = textured(spec("brick"));
    looks.lower = spec("plank");
    const PortalPictures portal = portal_with(looks);
    EXPECT_NE(portal.upper, portal.lower);
    looks.upper = looks.lower;
    EXPECT_EQ(portal_with(looks).upper, portal_with(looks).lower);
}

TEST(Surface, OfAMiddleIsKeptBesideTheSteps) {
    WallRecord looks = textured(spec("brick"));
    looks.middle = spec("bars");
    const PortalPictures portal = portal_with(looks);
    EXPECT_TRUE(portal.middle);
    EXPECT_NE(portal.middle, portal.upper);
}

TEST(Flat, LiesFromTheWorldsOriginUnlessItIsRelative) {
    MapFile file = map_of({box_room("hall", 3, 5, 8, 9)});
    file.sectors[0].ceiling.is_relative = true;
    const Map map = built(file);
    EXPECT_EQ(map.sectors[0].floor.origin, (Vec2{0, 0}));
    EXPECT_EQ(map.sectors[0].ceiling.origin, (Vec2{3, 5}));
}

TEST(Flat, IsSkyWhereItHasParallax) {
    MapFile file = one_room();
    file.sectors[0].ceiling.parallax = true;
    file.sectors[0].ceiling.texture = TextureSpec{"sky", Vec2{4, 0.75}, {}, {}};
    file.size = file.sectors[0].ceiling.size = 32;  // says nothing about wraps and a tangent
    const Map map = built(file);
    EXPECT_TRUE(map.sectors[0].ceiling.sky);
    EXPECT_FALSE(map.sectors[0].floor.sky);
    EXPECT_EQ(map[map.sectors[0].ceiling.surface].tile_m, (Vec2{4, 0.75}));
}

/// Where a level look in a direction meets the sky of one room, in tiles.
double sky_met(int format, Vec2 wraps, double turns) {
    MapFile file = one_room();
    file.format = format;
    file.sectors[0].ceiling.parallax = true;
    file.sectors[0].ceiling.texture = TextureSpec{"sky", wraps, {}, {}};
    const Map map = built(file);
    const Surface sky = map[map.sectors[0].ceiling.surface];
    const double tiles = turns * sky.tile_m.x - sky.offset_tiles.x;  // map/map.h
    return tiles - std::floor(tiles);
}

TEST(Flat, TurnsTheTutorialsSkyAQuarterOn) {
    for (const double turns : {0.0, 0.125, 0.5, 0.8125}) {
        EXPECT_EQ(sky_met(1, {1, 1}, turns), turns);
        EXPECT_EQ(sky_met(0, {1, 1}, turns), turns < 0.75 ? turns + 0.25 : turns - 0.75);
    }
}

TEST(Flat, TakesTheTutorialsSkyForTurnsPerTile) {
    EXPECT_EQ(sky_met(1, {4, 1}, 0.0625), 0.25);
    EXPECT_EQ(sky_met(0, {0.25, 1}, 0.0625), 0.25);  // four tiles a turn, of which one is the quarter
    EXPECT_EQ(sky_met(0, {2, 1}, 0.25), 0.25);       // half a tile a turn
    EXPECT_EQ(sky_met(0, {-1, 1}, 0.125), 0.625);    // mirrored: -(0.125 + 0.25)
}

TEST(Flat, HasTheLayersOfItsOwnSky) {
    MapFile file = map_of({box_room("hall", 0, 0, 4, 4), box_room("yard", 4, 0, 8, 4)});
    for (SectorRecord& sector : file.sectors) sector.ceiling.parallax = true;
    file.sectors[0].ceiling.layers = {{TextureSpec{"mist", Vec2{3, 0.5}, {}, {}}, 1.5, {}, {}}};
    file.sectors[1].ceiling.layers = {{TextureSpec{"mist", Vec2{3, 0.5}, {}, {}}, 0, {}, {}},
                                      {TextureSpec{"clouds", Vec2{2, 0.75}, {}, {}}, -3, {}, {}}};
    const Map map = built(file);
    const Flat& sky = map.sectors[1].ceiling;
    ASSERT_EQ(sky.layer_count, 2u);
    EXPECT_EQ(map.flat_layers[sky.first_layer + 1].tile_m, (Vec2{2, 0.75}));
    EXPECT_EQ(map.flat_layers[sky.first_layer + 1].scroll, (Vec2{-3, 0}));
    EXPECT_EQ(map.sectors[0].floor.layer_count, 0u);
}

TEST(Flat, HasTheLayersOfItsOwnFloor) {
    MapFile file = map_of({box_room("hall", 0, 0, 4, 4)});
    file.size = 16;
    file.sectors[0].floor.layers = {{TextureSpec{"foam", {}, {}, {}}, 0, {1, -2}, {}},
                                    {TextureSpec{"ripples", Vec2{3, 0.5}, {}, {}}, 0, {}, {}}};
    const Map map = built(file);
    const Flat& floor = map.sectors[0].floor;
    ASSERT_EQ(floor.layer_count, 2u);
    EXPECT_EQ(map.flat_layers[floor.first_layer].scroll, (Vec2{1, -2}));
    EXPECT_EQ(map.flat_layers[floor.first_layer].tile_m, (Vec2{4, 4}));  // 64 texels, 16 to the metre
    EXPECT_EQ(map.flat_layers[floor.first_layer + 1].tile_m, (Vec2{3, 0.5}));
}

TEST(Contrast, OfSmoothLightGrowsFromWallsAlongXToWallsAlongY) {
    MapFile file = map_of({room("hall", {{0, 0}, {4, 0}, {8, 4}, {8, 8}, {4, 9}})});
    const Map map = built(file);
    EXPECT_EQ(map.walls[0].contrast, 0.8);
    EXPECT_NEAR(map.walls[1].contrast, 0.9, 1e-15);  // 45 degrees; 0.8 + 0.2 * 0.5, each rounded once
    EXPECT_EQ(map.walls[2].contrast, 1);
    EXPECT_LT(map.walls[3].contrast, map.walls[1].contrast);
}

TEST(Contrast, IsNoneInTheTutorial) {
    MapFile file = one_room();
    file.format = 0;
    for (const Wall& wall : built(file).walls) EXPECT_EQ(wall.contrast, 1);
}

TEST(Contrast, OfClassicLightDiffersOnlyExactlyAlongAnAxis) {
    MapFile file = map_of({room("hall", {{0, 0}, {4, 0}, {4 + kVertexGrid, 4}, {4 + kVertexGrid, 8}, {0, 9}})});
    file.render.light = LightModel::classic;
    const Map map = built(file);
    EXPECT_EQ(map.walls[0].contrast, 0.8);
    EXPECT_EQ(map.walls[1].contrast, 1);
    EXPECT_EQ(map.walls[2].contrast, 1.2);
}

}  // namespace
}  // namespace enfilade
