// The renderers by name.
#include "render/choice/renderer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <set>

#include "flight/scenes.h"
#include "render/reference/reference_renderer.h"

namespace enfilade {
namespace {

TEST(ParseRenderer, KnowsWhatThereIs) {
    for (const RendererKind kind : {RendererKind::column, RendererKind::stencil, RendererKind::reference})
        EXPECT_EQ(parse_renderer(name_of(kind)).value(), kind);
}

/// For renderers that are not drawn by OpenGL: asking for a context is a mistake.
Result<std::unique_ptr<GlContext>> no_gl() { return Error{"OpenGL", "none here"}; }

TEST(MakeRenderer, SaysWhyThereIsNoContext) {
    const auto stencil = make_renderer({RendererKind::stencil, {}, 1, no_gl}, Map(), TextureSet());
    ASSERT_FALSE(stencil.ok());
    EXPECT_EQ(stencil.error().text(), "OpenGL: none here");
}

TEST(MakeRenderer, AsksForAContextWhereItDrawsByOpenGlAndNowhereElse) {
    for (const RendererKind kind : {RendererKind::column, RendererKind::reference, RendererKind::stencil}) {
        int asked = 0;
        const auto counting = [&] {
            ++asked;
            return no_gl();
        };
        (void)make_renderer({kind, {}, 2, counting}, Map(), TextureSet());
        EXPECT_EQ(asked, kind == RendererKind::stencil ? 1 : 0) << name_of(kind);
    }
}

TEST(ParseRenderer, RefusesOtherNamesAndTellsTheRightOnes) {
    const auto other = parse_renderer("Column");
    ASSERT_FALSE(other.ok());
    EXPECT_NE(other.error().what.find("column, stencil or reference"), std::string::npos);
}

class RendererInHall : public ::testing::Test {
protected:
    Frame picture(RendererKind kind, std::size_t threads, int samples = 1, Sampling sampling = Sampling::nearest) {
        return picture(kind, threads, Dials{.sampling = sampling, .samples = samples});
    }
    Frame picture(RendererKind kind, std::size_t threads, const Dials& dials) {
        Frame frame;
        frame.resize(64, 40);
        auto renderer = std::move(make_renderer({kind, dials, threads, no_gl}, map_, textures_)).value();
        EXPECT_TRUE(renderer->render(frame, nullptr, at_rest(map_), view()).ok());
        viewports_ = renderer->viewports();
        return frame;
    }
    View view() const {
        View view;
        view.sector = SectorId(0u);
        view.eye = {2.1, 3.3};
        view.eye_z = 1.5;
        view.forward = forward_;
        return view;
    }

    void turn_to(double degrees) { forward_ = direction(Angle::from_degrees(degrees)); }

