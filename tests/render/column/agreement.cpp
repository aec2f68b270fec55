#include "render/column/agreement.h"

#include <gtest/gtest.h>

#include <cmath>

#include "math/vec.h"
#include "render/reference/reference_renderer.h"
#include "space/trace.h"
#include "support/count_allocations.h"
#include "support/trials.h"

namespace enfilade::test {
namespace {

bool alike(std::uint32_t a, std::uint32_t b) {
    for (int shift : {0, 8, 16}) {
        const int difference = int(a >> shift & 0xFF) - int(b >> shift & 0xFF);
        if (difference > 2 || difference < -2) return false;
    }
    return true;
}

/// True where the texel position is so near a texel's edge that rounding may choose either side. The pictures are 64
/// x 64.
bool on_texel_edge(TexelPosition p) {
    constexpr double kSide = 64, kNear = 1e-6;  // [texels]
    const auto near_edge = [](double tiles) { return std::fabs(tiles * kSide - std::round(tiles * kSide)) < kNear; };
    return near_edge(p.u) || near_edge(p.v);
}

}  // namespace

MapFile palace() {
    MapFile file = map_of({
        box_room("hall", 0, 0, 8, 8, 0, 4),
        box_room("step", 8, 2, 9, 6, 0.5, 3),
        box_room("high", 9, 0, 15, 8, 1, 6),
        box_room("pit", 0, 8, 4, 12, -2, 3),
        box_room("door", 4, 8, 5, 9, 0, 0),
        box_room("vault", 4, 9, 8, 13, 0, 2.5),
        box_room("window", 15, 3, 15.5, 5, 2, 3),
        box_room("yard", 15.5, -4, 24, 12, 0, 7),
        room("nook", {{0, 0}, {0, 8}, {-4, 8}, {-3, 5}, {-5, 3}, {-3, -2}}, 0.25, 2),
    });
    cut_pillar(sector(file, "hall"), 3, 3, 4, 5);
    cut_pillar(sector(file, "yard"), 18, 1, 19, 2);
    sector(file, "yard").ceiling.parallax = true;
    sector(file, "high").light = 0.5;
    sector(file, "vault").light = 0.25;
    split_and_join(file);
    return file;
}

View random_view(const Map& map, Random& random) {
    View view;
    const Sector* sector = nullptr;
    do {
        view.sector = SectorId(random.below(map.sectors.size()));
        sector = &map[view.sector];
        view.eye = {random.uniform(sector->min.x, sector->max.x), random.uniform(sector->min.y, sector->max.y)};
        if (random.below(2) == 0) view.eye = {double(int(view.eye.x * 2)) / 2, double(int(view.eye.y * 2)) / 2};
        view.eye = snap_to_point_grid(view.eye);
    } while (!contains(map, view.sector, view.eye));
    view.eye_z = random.uniform(sector->floor.z, sector->ceiling.z);
    view.forward = direction(random.below(2) ? Angle{static_cast<std::uint32_t>(random.bits())}
                                             : Angle{static_cast<std::uint32_t>(random.below(8)) << 29});
    view.pitch_tangent = random.below(2) ? 0 : random.uniform(-1, 1);
    view.fov_degrees = random.below(2) ? 90 : random.uniform(20, 150);
    return view;
}

Comparer::Comparer(const TexturedMap& world) : world_(world), lights_(world.map), columns_(world.map, world.textures) {}

void Comparer::compare(const View& view, int width, int height, ColumnComparison& sum) {
    Frame a, b;
    FrameFacts facts_a, facts_b;
    a.resize(width, height);
    b.resize(width, height);
    reset(facts_a, width, height);
    reset(facts_b, width, height);
    columns_.render(a, &facts_a, world_.snapshot, view);
    render_reference(b, &facts_b, world_.map, world_.textures, world_.snapshot, view, {.lights = &lights_});
    count_trials(a.pixels.size(), "pixels");
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        sum.not_once += facts_a.writes[i] != 1;
        ++sum.pixels;
        const bool same_id = facts_a.ids[i] == facts_b.ids[i];
        sum.wrong_ids += !same_id;
        sum.wrong_colors += same_id && !alike(a.pixels[i], b.pixels[i]) && !on_texel_edge(facts_b.texels[i]);
    }
}

void expect_agreement(const TexturedMap& world, std::uint64_t seed, int poses) {
    Random random(seed);
    Comparer renderers(world);
    ColumnComparison sum;
    for (int trial = 0; trial < poses; ++trial) {
        const View view = random_view(world.map, random);
        const ColumnComparison before = sum;
        renderers.compare(view, 160, 100, sum);
        EXPECT_TRUE(sum.not_once == before.not_once && sum.wrong_ids == before.wrong_ids)
            << "trial " << trial << ": sector " << world.map[view.sector].name << " eye " << view.eye.x << ","
            << view.eye.y << "," << view.eye_z << " forward " << view.forward.x << "," << view.forward.y << " fov "
            << view.fov_degrees << " pitch " << view.pitch_tangent << ": " << sum.not_once - before.not_once
            << " not written once, " << sum.wrong_ids - before.wrong_ids << " wrong ids";
        if (testing::Test::HasFailure()) break;
    }
    EXPECT_EQ(sum.wrong_colors, 0u);
    std::printf("%zu pixels, %zu colours differ\n", sum.pixels, sum.wrong_colors);
}

void expect_strips_equal_the_whole(const TexturedMap& world, std::uint64_t seed, int poses) {
    Random random(seed);
    for (int trial = 0; trial < poses; ++trial) {
        const View view = random_view(world.map, random);
        const int width = 3 + static_cast<int>(random.below(200));
        Frame whole, cut, shared;
        for (Frame* frame : {&whole, &cut, &shared}) frame->resize(width, 90);
        ColumnRenderer renderer(world.map, world.textures);
        renderer.render(whole, nullptr, world.snapshot, view);
        const int x = 1 + static_cast<int>(random.below(static_cast<std::uint64_t>(width - 2)));
        for (ColumnRange range : {ColumnRange{0, x}, ColumnRange{x, x + 1}, ColumnRange{x + 1, width}})
            renderer.render_columns(cut, nullptr, world.snapshot, view, range);
        ASSERT_EQ(whole.pixels, cut.pixels) << "trial " << trial;
        ColumnStrips(world.map, world.textures, 4).render(shared, nullptr, world.snapshot, view);
        ASSERT_EQ(whole.pixels, shared.pixels) << "trial " << trial;
    }
}

void expect_no_allocations(const TexturedMap& world, std::uint64_t seed, int poses) {
    Random random(seed);
    ColumnRenderer renderer(world.map, world.textures);
    Frame frame;
    frame.resize(320, 200);
    for (int trial = 0; trial < poses; ++trial) {
        const View view = random_view(world.map, random);
        renderer.render(frame, nullptr, world.snapshot, view);
        const std::size_t before = allocations();
        renderer.render(frame, nullptr, world.snapshot, view);
        EXPECT_EQ(allocations(), before) << "trial " << trial;
    }
}

}  // namespace enfilade::test
