// The first picture of every map that ships: players start on round coordinates, where rays pass through vertices.
#include <gtest/gtest.h>

#include "hard_cases/comparison.h"
#include "ties/tie_worlds.h"

namespace enfilade::test {
namespace {

// hard cases R2, I1
TEST(StartViews, OfShippedMapsAreThoseOfTheReference) {
    const TieWorlds worlds;
    for (const TieWorld& world : worlds.shipped()) {
        const Comparison sum = compare_at_start({world.name, world.map, world.textures}, {320, 200});
        EXPECT_TRUE(sum.is_faultless()) << world.name << ": " << describe(sum);
    }
}

}  // namespace
}  // namespace enfilade::test
