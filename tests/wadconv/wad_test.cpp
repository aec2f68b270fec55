// Reading archives, sound and hostile, and laying one over another.
#include "wadconv/wad.h"

#include <gmock/gmock.h>

#include "wadconv/wad_builder.h"

namespace enfilade::wadconv {
namespace {

using namespace test;
using ::testing::HasSubstr;

Bytes text_bytes(std::string_view text) {
    ByteWriter out;
    out.text(text);
    return bytes_of(out);
}

/// A file with a header, a directory of one entry right behind it, and some bytes.
Bytes one_entry(std::uint32_t offset, std::uint32_t size, std::size_t more_bytes) {
    ByteWriter out;
    out.text("PWAD");
    out.u32(1);
    out.u32(12);
    out.u32(offset);
    out.u32(size);
    put_name(out, "LUMP");
    for (std::size_t i = 0; i < more_bytes; ++i) out.u8(0);
    return bytes_of(out);
}

std::string error_of(Bytes bytes) {
    const Result<Wad> wad = Wad::read("x.wad", std::move(bytes));
    return wad.ok() ? "" : wad.error().text();
}

TEST(LumpName, IsUpperCaseUpToTheFirstZero) {
    ByteWriter out;
    out.text("flat1");
    out.u8(0);
    out.text("xx");
    EXPECT_EQ(lump_name(out.bytes()), "FLAT1");
}

TEST(LumpName, HasAtMostEightCharacters) { EXPECT_EQ(lump_name(text_bytes("ABCDEFGHIJ")), "ABCDEFGH"); }

TEST(LumpName, ShowsWhatCannotBePrintedAsQuestionMarks) { EXPECT_EQ(lump_name(text_bytes("A \n\xFFz")), "A???Z"); }

TEST(Wad, KeepsLumpsInTheOrderOfTheDirectory) {
    WadBuilder builder;
    builder.add("ONE", text_bytes("1"));
    builder.add("TWO", text_bytes("22"));
    const Result<Wad> wad = Wad::read("x.wad", builder.finish());
    ASSERT_TRUE(wad.ok()) << wad.error().text();
    ASSERT_EQ(wad.value().lumps().size(), 2u);
    EXPECT_EQ(wad.value().lumps()[1].name, "TWO");
    EXPECT_EQ(as_text(wad.value().lumps()[1].bytes), "22");
}

TEST(Wad, RefusesWhatDoesNotStartWithItsMagic) { EXPECT_THAT(error_of(text_bytes("RIFFxxxxxxxx")), HasSubstr("IWAD")); }

TEST(Wad, RefusesADirectoryBehindTheEnd) {
    Bytes bytes = WadBuilder().finish();
    bytes[4] = std::byte{1};
    EXPECT_THAT(error_of(bytes), HasSubstr("directory"));
}

TEST(Wad, RefusesANegativeCount) {
    Bytes bytes = one_entry(28, 0, 0);
    bytes[7] = std::byte{0xFF};
    EXPECT_THAT(error_of(bytes), HasSubstr("directory"));
}

TEST(Wad, NamesALumpThatLeadsOutOfTheFile) { EXPECT_THAT(error_of(one_entry(28, 5, 4)), HasSubstr("lump 0 'LUMP'")); }

TEST(Wad, RefusesALumpBeforeTheFile) { EXPECT_NE(error_of(one_entry(0xFFFFFFF0u, 4, 4)), ""); }

TEST(Wad, RefusesALumpThatWouldWrapAround) { EXPECT_NE(error_of(one_entry(28, 0x7FFFFFFF, 4)), ""); }

TEST(Wad, TakesAnEmptyLumpWhereverItPoints) { EXPECT_EQ(error_of(one_entry(0xFFFFFFF0u, 0, 0)), ""); }

TEST(Wad, LetsLumpsOverlap) { EXPECT_EQ(error_of(one_entry(0, 28, 0)), ""); }

TEST(Wad, RefusesMoreLumpsThanAnyArchiveHas) {
    ByteWriter out;
    out.text("PWAD");
    out.u32(static_cast<std::uint32_t>(kMaxLumps + 1));
    out.u32(12);
    Bytes bytes = bytes_of(out);
    bytes.resize(12 + 16 * (kMaxLumps + 1));
    EXPECT_THAT(error_of(bytes), HasSubstr("at most"));
}

TEST(Wad, IsReadWholeOrNotAtAllWhereverItIsCut) {
    const Bytes whole = picture_wad().finish();
    for (std::size_t length = 0; length < whole.size(); ++length)
        ASSERT_FALSE(Wad::read("x.wad", Bytes(whole.begin(), whole.begin() + std::ptrdiff_t(length))).ok()) << length;
}

TEST(WadPile, PrefersTheUpperArchive) {
    WadBuilder below, above;
    below.add("LUMP", text_bytes("below"));
    above.add("LUMP", text_bytes("above"));
    EXPECT_EQ(as_text(pile_of({below.finish(), above.finish("PWAD")}).find("LUMP")->bytes), "above");
}

TEST(WadPile, PrefersTheLaterLumpOfAnArchive) {
    WadBuilder wad;
    wad.add("LUMP", text_bytes("first"));
    wad.add("LUMP", text_bytes("second"));
    EXPECT_EQ(as_text(pile_of({wad.finish()}).find("LUMP")->bytes), "second");
}

TEST(WadPile, KeepsFlatsApartFromOtherLumps) {
    WadBuilder wad;
    wad.add("STEP1", text_bytes("patch"));
    wad.add("F_START");
    wad.add("F1_START");
    wad.add("STEP1", text_bytes("flat"));
    wad.add("F1_END");
    wad.add("F_END");
    const WadPile pile = pile_of({wad.finish()});
    EXPECT_EQ(as_text(pile.find("STEP1")->bytes), "patch");
    ASSERT_EQ(pile.flats().size(), 1u);
    EXPECT_EQ(as_text(pile.flats().at("STEP1")->bytes), "flat");
}

TEST(WadPile, FindsSpritesBetweenDoubledMarkersToo) {
    WadBuilder wad;
    wad.add("SS_START");
    wad.add("POSSA1", text_bytes("x"));
    wad.add("SS_END");
    EXPECT_EQ(pile_of({wad.finish("PWAD")}).sprites().count("POSSA1"), 1u);
}

// Freedoom's textures SLAD10 and SLAD11 are made of the teleport fog.
TEST(WadPile, FindsSpritesWhereThereIsNoOtherLumpOfTheName) {
    WadBuilder wad;
    wad.add("S_START");
    wad.add("TFOGF0", text_bytes("sprite"));
    wad.add("S_END");
    EXPECT_EQ(as_text(pile_of({wad.finish()}).find("TFOGF0")->bytes), "sprite");
}

TEST(WadPile, HasNothingOfAnUnknownName) { EXPECT_EQ(pile_of({WadBuilder().finish()}).find("NONE"), nullptr); }

}  // namespace
}  // namespace enfilade::wadconv
