// Views aimed at ties: both renderers say the same of every pixel, and what whole numbers say of the rays.
// ENFILADE_SEED=N begins elsewhere, ENFILADE_VIEWS=N tries so many.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "support/map_builder.h"
#include "ties/tie_search.h"

namespace enfilade::test {
namespace {

std::uint64_t number_given(const char* name, std::uint64_t usual) {
    const char* given = std::getenv(name);
    return given ? std::strtoull(given, nullptr, 10) : usual;
}

// hard cases R2, R4, R5, R6, R7, R26, I1
TEST(ViewsAimedAtTies, ShowWhatWholeNumbersSayByBothRenderers) {
    const TieWorlds worlds;
    const TieCounts counts =
        search_ties(worlds, number_given("ENFILADE_SEED", 1), number_given("ENFILADE_VIEWS", 10'000));
    std::printf("%s", describe(counts).c_str());
    EXPECT_TRUE(counts.is_faultless());
    EXPECT_GE(counts.rays, counts.views);
    EXPECT_LE(counts.lost, counts.rays / 50);  // else the judge says little
}

// hard case R6: the ray of one column runs within 2^-40 of -x, but not along it
TEST(EyeOnAVertex, SeesByARayAlmostAlongAnAxisWhatWholeNumbersSay) {
    const MapFile file = map_of({room("room", {{0, 0}, {8, -2}, {8, 6}, {-3, 4}})});
    Map map = built(file);
    Snapshot snapshot = at_rest(map);
    const TieWorld world{"room", std::move(map), textures_for(file), std::move(snapshot)};
    TieCounts counts;
    for (const double aside : {0x1p-41, -0x1p-41, 0x1p-50, -0x1p-50})
        for (const Vec2 way : {Vec2{-1, aside}, Vec2{1, aside}, Vec2{aside, -1}, Vec2{aside, 1}}) {
            TiedView tied{{}, {64, 8}, 29};
            tied.view.sector = SectorId(0u);
            tied.view.eye_z = 1;
            const double slope = Projection(tied.view, 64, 8).slope(tied.column);
            tied.view.forward = (way - right_of(way) * slope) * (1 / std::sqrt(1 + slope * slope));
            search_view(world, true, tied, "", counts);
        }
    EXPECT_TRUE(counts.is_faultless()) << describe(counts);
}

}  // namespace
}  // namespace enfilade::test
