// What an author writes once: rectangles, polygons, walls of many, openings and prefabs become plain loops and sectors.
#include <gmock/gmock.h>

#include <cmath>
#include <map>

#include "formats/findings.h"
#include "formats/map_keys.h"
#include "formats/map_toml.h"
#include "formats/text_parts.h"

namespace enfilade {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

const std::string kTwoRooms = R"(format = 1
[[sectors]]
name = "hall"
rect = [0, 0,  4, 4]
wall = { texture = "brick" }
ceiling = { z = 3 }
[[sectors]]
name = "yard"
rect = [4.5, 0,  8, 4]
wall = { texture = "hedge" }
floor = { z = 0.5 }
ceiling = { z = 4 }
[[openings]]
between = ["hall", "yard"]
)";

/// The map that a text says, which has nothing wrong.
MapFile read_sound(const std::string& text) {
    MapReading reading = read_map(text);
    EXPECT_THAT(codes_and_places(reading.findings), IsEmpty()) << text;
    return std::move(reading.map);
}

std::string code_of(const std::string& text) {
    const MapReading reading = read_map(text);
    return reading.findings.empty() ? "none" : reading.findings.front().code;
}

/// "0,0 4,0 …"
std::string corners(const LoopRecord& loop) {
    std::string text;
    for (const Vec2& v : loop.vertices) text += (text.empty() ? "" : " ") + number_text(v.x) + "," + number_text(v.y);
    return text;
}

/// Who is behind each wall, "-" for nobody.
std::string behind(const LoopRecord& loop) {
    std::string text;
    for (const WallRecord& wall : loop.walls) text += (text.empty() ? "" : " ") + (wall.next.empty() ? "-" : wall.next);
    return text;
}

const SectorRecord& sector(const MapFile& map, const std::string& name) {
    for (const SectorRecord& record : map.sectors)
        if (record.name == name) return record;
    ADD_FAILURE() << "no sector " << name;
    return map.sectors.front();
}

TEST(Rect, IsAnOutlineClockwiseAndAHoleTheOtherWay) {
    const MapFile map = read_sound(R"(format = 1
[[sectors]]
name = "hall"
rect = [4, 3,  0, 0]
wall = { texture = "brick" }
[[sectors.loops]]
rect = [1, 1,  2, 2]
)");
    ASSERT_THAT(map.sectors[0].loops, SizeIs(2));
    EXPECT_EQ(corners(map.sectors[0].loops[0]), "0,0 4,0 4,3 0,3");
    EXPECT_EQ(corners(map.sectors[0].loops[1]), "1,2 2,2 2,1 1,1");
    for (const LoopRecord& loop : map.sectors[0].loops)
        for (const WallRecord& wall : loop.walls) EXPECT_EQ(wall.texture->name, "brick");
}

TEST(Polygon, LetsThePictureOfItsWallGoOnRoundTheCorners) {
    const MapFile map = read_sound(
        "format = 1\n[[sectors]]\nname = \"t\"\npolygon = { x = 0, y = 0, radius = 5, corners = 4 }\n"
        "wall = { texture = \"brick\" }\n[[sectors.loops]]\nrect = [-1, -1,  1, 1]\n");
    const std::vector<WallRecord>& walls = map.sectors[0].loops[0].walls;
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(walls[i].texture->moved_m().x, -i * 5 * std::sqrt(2), 1e-12);
    for (const WallRecord& wall : map.sectors[0].loops[1].walls) EXPECT_EQ(wall.texture->moved_m(), Vec2{});
}

TEST(Polygon, HasItsCornersOnTheGrid) {
    const MapFile map = read_sound(
        "format = 1\n[[sectors]]\nname = \"t\"\npolygon = { x = 1, y = 2, radius = 3, corners = 4 }\nwall = {}\n");
    EXPECT_EQ(corners(map.sectors[0].loops[0]), "4,2 1,5 -2,2 1,-1");
    const MapFile round = read_sound(
        "format = 1\n[[sectors]]\nname = \"t\"\npolygon = { x = 0, y = 0, radius = 1, corners = 7 }\nwall = {}\n");
    for (const Vec2& v : round.sectors[0].loops[0].vertices) EXPECT_EQ(v, snap_to_vertex_grid(v));
}

