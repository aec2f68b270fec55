// Any bytes at all: a sentence or a map, never a crash, a hang or a map that the check would refuse unheard.
#include <gmock/gmock.h>

#include "base/hash.h"
#include "wadconv/convert.h"
#include "wadconv/digest.h"
#include "wadconv/wad_builder.h"

namespace enfilade::wadconv {
namespace {

using namespace test;

/// Where in a file with the directory first its entries are.
constexpr std::size_t kEntriesAt = 12, kEntryBytes = 16, kSizeAt = 4;

WadBuilder whole_wad() {
    WadBuilder wad = picture_wad();
    wad.add_map("MAP01", small_level().map);
    return wad;
}

Bytes cut(const Bytes& bytes, std::size_t length) {
    return Bytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(length));
}

void put_u32(Bytes& bytes, std::size_t at, std::uint32_t value) {
    for (std::size_t i = 0; i < 4; ++i) bytes.at(at + i) = static_cast<std::byte>(value >> (8 * i));
}

TEST(HostileWad, IsFineWhenItIsNot) {
    const Outcome outcome = digest({whole_wad().finish_directory_first()});
    EXPECT_EQ(outcome.error, "");
    EXPECT_EQ(outcome.maps, 1u);
    EXPECT_TRUE(outcome.has_all_sides);
    EXPECT_EQ(outcome.pictures, 27u);
}

TEST(HostileWad, IsRefusedWhenCutAtAnyLump) {
    const WadBuilder wad = whole_wad();
    const Bytes first = wad.finish_directory_first(), last = wad.finish();
    const std::vector<std::size_t> starts = wad.boundaries();
    const std::size_t directory = first.size() - starts.back();
    for (std::size_t start : starts) {
        EXPECT_NE(digest({cut(last, start)}).error, "") << start;
        if (start != starts.back()) {
            EXPECT_NE(digest({cut(first, start + directory)}).error, "") << start;
        }
    }
}

TEST(HostileWad, IsRefusedWhenCutAnywhere) {
    const Bytes whole = whole_wad().finish_directory_first();
    Random random(1);
    for (int i = 0; i < 2000; ++i) {
        const std::size_t length = random.below(whole.size());
        EXPECT_NE(digest({cut(whole, length)}).error, "") << length;
    }
}

TEST(HostileWad, SurvivesLumpsThatEndEarly) {
    const Bytes whole = whole_wad().finish_directory_first();
    const std::size_t lumps = std::to_integer<std::size_t>(whole[4]);
    for (std::size_t lump = 0; lump < lumps; ++lump) {
        const std::size_t at = kEntriesAt + kEntryBytes * lump + kSizeAt;
        const std::uint32_t size = ByteReader(std::span(whole).subspan(at)).u32();
        for (std::uint32_t parts = 0; parts < 16; ++parts) {
            Bytes spoilt = whole;
            put_u32(spoilt, at, size * parts / 16);
            digest({std::move(spoilt)});
        }
    }
}

TEST(HostileWad, SurvivesLumpsThatOverlap) {
    const Bytes whole = whole_wad().finish_directory_first();
    const std::size_t lumps = std::to_integer<std::size_t>(whole[4]);
    Random random(2);
    for (int i = 0; i < 150; ++i) {
        Bytes spoilt = whole;
        const std::size_t at = kEntriesAt + kEntryBytes * random.below(lumps);
        const auto offset = static_cast<std::uint32_t>(random.below(whole.size()));
        put_u32(spoilt, at, offset);
        put_u32(spoilt, at + kSizeAt, static_cast<std::uint32_t>(random.below(whole.size() - offset)));
        digest({std::move(spoilt)});
    }
}

TEST(HostileWad, SurvivesWrongBytesAnywhere) {
    const Bytes whole = whole_wad().finish_directory_first();
    for (std::uint64_t trial = 0; trial < 1000; ++trial) {
        Random random(trial);
        Bytes spoilt = whole;
        for (std::uint64_t count = 1 + random.below(8); count > 0; --count)
            spoilt[random.below(spoilt.size())] = static_cast<std::byte>(random.below(256));
        digest({std::move(spoilt)});
    }
}

// hard cases W5, W8
TEST(HostileWad, SurvivesExtremeNumbersInEveryFieldOfAMap) {
    const WadBuilder wad = whole_wad();
    const Bytes whole = wad.finish_directory_first();
    const std::vector<std::size_t> starts = wad.boundaries();
    const std::size_t directory = whole.size() - starts.back();
    // The map's lumps are the last five.
    for (std::size_t at = starts[starts.size() - 6] + directory; at + 1 < whole.size(); at += 2)
        for (unsigned value : {0x0000, 0x7FFF, 0x8000, 0xFFFF}) {
            Bytes spoilt = whole;
            spoilt[at] = static_cast<std::byte>(value);
            spoilt[at + 1] = static_cast<std::byte>(value >> 8);
            digest({std::move(spoilt)});
        }
}

TEST(HostileWad, RefusesMoreThingsAndSidesThanCanBePlaced) {
    Level level;
    level.sector();
    level.box(0, 0, 64, 64, 0);
    level.map.things.resize(60000);
    // Boxes within boxes, by turns outlines and holes: 40000 sides in every one of which every thing would have to be
    // looked for.
    level.map.lines.clear();
    level.map.vertices.clear();
    const auto put = [&](int x, int y) { level.map.vertices.push_back({std::int16_t(x), std::int16_t(y)}); };
    for (int i = 0; i < 9999; ++i) {
        put(-i - 1, -i - 1), put(-i - 1, i + 1), put(i + 1, i + 1), put(i + 1, -i - 1);
        for (int k = 0; k < 4; ++k)
            level.map.lines.push_back({static_cast<std::uint16_t>(4 * i + (i % 2 ? 3 - k : k)),
                                       static_cast<std::uint16_t>(4 * i + (i % 2 ? (6 - k) % 4 : (k + 1) % 4)),
                                       kBlocking, 0, 0, 0, kNoSide});
    }
    const WadPile pile = pile_of({picture_wad().finish()});
    const Conversion conversion = convert_map(level.map, Pictures::list(pile, {}).value(), {}, {});
    EXPECT_THAT(conversion.report.refused, ::testing::HasSubstr("too many together"));
}

}  // namespace
}  // namespace enfilade::wadconv
