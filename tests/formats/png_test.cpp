// PNG files: pixels survive, and spoilt files give an error without taking memory.
#include "formats/png.h"

#include <gtest/gtest.h>

#include "base/hash.h"
#include "formats/hostile.h"

namespace enfilade {
namespace {

Image some_image(std::uint32_t width, std::uint32_t height) {
    Image image{width, height, {}};
    Random random(1);
    for (std::size_t i = 0; i < std::size_t{width} * height; ++i)
        image.pixels.push_back(static_cast<std::uint32_t>(random.bits()));
    return image;
}

Bytes with_u32(Bytes bytes, std::size_t at, std::uint32_t value) {
    for (std::size_t i = 0; i < 4; ++i) bytes.at(at + i) = static_cast<std::byte>(value >> (24 - 8 * i));
    return bytes;
}

/// The header's checksum, as the format wants it (CRC-32, ISO 3309).
std::uint32_t header_checksum(const Bytes& png) {
    std::uint32_t crc = ~0u;
    for (std::size_t i = 12; i < 29; ++i) {
        crc ^= static_cast<std::uint32_t>(png[i]);
        for (int bit = 0; bit < 8; ++bit) crc = crc & 1 ? crc >> 1 ^ 0xEDB88320u : crc >> 1;
    }
    return ~crc;
}

/// A small picture whose header says another size, with a checksum to match.
Bytes with_size(std::uint32_t width, std::uint32_t height) {
    Bytes png = with_u32(with_u32(write_png(some_image(3, 2)), 16, width), 20, height);
    return with_u32(png, 29, header_checksum(png));
}

TEST(Png, ReadsBackEveryPixel) {
    const Image image = some_image(7, 5);
    const auto back = read_png(write_png(image));
    ASSERT_TRUE(back.ok());
    EXPECT_EQ(back.value().width, 7u);
    EXPECT_EQ(back.value().height, 5u);
    EXPECT_EQ(back.value().pixels, image.pixels);
}

TEST(Png, GetsSmallerWithMoreEffort) {
    Image image{300, 200, std::vector<std::uint32_t>(300 * 200)};
    for (std::uint32_t i = 0; i < 300 * 200; ++i) image.pixels[i] = 0xFF000000u | i % 300 / 3 << 8 | i / 300;
    const Bytes small = write_png(image, PngEffort::smallest);
    EXPECT_LT(small.size(), write_png(image).size());
    EXPECT_EQ(read_png(small).value().pixels, image.pixels);
}

TEST(Png, GivesTheSameBytesAgain) { EXPECT_EQ(write_png(some_image(7, 5)), write_png(some_image(7, 5))); }

// The file ends in an empty chunk of 12 bytes, which pixels do not need.
TEST(Png, IsRefusedWhenCutBeforeItsEnd) {
    const Bytes whole = write_png(some_image(7, 5));
    constexpr std::size_t kEndChunk = 12;
    for_each_cut(whole, [&](std::span<const std::byte> cut) {
        EXPECT_TRUE(!read_png(cut).ok() || cut.size() + kEndChunk >= whole.size()) << cut.size() << " bytes";
    });
}

TEST(Png, SurvivesAWrongByteAnywhere) {
    const Bytes whole = write_png(some_image(7, 5));
    for (std::size_t i = 0; i < whole.size(); ++i)
        for (unsigned flip : {0x01u, 0x80u, 0xFFu}) {
            Bytes spoilt = whole;
            spoilt[i] ^= static_cast<std::byte>(flip);
            const auto image = read_png(spoilt);
            EXPECT_TRUE(!image.ok() ||
                        image.value().pixels.size() == std::size_t{image.value().width} * image.value().height);
        }
}

TEST(Png, IgnoresWhatFollowsTheEnd) {
    Bytes bytes = write_png(some_image(7, 5));
    bytes.push_back(std::byte{7});
    EXPECT_TRUE(read_png(bytes).ok());
}

TEST(Png, IsRefusedWithoutItsSignature) {
    Bytes bytes = write_png(some_image(1, 1));
    bytes[1] = std::byte{'X'};
    EXPECT_FALSE(read_png(bytes).ok());
}

TEST(Png, SaysWhatIsTooLarge) {
    const auto image = read_png(with_size(60000, 60000));
    ASSERT_FALSE(image.ok());
    EXPECT_EQ(image.error().what, "the image is 60000 x 60000 pixels; at most 16384 a side are read");
}

TEST(Png, TakesNoMemoryForPixelsThatAreNotThere) {
    const auto image = read_png(with_size(8192, 4096));
    ASSERT_FALSE(image.ok());
    EXPECT_EQ(image.error().what, "not a PNG image: 8192 x 4096 pixels are more than a file of this size can hold");
}

TEST(Png, SaysWhatHasTooManyPixels) {
    const auto image = read_png(with_size(8192, 4097));
    ASSERT_FALSE(image.ok());
    EXPECT_EQ(image.error().what, "the image is 8192 x 4097 pixels; at most 33554432 in all are read");
}

TEST(Png, ReadsAPictureThatPacksWell) {
    const auto image = read_png(write_png({1024, 1024, std::vector<std::uint32_t>(1024 * 1024, 0xFF000000u)}));
    ASSERT_TRUE(image.ok());
    EXPECT_EQ(image.value().pixels.back(), 0xFF000000u);
}

TEST(Png, IsRefusedWithNoPixels) { EXPECT_FALSE(read_png(with_size(0, 2)).ok()); }

TEST(Png, IsRefusedWithAWrongChecksum) { EXPECT_FALSE(read_png(with_u32(write_png(some_image(3, 2)), 29, 0)).ok()); }

TEST(Png, SurvivesChunksThatClaimToBeHuge) {
    EXPECT_FALSE(read_png(with_u32(write_png(some_image(3, 2)), 33, 0x7FFFFFFF)).ok());
}

// Who asks for its size before it is unpacked would be told another one.
TEST(Png, IsRefusedWhereAnythingIsBeforeItsHeader) {
    Bytes png = write_png(some_image(3, 2));
    const std::size_t begin = 8;                                                      // of the header
    const Bytes chunk = with_u32(with_u32(Bytes(12), 4, 0x616E676C), 8, 0xA0A1F5A2);  // "angl", and its sum
    png.insert(png.begin() + begin, chunk.begin(), chunk.end());
    const auto refused = read_png(png);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().what, "not a PNG image: expected the header (IHDR) as the first chunk");
    EXPECT_FALSE(png_size(png));
}

// libpng would take as much memory as the chunk says.
TEST(Png, IsRefusedForAChunkLongerThanTheFile) {
    Bytes png = write_png(some_image(3, 2));
    const std::size_t begin = 33;  // of the first chunk after the header
    const Bytes text = with_u32(with_u32(Bytes(12), 0, 0x7FFFFFFF), 4, 0x69545874);  // "iTXt"
    png.insert(png.begin() + begin, text.begin(), text.end());
    const std::uint32_t width_at = 16, too_wide = kMaxImageSide + 1;
    for (const Bytes& file : {png, with_u32(png, width_at, too_wide)}) {
        const auto refused = read_png(file);
        ASSERT_FALSE(refused.ok());
        EXPECT_EQ(refused.error().what,
                  "not a PNG image: a chunk of 2147483647 bytes begins at byte 33, but the file ends "
                  "after " +
                      std::to_string(png.size()));
    }
}

TEST(IndexedPng, KeepsColoursAndAlpha) {
    const IndexedImage image{3, 1, {2, 0, 1}, {0xFF030201u, 0x00000000u, 0xFFFFFFFFu}};
    EXPECT_EQ(read_png(write_indexed_png(image)).value().pixels, (std::vector{0xFFFFFFFFu, 0xFF030201u, 0u}));
}

TEST(IndexedPng, HoldsAFullPalette) {
    IndexedImage image{256, 1, {}, {}};
    for (std::uint32_t i = 0; i < 256; ++i) {
        image.pixels.push_back(static_cast<std::uint8_t>(i));
        image.palette.push_back(0xFF000000u | i * 0x010203u);
    }
    EXPECT_EQ(read_png(write_indexed_png(image)).value().pixels, image.palette);
}

}  // namespace
}  // namespace enfilade
