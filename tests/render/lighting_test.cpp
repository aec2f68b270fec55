// What light falls on a surface beside that of lamps: of rooms that are unlit.
#include "render/lighting.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/map_builder.h"

namespace enfilade {
namespace {

using namespace test;

Shade shade_of(const Map& map, double light, double contrast, double depth) {
    return shade_at(lighting_in(map, SectorId(0u), light, contrast), depth);
}

TEST(UnlitRoom, HasTheSameLightAtAnyDistanceAndInAnyDirection) {
    for (const LightModel model : {LightModel::smooth, LightModel::classic}) {
        MapFile file = map_of({box_room("room", 0, 0, 4, 4)});
        file.render.light = model;
        file.sectors[0].unlit = true;
        const Map map = built(file);
        for (const double light : {0.0, 0.3, 0.5, 1.0, 1.5})
            for (const double contrast : {0.8, 1.0, 1.2})
                for (const double depth : {0.0, 1.0, 100.0, HUGE_VAL})
                    EXPECT_EQ(shade_of(map, light, contrast, depth),
                              static_cast<Shade>(256 * std::min(light, 1.0) + 0.5))
                        << light << ' ' << depth;
    }
}

TEST(LitRoom, IsShadedAsItsMapSays) {
    for (const LightModel model : {LightModel::smooth, LightModel::classic}) {
        MapFile file = map_of({box_room("room", 0, 0, 4, 4)});
        file.render.light = model;
        const Map map = built(file);
        for (const double depth : {0.0, 1.0, 9.0, 100.0})
            EXPECT_EQ(shade_of(map, 0.4, 0.8, depth), shade_at(model, 0.4, 0.8, depth));
    }
}

}  // namespace
}  // namespace enfilade
