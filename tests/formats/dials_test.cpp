// Dials as texts.
#include "formats/dials.h"

#include <gmock/gmock.h>

namespace enfilade {
namespace {

using ::testing::HasSubstr;

TEST(SetAccuracy, KnowsNamesAndNumbers) {
    Dials dials;
    const auto promised = [&](const char* text) {
        EXPECT_TRUE(set_accuracy(dials, text).ok()) << text;
        return dials.texel_error;
    };
    EXPECT_EQ(promised("fine"), 0.25);
    EXPECT_EQ(promised("exact"), 0);
    EXPECT_EQ(promised("fast"), 1);
    EXPECT_EQ(promised("1e-6"), 1e-6);
    EXPECT_EQ(promised("64"), 64);
    EXPECT_EQ(dials.number, NumberKind::real64);
    EXPECT_TRUE(set_accuracy(dials = {}, "vanilla").ok());
    EXPECT_EQ(to_text(dials), "number=vanilla");
}

TEST(SetAccuracy, RefusesOtherTexts) {
    for (const char* text : {"", "Fast", "-0.1", "64.5", "nan", "1 "}) {
        Dials dials;
        const Result<void> result = set_accuracy(dials, text);
        ASSERT_FALSE(result.ok()) << text;
        EXPECT_THAT(result.error().what, HasSubstr("expected exact, fine, fast, vanilla, or how many texels")) << text;
        EXPECT_EQ(dials, Dials()) << text;
    }
}

TEST(SetDial, SetsEachDialAndNoOther) {
    Dials expected, dials;
    const auto set = [&](const char* text) {
        EXPECT_TRUE(set_dial(dials, text).ok()) << text;
        EXPECT_EQ(dials, expected) << text;
    };
    expected.span = 16;
    set("span=16");
    expected.number = NumberKind::fixed16;
    set("number=fixed");
    expected.sampling = Sampling::mip;
    set("sampling=mip");
    expected.sampling = Sampling::bilinear;
    set("sampling=bilinear");
    expected.sampling = Sampling::trilinear;
    set("sampling=trilinear");
    expected.samples = 3;
    set("samples=3");
    expected.light = LightSteps::bands;
    set("light=bands");
    expected.fog = FogSteps::bands;
    set("fog=bands");
    expected.light_grid = 64;
    set("light_grid=64");
    expected.portals = PortalMethod::oblique24;
    set("portals=oblique24");
    expected.links = 0;
    set("links=0");
    expected.tick_rate = TickRate::hz35;
    set("tick_rate=35");
    expected.crossing = CrossingMethod::naive;
    set("crossing=naive");
}

TEST(SetDial, SaysWhatADialMayBe) {
    Dials dials;
    EXPECT_EQ(set_dial(dials, "span=65").error().what, "expected span=a whole number from 1 to 64; found 'span=65'");
    EXPECT_EQ(set_dial(dials, "span=1.5").error().what, "expected span=a whole number from 1 to 64; found 'span=1.5'");
    EXPECT_EQ(set_dial(dials, "light_grid=0").error().what,
              "expected light_grid=a whole number from 1 to 64; found 'light_grid=0'");
    EXPECT_EQ(set_dial(dials, "fog=map").error().what, "expected fog=smooth, bands; found 'fog=map'");
    EXPECT_EQ(set_dial(dials, "number=half").error().what,
              "expected number=double, float, fixed, vanilla; found 'number=half'");
    EXPECT_EQ(set_dial(dials, "sampling=cubic").error().what,
              "expected sampling=nearest, mip, bilinear, trilinear; found 'sampling=cubic'");
    EXPECT_EQ(set_dial(dials, "portals=near").error().what,
              "expected portals=exact, plane24, plane32, oblique24, oblique32; found 'portals=near'");
    EXPECT_EQ(set_dial(dials, "tick_rate=50").error().what, "expected tick_rate=60, 35, 140; found 'tick_rate=50'");
    EXPECT_EQ(set_dial(dials, "crossing=near").error().what, "expected crossing=exact, naive; found 'crossing=near'");
    EXPECT_EQ(set_dial(dials, "smaples=2").error().what,
              "expected NAME=VALUE, as in span=8; found 'smaples=2'; did you mean 'samples'?");
    EXPECT_THAT(set_dial(dials, "span").error().what, HasSubstr("found 'span'"));
    EXPECT_EQ(dials, Dials());
}

TEST(DialsText, SaysWhatIsNotExact) {
    Dials dials;
    EXPECT_EQ(to_text(dials), "exact");
    dials.texel_error = 0.25;
    dials.samples = 2;
    dials.light = LightSteps::smooth;
    dials.light_grid = 16;
    EXPECT_EQ(to_text(dials), "accuracy=0.25 samples=2 light=smooth light_grid=16");
}

}  // namespace
}  // namespace enfilade
