// FreeDoom's sectors as triangles, and what is made of them: tiles that sound goes through, and the stencil renderer's
// pictures.
#include <gtest/gtest.h>

#include <cstdio>

#include "render/stencil/agreement.h"
#include "space/triangle_faults.h"
#include "space/triangulate.h"
#include "wadconv/freedoom/wads.h"

namespace enfilade::test {
namespace {

const int kPoses = is_long_run() ? 20 : 4;  ///< of each kind and map
const PictureSize kSize = is_long_run() ? PictureSize{320, 200} : PictureSize{80, 50};

class FreeDoomTriangles : public ::testing::TestWithParam<FreeDoomWad> {};

void expect_triangles(const std::string& name, const Map& map) {
    for (std::size_t i = 0; i < map.sectors.size(); ++i)
        EXPECT_EQ(triangle_fault(map, SectorId(i), triangulate(map, SectorId(i))), "")
            << name << ", sector " << map.sectors[i].name;
}

/// Every wall is the edge of one tile, and every other edge has a tile on each side.
void expect_tiles(const std::string& name, const Map& map) {
    const Tiling tiling(map);
    std::size_t walls = 0;
    for (std::uint32_t edge = 0; edge < 3 * tiling.tile_count(); ++edge)
        if (tiling.wall(edge))
            ++walls;
        else
            ASSERT_EQ(tiling.across(tiling.across(edge)), edge) << name;
    EXPECT_EQ(walls, map.walls.size()) << name;
}

/// One row of the table.
Agreement compare_triangles(const std::string& name, const LoadedMap& loaded, std::uint64_t seed) {
    const Agreement agreement = Sight(*loaded.map, loaded.textures).compare_poses(kPoses, kSize, seed);
    std::printf(
        "%-6s %5zu sectors as triangles, %d + %d poses by stencil: %llu pixels %3llu of another surface at edges"
        " %3llu elsewhere %3llu of a wrong colour\n",
        name.c_str(), loaded.map->sectors.size(), kPoses, kPoses, static_cast<unsigned long long>(agreement.pixels),
        static_cast<unsigned long long>(agreement.at_edges), static_cast<unsigned long long>(agreement.elsewhere),
        static_cast<unsigned long long>(agreement.wrong_color));
    EXPECT_EQ(agreement.first_fault, "") << name;
    return agreement;
}

// hard cases W14, G14, I2
TEST_P(FreeDoomTriangles, AreRightInEveryMapAndMakeTilesAndPictures) {
    if (is_missing(GetParam())) GTEST_SKIP() << kMissing;
    const ConvertedWad wad(GetParam(), Doors::open);
    ASSERT_EQ(wad.maps().size(), GetParam().maps) << wad.error();
    Agreement sum;
    for (std::size_t i = 0; i < wad.maps().size(); ++i) {
        const std::string& name = wad.maps()[i];
        const LoadedMap loaded = wad.load(name);
        ASSERT_TRUE(loaded.map) << name;
        expect_triangles(name, *loaded.map);
        expect_tiles(name, *loaded.map);
        sum += compare_triangles(name, loaded, i);
    }
    expect_agreement(sum);
}

INSTANTIATE_TEST_SUITE_P(Wads, FreeDoomTriangles, freedoom_wads(), name_of);

}  // namespace
}  // namespace enfilade::test
