// The experiment of `enfilade accuracy`: its truth, its poses and its report.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "app/accuracy/picture_files.h"
#include "app/accuracy/report.h"
#include "app/accuracy/true_texels.h"
#include "render/reference/reference_renderer.h"
#include "space/trace.h"
#include "support/map_builder.h"

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
                        if (!truth || is_looked_through(map.map, facts.ids[i])) continue;
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

TEST(StructuralSimilarity, IsOneOfAPictureToItself) {
    Frame a, b;
    a.resize(24, 16);
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        a.pixels[i] = 0xFF000000u + static_cast<std::uint32_t>(i * 0x010203);
    b = a;
    EXPECT_DOUBLE_EQ(structural_similarity(a, b), 1);
    for (std::uint32_t& pixel : b.pixels) pixel = 0xFF808080u;
    EXPECT_LT(structural_similarity(a, b), 0.5);
}

TEST(StructuralSimilarity, OfGreysIsWhatItsFormulaSays) {
    Frame a, b;
    a.resize(8, 8);
    b.resize(8, 8);
    a.pixels.assign(64, 0xFF646464u);  // 100
    b.pixels.assign(64, 0xFF323232u);  // 50
    const double steady = 2.55 * 2.55;
    EXPECT_NEAR(structural_similarity(a, b), (2 * 100 * 50 + steady) / (100 * 100 + 50 * 50 + steady), 1e-12);
}

// A bare room, all walls of which are one picture.
TEST(MeasureErrors, FindsOutWhatADialDoes) {
    const OpenMap map = shipped("rooms.toml");
    const std::vector<AccuracySetting> all = accuracy_settings(true);
    const auto setting = [&](const std::string& name) {
        return *std::ranges::find(all, name, [](const AccuracySetting& s) { return name_of(s); });
    };
    const auto errors = measure_errors(map, poses_in(map.map, PoseKind::random, 2, 9),
                                       {setting("exact"), setting("--accuracy 1"), setting("--dial span=32"),
                                        setting("--dial samples=2"), setting("--dial sampling=mip")},
                                       96, 64);
    ASSERT_TRUE(errors.ok());
    const AccuracyErrors &exact = errors.value()[0], &one = errors.value()[1], &span = errors.value()[2];
    const AccuracyErrors &samples = errors.value()[3], &mip = errors.value()[4];
    EXPECT_EQ(exact.pixels, 2u * 96 * 64);
    EXPECT_LE(exact.judged, exact.pixels);
    EXPECT_LT(exact.largest, 1e-6);
    EXPECT_GT(one.largest, 0.1);
    EXPECT_LE(one.largest, 1);
    EXPECT_GT(span.largest, one.largest);
    EXPECT_GT(samples.psnr, exact.psnr);
    EXPECT_GT(samples.ssim, exact.ssim);
    EXPECT_LT(samples.shimmer_stepped, exact.shimmer_stepped);
    EXPECT_LT(mip.shimmer_stepped, exact.shimmer_stepped);
}

// Columns of a wall 5 m ahead, of 64 texels a metre, are exactly two texels apart: their mean is off by one.
TEST(MeasureErrors, CountsWhatRoundingAddsToAPromise) {
    const MapFile file = test::map_of({test::box_room("hall", 0, 0, 10, 10, 0, 3)});
    const OpenMap map{test::built(file), test::textures_for(file)};
    View view;
    view.sector = SectorId(0u);
    view.eye = {5, 5};
    view.eye_z = 1.5;
    AccuracySetting one{{"--accuracy", "1"}, {}, 1};
    one.dials.texel_error = 1;
    const auto errors = measure_errors(map, {view}, {one}, 320, 200);
    ASSERT_TRUE(errors.ok());
    EXPECT_EQ(errors.value()[0].broken, 0u);
    EXPECT_GT(errors.value()[0].largest, 0.4);
}

TEST(ErrorColor, GrowsBrighter) {
    EXPECT_EQ(error_color({}), 0xFF204020u);
    EXPECT_EQ(error_color(0), 0xFF000000u);
    EXPECT_EQ(error_color(1e-6), 0xFF000000u);
    EXPECT_EQ(error_color(10), 0xFFFFFFFFu);
    EXPECT_EQ(error_color(1e9), 0xFFFFFFFFu);
    int before = -1;
    for (const double error : {1e-6, 1e-4, 1e-2, 0.5, 9.0}) {
        const std::uint32_t color = error_color(error);
        const int sum = static_cast<int>((color & 0xFF) + (color >> 8 & 0xFF) + (color >> 16 & 0xFF));
        EXPECT_GT(sum, before) << error;
        before = sum;
    }
}

// A promise is kept in every pixel of a picture, and made use of in some.
TEST(JudgePictures, SaysHowFarEachPixelIsOff) {
    const OpenMap map = shipped("rooms.toml");
    const View view = poses_in(map.map, PoseKind::random, 1, 5).front();
    const auto pictures = judge_pictures(map, view, {AccuracySetting(), promise_of(2)}, 160, 100);
    ASSERT_TRUE(pictures.ok());
    std::size_t used = 0;
    for (std::size_t i = 0; i < 160u * 100; ++i) {
        EXPECT_LT(pictures.value()[0].errors[i].value_or(0), 1e-6);
        EXPECT_LE(pictures.value()[1].errors[i].value_or(0), 2);
        used += pictures.value()[1].errors[i].value_or(0) > 0.5;
    }
    EXPECT_GT(used, 100u);
}

