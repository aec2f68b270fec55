// What a map calls for.
#include "app/effects.h"

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
    EXPECT_THAT(effects_in(file), ElementsAre(Field(&EffectUse::name, "sky"), Field(&EffectUse::count, 2u),
                                              Field(&EffectUse::count, 3u)));
}

TEST(EffectsIn, DoesNotCountAMiddleThatIsNoTexture) {
    MapFile file = test::map_of({test::box_room("main", 0, 0, 4, 4)});
    file.sectors[0].loops[0].walls[0].middle = test::spec("-");
    EXPECT_TRUE(effects_in(file).empty());
}

}  // namespace
}  // namespace enfilade
