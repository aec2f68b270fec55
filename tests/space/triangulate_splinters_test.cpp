// A hundred thousand sectors of every shape that a map may have, as triangles. ENFILADE_LONG=1: a million.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <vector>

#include "math/predicates.h"
#include "space/mosaic.h"
#include "space/triangle_faults.h"
#include "space/triangulate.h"

namespace enfilade {
namespace {

using namespace test;

const std::size_t kSectors = std::getenv("ENFILADE_LONG") ? 1'000'000 : 100'000;

/// Small ones for variety, from one where most points are on a line with others to one as wide as the world; some
/// large, for rows of holes, and some for fans.
SplinterPlan plan_of(std::uint64_t seed) {
    constexpr double kSizes[] = {0x1p-6, 1, 8, 65000};
    SplinterPlan plan{.size = kSizes[seed % 4],
                      .points = 8 + static_cast<int>(seed % 16),
                      .labels = 2 + static_cast<int>(seed / 3 % 4),
                      .solid = static_cast<double>(seed % 5) * 0.1,
                      .loops = {.is_tangled = seed % 3 == 0, .slits = seed % 9 == 0 ? 0.1 : 0}};
    if (seed % 100 == 0) plan.size = 1000, plan.points = 300, plan.labels = 2;
    if (seed % 100 == 50) plan.size = 1000, plan.points = 250, plan.rim = 1, plan.labels = 2;
    return plan;
}

/// How many sectors, or vertices, of each kind there were.
struct Kinds {
    int single_loops = 0, outlines_apart = 0;               ///< sectors
    int touched_once = 0, touched_often = 0;                ///< holes, and an outline that touches them
    int holes_touch_once = 0, holes_touch_often = 0;        ///< pairs
    int outlines_touch_once = 0, outlines_touch_often = 0;  ///< pairs
    int loops_touch_themselves = 0, back_to_back = 0;       ///< vertices, walls
    int fans_of_8 = 0, fans_of_20 = 0;                      ///< vertices where so many walls start
};

/// Looks at the loops of a sector.
class Census {
public:
    Census(const Map& map, const Sector& sector, Kinds& kinds) : map_(map), kinds_(kinds) {
        std::vector<char> seen(sector.wall_count, 0);
        for (std::uint32_t i = 0; i < sector.wall_count; ++i)
            if (!seen[i]) add_loop(WallId(sector.first_wall + i), sector.first_wall, seen);
    }

    void take() {
        const auto outlines = std::count(is_outline_.begin(), is_outline_.end(), true);
        kinds_.single_loops += is_outline_.size() == 1;
        std::map<std::pair<std::size_t, std::size_t>, int> touches;
        for (const auto& [place, loops] : loops_at_) {
            kinds_.fans_of_8 += loops.size() >= 8;
            kinds_.fans_of_20 += loops.size() >= 20;
            for (std::size_t i = 0; i < loops.size(); ++i)
                for (std::size_t k = 0; k < i; ++k) ++touches[std::minmax(loops[i], loops[k])];
        }
        kinds_.outlines_apart += outlines > 1 && touches.empty();
        for (const auto& [pair, count] : touches) take_pair(pair.first, pair.second, count);
        for (const auto& [ends, count] : walls_between_) kinds_.back_to_back += count == 2;
    }

private:
    using Place = std::pair<double, double>;

    void add_loop(WallId first, std::uint32_t first_of_sector, std::vector<char>& seen) {
        double area = 0;  // its sign only; rounded where the world is wide, but for no loop of a few steps
        WallId id = first;
        do {
            const Wall& wall = map_[id];
            seen[id.index - first_of_sector] = 1;
            area += cross(wall.a - map_[first].a, wall.b - map_[first].a);
            const Place a(wall.a.x, wall.a.y), b(wall.b.x, wall.b.y);
            loops_at_[a].push_back(is_outline_.size());
            ++walls_between_[std::minmax(a, b)];
            id = wall.next;
        } while (id != first);
        is_outline_.push_back(area > 0);
    }

    void take_pair(std::size_t one, std::size_t other, int count) {
        if (one == other)
            kinds_.loops_touch_themselves += count;
        else if (is_outline_[one] && is_outline_[other])
            ++(count == 1 ? kinds_.outlines_touch_once : kinds_.outlines_touch_often);
        else if (is_outline_[one] || is_outline_[other])
            ++(count == 1 ? kinds_.touched_once : kinds_.touched_often);
        else
            ++(count == 1 ? kinds_.holes_touch_once : kinds_.holes_touch_often);
    }

    const Map& map_;
    Kinds& kinds_;
    std::vector<char> is_outline_;  ///< by loop
    std::map<Place, std::vector<std::size_t>> loops_at_;
    std::map<std::pair<Place, Place>, int> walls_between_;
};

// hard case R17
TEST(TriangulateSplinters, CoversEverySectorOnce) {
    std::size_t sectors = 0;
    for (std::uint64_t seed = 0; sectors < kSectors; ++seed) {
        const Map map = lay_splinters(plan_of(seed), seed).map;
        for (std::size_t i = 0; i < map.sectors.size(); ++i, ++sectors) {
            const std::string fault = triangle_fault(map, SectorId(i), triangulate(map, SectorId(i)));
            ASSERT_EQ(fault, "") << "seed " << seed << ", sector " << i;
        }
    }
}

// hard case T8
TEST(TriangulateSplinters, FormTilings) {
    for (std::uint64_t seed = 0; seed < 1000; ++seed) {
        const Map map = lay_splinters(plan_of(seed), seed).map;
        const Tiling tiling(map);
        for (std::uint32_t edge = 0; edge < 3 * tiling.tile_count(); ++edge) {
            if (tiling.wall(edge)) continue;
            ASSERT_EQ(tiling.across(tiling.across(edge)), edge) << seed;
        }
    }
}

/// What the two tests above are worth.
TEST(TriangulateSplinters, AreOfEveryKind) {
    Kinds kinds;
    for (std::uint64_t seed = 0; seed < 1000; ++seed) {
        const Map map = lay_splinters(plan_of(seed), seed).map;
        for (const Sector& sector : map.sectors) Census(map, sector, kinds).take();
    }
    constexpr int kMany = 10;
    EXPECT_GE(kinds.single_loops, kMany);
    EXPECT_GE(kinds.outlines_apart, kMany);
    EXPECT_GE(kinds.touched_once, kMany);
    EXPECT_GE(kinds.touched_often, kMany);
    EXPECT_GE(kinds.holes_touch_once, kMany);
    EXPECT_GE(kinds.holes_touch_often, kMany);
    EXPECT_GE(kinds.outlines_touch_once, kMany);
    EXPECT_GE(kinds.outlines_touch_often, kMany);
    EXPECT_GE(kinds.loops_touch_themselves, kMany);
    EXPECT_GE(kinds.back_to_back, kMany);
    EXPECT_GE(kinds.fans_of_8, kMany);
    EXPECT_GE(kinds.fans_of_20, kMany);
}

}  // namespace
}  // namespace enfilade