TEST(WallOfAll, StandsForThoseThatSayNothing) {
    const MapFile map = read_sound(R"(format = 1
[[sectors]]
name = "hall"
wall = { texture = "brick", peg = "floor" }
[[sectors.loops]]
v = [0, 0,  4, 0,  4, 3]
walls = [{}, { texture = "books" }, {}]
)");
    const std::vector<WallRecord>& walls = map.sectors[0].loops[0].walls;
    EXPECT_EQ(walls[0].texture->name, "brick");
    EXPECT_EQ(walls[1].texture->name, "books");
    EXPECT_EQ(walls[1].texture_peg, Peg::ceiling);
    EXPECT_EQ(walls[2].texture_peg, Peg::floor);
    EXPECT_EQ(walls[2].place.line, 7u) << "each wall has its own place";
}

TEST(Opening, CutsBothWallsWhereRoomsTouch) {
    std::string text = kTwoRooms;
    text.replace(text.find("4.5, 0"), 6, "4, -1");
    const MapFile map = read_sound(text + "at = [4, 2]\nwidth = 1\n");
    EXPECT_EQ(corners(map.sectors[0].loops[0]), "0,0 4,0 4,1.5 4,2.5 4,4 0,4");
    EXPECT_EQ(behind(map.sectors[0].loops[0]), "- - yard - - -");
    EXPECT_EQ(corners(map.sectors[1].loops[0]), "4,-1 8,-1 8,4 4,4 4,2.5 4,1.5");
    EXPECT_EQ(behind(map.sectors[1].loops[0]), "- - - - hall -");
    EXPECT_THAT(map.sectors, SizeIs(2));
}

TEST(Opening, TakesTheWholeStretchThatTouchesWithoutAWidth) {
    std::string text = kTwoRooms;
    text.replace(text.find("4.5, 0"), 6, "4, 1");
    const MapFile map = read_sound(text);
    EXPECT_EQ(corners(map.sectors[0].loops[0]), "0,0 4,0 4,1 4,4 0,4");
    EXPECT_EQ(behind(map.sectors[0].loops[0]), "- - yard - -");
    EXPECT_EQ(behind(map.sectors[1].loops[0]), "- - - hall");
}

TEST(Opening, BetweenRoomsApartMakesTheThicknessOfTheWall) {
    const MapFile map = read_sound(kTwoRooms + "width = 1\n");
    ASSERT_THAT(map.sectors, SizeIs(3));
    const SectorRecord& between = map.sectors[2];
    EXPECT_EQ(between.name, "hall-yard");
    EXPECT_EQ(corners(between.loops[0]), "4,2.5 4,1.5 4.5,1.5 4.5,2.5");
    EXPECT_EQ(behind(between.loops[0]), "hall - yard -");
    EXPECT_EQ(between.floor.z, 0.5);
    EXPECT_EQ(between.ceiling.z, 3);
    EXPECT_EQ(between.loops[0].walls[1].texture->name, "brick");
    EXPECT_EQ(behind(map.sectors[0].loops[0]), "- - hall-yard - - -");
    EXPECT_EQ(behind(map.sectors[1].loops[0]), "- - - - hall-yard -");
}

