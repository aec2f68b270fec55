// What the reader makes of maps: records of both dialects, and every complaint with the place it belongs to.
#include <gmock/gmock.h>

#include <algorithm>

#include "base/hash.h"
#include "formats/findings.h"
#include "formats/hostile.h"
#include "formats/map_toml.h"
#include "formats/reading.h"

namespace enfilade {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr std::string_view kTutorial = R"(name = "two rooms"

[[sectors]]
name = "main"
light = 0.5
[sectors.floor]
texture = "FLOOR 2,2"
[sectors.ceiling]
texture = "SKY 4,1"
parallax = true
[[sectors.loops]]
name = "border"
v = [0, 0, 4.5, 0, 4, 4, 0, 4]
walls = [
  { texture = "W" }, { next = "b", up = "U", down = "L 1,1 3,4" }, { texture = "W" },
  { texture = "-" },
]

[[sectors]]
name = "b"
[[sectors.loops]]
v = [4, 0, 8, 0, 4, 4]
walls = [{ texture = "W" }, { texture = "W" }, { next = "main" }]

[player]
x = 1
y = 2
z = 1.5
angle = 3.141592653589793
)";

/// A sound room of the enfilade dialect with one more line in each place a test may need.
std::string room(const std::string& wall, const std::string& top = "", const std::string& sector = "") {
    return "format = 1\n" + top + "\n[[sectors]]\nname = \"main\"\n" + sector +
           "\n[[sectors.loops]]\nv = [0, 0, 1, 0, 1, 1]\nwalls = [\n" + wall + ",\n{}, {},\n]\n";
}

WallRecord read_wall(const std::string& wall) {
    const MapReading reading = read_map(room(wall));
    EXPECT_THAT(codes_and_places(reading.findings), IsEmpty());
    return reading.map.sectors.at(0).loops.at(0).walls.at(0);
}

TEST(ReadMap, ReadsATutorialFile) {
    const MapReading reading = read_map(kTutorial);
    EXPECT_THAT(codes_and_places(reading.findings), IsEmpty());
    EXPECT_EQ(reading.map.format, 0);
    EXPECT_EQ(reading.map.sectors.size(), 2u);
}

TEST(ReadMap, FillsInTheDefaults) {
    const MapFile map = read_map(kTutorial).map;
    EXPECT_EQ(map.sectors.at(1).light, 1);
    EXPECT_EQ(map.sectors.at(1).floor.z, 0);
    EXPECT_EQ(map.sectors.at(1).ceiling.z, 2);
    EXPECT_EQ(map.player->sector, "main");
    EXPECT_THAT(map.textures, ElementsAre("textures"));
}

TEST(ReadMap, TurnsTheTutorialsRadiansIntoDegrees) { EXPECT_EQ(read_map(kTutorial).map.player->yaw_degrees, 180); }

TEST(ReadMap, LetsAPlayerWithoutEyeHeightStandOnTheFloor) {
    const std::string text = room("{}", "player = { x = 0.5, y = 0.25 }", "floor = { z = 3 }");
    EXPECT_EQ(read_map(text).map.player->eye_z, 4.6);
}

TEST(ReadMap, TakesUpAndDownForUpperAndLower) {
    const WallRecord wall = read_map(kTutorial).map.sectors.at(0).loops.at(0).walls.at(1);
    EXPECT_EQ(wall.upper->name, "U");
    EXPECT_EQ(wall.lower->offset_tx, (Vec2{3, 4}));
}

TEST(ReadMap, KeepsThePlaceOfEveryVertex) {
    const LoopRecord loop = read_map(kTutorial).map.sectors.at(0).loops.at(0);
    EXPECT_EQ(loop.vertices.at(1), (Vec2{4.5, 0}));
    EXPECT_EQ(loop.vertex_places.at(1), (TextPlace{13, 12}));
}

TEST(ReadMap, KeepsThePlacesOfNextAndVia) {
    const WallRecord wall = read_wall(R"({ next = "hall", via = "door" })");
    EXPECT_EQ(key_place(wall, "next"), (TextPlace{9, 10}));
    EXPECT_EQ(key_place(wall, "via"), (TextPlace{9, 24}));
}

