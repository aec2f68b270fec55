// The experiment of `enfilade accuracy`: its truth, its poses and its report.
#include <gmock/gmock.h>

#include <cmath>

#include "app/accuracy/report.h"
#include "app/accuracy/true_texels.h"
#include "render/reference/reference_renderer.h"
#include "space/trace.h"

namespace enfilade {
namespace {

using ::testing::HasSubstr;

constexpr int kWidth = 80, kHeight = 50;

OpenMap shipped(const char* name) {
    auto map = open_map(std::string(ENFILADE_SOURCE_DIR "/maps/") + name, {}, {});
    ENFILADE_CHECK(map.has_value());
    return std::move(*map);
}

/// Things, panels, and pictures with holes in doorways.
bool is_looked_through(const Map& map, PixelSurface id) {
    const auto owner = owner_of(map, id);
    if (!owner || owner->kind == SurfaceKind::thing || owner->kind == SurfaceKind::panel) return true;
    const bool is_middle = owner->kind == SurfaceKind::wall && owner->part == WallPart::middle;
    return is_middle && map[WallId(owner->index)].kind != WallKind::solid;
}

TEST(TrueTexels, AreWhereTheReferenceSeesThem) {
    std::size_t judged = 0;
    for (const char* name : {"rooms.toml", "quarter_turn.toml", "facing_doors.toml", "mirrors.toml"}) {
        const OpenMap map = shipped(name);
        const Snapshot snapshot = at_rest(map.map);
        for (const PoseKind kind : kPoseKinds)
            for (const View& view : poses_in(map.map, kind, 6, 3)) {
                Frame frame;
                FrameFacts facts;
                frame.resize(kWidth, kHeight);
                reset(facts, kWidth, kHeight);
                render_reference(frame, &facts, map.map, map.textures, snapshot, view);
                for (int x = 0; x < kWidth; ++x) {
                    TrueColumn column(map.map, snapshot, view, kWidth, kHeight, x);
                    for (int y = 0; y < kHeight; ++y) {
                        const auto i = static_cast<std::size_t>(y * kWidth + x);
                        const auto truth = column.at(y);
                        if (!truth || facts.ambiguous[i] || is_looked_through(map.map, facts.ids[i])) continue;
                        ASSERT_EQ(truth->id, facts.ids[i]) << name << " " << x << "," << y;
                        ASSERT_LE(texel_error(*truth, facts.texels[i], 64, 64), 1e-8) << name << " " << x << "," << y;
                        ++judged;
                    }
                }
            }
    }
    EXPECT_GT(judged, 100'000u);
}

TEST(TexelError, GoesTheShorterWayRound) {
    TrueTexel truth;
    truth.u = Quad(-7) / 8;
    truth.v = 1000;
    EXPECT_DOUBLE_EQ(texel_error(truth, {0.125, 0.0}, 64, 32), 0);
    EXPECT_DOUBLE_EQ(texel_error(truth, {0.0, 0.0}, 64, 32), 8);
    EXPECT_DOUBLE_EQ(texel_error(truth, {0.125, 0.75}, 64, 32), 8);
}

TEST(PosesIn, AreInsideAndTheSameEachTime) {
    const OpenMap map = shipped("rooms.toml");
    for (const PoseKind kind : kPoseKinds) {
        const std::vector<View> views = poses_in(map.map, kind, 20, 1), again = poses_in(map.map, kind, 20, 1);
        for (std::size_t i = 0; i < views.size(); ++i) {
            EXPECT_TRUE(contains(map.map, views[i].sector, views[i].eye));
            EXPECT_EQ(views[i].eye.x, again[i].eye.x);
            if (kind == PoseKind::lattice) {
                EXPECT_EQ(std::round(2 * views[i].eye.x), 2 * views[i].eye.x);
            }
        }
    }
}

std::vector<AccuracyRow> two_rows() {
    std::vector<AccuracyRow> rows(2);
    for (AccuracyRow& row : rows) {
        row.scene = "room";
        row.errors.pixels = 4;
        row.errors.texel_errors = {0, 0.5f, 0.25f, 0.25f};
        row.errors.squared_color = 12;
    }
    rows[1].setting = {{"--accuracy", "0.5"}, {}, 0.5};
    rows[1].price.low_ratio = rows[1].price.high_ratio = 0.75;
    return rows;
}

TEST(AccuracyErrors, SayWhatTheyAre) {
    AccuracyErrors errors = two_rows()[0].errors;
    EXPECT_EQ(errors.mean(), 0.25);
    EXPECT_EQ(errors.largest(), 0.5);
    EXPECT_NEAR(errors.psnr(), 10 * std::log10(255.0 * 255.0), 1e-9);
    errors.texel_errors.assign(2000, 1);
    errors.texel_errors[7] = 9;
    EXPECT_EQ(errors.per_mille(), 1);
    EXPECT_EQ(AccuracyErrors().psnr(), std::numeric_limits<double>::infinity());
}

TEST(AccuracyReport, FindsItsErrorsAgainWhateverThePrices) {
    std::vector<AccuracyRow> rows = two_rows();
    const std::string csv = accuracy_csv(rows);
    rows[1].price.minimum_ns = 7;
    EXPECT_FALSE(compare_errors("a.csv", csv, rows));
    rows[1].errors.wrong_texels = 1;
    const Status other = compare_errors("a.csv", csv, rows);
    ASSERT_TRUE(other);
    EXPECT_THAT(other->text(), HasSubstr("a.csv:3: expected room,random,--accuracy 0.5,0.5,4"));
    EXPECT_THAT(compare_errors("a.csv", "scene,poses\n", rows)->text(), HasSubstr("expected the columns"));
    EXPECT_THAT(compare_errors("a.csv", "", rows)->text(), HasSubstr("expected the columns"));
}

TEST(AccuracyReport, SaysWhichPromiseIsBroken) {
    std::vector<AccuracyRow> rows = two_rows();
    EXPECT_FALSE(check_promises(rows));
    rows[1].errors.broken = 3;
    EXPECT_EQ(check_promises(rows)->text(),
              "room, random poses, --accuracy 0.5: expected no texel to be off by more than 0.5; 3 are, by up to 0.5");
    rows = two_rows();
    rows[0].errors.written_more = 1;
    EXPECT_THAT(check_promises(rows)->text(), HasSubstr("expected every pixel to be written once; 1 are not"));
    rows = two_rows();
    rows[0].errors.wrong_ids = 1;
    EXPECT_THAT(check_promises(rows)->text(), HasSubstr("1 of 4 pixels show others"));
    rows[0].setting.dials.links = 4;
    EXPECT_FALSE(check_promises(rows));
}

TEST(AccuracyReport, ShowsEachSettingOnce) {
    std::vector<AccuracyRow> rows = two_rows(), more = two_rows();
    rows.insert(rows.end(), more.begin(), more.end());
    const std::string page = accuracy_page(rows, "enfilade accuracy");
    EXPECT_THAT(page, HasSubstr("| `--accuracy 0.5` | 0.5 | 0 | 2.5e-01 | 5.0e-01 | 5.0e-01 |"));
    EXPECT_EQ(page.find("| `exact`"), page.rfind("| `exact`"));
    EXPECT_THAT(accuracy_plot(rows, "a.svg"), HasSubstr("0.7500 5.0000e-01 \"--accuracy 0.5\" 0.5\n"));
}

}  // namespace
}  // namespace enfilade