TEST(Opening, IsAWindow) {
    const MapFile map = read_sound(
        kTwoRooms + "width = 2\nbottom = 1\ntop = 2\nmiddle = \"bars\"\nblocks = true\ntexture = \"sill\"\n");
    const SectorRecord& window = map.sectors[2];
    EXPECT_EQ(window.floor.z, 1);
    EXPECT_EQ(window.ceiling.z, 2);
    EXPECT_EQ(window.loops[0].walls[1].texture->name, "sill");
    const WallRecord& from_hall = map.sectors[0].loops[0].walls[2];
    EXPECT_TRUE(from_hall.blocks);
    EXPECT_EQ(from_hall.middle->name, "bars");
    EXPECT_EQ(from_hall.texture->name, "brick") << "the room's own wall goes on above and below";
    EXPECT_EQ(from_hall.upper_peg, Peg::ceiling) << "and hangs as it did";
}

TEST(Opening, IsADoorInItsFrame) {
    const MapFile map = read_sound(kTwoRooms + "width = 1\ntop = 2\nleaf = \"oak 1,2\"\n");
    EXPECT_EQ(sector(map, "hall-yard 1").ceiling.z, 2);
    EXPECT_EQ(sector(map, "hall-yard 3").ceiling.z, 2);
    const SectorRecord& leaf = sector(map, "hall-yard");
    EXPECT_EQ(leaf.ceiling.z, leaf.floor.z) << "closed";
    ASSERT_THAT(leaf.triggers, SizeIs(1));
    EXPECT_EQ(leaf.triggers[0].action, TriggerAction::door);
    EXPECT_EQ(leaf.loops[0].walls[1].texture_peg, Peg::floor);
    EXPECT_EQ(sector(map, "hall-yard 1").loops[0].walls[2].upper->name, "oak");
    EXPECT_EQ(sector(map, "hall-yard 3").loops[0].walls[0].upper->name, "oak");
}

TEST(Opening, IsADoorAsHighAsTheRoom) {
    const MapFile map = read_sound(kTwoRooms + "width = 1\nleaf = \"oak 1,2\"\nname = \"gate\"\n");
    ASSERT_THAT(map.sectors, SizeIs(3));
    EXPECT_EQ(map.sectors[2].name, "gate");
    EXPECT_EQ(map.sectors[0].loops[0].walls[2].upper->name, "oak");
    EXPECT_EQ(map.sectors[0].loops[0].walls[2].upper_peg, Peg::opening_top);
}

TEST(Opening, IsStairs) {
    std::string text = kTwoRooms;
    text.replace(text.find("4.5, 0"), 6, "6, 0");
    text.replace(text.find("z = 0.5"), 7, "z = 2");
    text.replace(text.find("z = 4 "), 6, "z = 5 ");
    const MapFile map = read_sound(text + "width = 1\nsteps = 3\nname = \"stairs\"\n");
    ASSERT_THAT(map.sectors, SizeIs(5));
    for (int i = 1; i <= 3; ++i) {
        const SectorRecord& step = sector(map, "stairs " + std::to_string(i));
        EXPECT_EQ(step.floor.z, 0.5 * i);
        EXPECT_EQ(step.ceiling.z, 3 + 0.5 * i);
    }
    EXPECT_EQ(behind(sector(map, "stairs 2").loops[0]), "stairs 1 - stairs 3 -");
    const std::vector<WallRecord>&second = sector(map, "stairs 2").loops[0].walls,
          &last = sector(map, "stairs 3").loops[0].walls;
    EXPECT_EQ(second[1].texture->moved_m(), second[3].texture->moved_m()) << "in the middle: as far from either end";
    EXPECT_LT(last[1].texture->moved_m().x, second[1].texture->moved_m().x);
    EXPECT_EQ(last[3].texture->moved_m(), (Vec2{0, 1})) << "as much as its ceiling is higher than the first";
}

TEST(Opening, LeadsElsewhereThereAndBack) {
    const MapFile map = read_sound(kTwoRooms + "at = [0, 2]\nto = [8, 2]\nwidth = 1\nrise = 2\n");
    const WallRecord &there = map.sectors[0].loops[0].walls[4], &back = map.sectors[1].loops[0].walls[2];
    EXPECT_EQ(there.next, "yard");
    EXPECT_EQ(there.via, back.name);
    EXPECT_EQ(back.next, "hall");
    EXPECT_EQ(back.via, there.name);
    EXPECT_EQ(there.rise, 2);
    EXPECT_EQ(back.rise, -2);
    EXPECT_THAT(map.sectors, SizeIs(2));
}