TEST(ReadMap, ReportsEverythingAtOnceSortedByPlace) {
    const auto findings = read_map(R"([[sectors]]
naem = "main"
light = 2
[sectors.floor]
z = nan
texture = "FLOOR 2"
[[sectors.loops]]
v = [0, 0, 4, 0, 4, 1e9, 0, 4, 5]
walls = [ { texture = 3 }, { upper = "A", up = "U" }, 5 ]
[player]
x = inf
y = 1979-05-27
z = true
)")
                              .findings;
    EXPECT_THAT(codes_and_places(findings),
                ElementsAre("unknown-key 2:1", "out-of-range 3:9", "bad-number 5:5", "bad-texture-spec 6:11",
                            "odd-vertices 8:5", "out-of-range 8:21", "wrong-type 9:23", "given-twice 9:43",
                            "wrong-type 9:55", "bad-number 11:5", "wrong-type 12:5", "wrong-type 13:5"));
}

TEST(ReadMap, SaysOnceHowCornersAreWritten) {
    const auto findings = read_map(R"(format = 1
[[sectors]]
name = "main"
floor = 0
[[sectors.loops]]
v = [[0, 0], [0, 4], [4, 4]]
walls = [{}, {}, {}]
)")
                              .findings;
    ASSERT_THAT(codes_and_places(findings), ElementsAre("wrong-type 4:9", "wrong-type 6:6"));
    EXPECT_EQ(findings[0].sentence, "'floor' must be a table, as in { z = … }, found a whole number");
    EXPECT_THAT(findings[1].sentence, testing::HasSubstr("take the inner brackets away"));
}

TEST(ReadMap, NamesTheNearestKnownKey) {
    const auto findings = read_map(room("{ textrue = \"A\" }")).findings;
    ASSERT_EQ(findings.size(), 1u);
    EXPECT_EQ(findings[0].sentence, "a wall has no key 'textrue'; did you mean 'texture'?");
}

TEST(ReadMap, ListsTheKnownKeysWhereNoneIsNear) {
    const auto findings = read_map(room("{}", "",
                                        "panels = [{ v = [0, 0, 1, 1], bottom = 0, top = 1, texture = \"A\", "
                                        "transparency = 1 }]"))
                              .findings;
    ASSERT_EQ(findings.size(), 1u);
    EXPECT_EQ(findings[0].sentence,
              "a panel has no key 'transparency'; known here: v, bottom, top, texture, size, one_sided, blocks, "
              "scroll, triggers, doom");
}

TEST(ReadMap, SaysHowSeveralTablesAreWritten) {
    const auto findings = read_map(room("{ texture = \"A\" }", "suns = { x = 1 }")).findings;
    ASSERT_EQ(findings.size(), 1u);
    EXPECT_EQ(findings[0].sentence,
              "'suns' must be an array of tables, found one table; write two brackets around its name, as in [[suns]], "
              "or an array, [{ … }]");
}

TEST(ReadMap, SaysWhatItFoundInsteadOfTwoNumbersOrAColour) {
    const auto numbers = read_map(room("{ texture = \"A\", scroll = [0.1] }")).findings;
    ASSERT_EQ(numbers.size(), 1u);
    EXPECT_EQ(numbers[0].sentence, "'scroll' must be an array of two numbers, found an array of 1");
    const auto colour = read_map(room("{ texture = \"A\" }", "render = { fog_color = \"orange\" }")).findings;
    ASSERT_EQ(colour.size(), 1u);
    EXPECT_EQ(colour[0].sentence, "'fog_color' must be a colour like \"#ff00ff\", found 'orange'");
}

struct WallCase {
    const char* wall;
    const char* complaint;
};

void PrintTo(const WallCase& bad, std::ostream* out) { *out << bad.wall; }

class BadWall : public testing::TestWithParam<WallCase> {};

// The wall stands in line 9, its first value in column 9 or later.
// hard case T1
TEST_P(BadWall, IsReportedAtItsPlace) {
    EXPECT_THAT(codes_and_places(read_map(room(GetParam().wall)).findings), ElementsAre(GetParam().complaint));
}

