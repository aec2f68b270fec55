// The column renderer against the reference, in small maps made for what is hard: steps, windows, pillars, closed
// doors, open steps, rooms over rooms, links. (tests/hard_cases does the same for the authored maps.)
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/column/agreement.h"
#include "render/column/column_renderer.h"
#include "space/trace.h"
#include "support/furnish.h"
#include "support/trials.h"

namespace enfilade {
namespace {

using namespace test;

TEST(ColumnRenderer, AgreesWithTheReferenceInAPalace) { expect_agreement(TexturedMap(palace()), 1, 400); }

// hard case W3
TEST(ColumnRenderer, AgreesWithTheReferenceWhereStepsAreOpen) {
    MapFile file = palace();
    for (SectorRecord& s : file.sectors)
        for (WallRecord& w : s.loops[0].walls)
            if (!w.next.empty()) w.texture.reset();
    expect_agreement(TexturedMap(file), 2, 200);
}

TEST(ColumnRenderer, AgreesWithTheReferenceThroughFencesAndColouredGlass) {
    MapFile file = palace();
    int count = 0;
    for (SectorRecord& s : file.sectors)
        for (WallRecord& w : s.loops[0].walls)
            if (!w.next.empty()) {
                w.middle = spec("lattice");
                w.middle->offset_tx = {5.0 * count, 7.0 * (count % 9) - 20};
                w.middle_peg = static_cast<Peg>(count++ % 4);
            }
    TexturedMap world(file);
    world.textures.textures[world.textures.find("lattice").index] = lattice();
    expect_agreement(world, 3, 200);
}

TEST(ColumnRenderer, AgreesWithTheReferenceInFog) {
    MapFile file = palace();
    for (SectorRecord& s : file.sectors)
        for (WallRecord& w : s.loops[0].walls)
            if (!w.next.empty()) {
                w.middle = spec("lattice");
                w.middle->offset_tx = {3, 5};
            }
    file.render.fog_color = 0x4080C0;
    file.render.fog_reach = 3;
    for (const std::uint32_t fog_step : {1u, 8u}) {
        file.render.fog_step = fog_step;
        TexturedMap world(file);
        world.textures.textures[world.textures.find("lattice").index] = lattice();
        expect_agreement(world, 7, 100);
    }
}

/// Pictures that scroll and follow one another, lights that change, a sky that turns.
MapFile restless_palace() {
    MapFile file = palace();
    for (SectorRecord& s : file.sectors) {
        s.floor.scroll = {0.7, -1.3};
        s.ceiling.scroll = {-2.1, 0.4};
        s.light_effect = LightEffectRecord{};
        for (LoopRecord& loop : s.loops)
            for (WallRecord& w : loop.walls) w.scroll = {1.1, -0.9};
    }
    file.animations = {{{"wall", "floor", "ceiling"}, 0.3, {}}};
    return file;
}

TEST(ColumnRenderer, AgreesWithTheReferenceWhateverMoves) {
    TexturedMap world(restless_palace());
    for (const double time_s : {0.0, 1.25, 17.3, 86'400.7}) {
        world.snapshot.time_s = time_s;
        for (SectorSnapshot& sector : world.snapshot.sectors) sector.ceiling_z += 0.0625;
        expect_agreement(world, 8, 60);
    }
}

TEST(ColumnRenderer, AgreesWithTheReferenceUnderSkiesWithLayers) {
    MapFile file = palace();
    sector(file, "yard").ceiling.scroll = {1.7, 0};
    sector(file, "yard").ceiling.layers = {{TextureSpec{"lattice", Vec2{3, 0.7}, {3.3, 1.7}, {}}, 2.3, {}, {}},
                                           {TextureSpec{"lattice", Vec2{-2, 1.3}, {9.1, -4.7}, {}}, -5.9, {}, {}}};
    TexturedMap world(file);
    world.textures.textures[world.textures.find("lattice").index] = lattice();
    world.snapshot.time_s = 17.3;
    expect_agreement(world, 9, 100);
}

/// Layers over every floor and ceiling but skies, each with a way of its own.
void lay_layers(MapFile& file, const char* picture) {
    for (SectorRecord& s : file.sectors) {
        s.floor.scroll = {0.7, -1.3};
        s.floor.layers = {{TextureSpec{picture, Vec2{1.7, 2.3}, {3.3, 1.7}, {}}, 0, {-0.9, 0.4}, {}},
                          {TextureSpec{picture, Vec2{0.6, 0.6}, {}, {}}, 0, {0.3, 0.8}, {}}};
        if (!s.ceiling.parallax)
            s.ceiling.layers = {{TextureSpec{picture, Vec2{-2, 1}, {9.1, -4.7}, {}}, 0, {2, 1}, {}}};
    }
}

TEST(ColumnRenderer, AgreesWithTheReferenceOnFlatsWithLayers) {
    for (const LightModel model : {LightModel::smooth, LightModel::classic})
        for (const bool is_by_table : {false, true})
            for (const double fog_reach : {0.0, 6.0}) {
                MapFile file = palace();
                file.render.light = model;
                file.render.fog_reach = fog_reach;
                lay_layers(file, "lattice");
                TexturedMap world(file);
                if (is_by_table) paint_by_table(world.textures);
                world.textures.textures[world.textures.find("lattice").index] = lattice();
                world.snapshot.time_s = 17.3;
                expect_agreement(world, 9, 40);
            }
}

TEST(ColumnRenderer, AgreesWithTheReferenceUnderASkyWithStraightRows) {
    MapFile file = palace();
    file.render.sky = SkyRows::straight;
    sector(file, "yard").ceiling.layers = {{TextureSpec{"haze", Vec2{3, 0.7}, {3.3, 1.7}, {}}, 2.3, {}, {}}};
    expect_agreement(TexturedMap(file), 10, 100);
}

/// The least and the greatest v that row 0, all sky, shows from the middle of the yard, looking askew.
std::pair<double, double> range_of_sky_in_row_0(SkyRows rows) {
    MapFile file = palace();
    file.render.sky = rows;
    sector(file, "yard").ceiling.texture->tile_m = Vec2{1, 4};
    const TexturedMap world(file);
    View view;
    view.sector = locate(world.map, {20, 6});
    view.eye = {20, 6};
    view.eye_z = 6.75;
    view.forward = direction(Angle::from_degrees(33));
    view.pitch_tangent = 1;
    Frame frame;
    frame.resize(160, 100);
    FrameFacts facts;
    reset(facts, 160, 100);
    ColumnRenderer(world.map, world.textures).render(frame, &facts, world.snapshot, view);
    std::pair<double, double> range{1, 0};
    for (std::size_t x = 0; x < 160; ++x) {
        EXPECT_EQ(facts.depths[x], std::numeric_limits<double>::infinity());
        range = {std::min(range.first, facts.texels[x].v), std::max(range.second, facts.texels[x].v)};
    }
    return range;
}

TEST(ColumnRenderer, ShowsARowOfASkyWithStraightRowsInARow) {
    const auto straight = range_of_sky_in_row_0(SkyRows::straight), round = range_of_sky_in_row_0(SkyRows::round);
    EXPECT_EQ(straight.first, straight.second);
    EXPECT_LT(round.first, round.second);
}

/// Rooms of half light with lamps, things, panels and fences.
MapFile lit_palace() {
    MapFile file = palace();
    for (SectorRecord& s : file.sectors) s.light = 0.4;
    scatter_lights(file, 12, 10);
    scatter_panels(file, 20, 11);
    scatter_things(file, 10, 12);
    for (SectorRecord& s : file.sectors)
        for (WallRecord& w : s.loops[0].walls)
            if (!w.next.empty()) w.middle = spec("lattice");
    return file;
}

TexturedMap lit_world(const MapFile& file) {
    TexturedMap world(file);
    world.textures.textures[world.textures.find("lattice").index] = lattice();
    world.snapshot.time_s = 3.21;
    return world;
}

TEST(ColumnRenderer, AgreesWithTheReferenceInTheLightOfLamps) { expect_agreement(lit_world(lit_palace()), 11, 20); }

TEST(ColumnRenderer, AgreesWithTheReferenceInTheLightOfLampsInFog) {
    MapFile file = lit_palace();
    file.render.fog_reach = 6;
    file.render.light = LightModel::classic;
    expect_agreement(lit_world(file), 11, 20);
}

TEST(ColumnRenderer, AgreesWithTheReferenceWhereColorsAreLookedUp) {
    for (const LightModel model : {LightModel::classic, LightModel::smooth})
        for (const double fog_reach : {0.0, 6.0}) {
            MapFile dark = palace(), lamps = lit_palace();
            dark.render.light = lamps.render.light = model;
            dark.render.fog_reach = lamps.render.fog_reach = fog_reach;
            for (SectorRecord& s : dark.sectors) s.light = 0.6;
            MapFile alive = lamps;
            enliven(alive);
            for (const MapFile& file : {dark, lamps, alive}) {
                TexturedMap world(file);
                world.snapshot.time_s = 3.21;
                if (const TextureId found = world.textures.find("lattice"))
                    world.textures.textures[found.index] = lattice();
                paint_by_table(world.textures);
                expect_agreement(world, 15, 10);
            }
        }
}

TEST(ColumnRenderer, AgreesWithTheReferenceWhereEverythingMovesAndShinesByItself) {
    for (const LightModel model : {LightModel::smooth, LightModel::classic}) {
        MapFile file = lit_palace();
        enliven(file);
        file.render.light = model;
        TexturedMap world = lit_world(file);
        for (const double time_s : {0.0, 3.21, 1000.7}) {
            world.snapshot.time_s = time_s;
            expect_agreement(world, 11, 20);
        }
    }
}

TEST(ColumnRenderer, DrawsStripsOfLampsThatEqualTheWholePicture) {
    expect_strips_equal_the_whole(lit_world(lit_palace()), 12, 5);
}

TEST(ColumnRenderer, AllocatesNothingOnceItHasDrawnTheLampsInView) {
    expect_no_allocations(lit_world(lit_palace()), 13, 5);
}

TEST(ColumnRenderer, DrawsTheSameBitsWhereLampsReachNothingInView) {
    MapFile file = palace();
    const TexturedMap dark(file);
    file.sectors.push_back(box_room("far", 900, 900, 904, 904));
    PointLightRecord light;
    light.position = {902, 902};
    light.z = 1;
    file.lights = {light};
    const TexturedMap lit(file);
    Random random(14);
    Frame a, b;
    a.resize(160, 100);
    b.resize(160, 100);
    for (int trial = 0; trial < 5; ++trial) {
        const View view = random_view(dark.map, random);
        ColumnRenderer(dark.map, dark.textures).render(a, nullptr, dark.snapshot, view);
        ColumnRenderer(lit.map, lit.textures).render(b, nullptr, lit.snapshot, view);
        ASSERT_EQ(a.pixels, b.pixels) << "trial " << trial;
    }
}

// hard case I8
TEST(ColumnRenderer, DrawsStripsThatEqualTheWholePicture) {
    expect_strips_equal_the_whole(TexturedMap(palace()), 5, 40);
}

TEST(ColumnRenderer, AllocatesNothingOnceItHasDrawnTheView) { expect_no_allocations(TexturedMap(palace()), 7, 20); }

// Every pixel of a frame belongs to one chain of viewports: the eye's own, then one more for each portal looked
// through. So windows only ever shrink, and no two chains share a pixel.
// hard case I3
TEST(ColumnRenderer, SeesEachPixelThroughOneChainOfEverDeeperViewports) {
    const TexturedMap world(palace());
    Random random(8);
    ColumnRenderer renderer(world.map, world.textures);
    Frame frame;
    frame.resize(96, 60);
    for (int trial = 0; trial < 100; ++trial) {
        renderer.render(frame, nullptr, world.snapshot, random_view(world.map, random));
        std::vector<std::vector<const ViewportOutline*>> chains(96 * 60);
        const std::vector<ViewportOutline> viewports = renderer.viewports();
        for (const ViewportOutline& v : viewports)
            for (int x = v.begin; x < v.end; ++x)
                for (int y = v.top[x - v.begin]; y < v.bottom[x - v.begin]; ++y) chains[y * 96 + x].push_back(&v);
        for (std::size_t i = 0; i < chains.size(); ++i) {
            auto& chain = chains[i];
            std::sort(chain.begin(), chain.end(), [](auto* a, auto* b) { return a->depth < b->depth; });
            for (std::size_t k = 0; k < chain.size(); ++k) ASSERT_EQ(chain[k]->depth, int(k)) << "pixel " << i;
        }
    }
}

// Behind a portal everything is farther than the portal; 2^-40 is what rounding may take from that.
// hard case I5
TEST(ColumnRenderer, NeverMovesABoundaryNearerAlongAChain) {
    const TexturedMap world(palace());
    Random random(9);
    ColumnRenderer renderer(world.map, world.textures);
    Frame frame;
    frame.resize(96, 60);
    FrameFacts facts;
    reset(facts, 96, 60);
    count_trials(100 * 96 * 60, "pixels");
    for (int trial = 0; trial < 100; ++trial) {
        renderer.render(frame, &facts, world.snapshot, random_view(world.map, random));
        std::vector<double> boundary(96 * 60, std::numeric_limits<double>::infinity());
        std::vector<ViewportOutline> viewports = renderer.viewports();
        std::stable_sort(viewports.begin(), viewports.end(), [](auto& a, auto& b) { return a.depth < b.depth; });
        for (const ViewportOutline& v : viewports)
            for (int x = v.begin; x < v.end; ++x)
                for (int y = v.top[x - v.begin]; y < v.bottom[x - v.begin]; ++y) {
                    ASSERT_LE(v.boundary[x - v.begin], boundary[y * 96 + x] * (1 + 0x1p-40));
                    boundary[y * 96 + x] = v.boundary[x - v.begin];
                }
        for (std::size_t i = 0; i < boundary.size(); ++i)
            if (facts.ids[i] != kRecursionEnd && std::isfinite(boundary[i])) {
                ASSERT_LE(1 / facts.depths[i], boundary[i] * (1 + 0x1p-40));
            }
    }
}

}  // namespace
}  // namespace enfilade