    Vec2 forward_{1, 0};
    MapFile file_ = test::hall_file();
    Map map_ = test::built(file_);
    TextureSet textures_ = test::textures_for(file_);
    std::vector<ViewportShape> viewports_;
};

/// Pixels of which a colour differs by more than 2/255, as much as lamps may in different renderers.
std::size_t pixels_apart(const Frame& a, const Frame& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        int most = 0;
        for (const int shift : {0, 8, 16})
            most = std::max(most, std::abs(static_cast<int>(a.pixels[i] >> shift & 0xFF) -
                                           static_cast<int>(b.pixels[i] >> shift & 0xFF)));
        count += most > 2;
    }
    return count;
}

TEST_F(RendererInHall, WorksOutLampsAtAsManyPlacesAsTheDialSays) {
    PointLightRecord lamp;
    lamp.position = {4.3, 1.6};
    lamp.z = 2;
    lamp.reach = 8;
    file_.lights = {lamp};
    file_.sectors[0].light = 0.25;
    turn_to(3);
    test::cut_pillar(file_.sectors[0], 4.5, 2.5, 5, 3);
    map_ = test::built(file_);
    const auto with_points = [&](RendererKind kind, int points) {
        Frame frame;
        frame.resize(64, 40);
        auto renderer =
            std::move(make_renderer({kind, Dials{.light_grid = points}, 1, no_gl}, map_, textures_)).value();
        EXPECT_TRUE(renderer->render(frame, nullptr, at_rest(map_), view()).ok());
        return frame;
    };
    EXPECT_EQ(with_points(RendererKind::column, 4).pixels, picture(RendererKind::column, 1).pixels);
    for (const int points : {1, 3, 16, 64}) {
        const Frame drawn = with_points(RendererKind::column, points);
        const Frame other = with_points(RendererKind::column, 4), exact = with_points(RendererKind::reference, points);
        EXPECT_EQ(pixels_apart(drawn, exact), 0u) << points;
        EXPECT_GT(pixels_apart(drawn, other), 20u) << points;
    }
}

// hard case I13
TEST_F(RendererInHall, DrawsTheSameWithAnyNumberOfThreads) {
    for (const RendererKind kind : {RendererKind::column, RendererKind::reference})
        EXPECT_EQ(picture(kind, 3).pixels, picture(kind, 1).pixels) << name_of(kind);
}

// hard case G12
TEST_F(RendererInHall, GivesAPixelTheMeanOfItsSamplesAsTheReferenceDoes) {
    turn_to(20);  // looking along x the edges of texels are in line with columns
    for (const int samples : {2, 3, 8}) {
        Frame expected;
        expected.resize(64, 40);
        render_reference(expected, nullptr, map_, textures_, at_rest(map_), view(), {.samples = samples});
        EXPECT_EQ(picture(RendererKind::column, 1, samples).pixels, expected.pixels) << samples;
    }
    EXPECT_NE(picture(RendererKind::column, 1, 2).pixels, picture(RendererKind::column, 1).pixels);
}

TEST_F(RendererInHall, TakesSamplesOfBlendedTexelsAsTheReferenceDoes) {
    turn_to(20);
    for (const Sampling sampling : {Sampling::mip, Sampling::bilinear, Sampling::trilinear})
        for (const int samples : {1, 2, 3}) {
            const Frame reference = picture(RendererKind::reference, 1, samples, sampling);
            EXPECT_EQ(picture(RendererKind::column, 1, samples, sampling).pixels, reference.pixels) << samples;
            EXPECT_NE(reference.pixels, picture(RendererKind::reference, 1, samples).pixels) << samples;
        }
}

TEST(DialsFor, AreThoseThatARendererHas) {
    Dials dials;
    dials.span = 4;
    dials.sampling = Sampling::trilinear;
    dials.light = LightSteps::bands;
    dials.fog = FogSteps::bands;
    EXPECT_EQ(to_text(dials_for(RendererKind::column, dials)), "span=4 sampling=trilinear light=bands fog=bands");
    EXPECT_EQ(to_text(dials_for(RendererKind::reference, dials)), "sampling=trilinear light=bands fog=bands");
    EXPECT_EQ(to_text(dials_for(RendererKind::stencil, dials)), "light=bands fog=bands");
    EXPECT_FALSE(check_dials(RendererKind::reference, dials).ok());
    EXPECT_TRUE(check_dials(RendererKind::reference, dials_for(RendererKind::reference, dials)).ok());
    EXPECT_FALSE(check_dials(RendererKind::stencil, dials_for(RendererKind::reference, dials)).ok());
}

/// Number of different colours.
std::size_t colors_in(const Frame& frame) {
    return std::set<std::uint32_t>(frame.pixels.begin(), frame.pixels.end()).size();
}

TEST_F(RendererInHall, DrawsFogInFewerStepsWhereADialSaysSo) {
    map_.render.fog_reach = 6;
    turn_to(20);
    for (const RendererKind kind : {RendererKind::column, RendererKind::reference}) {
        const Frame smooth = picture(kind, 2), banded = picture(kind, 2, Dials{.fog = FogSteps::bands});
        EXPECT_NE(banded.pixels, smooth.pixels);
        EXPECT_LT(2 * colors_in(banded), colors_in(smooth)) << name_of(kind);
    }
    EXPECT_EQ(picture(RendererKind::column, 1, Dials{.fog = FogSteps::bands}).pixels,
              picture(RendererKind::reference, 1, Dials{.fog = FogSteps::bands}).pixels);
}

TEST_F(RendererInHall, TellsTheViewportsInThePixelsOfThePictureWhateverTheSamples) {
    picture(RendererKind::column, 1);
    const std::vector<ViewportShape> plain = viewports_;
    picture(RendererKind::column, 1, 4);
    ASSERT_EQ(viewports_.size(), plain.size());
    for (std::size_t i = 0; i < plain.size(); ++i) {
        EXPECT_NEAR(viewports_[i].begin, plain[i].begin, 1);
        EXPECT_NEAR(viewports_[i].end, plain[i].end, 1);
        ASSERT_EQ(viewports_[i].top.size(), std::size_t(viewports_[i].end - viewports_[i].begin));
        EXPECT_NEAR(viewports_[i].bottom.front(), plain[i].bottom.front(), 1);
    }
}

TEST_F(RendererInHall, TellsTheViewportsOfTheColumnRenderer) {
    picture(RendererKind::column, 1);
    ASSERT_EQ(viewports_.size(), 2u);
    EXPECT_EQ(viewports_[0].sector, SectorId(0u));
    EXPECT_EQ(viewports_[1].sector, SectorId(1u));
    EXPECT_EQ(viewports_[1].depth, 1);
}

TEST_F(RendererInHall, TellsTheSameViewportsWithAnyNumberOfThreads) {
    picture(RendererKind::column, 1);
    const std::vector<ViewportShape> whole = viewports_;
    for (const std::size_t threads : {2u, 3u, 5u}) {
        picture(RendererKind::column, threads);
        ASSERT_EQ(viewports_.size(), whole.size()) << threads;
        for (std::size_t i = 0; i < whole.size(); ++i) {
            const auto same = std::ranges::find_if(viewports_, [&](const ViewportShape& v) {
                return v.sector == whole[i].sector && v.begin == whole[i].begin && v.end == whole[i].end;
            });
            ASSERT_NE(same, viewports_.end()) << threads << ", " << i;
            EXPECT_EQ(same->top, whole[i].top);
            EXPECT_EQ(same->bottom, whole[i].bottom);
        }
    }
}

}  // namespace
}  // namespace enfilade