INSTANTIATE_TEST_SUITE_P(
    Codes, BadWall,
    testing::Values(
        WallCase{"{ texture = 1 }", "wrong-type 9:13"}, WallCase{"{ texture = '' }", "bad-texture-spec 9:13"},
        WallCase{"{ texture = 'A 1' }", "bad-texture-spec 9:13"}, WallCase{"{ next = '' }", "empty-string 9:10"},
        WallCase{"{ mirror = 1 }", "wrong-type 9:12"}, WallCase{"{ rise = nan }", "bad-number 9:10"},
        WallCase{"{ rise = -inf }", "bad-number 9:10"}, WallCase{"{ rise = 1e6 }", "out-of-range 9:10"},
        WallCase{"{ peg = 'roof' }", "unknown-word 9:9"}, WallCase{"{ peg = 1 }", "wrong-type 9:9"},
        WallCase{"{ size = 0 }", "out-of-range 9:10"}, WallCase{"{ size = -32 }", "out-of-range 9:10"},
        WallCase{"{ texture = 'A 1,1', size = 32 }", "tile-and-size 9:13"},
        WallCase{"{ upper = 'A', up = 'A' }", "given-twice 9:16"},
        WallCase{"{ down = 'A', lower = 'A' }", "given-twice 9:15"},
        WallCase{"{ doom = { special = 1.5 } }", "wrong-type 9:22"},
        WallCase{"{ doom = { special = 99999999999 } }", "out-of-range 9:22"},
        WallCase{"{ doom = { kind = 1 } }", "unknown-key 9:12"}, WallCase{"{ doom = 1 }", "wrong-type 9:10"},
        WallCase{"{ '' = 1 }", "unknown-key 9:3"}, WallCase{"'brick'", "wrong-type 9:1"}));

struct TopCase {
    const char* line;
    const char* complaint;
};

void PrintTo(const TopCase& bad, std::ostream* out) { *out << bad.line; }

class BadTop : public testing::TestWithParam<TopCase> {};

// hard case T1
TEST_P(BadTop, IsReportedAtItsPlace) {
    EXPECT_THAT(codes_and_places(read_map(room("{}", GetParam().line)).findings), ElementsAre(GetParam().complaint));
}

INSTANTIATE_TEST_SUITE_P(
    Codes, BadTop,
    testing::Values(
        TopCase{"nmae = 'A'", "unknown-key 2:1"}, TopCase{"name = 1", "wrong-type 2:8"},
        TopCase{"textures = 'A'", "wrong-type 2:12"}, TopCase{"textures = ['A', 1]", "wrong-type 2:18"},
        TopCase{"player = { x = 1 }", "missing-key 2:10"},
        TopCase{"player = { x = 1, y = 1, yaw = 1, angle = 1 }", "yaw-and-angle 2:35"},
        TopCase{"player = { x = 1, y = 40000 }", "out-of-range 2:23"}, TopCase{"player = 1", "wrong-type 2:10"},
        TopCase{"render = { stretch = 0 }", "out-of-range 2:22"},
        TopCase{"render = { light = 'dim' }", "unknown-word 2:20"},
        TopCase{"render = { recursion_color = '#12345g' }", "bad-color 2:30"},
        TopCase{"render = { recursion_color = '#1234567' }", "bad-color 2:30"},
        TopCase{"render = { recursion_color = 16777216 }", "bad-color 2:30"},
        TopCase{"render = { max_depth = 1.0 }", "wrong-type 2:24"},
        TopCase{"render = { max_depth = -1 }", "out-of-range 2:24"},
        TopCase{"things = [{ y = 1 }]", "missing-key 2:11"},
        TopCase{"things = [{ x = 1, y = 1, rotations = 4 }]", "out-of-range 2:39"},
        TopCase{"things = [{ x = 1, y = 1, frames = [{}] }]", "missing-key 2:37"},
        TopCase{"things = [{ x = 1, y = 1, frames = [{ texture = 'A', origin = [1] }] }]", "wrong-type 2:63"},
        TopCase{"things = [{ x = 1, y = 1, frames = [{ texture = 'A', seconds = -1 }] }]", "out-of-range 2:64"},
        TopCase{"things = [{ x = 1, y = 1, skills = 3 }]", "wrong-type 2:36"},
        TopCase{"things = [{ x = 1, y = 1, skills = [3, 6] }]", "out-of-range 2:40"},
        TopCase{"things = [{ x = 1, y = 1, multiplayer = 1 }]", "wrong-type 2:41"},
        TopCase{"things = {}", "wrong-type 2:10"}));