TEST(Opening, LeadsElsewhereThroughADoorOutsideTheFirstRoom) {
    const MapFile map =
        read_sound(kTwoRooms + "at = [0, 2]\nto = [8, 2]\nwidth = 1\ndepth = 0.5\nleaf = \"oak 1,2\"\n");
    ASSERT_THAT(map.sectors, SizeIs(3));
    EXPECT_EQ(corners(map.sectors[2].loops[0]), "0,1.5 0,2.5 -0.5,2.5 -0.5,1.5");
    EXPECT_EQ(map.sectors[2].loops[0].walls[2].next, "yard");
    EXPECT_EQ(map.sectors[1].loops[0].walls[2].next, "hall-yard");
}

TEST(Opening, LeadsFromOneRoomIntoItself) {
    const MapFile map = read_sound(
        "format = 1\n[[sectors]]\nname = \"a\"\nrect = [0, 0,  4, 4]\nwall = {}\n"
        "[[openings]]\nbetween = [\"a\", \"a\"]\nat = [1, 0]\nto = [3, 0]\nwidth = 1\n");
    EXPECT_EQ(corners(map.sectors[0].loops[0]), "0,0 0.5,0 1.5,0 2.5,0 3.5,0 4,0 4,4 0,4");
    EXPECT_EQ(behind(map.sectors[0].loops[0]), "- a - a - - - -");
}

TEST(Opening, MayCutWhatAnotherLeft) {
    const MapFile map =
        read_sound(kTwoRooms + "at = [4, 1]\nwidth = 1\n[[openings]]\nbetween = [\"hall\", \"yard\"]\n" +
                   "at = [4, 3]\nwidth = 1\n");
    EXPECT_EQ(behind(map.sectors[0].loops[0]), "- - hall-yard - hall-yard (2) - - -");
}

TEST(Opening, LetsThePictureOfTheWallGoOnOverItAndBehindIt) {
    const MapFile map = read_sound(kTwoRooms + "at = [4, 1]\nwidth = 1\nupper = \"oak\"\n[[openings]]\n" +
                                   "between = [\"hall\", \"yard\"]\nat = [4, 3]\nwidth = 1\n");
    const std::vector<WallRecord>& walls = map.sectors[0].loops[0].walls;
    std::vector<std::string> pictures;
    for (std::size_t i = 1; i <= 5; ++i) pictures.push_back(to_text(*walls[i].texture));
    EXPECT_THAT(pictures,
                ElementsAre("brick", "brick - -0.5m,0m", "brick - -1.5m,0m", "brick - -2.5m,0m", "brick - -3.5m,0m"));
    EXPECT_EQ(to_text(*walls[2].upper), "oak") << "a picture of its own begins with the opening";
}

TEST(Sector, SaysWhereItsCornersAreWritten) {
    const auto findings = read_map("format = 1\n[[sectors]]\nname = \"a\"\nv = [0, 0,  4, 0,  4, 4]\n").findings;
    ASSERT_FALSE(findings.empty());
    EXPECT_EQ(findings.back().sentence, "a sector has no key 'v'; write it under a line [[sectors.loops]] of its own");
}

TEST(Opening, TellsWhatOfItLeadsNowhere) {
    EXPECT_THAT(codes_and_places(read_map(kTwoRooms + "width = 1\ntop = 3\nbottom = 0.5\n").findings), IsEmpty());
    EXPECT_THAT(codes_and_places(read_map(kTwoRooms + "width = 1\ntop = 3.5\n").findings),
                ElementsAre("opening-past-room 16:7"));
    EXPECT_THAT(codes_and_places(read_map(kTwoRooms + "width = 1\ntop = 3\nbottom = 0.25\n").findings),
                ElementsAre("opening-past-room 17:10"));
}

