// What a map calls for.
#include "app/bench.h"

#include <gmock/gmock.h>

#include "support/map_builder.h"

namespace enfilade {
namespace {

using ::testing::ElementsAre;
using ::testing::Field;

TEST(EffectsIn, ListsNothingForPlainRooms) {
    EXPECT_TRUE(effects_in(test::map_of({test::box_room("main", 0, 0, 4, 4)})).empty());
}

TEST(EffectsIn, CountsWhatTheMapUses) {
    MapFile file = test::map_of({test::box_room("main", 0, 0, 4, 4)});
    file.sectors[0].ceiling.parallax = true;
    file.sectors[0].loops[0].walls[0].mirror = true;
    file.sectors[0].loops[0].walls[1].mirror = true;
    file.things.resize(3);
    EXPECT_THAT(effects_in(file),
                ElementsAre(Field(&EffectUse::count, 1u), Field(&EffectUse::count, 2u), Field(&EffectUse::count, 3u)));
    EXPECT_STREQ(effects_in(file)[0].effect->name, "sky");
}

TEST(EffectsIn, CountsAColorTable) {
    MapFile file = test::map_of({test::box_room("main", 0, 0, 4, 4)});
    file.render.color_table = "colors";
    ASSERT_EQ(effects_in(file).size(), 1u);
    EXPECT_STREQ(effects_in(file)[0].effect->name, "color table");
}

TEST(EffectsIn, DoesNotCountAMiddleThatIsNoTexture) {
    MapFile file = test::map_of({test::box_room("main", 0, 0, 4, 4)});
    file.sectors[0].loops[0].walls[0].middle = test::spec("-");
    EXPECT_TRUE(effects_in(file).empty());
}

/// A map with one of everything that can be taken out.
MapFile full_map() {
    MapFile file = test::map_of({test::box_room("main", 0, 0, 4, 4), test::box_room("yard", 4, 0, 8, 4)});
    test::join_all(file);
    file.sectors[0].ceiling.parallax = true;
    file.sectors[0].ceiling.layers = {{test::spec("clouds"), 1, {}, {}}};
    file.sectors[0].light_effect = LightEffectRecord{};
    file.sectors[0].floor.scroll = {1, 0};
    file.sectors[0].floor.bob = BobRecord{.amplitude = 0.5};
    file.sectors[0].unlit = true;
    file.sectors[0].sun = "noon";
    file.suns.emplace_back().name = "noon";
    file.sectors[0].loops[0].walls[0].mirror = true;
    test::wall(file, "main", {4, 0}, {4, 4}).middle = test::spec("fence");
    file.sectors[0].panels = {{{1, 1}, {2, 2}, 0, 1, test::spec("fence"), {}, false, false, {0, 1}, {}, {}, {}}};
    ThingRecord thing;
    thing.frames = {{"figure", 1, {}}, {"figure", 1, {}}};
    thing.turn = 90;
    file.things = {thing};
    file.animations = {{{"wall", "fence"}, 1, {}}};
    file.lights.emplace_back().position = {1, 1};
    file.lights[0].z = 1;
    file.render.fog_reach = 9;
    return file;
}

TEST(Effects, ThatAreTakenOutAreGone) {
    std::size_t taken_out = 0;
    for (const EffectUse& use : effects_in(full_map())) {
        if (!use.effect->take_out) continue;
        MapFile without = full_map();
        use.effect->take_out(without);
        const bool is_things = std::string_view(use.effect->name) == "things";
        EXPECT_TRUE(is_things || use.effect->count(without) == 0) << use.effect->name;
        ++taken_out;
    }
    EXPECT_EQ(taken_out, 16u);
}

}  // namespace
}  // namespace enfilade