TEST(ReadMap, ReadsTheSkillsAThingStandsAt) {
    const auto skills_of = [](const std::string& keys) {
        return read_map(room("{}", "things = [{ x = 1, y = 1" + keys + " }]")).map.things.at(0).skills;
    };
    EXPECT_EQ(skills_of(""), kAllSkills);
    EXPECT_EQ(skills_of(", skills = [1, 4, 1]"), 0b01001);
    EXPECT_EQ(skills_of(", skills = []"), 0);
}

TEST(ReadMap, ReadsAColourGivenAsANumber) {
    EXPECT_EQ(read_map(room("{}", "render = { recursion_color = 0x102030 }")).map.render.recursion_color, 0x102030u);
}

// hard case T16
TEST(ReadMap, WantsSectors) { EXPECT_THAT(codes_and_places(read_map("").findings), ElementsAre("missing-key 1:1")); }

// hard case T16
TEST(ReadMap, WantsALoopInASector) {
    EXPECT_THAT(codes_and_places(read_map("[[sectors]]\nname = 'A'\nloops = []").findings),
                ElementsAre("missing-key 3:9"));
}

// hard case T6
TEST(ReadMap, WantsVerticesAndWallsInALoop) {
    EXPECT_THAT(codes_and_places(read_map("[[sectors]]\nname = 'A'\n[[sectors.loops]]").findings),
                ElementsAre("missing-key 3:1", "missing-key 3:1"));
}

TEST(ReadMap, RefusesFormatsItDoesNotKnow) {
    EXPECT_THAT(codes_and_places(read_map("format = 2\nsectors = []").findings), ElementsAre("unknown-format 1:10"));
}

TEST(ReadMap, RefusesNewKeysInTutorialFiles) {
    EXPECT_THAT(codes_and_places(read_map("things = []\nsectors = []\n[player]\nx = 1\ny = 1\nyaw = 0").findings),
                ElementsAre("needs-format-1 1:1"));
}

/// A triangle with this number among its vertices.
MapReading with_coordinate(const std::string& number) {
    return read_map("[[sectors]]\nname = 'A'\nloops = [{ v = [" + number + ", 0, 1, 0, 1, 1], walls = [{}, {}, {}] }]");
}

// hard case T4
TEST(ReadMap, TakesWhatRoundsToTheEdgeOfTheWorld) {
    EXPECT_THAT(codes_and_places(with_coordinate("32768.0004").findings), IsEmpty());
}

// hard case T4
TEST(ReadMap, RefusesWhatLiesBeyondTheEdgeOfTheWorld) {
    EXPECT_THAT(codes_and_places(with_coordinate("-32768.001").findings), ElementsAre("out-of-range 3:17"));
}

TEST(ReadMap, BringsNumbersOutOfRangeIntoIt) {
    EXPECT_EQ(with_coordinate("1e300").map.sectors.at(0).loops.at(0).vertices.at(0).x, 32768 + 0x1p-11);
}

// hard case T6
TEST(ReadMap, GivesEveryLoopAsManyWallsAsVertices) {
    const MapReading reading =
        read_map("[[sectors]]\nname = 'A'\nloops = [{ v = [0, 0, 1, 0, 1, 1, 5], walls = [{}] }]");
    const LoopRecord loop = reading.map.sectors.at(0).loops.at(0);
    EXPECT_EQ(loop.vertices.size(), 3u);
    EXPECT_EQ(loop.walls.size(), 3u);
    EXPECT_EQ(loop.vertex_places.size(), 3u);
}