TEST(Opening, IsExactOnSlantingWallsWhereTheGridIs) {
    const std::string slanting = R"(format = 1
[[sectors]]
name = "a"
wall = {}
[[sectors.loops]]
v = [0, 0,  4, 3,  0, 6]
[[sectors]]
name = "b"
wall = {}
[[sectors.loops]]
v = [4, 3,  0, 0,  4, -3]
[[openings]]
between = ["a", "b"]
at = [2, 1.5]
)";
    const MapFile map = read_sound(slanting + "width = 2.5\n");
    EXPECT_EQ(corners(map.sectors[0].loops[0]), "0,0 1,0.75 3,2.25 4,3 0,6");
    EXPECT_EQ(code_of(slanting + "width = 1\n"), "opening-bends-wall");
}

TEST(Opening, NamesTheAuthorsLineForWhatItMakes) {
    const MapFile map = read_sound(kTwoRooms + "width = 1\n");
    EXPECT_EQ(map.sectors[2].place.line, 13u);
    EXPECT_EQ(map.sectors[2].loops[0].vertex_places[0].line, 13u);
    EXPECT_EQ(map.sectors[0].loops[0].walls[2].place.line, 13u);
    EXPECT_EQ(map.sectors[0].loops[0].walls[1].place.line, 5u);
}

TEST(Opening, WithAFaultBlamesNobodyElse) {
    const MapReading reading = read_map(kTwoRooms + "at = [1, 1]\nwidth = 1\nname = \"gate\"\n[[openings]]\n" +
                                        "between = [\"gate\", \"yard\"]\n");
    EXPECT_THAT(codes_and_places(reading.findings), ElementsAre("opening-off-wall 15:6"));
}

TEST(Opening, OffItsWallIsToldToMoveToWhereItFits) {
    const auto sentence = [](const std::string& opening) {
        return read_map(kTwoRooms + opening).findings.at(0).sentence;
    };
    EXPECT_THAT(sentence("at = [3.875, 0.25]\nwidth = 1\n"), HasSubstr("(4, 0) to (4, 4); move it to (4, 0.5)"));
    EXPECT_THAT(sentence("at = [4.25, 4]\nwidth = 1\n"), HasSubstr("(4, 0) to (4, 4); move it to (4, 3.5)"));
    EXPECT_THAT(sentence("at = [3.5, 2]\nwidth = 1\n"), HasSubstr("(4, 0) to (4, 4); move it to (4, 2)"));
    EXPECT_THAT(sentence("at = [1, 0.5]\nwidth = 1\n"), HasSubstr("(0, 0) to (4, 0); move it to (4, 0.5)"));
    EXPECT_THAT(sentence("at = [3.5, 2]\nwidth = 5\n"), Not(HasSubstr("move it")));
}

TEST(Opening, OffItsWallIsToldToMoveNowhereWhereTheOtherRoomIsFarAway) {
    const std::string rooms =
        "format = 1\n[[sectors]]\nname = \"hall\"\nrect = [0, 0,  4, 4]\nwall = {}\n[[sectors]]\n"
        "name = \"yard\"\nrect = [6.5, 0,  9, 4]\nwall = {}\n[[openings]]\n"
        "between = [\"hall\", \"yard\"]\nat = [3.5, 2]\nwidth = 1\n";
    const std::string sentence = read_map(rooms).findings.at(0).sentence;
    EXPECT_THAT(sentence, HasSubstr("; no free wall of it is close to one of sector 'yard' over that width"));
    EXPECT_THAT(sentence, Not(HasSubstr("move it to")));
}

