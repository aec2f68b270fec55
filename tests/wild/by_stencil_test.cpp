// Wild worlds by the graphics card, from the same hard poses: a smaller share, since the card is a processor here.
#include <gtest/gtest.h>

#include <cstdlib>

#include "render/stencil/agreement.h"
#include "support/map_builder.h"
#include "wild/hard_poses.h"
#include "wild/worlds.h"

namespace enfilade::test {
namespace {

TEST(WildWorlds, AreDrawnByStencilAsByColumn) {
    const std::uint64_t worlds = std::getenv("ENFILADE_LONG") ? 10'000 : 24;
    const char* given = std::getenv("ENFILADE_SEED");
    const std::uint64_t first = given ? std::strtoull(given, nullptr, 10) : 1;
    Agreement all;
    for (std::uint64_t seed = first; seed < first + worlds; ++seed) {
        const MapFile file = wild_world(seed);
        const Map map = built(file);
        const TextureSet textures = textures_for(file);
        Sight sight(map, textures);
        Random random(seed);
        for (int i = 0; i < 4; ++i) {
            const HardPose pose = hard_pose(map, {80, 50}, random);
            all += sight.compare(pose.view, pose.size);
        }
        ASSERT_TRUE(all.first_fault.empty()) << "seed " << seed << ": " << describe(all);
    }
    expect_agreement(all);
}

}  // namespace
}  // namespace enfilade::test
