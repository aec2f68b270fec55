// The pictures of a map: one for each file, however its name is written, and no more of them than there is room for.
#include "map/textures.h"

#include <gmock/gmock.h>

#include "formats/png.h"
#include "support/count_allocations.h"
#include "support/map_builder.h"

namespace enfilade {
namespace {

using namespace test;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A room with an animation of these pictures.
MapFile map_with(std::vector<std::string> names) {
    MapFile file = map_of({box_room("hall", 0, 0, 4, 4)});
    file.sectors[0].floor.texture = file.sectors[0].ceiling.texture = spec("-");
    for (WallRecord& wall : file.sectors[0].loops[0].walls) wall.texture = spec("-");
    file.animations.push_back({std::move(names), 1, {7, 1}});
    return file;
}

/// A file whose header promises a picture of this size. Its pixels are missing.
Bytes header_of(std::uint32_t width, std::uint32_t height) {
    Bytes bytes = write_png({1, 1, {0xFF808080u}});
    constexpr std::size_t kWidthAt = 16, kHeightAt = 20;
    for (std::size_t i = 0; i < 4; ++i) {
        bytes[kWidthAt + i] = static_cast<std::byte>(width >> (24 - 8 * i));
        bytes[kHeightAt + i] = static_cast<std::byte>(height >> (24 - 8 * i));
    }
    return bytes;
}

std::vector<std::string> names_of(const TextureSet& set) {
    std::vector<std::string> names;
    for (const Texture& texture : set.textures) names.push_back(texture.name);
    return names;
}

TEST(Textures, AreOnePictureHoweverTheirNameIsWritten) {
    std::vector<std::string> asked_for;
    const FileReader read = [&](const std::string& path) -> Result<Bytes> {
        asked_for.push_back(path);
        return write_png({1, 1, {0xFF808080u}});
    };
    Findings findings;
    const TextureSet set = load_textures(map_with({"b", "B", "a/b", "A/b", "a/B"}), {"pictures"}, read, findings);
    EXPECT_THAT(names_of(set), ElementsAre("a/b", "b"));
    EXPECT_THAT(asked_for, ElementsAre("pictures/a/b.png", "pictures/b.png"));
    EXPECT_EQ(set.find("B"), set.find("b"));
    EXPECT_EQ(set.find("A/b"), set.find("a/b"));
    EXPECT_TRUE(set.find("b") && set.find("a/b"));
}

/// A room with two pictures and a color table, which is the picture given.
TextureSet with_color_table(const Image& table, Findings& findings) {
    MapFile file = map_with({"plain", "foreign"});
    file.render.color_table = "Colors";
    const FileReader read = [&](const std::string& path) -> Result<Bytes> {
        if (path == "pictures/Colors.png") return write_png(table);
        const std::uint32_t second = path.ends_with("/plain.png") ? 0x00123456u : 0xFF000003u;
        return write_png({3, 1, {0xFF000002u, second, 0x80000001u}});
    };
    return load_textures(file, {"pictures"}, read, findings);
}

TEST(Textures, HaveTheNumbersOfTheirColorsInTheColorTable) {
    Image table{4, 33, std::vector<std::uint32_t>(std::size_t{4} * 33, 0xFF000000u)};
    for (std::uint32_t x = 0; x < 3; ++x) table.pixels[x] = 0xFF000000u | x;
    table.pixels[3] = 0xFF000002u;
    Findings findings;
    const TextureSet set = with_color_table(table, findings);
    EXPECT_EQ(text_of(findings), "");
    EXPECT_FALSE(set.color_table.is_empty());
    EXPECT_THAT(set[set.find("plain")].numbers, ElementsAre(2, 0, 1));
    EXPECT_THAT(set[set.find("foreign")].numbers, ElementsAre());
}

TEST(Textures, SayWhatIsWrongWithAColorTable) {
    const auto complaint_about = [](const Image& table) {
        Findings findings;
        EXPECT_TRUE(with_color_table(table, findings).color_table.is_empty());
        return text_of(findings);
    };
    const auto image = [](std::uint32_t width, std::uint32_t height, std::uint32_t pixel) {
        return Image{width, height, std::vector<std::uint32_t>(std::size_t{width} * height, pixel)};
    };
    EXPECT_THAT(complaint_about(image(257, 33, 0xFF000000u)), HasSubstr("found 257 x 33"));
    EXPECT_THAT(complaint_about(image(256, 32, 0xFF000000u)), HasSubstr("found 256 x 32"));
    EXPECT_THAT(complaint_about(image(256, 33, 0x80000000u)), HasSubstr("with holes"));
}

TEST(Textures, TogetherFillNoMoreThanTheirBudget) {
    const FileReader read = [](const std::string&) -> Result<Bytes> { return header_of(8192, 4096); };
    const auto complaint_about = [&](std::vector<std::string> names) {
        TextureLoader loader(pictures_needed(map_with(std::move(names))), {"pictures"}, read);
        Findings findings;
        loader.take(findings);
        return findings;
    };
    EXPECT_TRUE(complaint_about({"a", "b", "c"}).empty());
    const Findings found = complaint_about({"e", "d", "c", "b", "a"});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].code, "too-many-pictures");
    EXPECT_EQ(found[0].place, (TextPlace{7, 1}));
    EXPECT_THAT(found[0].sentence, HasSubstr("at most 512 MiB of memory together, found 640 MiB, and 'd' ("));
}

TEST(Textures, ThatAreOverTheirBudgetTakeNoMemory) {
    constexpr std::size_t kFile = std::size_t{30} << 20;
    const FileReader read = [](const std::string&) -> Result<Bytes> {
        Bytes bytes = header_of(8192, 4096);
        bytes.resize(kFile);
        return bytes;
    };
    const MapFile file = map_with({"a", "b", "c", "d", "e", "f"});
    const std::size_t before = restart_peak();
    const TextureLoader loader(pictures_needed(file), {"pictures"}, read);
    EXPECT_LT(peak_bytes() - before, 5 * kFile);  // three that fit, one that is looked at
}

}  // namespace
}  // namespace enfilade