TEST(Opening, OfRoomsThatOverlapSaysSo) {
    const auto sentence = [](const std::string& far, const std::string& more) {
        const std::string hall = "format = 1\n[[sectors]]\nname = \"hall\"\nrect = [0, 0,  4, 4]\nwall = {}\n";
        const std::string yard = "[[sectors]]\nname = \"yard\"\nrect = [" + far + "]\nwall = {}\n";
        const MapReading reading = read_map(hall + yard + "[[openings]]\nbetween = [\"hall\", \"yard\"]\n" + more);
        return reading.findings.empty() ? "" : reading.findings[0].sentence;
    };
    EXPECT_THAT(sentence("3.5, 1,  8, 3", "at = [4, 2]\nwidth = 1\n"),
                HasSubstr("lies inside sector 'yard': it and sector 'hall' overlap; move one of them, or"));
    EXPECT_THAT(sentence("3.5, 1,  8, 3", "width = 1\n"), HasSubstr("the two overlap, as at (4, 2); move one of them"));
    EXPECT_THAT(sentence("0, 3,  4, 8", "width = 1\n"), HasSubstr("the two overlap, as at (2, 4); move one of them"));
    EXPECT_THAT(sentence("4.5, 5,  8, 8", "width = 1\n"), HasSubstr("face each other over 1 m; give 'at' and 'to'"));
    EXPECT_THAT(sentence("4.5, 0,  8, 4", "at = [2, 0]\nwidth = 1\n"), HasSubstr("lies parallel before the opening"));
    EXPECT_EQ(sentence("4, 1,  8, 3", "width = 1\n"), "");
}

TEST(Opening, OfOneRoomOrThreeIsRefusedAndNotCut) {
    const std::string head = "format = 1\n[[sectors]]\nname = \"hall\"\nrect = [0, 0,  4, 4]\nwall = {}\n";
    for (const char* rooms : {"[]", "[\"hall\"]", "[\"hall\", \"hall\", \"hall\"]"}) {
        const std::string opening = std::string("[[openings]]\nbetween = ") + rooms + "\n";
        const MapReading reading = read_map(head + opening);
        EXPECT_THAT(codes_and_places(reading.findings), ElementsAre("wrong-type 7:11")) << rooms;
    }
}

// Prefabs.

FileReader files(std::map<std::string, std::string> texts) {
    return [texts = std::move(texts)](const std::string& name) -> Result<Bytes> {
        const auto found = texts.find(name);
        if (found == texts.end()) return Error{name, "no such file"};
        const auto bytes = std::as_bytes(std::span(found->second));
        return Bytes(bytes.begin(), bytes.end());
    };
}

const std::string kCell = R"(format = 1
[[sectors]]
name = "cell"
tags = ["all"]
rect = [0, 0,  2, 1]
wall = { texture = "brick" }
floor = { z = 1, scroll = [1, 0] }
triggers = [{ on = "enter", do = "light", target = ["all", "other"], light = 1 }]
[[things]]
name = "bed"
x = 1
y = 0.5
yaw = 10
)";

std::string placed(const std::string& how) {
    return "format = 1\n[[sectors]]\nname = \"hall\"\nrect = [90, 0,  94, 4]\nwall = {}\n[[prefabs]]\nname = "
           "\"left\"\nfile = \"cell.toml\"\n" +
           how;
}

TEST(Prefab, IsMovedTurnedRaisedAndCalledAfterItsPlace) {
    const MapReading reading = read_map(placed("at = [10, 20]\nturn = 90\nz = 3\n"), files({{"cell.toml", kCell}}));
    EXPECT_THAT(codes_and_places(reading.findings), IsEmpty());
    ASSERT_THAT(reading.map.sectors, SizeIs(2));
    const SectorRecord& cell = reading.map.sectors[1];
    EXPECT_EQ(cell.name, "left.cell");
    EXPECT_THAT(cell.tags, ElementsAre("left.all"));
    EXPECT_THAT(cell.triggers[0].targets, ElementsAre("left.all", "other"));
    EXPECT_EQ(corners(cell.loops[0]), "10,20 10,22 9,22 9,20");
    EXPECT_EQ(cell.floor.z, 4);
    EXPECT_EQ(cell.floor.scroll, (Vec2{0, 1}));
    EXPECT_EQ(reading.map.things[0].name, "left.bed");
    EXPECT_EQ(reading.map.things[0].position, (Vec2{9.5, 21}));
    EXPECT_EQ(reading.map.things[0].yaw_degrees, 100);
}

