// Flythrough scripts: what is read, and what is refused where.
#include <gmock/gmock.h>

#include "formats/findings.h"
#include "formats/hostile.h"
#include "formats/script.h"

namespace enfilade {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr std::string_view kScript = R"(map = "enfilade.toml"
size = [320, 200]
rate = 25
renderer = "stencil"
fov = 75.5

[start]
sector = "hall"
x = 1
y = 2.5
yaw = 90

[[legs]]
seconds = 3
to = [4, 5]
look_at = [9, 9]
ease = "linear"

[[legs]]
press = "use"

[[legs]]
wait = 0.5

[[legs]]
seconds = 2
to = [1, 2, 3]
turn = -720
pitch = -10
)";

std::vector<std::string> faults_of_script(const std::string& text) {
    return codes_and_places(read_script(text).findings);
}

/// A sound script with these keys in its only leg, which starts at line 3.
std::vector<std::string> complaints_of_leg(const std::string& keys) {
    return faults_of_script("map = \"m\"\n[[legs]]\n" + keys + "\n");
}

TEST(ReadScript, ReadsDials) {
    const std::string legs = "\n[[legs]]\nwait = 1\n";
    const auto read =
        read_script("map = \"m\"\nsamples = 2\naccuracy = \"fine\"\n[dials]\nsampling = \"trilinear\"" + legs);
    EXPECT_THAT(read.findings, IsEmpty());
    EXPECT_EQ(to_text(read.script.dials), "accuracy=0.25 sampling=trilinear samples=2");
    EXPECT_EQ(read_script("map = \"m\"\naccuracy = 0.01" + legs).script.dials.texel_error, 0.01);
    EXPECT_THAT(faults_of_script("map = \"m\"\naccuracy = \"good\"" + legs), ElementsAre("unknown-word 2:12"));
    EXPECT_THAT(faults_of_script("map = \"m\"\naccuracy = 65" + legs), ElementsAre("out-of-range 2:12"));
    EXPECT_THAT(faults_of_script("map = \"m\"\n[dials]\nspan = 65\nspam = 1" + legs),
                ElementsAre("out-of-range 3:8", "unknown-key 4:1"));
}

TEST(ReadScript, HasNothingAgainstASoundOne) {
    EXPECT_THAT(codes_and_places(read_script(kScript).findings), IsEmpty());
}

TEST(IsScript, KnowsAScriptByTheMapItNames) {
    EXPECT_TRUE(is_script(kScript));
    EXPECT_TRUE(is_script("map = \"m\"\nnonsense = 1\n"));
    EXPECT_FALSE(is_script("format = 1\n"));
    EXPECT_FALSE(is_script("[map]\n"));
    EXPECT_FALSE(is_script("map = "));
}

TEST(ReadScript, ReadsThePicture) {
    const ScriptFile script = read_script(kScript).script;
    EXPECT_EQ(script.map, "enfilade.toml");
    EXPECT_EQ(script.width, 320);
    EXPECT_EQ(script.height, 200);
    EXPECT_EQ(script.rate, 25);
    EXPECT_EQ(script.renderer, RendererKind::stencil);
    EXPECT_EQ(script.fov_degrees, 75.5);
}

TEST(ReadScript, ReadsTheStart) {
    const StartRecord start = read_script(kScript).script.start;
    EXPECT_EQ(start.sector, "hall");
    EXPECT_EQ(start.x, 1);
    EXPECT_EQ(start.y, 2.5);
    EXPECT_EQ(start.z, std::nullopt);
    EXPECT_EQ(start.yaw_degrees, 90);
}

TEST(ReadScript, ReadsALegToAPoint) {
    const LegRecord leg = read_script(kScript).script.legs.at(0);
    EXPECT_EQ(leg.seconds, 3);
    EXPECT_EQ(leg.to, (Vec2{4, 5}));
    EXPECT_EQ(leg.to_z, std::nullopt);
    EXPECT_EQ(leg.look_at, (Vec2{9, 9}));
    EXPECT_EQ(leg.ease, Ease::linear);
}

TEST(ReadScript, ReadsALegThatClimbsAndTurns) {
    const LegRecord leg = read_script(kScript).script.legs.at(3);
    EXPECT_EQ(leg.to_z, 3);
    EXPECT_EQ(leg.turn_degrees, -720);
    EXPECT_EQ(leg.pitch_degrees, -10);
}

TEST(ReadScript, TakesAPressAloneForALegWithoutTime) {
    const LegRecord leg = read_script(kScript).script.legs.at(1);
    EXPECT_EQ(leg.press, Press::use);
    EXPECT_EQ(leg.seconds, 0);
}

TEST(ReadScript, TakesAWaitForALegThatStandsStill) { EXPECT_EQ(read_script(kScript).script.legs.at(2).seconds, 0.5); }

TEST(ReadScript, WantsAMapAndLegs) {
    EXPECT_THAT(faults_of_script("rate = 5"), ElementsAre("missing-key 0:0", "missing-key 1:1"));
}

TEST(ReadScript, WantsSecondsInALeg) { EXPECT_THAT(complaints_of_leg("to = [1, 2]"), ElementsAre("missing-key 2:1")); }

TEST(ReadScript, RefusesTwoWaysToLook) {
    EXPECT_THAT(complaints_of_leg("seconds = 1\nlook = 1\nturn = 2"), ElementsAre("given-twice 5:1"));
}

TEST(ReadScript, RefusesToWaitAndMove) {
    EXPECT_THAT(complaints_of_leg("wait = 1\nto = [1, 2]"), ElementsAre("wait-and-move 3:1"));
}

TEST(ReadScript, RefusesAPointWithoutHeightOrWithMore) {
    EXPECT_THAT(complaints_of_leg("seconds = 1\nto = [1, 2, 3, 4]"), ElementsAre("wrong-type 4:6"));
}

TEST(ReadScript, RefusesNumbersOutOfRange) {
    EXPECT_THAT(faults_of_script("map = \"m\"\nsize = [0, 20000]\nrate = 0\nfov = 180\n[[legs]]\nseconds = -1"),
                ElementsAre("out-of-range 2:9", "out-of-range 2:12", "out-of-range 3:8", "out-of-range 4:7",
                            "out-of-range 6:11"));
}

TEST(ReadScript, RefusesAStartWithHalfAPosition) {
    EXPECT_THAT(faults_of_script("map = \"m\"\nlegs = [{ wait = 1 }]\n[start]\nx = 1"), ElementsAre("missing-key 3:1"));
}

TEST(ReadScript, RefusesATapeBesideLegs) {
    EXPECT_THAT(faults_of_script("map = \"m\"\ntape = \"t\"\n[start]\n[[legs]]\nwait = 1"),
                ElementsAre("tape-and-legs 3:2", "tape-and-legs 4:3"));
}

TEST(ReadScript, RefusesMoreThanADay) {
    std::string text = "map = \"m\"\nlegs = [\n";
    for (int leg = 0; leg < 25; ++leg) text += "{ wait = 3600 },\n";
    EXPECT_THAT(faults_of_script(text + "]"), ElementsAre("too-long 27:1"));
}

TEST(ReadScript, SurvivesBeingCutAnywhere) {
    for_each_cut(kScript, [](std::string_view cut) { EXPECT_LE(read_script(cut).script.legs.size(), 4u); });
}

}  // namespace
}  // namespace enfilade
