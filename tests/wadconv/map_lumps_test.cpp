// Finding maps, and refusing those in other formats.
#include "wadconv/wad.h"

#include <gmock/gmock.h>

#include "wadconv/wad_builder.h"

namespace enfilade::wadconv {
namespace {

using namespace test;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

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