AccuracyScene two_rows() {
    AccuracyScene scene{"room", 7, std::vector<AccuracyRow>(2)};
    for (AccuracyRow& row : scene.rows) {
        row.errors.pixels = row.errors.judged = 4;
        row.errors.mean = 0.25;
        row.errors.largest = row.errors.per_mille = 0.5;
    }
    scene.rows[1].setting = {{"--accuracy", "0.5"}, {}, 0.5};
    scene.rows[1].price.low_ratio = 0.5;
    return scene;
}

AccuracyRun some_run() { return {"enfilade accuracy --out DIR", true, 0xABC}; }

TEST(AccuracyReport, FindsItsErrorsAgainWhateverThePrices) {
    AccuracyScene scene = two_rows();
    const auto report = read_accuracy_json("a.json", accuracy_json(some_run(), {scene}));
    ASSERT_TRUE(report.ok()) << report.error().text();
    scene.rows[1].price.minimum_ns = 7;
    EXPECT_TRUE(compare_errors("a.json", report.value().scenes, {scene}).ok());
    scene.rows[1].errors.wrong_texels = 1;
    EXPECT_THAT(compare_errors("a.json", report.value().scenes, {scene}).error().text(),
                HasSubstr("a.json: expected of room, random poses, --accuracy 0.5 the errors {"));
    scene = two_rows();
    scene.map_hash = 8;
    EXPECT_THAT(compare_errors("a.json", report.value().scenes, {scene}).error().text(),
                HasSubstr("which was changed since"));
    scene.name = "hall";
    EXPECT_THAT(compare_errors("a.json", report.value().scenes, {scene}).error().text(),
                HasSubstr("expected the scene hall"));
}

TEST(AccuracyReport, IsReadAsItWasWritten) {
    AccuracyScene scene = two_rows();
    scene.rows[0].price.instructions = 13.25;
    scene.rows[0].errors.mean = 1.0 / 3;
    const auto report = read_accuracy_json("a.json", accuracy_json(some_run(), {scene}));
    ASSERT_TRUE(report.ok()) << report.error().text();
    EXPECT_EQ(report.value().run.command, some_run().command);
    EXPECT_EQ(report.value().run.program_hash, some_run().program_hash);
    EXPECT_TRUE(report.value().run.is_quick);
    EXPECT_EQ(report.value().scenes[0].rows[0].price.instructions, 13.25);
    EXPECT_FALSE(report.value().scenes[0].rows[1].price.instructions);
    EXPECT_EQ(accuracy_csv(report.value().scenes), accuracy_csv({scene}));
}

TEST(AccuracyReport, RefusesWhatIsNone) {
    const std::string whole = accuracy_json(some_run(), {two_rows()});
    std::string other = whole;
    other.replace(other.find("0.5\","), 4, "0.7\",");
    for (const std::string& text :
         {std::string(), std::string("[]"), std::string(200'000, '['), other, whole.substr(0, whole.size() / 2)})
        EXPECT_THAT(read_accuracy_json("a.json", text).error().text(), HasSubstr("a.json: expected a report.json"));
}

TEST(AccuracyReport, SaysWhichPromiseIsBroken) {
    AccuracyScene scene = two_rows();
    EXPECT_TRUE(check_promises({scene}).ok());
    scene.rows[1].errors.broken = 3;
    EXPECT_EQ(check_promises({scene}).error().text(),
              "room, random poses, --accuracy 0.5: expected no texel to be off by more than 0.5; 3 are, by up to 0.5");
    scene = two_rows();
    scene.rows[0].errors.written_more = 1;
    EXPECT_THAT(check_promises({scene}).error().text(),
                HasSubstr("expected every pixel to be written once; 1 are not"));
    scene = two_rows();
    scene.rows[0].errors.wrong_ids = 1;
    EXPECT_THAT(check_promises({scene}).error().text(), HasSubstr("1 of 4 pixels show others"));
    scene.rows[0].setting.dials.links = 4;
    EXPECT_TRUE(check_promises({scene}).ok());
}

TEST(AccuracyReport, ShowsEachSettingOnce) {
    const std::vector<AccuracyScene> scenes{two_rows(), two_rows()};
    const std::string page = accuracy_page(scenes, "enfilade accuracy");
    EXPECT_THAT(page, HasSubstr("| 0.5 | 5.0e-01 | 0 | 0.00 | not counted | 0.75 (0.50 to 1.00) |"));
    EXPECT_THAT(
        page, HasSubstr("takes 75 % of the time of the exact one in the mean, and 75 % in room, where it saves most"));
    EXPECT_EQ(page.find("| `exact` | 2.5e-01"), page.rfind("| `exact` | 2.5e-01"));
    EXPECT_NE(page.find("| `exact` | 2.5e-01"), page.npos);
    EXPECT_THAT(accuracy_plot(scenes, "dir"), HasSubstr("0.7500 5.0000e-01 0.5 \"0.5\"\n"));
}

}  // namespace
}  // namespace enfilade
