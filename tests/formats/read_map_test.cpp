// What the reader makes of maps: records of both dialects, and every complaint with the place it belongs to.
#include <gmock/gmock.h>

#include "formats/findings.h"
#include "formats/map_toml.h"

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
    EXPECT_EQ(wall.next_place, (TextPlace{9, 10}));
    EXPECT_EQ(wall.via_place, (TextPlace{9, 24}));
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
    EXPECT_THAT(
        codes_and_places(findings),
        ElementsAre("missing-key 1:1", "unknown-key 2:1", "out-of-range 3:9", "bad-number 5:5", "bad-texture-spec 6:11",
                    "odd-vertices 8:5", "out-of-range 8:21", "walls-vertices-mismatch 9:9", "wrong-type 9:23",
                    "given-twice 9:43", "wrong-type 9:55", "bad-number 11:5", "wrong-type 12:5", "wrong-type 13:5"));
}

TEST(ReadMap, NamesTheNearestKnownKey) {
    const auto findings = read_map(room("{ textrue = \"A\" }")).findings;
    ASSERT_EQ(findings.size(), 1u);
    EXPECT_EQ(findings[0].sentence, "a wall has no key 'textrue'; did you mean 'texture'?");
}

}  // namespace
}  // namespace enfilade
