// Portal equivalence: a map that is cut along its portals, whose pieces are moved away and linked, looks as before.
#include <gtest/gtest.h>

#include <cstdio>

#include "hard_cases/cut_apart.h"
#include "hard_cases/poses.h"
#include "map/load.h"
#include "render/column/column_renderer.h"
#include "render/reference/reference_renderer.h"
#include "support/trials.h"

namespace enfilade::test {
namespace {

constexpr PictureSize kCutSize{200, 125};
constexpr int kCutPoses = 25, kCuts = 3;

/// A view drawn in one map, by one renderer.
struct Picture {
    Picture(const Map& map, const TextureSet& textures, const View& view, bool by_columns) {
        frame.resize(kCutSize.width, kCutSize.height);
        reset(facts, kCutSize.width, kCutSize.height);
        const Snapshot snapshot = at_rest(map);
        if (by_columns)
            ColumnRenderer(map, textures).render(frame, &facts, snapshot, view);
        else
            render_reference(frame, &facts, map, textures, snapshot, view);
    }
    Frame frame;
    FrameFacts facts;
};

/// Pictures on flats and skies do not turn with a room: one colour for each instead.
void make_flats_plain(Map& map, TextureSet& textures) {
    const auto make_plain = [&](SurfaceId& id) {
        if (!map[id].texture) return;
        Surface surface = map[id];
        Texture plain;
        plain.pixels = {0xFF000000u | surface.texture.index * 0x9E3779u};
        textures.textures.push_back(plain);
        surface.texture = TextureId(textures.textures.size() - 1);
        id = SurfaceId(map.surfaces.size());
        map.surfaces.push_back(surface);
    };
    for (Sector& sector : map.sectors) {
        make_plain(sector.floor.surface);
        make_plain(sector.ceiling.surface);
    }
}

/// A sun shines from one side of the plan, whichever way a room is turned on it, and lamps are not moved with their
/// rooms: what is compared are shapes and pictures. That lamps shine through links as through other portals is
/// render/lights_test.cpp's.
void put_out_lights(Map& map) {
    map.lights.clear();
    map.suns.clear();
    for (Sector& sector : map.sectors) sector.sun = {};
}

class Equivalence : public testing::TestWithParam<const char*> {
protected:
    void SetUp() override {
        LoadedMap loaded = load_map(std::string(ENFILADE_SOURCE_DIR "/maps/") + GetParam() + ".toml", {}, read_file);
        ASSERT_TRUE(loaded.map);
        map_ = std::move(*loaded.map);
        put_out_lights(map_);
        textures_ = std::move(loaded.textures);
    }

    /// How many pixels of the two pictures of each view differ, in millionths.
    double differing(const Map& map, Move move, bool by_columns) const {
        Random random(1);
        std::uint64_t pixels = 0, other = 0, linked = 0;
        for (int i = 0; i < kCuts; ++i) {
            const CutMap cut = cut_apart(map, move, random);
            linked += cut.map.links.size() - map.links.size();
            for (int pose = 0; pose < kCutPoses; ++pose) {
                const View view = random_pose(map, random);
                const Picture before(map, textures_, view, by_columns),
                    after(cut.map, textures_, moved(view, cut), by_columns);
                for (std::size_t p = 0; p < before.frame.pixels.size(); ++p, ++pixels)
                    other +=
                        before.frame.pixels[p] != after.frame.pixels[p] || before.facts.ids[p] != after.facts.ids[p];
            }
        }
        EXPECT_GT(linked, 0u);
        count_trials(pixels, "pixels");
        const double share = 1e6 * static_cast<double>(other) / static_cast<double>(pixels);
        std::printf("  %s: %.2f per million of %llu pixels differ\n", by_columns ? "column" : "reference", share,
                    static_cast<unsigned long long>(pixels));
        return share;
    }

    Map map_;
    TextureSet textures_;
};

// hard case I10
TEST_P(Equivalence, IsExactForShifts) {
    for (const bool by_columns : {true, false}) EXPECT_EQ(differing(map_, Move::shift, by_columns), 0);
}

// hard case I10
TEST_P(Equivalence, IsExactForQuarterTurns) {
    make_flats_plain(map_, textures_);
    for (const bool by_columns : {true, false}) EXPECT_EQ(differing(map_, Move::quarter_turns, by_columns), 0);
}

// hard cases R3, I10
TEST_P(Equivalence, IsCloseForOtherAngles) {
    make_flats_plain(map_, textures_);
    const Map turnable = on_turnable_grid(map_);
    for (const bool by_columns : {true, false}) EXPECT_LE(differing(turnable, Move::other_angles, by_columns), 20);
}

INSTANTIATE_TEST_SUITE_P(Maps, Equivalence, testing::Values("enfilade", "rooms", "cave", "pillar_hall"),
                         [](const auto& map) { return std::string(map.param); });

}  // namespace
}  // namespace enfilade::test
