// Reading archives, sound and hostile, laying one over another, and finding the maps in them.
#include "wadconv/wad.h"

#include <gmock/gmock.h>

#include "wadconv/wad_builder.h"

namespace enfilade::wadconv {
namespace {

using namespace test;
using ::testing::ElementsAre;
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

// Finding maps, and refusing those in other formats.

/// A map with one more lump.
WadBuilder map_with(const std::string& lump) {
    WadBuilder wad;
    wad.add_map("MAP01", small_level().map);
    wad.add(lump, Bytes(4));
    return wad;
}

std::string error_of_map(const WadBuilder& wad) {
    const WadPile pile = pile_of({wad.finish()});
    const Result<MapLumps> map = find_map(pile, "MAP01");
    return map.ok() ? "" : map.error().text();
}

TEST(MapNames, AreThoseOfDoomAndDoomII) {
    for (const char* name : {"E1M1", "E4M9", "MAP01", "MAP32"}) EXPECT_TRUE(is_map_name(name)) << name;
    for (const char* name : {"E1M", "E1M10", "MAP1", "MAP001", "THINGS", "EAM1", "MAPXX"})
        EXPECT_FALSE(is_map_name(name)) << name;
}

TEST(MapNames, ComeInOrderOfAppearanceEachOnce) {
    WadBuilder below, above;
    for (const char* name : {"MAP02", "MAP01"}) below.add_map(name, {});
    for (const char* name : {"MAP01", "MAP03"}) above.add_map(name, {});
    EXPECT_THAT(map_names(pile_of({below.finish(), above.finish("PWAD")})), ElementsAre("MAP02", "MAP01", "MAP03"));
}

TEST(FindMap, TakesTheUpperArchives) {
    WadBuilder below, above;
    below.add_map("MAP01", small_level().map);
    above.add_map("MAP01", {});
    const WadPile pile = pile_of({below.finish(), above.finish("PWAD")});
    EXPECT_TRUE(find_map(pile, "MAP01").value().lines.empty());
}

TEST(FindMap, RefusesHexensFormatByName) { EXPECT_THAT(error_of_map(map_with("BEHAVIOR")), HasSubstr("Hexen")); }

TEST(FindMap, RefusesUdmfByName) { EXPECT_THAT(error_of_map(map_with("TEXTMAP")), HasSubstr("UDMF")); }

TEST(FindMap, LooksOnlyAtTheMapsOwnLumps) {
    WadBuilder wad = map_with("DEMO1");
    wad.add("BEHAVIOR");
    EXPECT_EQ(error_of_map(wad), "");
}

TEST(FindMap, NamesTheLumpThatIsMissing) {
    WadBuilder wad;
    wad.add("MAP01");
    for (const char* lump : {"THINGS", "LINEDEFS", "VERTEXES", "SECTORS"}) wad.add(lump);
    EXPECT_THAT(error_of_map(wad), HasSubstr("no SIDEDEFS lump"));
}

TEST(FindMap, NamesTheMapThatIsMissing) { EXPECT_THAT(error_of_map(WadBuilder()), HasSubstr("no map 'MAP01'")); }

TEST(DecodeMap, ReadsEveryFieldOfEveryRecord) {
    DoomMap map;
    map.vertices = {{-32768, 32767}};
    map.lines = {{1, 2, 3, 4, 5, 6, 7}};
    map.sides = {{-8, 9, "UPPER", "LOWER", "MIDDLE", 10}};
    map.sectors = {{-11, 12, "FLOOR", "CEILING", 255, 13, 14}};
    map.things = {{-15, 16, 270, 3004, 7}};
    WadBuilder wad;
    wad.add_map("E1M1", map);
    const WadPile pile = pile_of({wad.finish()});
    const DoomMap read = decode_map(find_map(pile, "E1M1").value()).value();
    EXPECT_EQ(read.name, "E1M1");
    EXPECT_EQ(read.vertices[0].x, -32768);
    EXPECT_EQ(read.vertices[0].y, 32767);
    const Linedef& l = read.lines[0];
    EXPECT_THAT((std::vector<int>{l.start, l.end, l.flags, l.special, l.tag, l.right, l.left}),
                ElementsAre(1, 2, 3, 4, 5, 6, 7));
    const Sidedef& s = read.sides[0];
    EXPECT_THAT((std::vector<int>{s.x_offset, s.y_offset, s.sector}), ElementsAre(-8, 9, 10));
    EXPECT_THAT((std::vector<std::string>{s.upper, s.lower, s.middle}), ElementsAre("UPPER", "LOWER", "MIDDLE"));
    const DoomSector& r = read.sectors[0];
    EXPECT_THAT((std::vector<int>{r.floor, r.ceiling, r.light, r.special, r.tag}), ElementsAre(-11, 12, 255, 13, 14));
    EXPECT_THAT((std::vector<std::string>{r.floor_flat, r.ceiling_flat}), ElementsAre("FLOOR", "CEILING"));
    const DoomThing& t = read.things[0];
    EXPECT_THAT((std::vector<int>{t.x, t.y, t.angle, t.type, t.flags}), ElementsAre(-15, 16, 270, 3004, 7));
}

TEST(DecodeMap, CountsBytesBehindTheLastWholeRecord) {
    const Bytes bytes(14 + 3);
    MapLumps lumps;
    lumps.lines = bytes;
    const DoomMap map = decode_map(lumps).value();
    EXPECT_EQ(map.lines.size(), 1u);
    EXPECT_EQ(map.trailing_bytes, 3u);
}

TEST(DecodeMap, RefusesMoreRecordsThanNumbersReach) {
    const Bytes bytes(4 * (kMaxRecords + 1));
    MapLumps lumps;
    lumps.vertices = bytes;
    EXPECT_THAT(decode_map(lumps).error().what, HasSubstr("VERTEXES"));
}

}  // namespace

}  // namespace enfilade::wadconv