TEST(ReadMap, MakesUpAFewWallsOnly) {
    std::string text = "[[sectors]]\nname = 'A'\nloops = [{ v = [0";
    for (int i = 1; i < 20000; ++i) text += ", 0";
    const MapReading reading = read_map(text + "], walls = [{}, {}, {}] }]");
    EXPECT_THAT(codes_and_places(reading.findings), ElementsAre("walls-vertices-mismatch 3:60026"));
    EXPECT_EQ(reading.map.sectors.at(0).loops.at(0).walls.size(), 1027u);
    EXPECT_EQ(reading.map.sectors.at(0).loops.at(0).vertices.size(), 1027u);
}

TEST(ReadMap, StopsAfterAThousandFindings) {
    std::string text = "sectors = []\n";
    for (int i = 0; i < 5000; ++i) text += "key" + std::to_string(i) + " = 1\n";
    const auto findings = read_map(text).findings;
    ASSERT_EQ(findings.size(), kMaxFindings + 1);
    EXPECT_EQ(findings.back().code, "too-many-findings");
}

TEST(ReadMap, SuggestsTheActionThatIsCalledNearlySo) {
    const auto findings = read_map(room("{ triggers = [{ on = 'use', do = 'dor' }] }", "")).findings;
    ASSERT_EQ(findings.size(), 1u);
    EXPECT_THAT(findings[0].sentence, testing::EndsWith("found 'dor'; did you mean 'door'?"));
}

TEST(IsMap, KnowsAMapByItsSectors) {
    EXPECT_TRUE(is_map(kTutorial));
    EXPECT_TRUE(is_map("[[sectors]]\nnonsense = 1\n"));
    EXPECT_FALSE(is_map("map = 'm'\n[[legs]]\nwait = 1\n"));
    EXPECT_FALSE(is_map("[[sectors]"));
}

TEST(ReadMap, ShowsHostileKeysHarmlessly) {
    const auto findings = read_map("sectors = []\n\"\\u001b[31m" + std::string(1000, 'x') + "\" = 1").findings;
    ASSERT_EQ(findings.size(), 1u);
    EXPECT_THAT(findings[0].sentence, testing::StartsWith("a map has no key '?[31mxxx"));
    EXPECT_LT(std::ranges::count(findings[0].sentence, 'x'), 100);
}

TEST(ReadMap, SurvivesBeingCutAnywhere) {
    for_each_cut(kTutorial, [](std::string_view cut) { EXPECT_LE(read_map(cut).map.sectors.size(), 2u); });
}

constexpr std::string_view kEveryKind = R"(format = 1
[render]
light = "classic"
recursion_color = "#123456"
[[sectors]]
name = "a"
ceiling = { z = 3.5, texture = "T 1,1", parallax = true }
doom = { special = 1 }
[[sectors.loops]]
v = [0, 0, 1, 0, 1, 1]
walls = [{ name = "w", size = 32, upper = "T - 1,2" }, { mirror = true }, { next = "a", via = "w", rise = -1 }]
[[sectors.panels]]
v = [0, 0, 1, 1]
bottom = 0
top = 1
texture = "T"
[[things]]
x = 0.5
y = 0.25
frames = [{ texture = "T", seconds = 0.5, origin = [1, 2] }]
)";

TEST(ReadMap, HasNothingAgainstOneOfEveryKind) {
    EXPECT_THAT(codes_and_places(read_map(kEveryKind).findings), IsEmpty());
}

TEST(ReadMap, SurvivesEveryKindCutAnywhere) {
    for_each_cut(kEveryKind, [](std::string_view cut) { EXPECT_LE(read_map(cut).map.things.size(), 1u); });
}

TEST(ReadMap, SurvivesWrongBytesAnywhere) {
    const std::string text(kEveryKind);
    Random random(1);
    for (int i = 0; i < 2000; ++i) {
        std::string spoilt = text;
        for (int n = 0; n < 3; ++n) spoilt[random.below(text.size())] = static_cast<char>(random.below(256));
        read_map(spoilt);
    }
}

TEST(ReadMap, RefusesTextsThatAreTooLarge) {
    EXPECT_THAT(codes_and_places(read_map(std::string(kMaxMapBytes + 1, '\n')).findings), ElementsAre("too-large 0:0"));
}

