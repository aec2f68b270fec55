// Pictures drawn by dials: what is promised, and that nobody can tell how they were cut.
#include "formats/dials.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "render/column/agreement.h"
#include "render/column/scene.h"
#include "render/column/texel_dials.h"

namespace enfilade {
namespace {

using test::palace;
using test::random_view;
using test::TexturedMap;

constexpr int kWidth = 211, kHeight = 97;

struct Drawn {
    Frame frame;
    FrameFacts facts;
};

Drawn draw(const TexturedMap& world, const View& view, const Dials& dials, std::size_t threads = 1) {
    Drawn drawn;
    drawn.frame.resize(kWidth, kHeight);
    reset(drawn.facts, kWidth, kHeight);
    ColumnStrips(world.map, world.textures, threads, dials).render(drawn.frame, &drawn.facts, world.snapshot, view);
    return drawn;
}

Dials with(const std::string& dial) {
    Dials dials;
    EXPECT_TRUE(set_dial(dials, dial).ok()) << dial;
    return dials;
}

Dials promising(double texels) {
    Dials dials;
    dials.texel_error = texels;
    return dials;
}

/// One of each, and some together.
std::vector<Dials> some_dials() {
    std::vector<Dials> all{promising(1e-6),      promising(0.1),       promising(1),
                           promising(8),         with("span=16"),      with("span=3"),
                           with("number=float"), with("number=fixed"), with("number=vanilla")};
    for (const char* sampling : {"sampling=mip", "sampling=bilinear", "sampling=trilinear"}) {
        all.push_back(with(sampling));
        Dials mixed = with(sampling);
        mixed.texel_error = 2;
        all.push_back(mixed);
        mixed = with(sampling);
        mixed.span = 8;
        mixed.number = NumberKind::real32;
        all.push_back(mixed);
        mixed = with(sampling);
        mixed.number = NumberKind::vanilla;
        all.push_back(mixed);
    }
    return all;
}

/// Between two places on a tile, the shorter way round [tiles].
double apart(double a, double b) {
    const double distance = std::fabs(a - b);
    return std::min(distance, 1 - distance);
}

/// The largest error in texels: pictures are 64 x 64, and texels of the sky are not counted.
double largest_error(const Drawn& exact, const Drawn& drawn) {
    double largest = 0;
    for (std::size_t i = 0; i < exact.facts.ids.size(); ++i) {
        if (std::isinf(exact.facts.depths[i])) continue;
        const TexelPosition &a = exact.facts.texels[i], &b = drawn.facts.texels[i];
        largest = std::max({largest, 64 * apart(a.u, b.u), 64 * apart(a.v, b.v)});
    }
    return largest;
}

/// With lamps, fog and layers everywhere, too.
std::vector<TexturedMap> worlds() {
    std::vector<TexturedMap> all;
    all.emplace_back(palace());
    MapFile lit = palace();
    PointLightRecord lamp;
    lamp.sector = "hall";
    lamp.position = {2, 2};
    lamp.z = 3;
    lit.lights.push_back(lamp);
    lit.render.fog_color = 0x8090A0;
    lit.render.fog_reach = 20;
    all.emplace_back(lit);
    return all;
}

TEST(ColumnDials, LeaveEverySurfaceWhereItIsAndDrawEachPixelOnce) {
    for (const TexturedMap& world : worlds()) {
        Random random(3);
        for (int trial = 0; trial < 10; ++trial) {
            const View view = random_view(world.map, random);
            const Drawn exact = draw(world, view, {});
            for (const Dials& dials : some_dials()) {
                const Drawn drawn = draw(world, view, dials);
                ASSERT_EQ(drawn.facts.ids, exact.facts.ids) << to_text(dials);
                ASSERT_EQ(drawn.facts.depths, exact.facts.depths) << to_text(dials);
                ASSERT_EQ(drawn.facts.writes, exact.facts.writes) << to_text(dials);
            }
        }
    }
}

TEST(ColumnDials, KeepWhatTheyPromise) {
    std::size_t used = 0;
    for (const TexturedMap& world : worlds()) {
        Random random(4);
        for (int trial = 0; trial < 20; ++trial) {
            const View view = random_view(world.map, random);
            const Drawn exact = draw(world, view, {});
            for (const double promise : {1e-6, 1e-3, 0.05, 0.25, 1.0, 4.0}) {
                const double error = largest_error(exact, draw(world, view, promising(promise)));
                ASSERT_LE(error, promise * (1 + 1e-9));
                used += error > promise / 4;
            }
        }
    }
    EXPECT_GT(used, 50u);  // of 240: the promise is made use of
}

TEST(ColumnDials, DrawTheColorsOfTheTexelsTheyTellOf) {
    const TexturedMap world(palace());
    Random random(5);
    std::size_t looked_at = 0;
    for (int trial = 0; trial < 6; ++trial) {
        View view = random_view(world.map, random);
        const Drawn exact = draw(world, view, {});
        for (const Dials& dials :
             {promising(1), promising(8), with("span=16"), with("number=fixed"), with("number=vanilla")}) {
            const Drawn drawn = draw(world, view, dials);
            for (std::size_t i = 0; i < drawn.facts.ids.size(); ++i) {
                if (std::isinf(drawn.facts.depths[i])) continue;
                const TexelPosition &a = exact.facts.texels[i], &b = drawn.facts.texels[i];
                const auto texel = [](double tiles) { return texel_of(place_on_tile(tiles), 64); };
                if (texel(a.u) != texel(b.u) || texel(a.v) != texel(b.v)) continue;
                // Within a group the light is one, so the same texel has the same colour.
                ASSERT_EQ(drawn.frame.pixels[i], exact.frame.pixels[i]) << to_text(dials) << ", pixel " << i;
                ++looked_at;
            }
        }
    }
    EXPECT_GT(looked_at, 100'000u);
}

TEST(ColumnDials, DrawTheSamePictureInAnyStrips) {
    for (const TexturedMap& world : worlds()) {
        Random random(6);
        for (int trial = 0; trial < 6; ++trial) {
            const View view = random_view(world.map, random);
            for (const Dials& dials : some_dials()) {
                const Drawn one = draw(world, view, dials);
                for (const std::size_t threads : {2u, 3u, 8u})
                    ASSERT_EQ(draw(world, view, dials, threads).frame.pixels, one.frame.pixels)
                        << to_text(dials) << ", " << threads << " threads";
            }
        }
    }
}

// A column of the palace is 0.0095 m wide at 1 m, of which a metre has 64 texels or more.
TEST(ColumnDials, SpendNothingOnAPromiseTooNarrowToBeUsed) {
    const TexturedMap world(palace());
    Random random(8);
    const View view = random_view(world.map, random);
    column::RayTables screen;
    screen.set(Projection(view, kWidth, kHeight));
    const auto is_narrow = [&](const Dials& dials) {
        const double least = column::least_texels_per_m(world.map, world.textures);
        return column::is_promise_too_narrow({dials, nullptr, least}, screen);
    };
    EXPECT_TRUE(is_narrow(promising(1e-6)));
    EXPECT_TRUE(is_narrow(promising(0.1)));
    EXPECT_FALSE(is_narrow(promising(0.5)));
    EXPECT_FALSE(is_narrow(with("span=2")));
}

// The first column of a strip may be like the last one of the strip before, which nobody draws in that strip.
TEST(ColumnDials, DrawTheSamePictureColumnByColumn) {
    const TexturedMap world(palace());
    Random random(7);
    for (int trial = 0; trial < 12; ++trial) {
        const View view = random_view(world.map, random);
        const Dials dials = promising(random.uniform(0.05, 1));
        const column::TexelDials texels{dials, nullptr, column::least_texels_per_m(world.map, world.textures)};
        LightGrids lights(world.map);
        ColumnRenderer renderer(world.map, world.textures, {lights, &texels});
        const Drawn whole = draw(world, view, dials);
        Frame one;
        one.resize(kWidth, kHeight);
        for (int x = 0; x < kWidth; ++x) renderer.render_columns(one, nullptr, world.snapshot, view, {x, x + 1});
        ASSERT_EQ(one.pixels, whole.frame.pixels) << to_text(dials);
    }
}

// Paul Heckbert and Henry Moreton, "Interpolation for Polygon Texture Mapping and Shading", 1991: between two places
// with depths of the ratio r, a straight line is off by at most tanh(|ln r| / 4) of the way between them.
TEST(ColumnDials, AreOffInSpansByWhatPerspectiveIs) {
    MapFile file = test::map_of({test::box_room("hall", 0, 0, 60, 4, 0, 3)});
    const TexturedMap world(file);
    View view;
    view.sector = SectorId(0u);
    view.eye = {1, 2};
    view.eye_z = 1.5;
    const Drawn exact = draw(world, view, {}), drawn = draw(world, view, with("span=16"));
    const int row = kHeight / 2;  // the wall on the left: its columns go away from the eye
    double worst = 0, expected = 0;
    for (int x = 16; x + 16 < 90; x += 16) {
        const auto at = [&](int column) { return static_cast<std::size_t>(row * kWidth + column); };
        const double near = exact.facts.depths[at(x)], far = exact.facts.depths[at(x + 16)];
        const double way = far - near;  // along the wall, which the eye looks along [m], and a tile is 1 m
        expected = std::max(expected, 64 * way * std::tanh(std::log(far / near) / 4));
        for (int column = x; column < x + 16; ++column)
            worst = std::max(worst, 64 * apart(exact.facts.texels[at(column)].u, drawn.facts.texels[at(column)].u));
    }
    ASSERT_GT(expected, 1);
    EXPECT_NEAR(worst / expected, 1, 0.03);
}

TEST(In16And16, TakesTheNearestStep) {
    EXPECT_EQ(column::in_16_16(1.0 / 3), std::round(65536 / 3.0) / 65536);
    EXPECT_EQ(column::in_16_16(-12345.678), std::round(-12345.678 * 65536) / 65536);
    EXPECT_EQ(column::in_16_16(2), 2);
}

}  // namespace
}  // namespace enfilade
