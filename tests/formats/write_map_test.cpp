// Maps as text: what is written reads back as the same records, and looks like something a person wrote.
#include <gmock/gmock.h>

#include "base/files.h"
#include "formats/findings.h"
#include "formats/map_toml.h"
#include "formats/random_map.h"

namespace enfilade {
namespace {

using testing::IsEmpty;

class WriteMapAtRandom : public testing::TestWithParam<int> {};

TEST_P(WriteMapAtRandom, ReadsBackAsTheSameRecords) {
    const MapFile map = RandomMap(static_cast<std::uint64_t>(GetParam())).map();
    const MapReading reading = read_map(write_map(map));
    EXPECT_THAT(codes_and_places(reading.findings), IsEmpty());
    EXPECT_TRUE(without_places(reading.map) == map) << write_map(map);
}

TEST_P(WriteMapAtRandom, GivesTheSameBytesAgain) {
    const std::string text = write_map(RandomMap(static_cast<std::uint64_t>(GetParam())).map());
    EXPECT_EQ(write_map(read_map(text).map), text);
}

INSTANTIATE_TEST_SUITE_P(Seeds, WriteMapAtRandom, testing::Range(0, 100));

TEST(WriteMap, TurnsATutorialFileIntoTheSameMap) {
    const auto bytes = read_file(ENFILADE_SOURCE_DIR "/maps/tutorial.toml");
    ASSERT_TRUE(bytes.ok());
    MapFile map = without_places(read_map(as_text(bytes.value())).map);
    ASSERT_EQ(map.format, 0);
    map.format = 1;
    EXPECT_TRUE(without_places(read_map(write_map(map)).map) == map);
}

TEST(WriteMap, LeavesOutWhatIsUsual) {
    MapFile map;
    map.sectors.resize(1);
    map.sectors[0].name = "main";
    EXPECT_EQ(write_map(map), "format = 1\n\n[[sectors]]\nname = \"main\"\n");
}

TEST(WriteMap, WritesEvenAMapWithoutSectorsSoThatItCanBeRead) {
    EXPECT_THAT(codes_and_places(read_map(write_map({})).findings), IsEmpty());
}

TEST(WriteMap, WritesACeilingAtZero) {
    MapFile map;
    map.sectors.resize(1);
    map.sectors[0].name = "main";
    map.sectors[0].ceiling.z = 0;
    EXPECT_EQ(write_map(map), "format = 1\n\n[[sectors]]\nname = \"main\"\nceiling = { z = 0 }\n");
}

TEST(WriteMap, WritesALoopAsAPersonWould) {
    MapFile map;
    map.sectors.resize(1);
    map.sectors[0].name = "main";
    LoopRecord& loop = map.sectors[0].loops.emplace_back();
    loop.vertices = {{0, 0}, {0.1, -0.0}, {1, 1}};
    loop.walls.resize(3);
    loop.walls[1].texture = TextureSpec{"BRICK", Vec2{2, 0.5}, {0, 8}, {}};
    loop.walls[2].next = "hall";
    loop.walls[2].via = "door \"B\"";
    EXPECT_EQ(write_map(map), R"(format = 1

[[sectors]]
name = "main"

[[sectors.loops]]
v = [0, 0,  0.1, 0,  1, 1]
walls = [
  {},
  { texture = "BRICK 2,0.5 0,8" },
  { next = "hall", via = "door \"B\"" },
]
)");
}

TEST(WriteMap, ReplacesBytesThatAreNotText) {
    MapFile map;
    map.name = "a\xFFz";
    EXPECT_EQ(write_map(map), "format = 1\nname = \"a\\uFFFDz\"\nsectors = []\n");
}

}  // namespace
}  // namespace enfilade
