// A map with every key that no shipped map has: it is sound, and what its short words become is the same map.
#include <gmock/gmock.h>

#include "formats/findings.h"
#include "formats/map_toml.h"
#include "formats/png.h"
#include "map/load.h"

namespace enfilade {
namespace {

const std::string kFolder = ENFILADE_SOURCE_DIR "/tests/data/every_key/";

/// Its texts come from the disk; its pictures are a pixel, its table of colours one colour.
Result<Bytes> read_every_key(const std::string& path) {
    if (path.ends_with(".toml")) return read_file(path);
    constexpr std::uint32_t kRows = 33;
    if (path.ends_with("palette.png")) return write_png({1, kRows, std::vector<std::uint32_t>(kRows, 0xFF808080u)});
    return write_png({1, 1, {0xFF808080u}});
}

TEST(EveryKey, IsInASoundMap) {
    const LoadedMap loaded = load_map(kFolder + "map.toml", {}, read_every_key);
    for (const Finding& finding : loaded.findings) ADD_FAILURE() << to_text("map.toml", finding);
    EXPECT_TRUE(loaded.map);
}

TEST(EveryKey, IsTheSameWrittenOut) {
    const auto text = read_file(kFolder + "map.toml");
    const MapReading reading = read_map_at(kFolder + "map.toml", as_text(text.value()), read_every_key);
    const std::string expanded = write_map(reading.map);
    const MapReading again = read_map(expanded);
    EXPECT_THAT(codes_and_places(again.findings), testing::IsEmpty());
    EXPECT_EQ(write_map(again.map), expanded);
    EXPECT_EQ(again.map.sectors.size(), 8u);
}

}  // namespace
}  // namespace enfilade
