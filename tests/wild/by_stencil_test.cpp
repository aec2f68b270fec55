// Wild worlds by the graphics card, from the same hard poses: a smaller share, since the card is a processor here.
#include <gtest/gtest.h>

#include <cstdlib>

#include "base/files.h"
#include "formats/map_toml.h"
#include "render/stencil/agreement.h"
#include "support/map_builder.h"
#include "wild/hard_poses.h"
#include "wild/worlds.h"

namespace enfilade::test {
namespace {

/// Keeps the world, and says how to see the fault again.
std::string left_behind(const MapFile& file, std::uint64_t seed) {
    const std::string path = "fault-" + std::to_string(seed) + ".toml";
    if (const Result<void> done = write_file(path, std::string_view(write_map(file))); !done.ok())
        return "\n" + done.error().text();
    return "\nto see it: `enfilade render " + path + " --out FILE.png` with the view above, by stencil and by column";
}

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
        ASSERT_TRUE(all.first_fault.empty()) << "seed " << seed << ": " << describe(all) << left_behind(file, seed);
    }
    expect_agreement(all);
}

}  // namespace
}  // namespace enfilade::test