TEST(Prefab, TurnedByAnyAngleHasItsCornersOnTheGrid) {
    const MapReading reading = read_map(placed("turn = 30\n"), files({{"cell.toml", kCell}}));
    for (const Vec2& v : reading.map.sectors[1].loops[0].vertices) EXPECT_EQ(v, snap_to_vertex_grid(v));
}

TEST(Prefab, NamesItsOwnLines) {
    std::string wrong = kCell;
    wrong.replace(wrong.find("brick"), 5, "brick 2");
    MapReading reading = read_map(placed(""), files({{"cell.toml", wrong}}));
    ASSERT_THAT(reading.findings, SizeIs(1));
    tell_files(reading.findings, reading.sources);
    EXPECT_EQ(*reading.findings[0].file, "cell.toml");
    EXPECT_THAT(codes_and_places(reading.findings), ElementsAre("bad-texture-spec 6:20"));
}

TEST(Prefab, NamesItsOwnLinesWhereItIsNoToml) {
    MapReading reading = read_map(placed(""), files({{"cell.toml", "format = 1\nname ="}}));
    tell_files(reading.findings, reading.sources);
    ASSERT_FALSE(reading.findings.empty());
    EXPECT_EQ(*reading.findings[0].file, "cell.toml");
    EXPECT_EQ(reading.findings[0].place.line, 2u);
}

TEST(Prefab, MayHaveOpeningsAndPrefabsOfItsOwn) {
    const std::string two =
        "format = 1\nsectors = []\n[[prefabs]]\nname = \"a\"\nfile = \"cell.toml\"\n"
        "[[prefabs]]\nname = \"b\"\nfile = \"cell.toml\"\nat = [2.5, 0]\n"
        "[[openings]]\nbetween = [\"a.cell\", \"b.cell\"]\n";
    const MapReading reading = read_map("format = 1\nsectors = []\n[[prefabs]]\nname = \"x\"\nfile = \"two.toml\"\n",
                                        files({{"cell.toml", kCell}, {"two.toml", two}}));
    EXPECT_THAT(codes_and_places(reading.findings), IsEmpty());
    ASSERT_THAT(reading.map.sectors, SizeIs(3));
    EXPECT_EQ(reading.map.sectors[2].name, "x.a.cell-b.cell");
    EXPECT_EQ(behind(reading.map.sectors[0].loops[0]), "- x.a.cell-b.cell - -");
}

TEST(Prefab, MayNotStandInItselfByWhateverWay) {
    const auto other = [](const char* file) {
        return std::string("format = 1\nsectors = []\n[[prefabs]]\nname = \"n\"\nfile = \"") + file + "\"\n";
    };
    MapReading reading = read_map(other("a.toml"), files({{"a.toml", other("b.toml")}, {"b.toml", other("a.toml")}}));
    tell_files(reading.findings, reading.sources);
    ASSERT_FALSE(reading.findings.empty());
    EXPECT_EQ(reading.findings.back().code, "prefab-in-itself");
    EXPECT_EQ(*reading.findings.back().file, "b.toml");
    std::map<std::string, std::string> chain;
    for (int i = 0; i < 20; ++i) chain[std::to_string(i)] = other(std::to_string(i + 1).c_str());
    EXPECT_EQ(read_map(other("0"), files(chain)).findings.back().code, "prefab-in-itself");
}

}  // namespace
}  // namespace enfilade