/// So many sectors that several threads read them; each has a name of its own, and every thousandth a light too bright.
std::string many_sectors(int count) {
    std::string text = "format = 1\n";
    for (int i = 0; i < count; ++i)
        text.append("[[sectors]]\nname = 's")
            .append(std::to_string(i))
            .append("'\nloops = [{ v = [0, 0, 1, 0, 0, 1], walls = [{}, {}, {}] }]\nlight = ")
            .append(i % 1000 == 999 ? "2\n" : "1\n");
    return text;
}

TEST(ReadMap, KeepsTheOrderOfThousandsOfSectors) {
    const MapFile map = read_map(many_sectors(5000)).map;
    ASSERT_EQ(map.sectors.size(), 5000u);
    for (std::size_t i = 0; i < 5000; ++i) ASSERT_EQ(map.sectors[i].name, "s" + std::to_string(i));
}

TEST(ReadMap, FindsWhatIsWrongInAnyOfThousandsOfSectors) {
    Findings findings = read_map(many_sectors(5000)).findings;
    std::erase_if(findings, [](const Finding& finding) { return finding.code != "out-of-range"; });
    EXPECT_THAT(codes_and_places(findings),
                ElementsAre("out-of-range 4001:9", "out-of-range 8001:9", "out-of-range 12001:9",
                            "out-of-range 16001:9", "out-of-range 20001:9"));
}

TEST(ReadMap, NamesTheShortWordsThatAreMissing) {
    const auto sentence = [](const std::string& text) { return read_map(text).findings.at(0).sentence; };
    EXPECT_EQ(sentence("format = 1\n[[sectors]]\nname = 'a'\n"),
              "a sector needs 'rect', 'polygon' or [[sectors.loops]], found none");
    EXPECT_EQ(sentence("[[sectors]]\nname = 'a'\n"),
              "a sector needs 'loops', found none; in a file that says `format = 1` on its first line it may have a "
              "'rect' or 'polygon' instead");
    EXPECT_EQ(sentence("format = 1\n[[sectors]]\nname = 'a'\nrect = [0, 0, 1, 1]\n"),
              "expected 'wall', which all walls of the outline are like, or 'walls'; found neither");
    EXPECT_EQ(sentence("format = 1\n[[sectors]]\nname = 'a'\n[sectors]\nname = 'b'\n"),
              "not valid TOML: expected [[name]], as where the name stands before, found [name]; double the brackets: "
              "each [[name]] is one more of many");
}

TEST(ReadMap, DoesNotMissAShortWordThatIsMisspelt) {
    const std::string head = "format = 1\n[[sectors]]\nname = 'a'\n";
    EXPECT_THAT(codes_and_places(read_map(head + "rect = [0, 0, 1, 1]\nwal = {}\n").findings),
                ElementsAre("unknown-key 5:1"));
    EXPECT_THAT(codes_and_places(read_map(head + "rcet = [0, 0, 1, 1]\nwall = {}\n").findings),
                ElementsAre("unknown-key 4:1"));
}

TEST(ReadMap, SaysOnceThatTheFormatIsMissing) {
    EXPECT_THAT(codes_and_places(read_map("[[sectors]]\nname = 'a'\nrect = [0, 0, 1, 1]\nwall = {}\n[[sectors]]\n"
                                          "name = 'b'\nrect = [1, 0, 2, 1]\nwall = {}\n[[openings]]\n")
                                     .findings),
                ElementsAre("needs-format-1 3:1"));
}

TEST(ReadMap, DoesNotMissAKeyThatIsMisspelt) {
    EXPECT_THAT(codes_and_places(read_map("format = 1\n[[sectors]]\nnmae = 'a'\nloops = []\n").findings),
                ElementsAre("unknown-key 3:1", "missing-key 4:9"));
    EXPECT_THAT(
        codes_and_places(read_map("format = 1\n[[sectors]]\ncolour = 'a'\nrect = [0, 0, 1, 1]\nwall = {}\n").findings),
        ElementsAre("missing-key 2:1", "unknown-key 3:1"));
}

}  // namespace
}  // namespace enfilade
