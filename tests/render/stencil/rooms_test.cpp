// Rooms, steps, skies, overlapping rooms, links and mirrors, as the column renderer draws them.
#include <gtest/gtest.h>

#include "hard_cases/scenes.h"
#include "render/stencil/agreement.h"
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

std::string name_of_scene(const testing::TestParamInfo<NamedScene>& info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(Plain, StencilRooms, testing::ValuesIn(plain_scenes()), name_of_scene);
INSTANTIATE_TEST_SUITE_P(Linked, StencilRooms, testing::ValuesIn(linked_scenes()), name_of_scene);

}  // namespace
}  // namespace enfilade::test
