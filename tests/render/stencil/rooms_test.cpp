// Rooms, steps, skies, overlapping rooms, links and mirrors, as the column renderer draws them.
#include <gtest/gtest.h>

#include "hard_cases/scenes.h"
#include "render/stencil/agreement.h"
#include "support/furnish.h"
#include "support/looks.h"
#include "support/map_builder.h"

namespace enfilade::test {
namespace {

class StencilRooms : public testing::TestWithParam<NamedScene> {};

TEST_P(StencilRooms, LookAsInTheColumnRenderer) {
    const MapFile file = GetParam().file();
    const Map map = built(file);
    const TextureSet textures = textures_for(file);
    const Agreement agreement = Sight(map, textures).compare_poses(20, {160, 100}, 1);
    expect_agreement(agreement);
    RecordProperty("agreement", describe(agreement));
}

TEST(StencilLight, IsTheColumnRenderersInBothModels) {
    for (const LightModel model : {LightModel::smooth, LightModel::classic}) {
        MapFile file = stepped_rooms();
        file.render.light = model;
        for (std::size_t i = 0; i < file.sectors.size(); ++i) file.sectors[i].light = double(i) / 16;
        const Map map = built(file);
        const TextureSet textures = textures_for(file);
        expect_agreement(Sight(map, textures).compare_poses(10, {160, 100}, 2));
    }
}

/// Looks along an axis at a wall and a thing as far away as classic light changes by a level: all of them is on the
/// very edge.
TEST(StencilLight, IsTheColumnRenderersOnTheEdgeBetweenTwoLevels) {
    MapFile file = map_of({box_room("hall", 0, 0, 4, 32, 0, 3)});
    scatter_things(file, 1, 1);
    file.things.front().position = {2, 4};
    file.render.light = LightModel::classic;
    file.sectors[0].light = 0.6;
    const Map map = built(file);
    const TextureSet textures = textures_for(file);
    Sight sight(map, textures);
    for (const double stands_at : {0.0, 4.0})
        for (const double level : {2.0, 4.0, 5.0, 8.0, 10.0, 16.0, 20.0}) {
            const View view = look_from(map, {2, stands_at + 40 / level}, 1.5, -90);
            const Agreement agreement = sight.compare(view, {160, 100});
            expect_agreement(agreement);
            EXPECT_LT(agreement.other_texel, agreement.pixels / 100) << describe(agreement);
        }
}

TEST(StencilFog, IsTheColumnRenderers) {
    MapFile file = stepped_rooms();
    file.render.fog_color = 0x4080C0;
    file.render.fog_reach = 3;
    for (const std::uint32_t fog_step : {1u, 8u}) {
        file.render.fog_step = fog_step;
        const Map map = built(file);
        const TextureSet textures = textures_for(file);
        expect_agreement(Sight(map, textures).compare_poses(10, {160, 100}, 3));
    }
}

class StencilLamps : public testing::TestWithParam<NamedScene> {};

TEST_P(StencilLamps, ShineAsInTheColumnRenderer) {
    MapFile file = GetParam().file();
    for (SectorRecord& sector : file.sectors) sector.light = 0.4;
    scatter_lights(file, 12, 1);
    scatter_panels(file, 20, 2);
    scatter_things(file, 10, 3);
    const Map map = built(file);
    const TextureSet textures = textures_for(file);
    Sight sight(map, textures);
    sight.snapshot().time_s = 3.21;
    expect_agreement(sight.compare_poses(6, {160, 100}, 5));
}

TEST_P(StencilLamps, ShineAsInTheColumnRendererWhereEverythingMovesByItself) {
    for (const LightModel model : {LightModel::smooth, LightModel::classic}) {
        MapFile file = GetParam().file();
        scatter_lights(file, 6, 1);
        scatter_panels(file, 20, 2);
        scatter_things(file, 10, 3);
        enliven(file);
        file.render.light = model;
        const Map map = built(file);
        const TextureSet textures = textures_for(file);
        Sight sight(map, textures);
        for (const double time_s : {0.0, 3.21, 1000.7}) {
            sight.snapshot().time_s = time_s;
            expect_agreement(sight.compare_poses(4, {160, 100}, 5));
        }
    }
}

/// A picture with alpha whose neighbouring texels are alike, so that the edges between them hardly show.
Texture haze() {
    Texture texture;
    texture.name = "haze";
    texture.width = texture.height = 64;
    texture.has_holes = true;
    for (std::uint32_t x = 0; x < 64; ++x)
        for (std::uint32_t y = 0; y < 64; ++y)
            texture.pixels.push_back((x < 32 ? x : 63 - x) << 26 | (y < 32 ? y : 63 - y) << 18 | 0x40u << 8 | 0xA0u);
    return texture;
}

TEST(StencilSky, HasTheColumnRenderersLayers) {
    MapFile file = open_steps();
    for (SectorRecord& sector : file.sectors)
        sector.ceiling.layers = {{TextureSpec{"haze", Vec2{3, 0.7}, {3.3, 1.7}, {}}, 2.3, {}, {}},
                                 {TextureSpec{"haze", Vec2{-2, 1.3}, {9.1, -4.7}, {}}, -5.9, {}, {}}};
    const Map map = built(file);
    TextureSet textures = textures_for(file);
    textures.textures[textures.find("haze").index] = haze();
    Sight sight(map, textures);
    sight.snapshot().time_s = 17.3;
    expect_agreement(sight.compare_poses(10, {160, 100}, 4));
}

TEST(StencilFlats, HaveTheColumnRenderersLayers) {
    for (const bool has_lamps : {false, true})
        for (const bool is_by_table : {false, true}) {
            MapFile file = open_steps();
            file.render.light = is_by_table ? LightModel::classic : LightModel::smooth;
            file.render.fog_reach = has_lamps ? 6 : 0;
            if (has_lamps) scatter_lights(file, 6, 1);
            for (SectorRecord& sector : file.sectors) {
                sector.ceiling.parallax = false;
                sector.floor.layers = {{TextureSpec{"haze", Vec2{3, 1.7}, {3.3, 1.7}, {}}, 0, {0.9, -0.4}, {}},
                                       {TextureSpec{"haze", Vec2{-2, 1.3}, {9.1, -4.7}, {}}, 0, {}, {}}};
                sector.ceiling.layers = {{TextureSpec{"haze", Vec2{4, 4}, {}, {}}, 0, {1, 1}, {}}};
            }
            const Map map = built(file);
            TextureSet textures = textures_for(file);
            if (is_by_table) paint_by_table(textures);
            textures.textures[textures.find("haze").index] = haze();
            Sight sight(map, textures);
            sight.snapshot().time_s = 17.3;
            expect_agreement(sight.compare_poses(10, {160, 100}, 4));
        }
}

TEST(StencilLamps, AreWorkedOutAtAsManyPlacesAsTheColumnRenderers) {
    for (const int points_per_m : {1, 3, 16}) {
        MapFile file = open_steps();
        for (SectorRecord& sector : file.sectors) sector.light = 0.25;
        scatter_lights(file, 6, 1);
        const Map map = built(file);
        const TextureSet textures = textures_for(file);
        expect_agreement(Sight(map, textures, GlApi::desktop, points_per_m).compare_poses(10, {160, 100}, 6));
    }
}

TEST(StencilSky, HasTheColumnRenderersStraightRows) {
    MapFile file = open_steps();
    file.render.sky = SkyRows::straight;
    for (SectorRecord& sector : file.sectors)
        sector.ceiling.layers = {{TextureSpec{"haze", Vec2{3, 0.7}, {3.3, 1.7}, {}}, 2.3, {}, {}}};
    const Map map = built(file);
    TextureSet textures = textures_for(file);
    textures.textures[textures.find("haze").index] = haze();
    expect_agreement(Sight(map, textures).compare_poses(10, {160, 100}, 4));
}

TEST(StencilColorTable, IsTheColumnRenderers) {
    for (const bool has_lamps : {false, true})
        for (const double fog_reach : {0.0, 6.0}) {
            MapFile file = open_steps();
            file.render.light = LightModel::classic;
            file.render.fog_reach = fog_reach;
            for (std::size_t i = 0; i < file.sectors.size(); ++i) file.sectors[i].light = double(i + 1) / 8;
            if (has_lamps) scatter_lights(file, 6, 1);
            scatter_panels(file, 10, 2);
            scatter_things(file, 10, 3);
            const Map map = built(file);
            TextureSet textures = textures_for(file);
            paint_by_table(textures);
            expect_agreement(Sight(map, textures).compare_poses(10, {160, 100}, 5));
        }
}

INSTANTIATE_TEST_SUITE_P(Scenes, StencilLamps,
                         testing::Values(NamedScene{"SteppedRooms", stepped_rooms},
                                         NamedScene{"LinkedRooms", linked_rooms}, NamedScene{"Mirrors", mirrors}),
                         name_of_scene);
INSTANTIATE_TEST_SUITE_P(Plain, StencilRooms, testing::ValuesIn(plain_scenes()), name_of_scene);
INSTANTIATE_TEST_SUITE_P(Linked, StencilRooms, testing::ValuesIn(linked_scenes()), name_of_scene);

}  // namespace
}  // namespace enfilade::test
