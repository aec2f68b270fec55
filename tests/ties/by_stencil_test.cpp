// Views aimed at ties by the graphics card, held against the reference: it may differ at edges, and nowhere else.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

#include "hard_cases/scenes.h"
#include "render/stencil/agreement.h"
#include "space/trace.h"
#include "support/furnish.h"
#include "support/map_builder.h"
#include "ties/tie_worlds.h"
#include "ties/tied_view.h"

namespace enfilade::test {
namespace {

constexpr int kViewsPerWorld = 8;

// hard cases R4, R6, R7, I1
TEST(ViewsAimedAtTies, AreDrawnByStencilAsByTheReference) {
    const char *given = std::getenv("ENFILADE_SEED"), *wanted = std::getenv("ENFILADE_VIEWS");
    const std::uint64_t first = given ? std::strtoull(given, nullptr, 10) : 1;
    const std::uint64_t views = wanted ? std::strtoull(wanted, nullptr, 10) : 400;
    const TieWorlds worlds;
    Agreement sum;
    for (std::uint64_t round = first; round < first + views / kViewsPerWorld; ++round)
        worlds.visit(round, [&](const TieWorld& world, bool) {
            Sight sight(world.map, world.textures);
            Random random(round);
            for (int i = 0; i < kViewsPerWorld; ++i) {
                const TiedView tied = tied_view(world.map, random);
                const Agreement found = sight.compare(tied.view, tied.size, Truth::reference);
                if (!found.first_fault.empty())
                    std::printf("seed %llu, %s: %s\n", static_cast<unsigned long long>(round), world.name.c_str(),
                                found.first_fault.c_str());
                sum += found;
            }
        });
    std::printf("%s\n", describe(sum).c_str());
    EXPECT_EQ(sum.undrawn, 0u);
    EXPECT_EQ(sum.elsewhere, 0u);
    EXPECT_EQ(sum.wrong_color, 0u);
}

/// Steeply up and down, along an axis, in one column.
Agreement compare_along_axes(Sight& sight, View view) {
    constexpr PictureSize kColumn{1, 200};
    Agreement sum;
    view.fov_degrees = 178.999;
    for (std::uint32_t quarter = 0; quarter < 4; ++quarter)
        for (const double pitch : {-0.905, 0.0, 0.905}) {
            view.forward = direction(Angle{quarter << 30});
            view.pitch_tangent = pitch;
            sum += sight.compare(view, kColumn, Truth::reference);
        }
    return sum;
}

// hard cases R6, R7
TEST(EyeOnAVertexAtAFlatsHeight, SeesByStencilWhatTheReferenceSees) {
    Agreement sum;
    for (const NamedScene& scene : {NamedScene{"SteppedRooms", stepped_rooms},
                                    {"Wheel", wheel},
                                    {"PinchedRoom", pinched_room},
                                    {"CrookedRooms", crooked_rooms},
                                    {"LinkedRooms", linked_rooms}}) {
        const MapFile file = scene.file();
        const Map map = built(file);
        const TextureSet textures = textures_for(file);
        Sight sight(map, textures);
        for (const Wall& wall : map.walls) {
            View view;
            view.eye = wall.a;
            view.sector = locate_near(map, wall.sector, wall.a);
            if (!view.sector) continue;
            view.eye_z = map[view.sector].ceiling.z;
            sum += compare_along_axes(sight, view);
            view.eye_z = map[view.sector].floor.z;
            sum += compare_along_axes(sight, view);
        }
    }
    std::printf("%s\n", describe(sum).c_str());
    EXPECT_EQ(sum.undrawn + sum.elsewhere + sum.wrong_color, 0u);
}

/// A room a millimetre high with a panel from one of its corners on, as a search found it.
MapFile low_room() {
    MapFile file = map_of({room("low",
                                {{1.890625, -0.7734375},
                                 {2.3740234375, -0.6513671875},
                                 {2.2470703125, -0.1494140625},
                                 {2.0537109375, -0.1982421875},
                                 {1.826171875, -0.4248046875},
                                 {0.990234375, -0.9638671875},
                                 {1, -1},
                                 {1.599609375, -0.84765625}},
                                1, 1.001)});
    file.sectors[0].panels = {panel({1.826171875, -0.4248046875}, {1.8330078125, -0.763671875}, 1, 1.1)};
    return file;
}

// hard cases R6, R7: the ray goes along -y past the panel's end, which is where the eye is, at the ceiling's height
TEST(EyeOnAPanelsEndAtTheCeiling, SeesByStencilWhatTheReferenceSees) {
    const MapFile file = low_room();
    const Map map = built(file);
    const TextureSet textures = textures_for(file);
    View view;
    view.sector = SectorId(0u);
    view.eye = {1.826171875, -0.4248046875};
    view.eye_z = 1.0009999999999999;
    view.forward = {0, -1};
    view.pitch_tangent = -0.905;
    view.fov_degrees = 178.999;
    const Agreement found = Sight(map, textures).compare(view, {1, 800}, Truth::reference);
    EXPECT_EQ(found.undrawn + found.at_edges + found.elsewhere, 0u) << describe(found);
}

}  // namespace
}  // namespace enfilade::test
