// Doom's maps as ours: how textures hang, what floors and skies become, what is kept.
#include <gmock/gmock.h>

#include "formats/map_toml.h"
#include "map/load.h"
#include "wadconv/converted.h"

namespace enfilade::wadconv {
namespace {

using namespace test;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

const WallRecord& front(const Converted& c) { return c.wall("s0", 64, 64); }
const WallRecord& back(const Converted& c) { return c.wall("s1", 64, 0); }

TEST(ConvertMap, PassesTheCheckWithoutAWord) {
    const Converted c(small_level());
    Findings findings;
    EXPECT_TRUE(build_map(c.file, c.pictures.sizes(), findings));
    for (const Finding& finding : findings) ADD_FAILURE() << finding.sentence;
}

// hard case W15
TEST(ConvertMap, KeepsEveryVertexExactlyThroughTheText) {
    Level level;
    level.sector();
    level.ring({{-32768, -32768}, {-32767, 32767}, {32767, 31}, {1, -1}}, 0);
    const Converted c(level);
    const MapReading back = read_map(write_map(c.file));
    EXPECT_THAT(back.findings, IsEmpty());
    std::vector<std::pair<double, double>> doom;
    for (const Vec2& v : back.map.sectors.at(0).loops.at(0).vertices) doom.emplace_back(v.x * 32, -v.y * 32);
    EXPECT_THAT(doom, ElementsAre(std::pair(-32768., -32768.), std::pair(-32767., 32767.), std::pair(32767., 31.),
                                  std::pair(1., -1.)));
}

TEST(ConvertMap, SaysItsScaleStretchAndLightOnce) {
    const Converted c(small_level());
    EXPECT_EQ(c.file.format, 1);
    EXPECT_EQ(c.file.size, 32);
    EXPECT_EQ(c.file.render.stretch, 1.2);
    EXPECT_EQ(c.file.render.light, LightModel::classic);
    EXPECT_EQ(c.file.render.sky, SkyRows::straight);
    EXPECT_EQ(c.file.render.rays, RayPoint::corner);
    EXPECT_EQ(c.file.render.things, ThingEdges::whole);
    EXPECT_EQ(c.file.render.color_table, "color_table");
}

TEST(ConvertMap, AccountsForEverySide) {
    const Converted c(small_level());
    EXPECT_TRUE(c.report.sides.is_complete());
    EXPECT_EQ(c.report.sides.panels, 4u);
}

/// A room whose walls have another picture than all that come after it.
Level level_before_doorway() {
    Level level;
    level.sector();
    level.box(256, 0, 320, 64, 0);
    for (Sidedef& side : level.map.sides) side.middle = "SW1WALL";
    level.thing(288, 32, 1);
    return level;
}

TEST(ConvertMap, ClosesTheDoorwaysIntoALostRoom) {
    Doorway doorway;
    doorway.level.map.lines.resize(4);
    doorway.level.line({64, 64}, {128, 0}, 1);
    doorway.level.line({128, 0}, {160, 96}, 1);
    doorway.level.line({160, 96}, {64, 0}, 1);
    for (const char* lower : {"WALL", "-"}) {
        doorway.right().lower = lower;
        doorway.right().upper = doorway.right().middle = "-";
        const Converted c(doorway.level);
        ASSERT_THAT(c.file.sectors, SizeIs(1));
        EXPECT_EQ(front(c).next, "");
        EXPECT_EQ(front(c).texture->name, c.wall("s0", 0, 0).texture->name);
        EXPECT_TRUE(c.report.sides.is_complete());
        Findings findings;
        EXPECT_TRUE(build_map(c.file, c.pictures.sizes(), findings));
        EXPECT_THAT(findings, IsEmpty());
    }
}

TEST(ConvertMap, ClosesDoorwaysWithAPictureOfTheirRoom) {
    Level level = level_before_doorway();
    const int here = level.sector(), lost = level.sector();
    level.line({64, 0}, {0, 0}, here);
    level.line({0, 0}, {0, 64}, here);
    level.line({0, 64}, {64, 64}, here);
    level.line({64, 64}, {64, 0}, here, lost);
    level.line({64, 64}, {128, 0}, lost);
    level.line({128, 0}, {160, 96}, lost);
    level.line({160, 96}, {64, 0}, lost);
    EXPECT_EQ(Converted(level).wall("s1", 64, 64).texture->name, "wall");
}

TEST(ConvertMap, ClosesDoorwaysOfARoomWithoutPicturesWithTheLevelsFirst) {
    Doorway doorway;
    doorway.level.map.lines.resize(4);
    for (Sidedef& side : doorway.level.map.sides) side.lower = side.upper = side.middle = "-";
    doorway.level.line({64, 64}, {128, 0}, 1);
    doorway.level.line({128, 0}, {160, 96}, 1);
    doorway.level.line({160, 96}, {64, 0}, 1);
    const Converted c(doorway.level);
    EXPECT_EQ(c.wall("s0", 0, 0).texture->name, "-");
    EXPECT_EQ(front(c).texture->name, "wall");
}

TEST(ConvertSectors, TakeHeightsLightAndFlats) {
    Level level = small_level();
    level.map.sectors[0].light = 128;
    const Converted c(level);
    EXPECT_EQ(c.file.sectors[1].floor.z, 0.5);
    EXPECT_EQ(c.file.sectors[1].ceiling.z, 3);
    EXPECT_EQ(c.file.sectors[0].light, 0.5);
    EXPECT_EQ(c.file.sectors[0].floor.texture->name, "flats/floor0_1");
    EXPECT_FALSE(c.file.sectors[0].floor.parallax);
}

TEST(ConvertSectors, BringLightIntoRange) {
    Level level = small_level();
    level.map.sectors[0].light = -1;
    level.map.sectors[1].light = 300;
    const Converted c(level);
    EXPECT_EQ(c.file.sectors[0].light, 0);
    EXPECT_EQ(c.file.sectors[1].light, 255 / 256.);
    EXPECT_THAT(c.noted(Kind::light_out_of_range), ElementsAre(0u, 1u));
}

TEST(ConvertSectors, HangTheSkyAsDoomDoes) {
    const FlatRecord sky = Converted(small_level()).file.sectors[1].ceiling;
    EXPECT_TRUE(sky.parallax);
    EXPECT_EQ(sky.texture->name, "sky1");
    EXPECT_EQ(sky.texture->tile_m, (Vec2{-256, 0.8}));  // four texels wide, 128 high
    EXPECT_EQ(sky.texture->offset_tx, (Vec2{0, 28}));
}

TEST(ConvertSectors, NoteFlatsThatAreNotThere) {
    Level level = small_level();
    level.map.sectors[0].floor_flat = "NONE";
    EXPECT_THAT(Converted(level).noted(Kind::unknown_flat), ElementsAre(0u));
}

// hard case W6
TEST(ConvertSectors, GiveEveryPartItsTagNatureAndGroup) {
    Level level;
    level.sector();
    level.map.sectors[0].special = 9;
    level.map.sectors[0].tag = 5;
    level.box(0, 0, 64, 64, 0);
    level.box(128, 0, 192, 64, 0);
    const Converted c(level);
    ASSERT_THAT(c.file.sectors, SizeIs(2));
    for (const SectorRecord& sector : c.file.sectors) {
        EXPECT_THAT(sector.tags, ElementsAre("tag 5"));
        EXPECT_TRUE(sector.secret);
    }
    EXPECT_EQ(c.file.sectors[1].name, "s0b");
    EXPECT_EQ(c.file.sectors[0].group, "s0");
    EXPECT_EQ(c.file.sectors[1].group, "s0");
    EXPECT_EQ(c.report.sector_specials.at(9), 1u);
}

// hard case W8
TEST(ConvertSectors, RaiseCeilingsThatAreBelowTheFloor) {
    const Converted c(Doorway(32, 16).level);
    EXPECT_EQ(c.file.sectors[1].floor.z, 1);
    EXPECT_EQ(c.file.sectors[1].ceiling.z, 1);
    EXPECT_THAT(c.noted(Kind::ceiling_below_floor), ElementsAre(1u));
}

TEST(ConvertWalls, HangASolidWallFromTheCeilingOrStandItOnTheFloor) {
    Doorway d;
    EXPECT_EQ(Converted(d.level).wall("s0", 0, 0).texture_peg, Peg::ceiling);
    d.level.map.lines[0].flags |= kLowerUnpegged;
    EXPECT_EQ(Converted(d.level).wall("s0", 0, 0).texture_peg, Peg::floor);
}

TEST(ConvertWalls, HangStepsAndMiddlesAtTheOpening) {
    const Converted c(Doorway().level);
    EXPECT_EQ(front(c).upper_peg, Peg::opening_top);
    EXPECT_EQ(front(c).lower_peg, Peg::opening_bottom);
    EXPECT_EQ(front(c).middle_peg, Peg::opening_top);
}

TEST(ConvertWalls, HangUnpeggedUpperStepsFromTheCeiling) {
    Doorway d;
    d.line().flags |= kUpperUnpegged;
    const Converted c(d.level);
    EXPECT_EQ(front(c).upper_peg, Peg::ceiling);
    EXPECT_EQ(front(c).lower_peg, Peg::opening_bottom);
}

TEST(ConvertWalls, HangUnpeggedLowerStepsFromTheCeilingAndStandMiddlesOnTheOpening) {
    Doorway d;
    d.line().flags |= kLowerUnpegged;
    const Converted c(d.level);
    EXPECT_EQ(front(c).upper_peg, Peg::opening_top);
    EXPECT_EQ(front(c).lower_peg, Peg::ceiling);
    EXPECT_EQ(front(c).middle_peg, Peg::opening_bottom);
}

TEST(ConvertWalls, MoveTexturesByDoomsOffsetsOfEitherSign) {
    Doorway d;
    d.right().x_offset = 5;
    d.right().y_offset = -7;
    const Converted c(d.level);
    EXPECT_EQ(front(c).upper->offset_tx, (Vec2{-5, 7}));
    EXPECT_EQ(front(c).middle->offset_tx, (Vec2{-5, 7}));
}

TEST(ConvertWalls, JoinBothSidesOfALine) {
    const Converted c(Doorway().level);
    EXPECT_EQ(front(c).next, "s1");
    EXPECT_EQ(back(c).next, "s0");
    EXPECT_EQ(c.report.portals, 2u);
}

// hard case W3
TEST(ConvertWalls, OpenStepsWithoutTexture) {
    Doorway d;
    d.right().upper = d.right().lower = "-";
    const Converted c(d.level);
    EXPECT_EQ(front(c).upper->name, "-");
    EXPECT_EQ(front(c).lower->name, "-");
    EXPECT_THAT(c.noted(Kind::missing_upper), ElementsAre(2u));
    EXPECT_THAT(c.noted(Kind::missing_lower), ElementsAre(2u));
}

TEST(ConvertWalls, NoteNoMissingTextureWhereThereIsNoStep) {
    const Converted c(Doorway(0, 128).level);
    EXPECT_THAT(c.noted(Kind::missing_upper), IsEmpty());
    EXPECT_THAT(c.noted(Kind::missing_lower), IsEmpty());
}

// hard case W4
TEST(ConvertWalls, OpenStepsBetweenTwoSkies) {
    const Converted c(Doorway(16, 96, "F_SKY1").level);
    EXPECT_EQ(front(c).upper->name, "-");
    EXPECT_THAT(c.noted(Kind::sky_step), ElementsAre(2u));
    EXPECT_THAT(c.noted(Kind::missing_upper), IsEmpty());
}

TEST(ConvertSectors, LetTheSkyHideWhatIsBehindAClosedOne) {
    Doorway d(128, 128, "F_SKY1");
    const FlatRecord floor = Converted(d.level).file.sectors[1].floor;
    EXPECT_TRUE(floor.parallax);
    EXPECT_EQ(floor.texture->name, "sky1");
    EXPECT_FALSE(Converted(Doorway(127, 128, "F_SKY1").level).file.sectors[1].floor.parallax) << "open";
    EXPECT_FALSE(Converted(Doorway(128, 128).level).file.sectors[1].floor.parallax) << "no sky";
    d.line().special = 1;
    EXPECT_FALSE(Converted(d.level).file.sectors[1].floor.parallax) << "a door";
    d.line().special = 0;
    d.level.map.sectors[1].tag = 3;
    EXPECT_FALSE(Converted(d.level).file.sectors[1].floor.parallax) << "with a tag";
}

// With two skies Doom counts from the ceiling beyond, here 32 units lower than the own one.
TEST(ConvertWalls, HangUnpeggedLowerStepsBetweenTwoSkiesFromTheCeilingBeyond) {
    Doorway d(16, 96, "F_SKY1");
    d.line().flags |= kLowerUnpegged;
    d.right().y_offset = 1;
    const Converted c(d.level);
    EXPECT_EQ(front(c).lower_peg, Peg::ceiling);
    EXPECT_EQ(front(c).lower->offset_tx.y, 31);
}

TEST(ConvertWalls, DrawNothingForDoomsFirstTexture) {
    Doorway d;
    d.right().middle = "AANULL";
    const Converted c(d.level);
    EXPECT_FALSE(front(c).middle);
    EXPECT_THAT(c.noted(Kind::null_texture), ElementsAre(2u));
}

TEST(ConvertWalls, NoteTexturesThatAreNotThere) {
    Doorway d;
    d.right().lower = "NONE";
    EXPECT_THAT(Converted(d.level).noted(Kind::unknown_texture), ElementsAre(2u));
}

TEST(ConvertWalls, ShowThePlaceholderOnSolidWallsWithoutTexture) {
    Doorway d;
    d.level.map.sides[0].middle = "-";
    const Converted c(d.level);
    EXPECT_EQ(c.wall("s0", 0, 0).texture->name, "-");
    EXPECT_THAT(c.noted(Kind::missing_middle), ElementsAre(0u));
}

TEST(ConvertWalls, NoteNoMissingTextureInClosedSectors) {
    Doorway d(0, 0);
    for (Sidedef& side : d.level.map.sides)
        if (side.sector == 1) side.middle = "-";
    EXPECT_THAT(Converted(d.level).noted(Kind::missing_middle), IsEmpty());
}

TEST(ConvertWalls, KeepASpecialWithoutWordsOnItsRightSide) {
    Doorway d;
    d.line().special = 126;
    d.line().tag = 4;
    const Converted c(d.level);
    EXPECT_EQ(front(c).doom, (DoomRecord{126, 4, 0}));
    EXPECT_FALSE(back(c).doom);
    EXPECT_EQ(c.report.lines_left.at(126), 1u);
}

TEST(ConvertWalls, KeepNoRecordOfPlainLines) {
    const Converted c(Doorway().level);
    EXPECT_FALSE(front(c).doom);
    EXPECT_FALSE(c.wall("s0", 0, 0).doom);
}

TEST(ConvertWalls, KeepFlagsThatSayMore) {
    Doorway d;
    constexpr std::uint16_t kSecret = 0x20;
    d.line().flags = kTwoSided | kBlocking | kSecret;
    EXPECT_EQ(front(Converted(d.level)).doom->flags, kSecret);
}

TEST(ConvertWalls, BlockWhereTheLineDoes) {
    Doorway d;
    EXPECT_FALSE(front(Converted(d.level)).blocks);
    d.line().flags = kTwoSided | kBlocking;
    EXPECT_TRUE(front(Converted(d.level)).blocks);
    EXPECT_TRUE(back(Converted(d.level)).blocks);
    EXPECT_FALSE(front(Converted(d.level)).doom);  // the wall itself says all that the line does
}

TEST(ConvertWalls, MakeUnmarkedLinesSolid) {
    Doorway d;
    d.line().flags = 0;
    const Converted c(d.level);
    EXPECT_EQ(front(c).next, "");
    EXPECT_EQ(front(c).texture->name, "wall");
}

/// The only panel of the map.
const PanelRecord& panel(const Converted& c, const std::string& texture) {
    for (const SectorRecord& sector : c.file.sectors)
        for (const PanelRecord& panel : sector.panels)
            if (panel.texture.name == texture) return panel;
    ADD_FAILURE() << "no panel with " << texture;
    return c.file.sectors.at(0).panels.at(0);
}

/// The line does something when it is crossed, and so is kept; but nobody knows how high its picture hangs.
TEST(ConvertPanels, ShowNothingOfASideWhoseSectorIsNotThere) {
    Level level;
    level.sector();
    level.box(0, 0, 256, 256, 0);
    const int line = level.line({64, 64}, {128, 64}, 0);
    level.map.sides[level.map.lines[line].right].sector = 60000;
    level.map.lines[line].special = 11;
    const Converted c(level);
    ASSERT_THAT(c.file.sectors.at(0).panels, ::testing::SizeIs(1));
    EXPECT_EQ(c.file.sectors[0].panels[0].texture.name, "-");
}

TEST(ConvertPanels, HangAFenceFromTheCeilingOnce) {
    const PanelRecord fence = panel(Converted(small_level()), "fence");
    EXPECT_EQ(fence.a, (Vec2{4, -4}));
    EXPECT_EQ(fence.b, (Vec2{6, -4}));
    EXPECT_EQ(fence.top, 4);
    EXPECT_EQ(fence.bottom, 4 - 4 / 32.);
}

TEST(ConvertPanels, StandAnUnpeggedFenceOnTheFloor) {
    Level level = small_level();
    Linedef& line = level.map.lines[11];
    line.flags |= kLowerUnpegged;
    level.map.sides[line.right].x_offset = 3;
    level.map.sides[line.right].y_offset = 8;
    const PanelRecord fence = panel(Converted(level), "fence");
    EXPECT_EQ(fence.bottom, 8 / 32.);
    EXPECT_EQ(fence.top, 12 / 32.);
    EXPECT_EQ(fence.texture.offset_tx, (Vec2{-3, 0}));
}

TEST(ConvertPanels, TurnAFenceThatOnlyTheLeftSideShows) {
    Level level = small_level();
    const Linedef& line = level.map.lines[11];
    std::swap(level.map.sides[line.right].middle, level.map.sides[line.left].middle);
    const PanelRecord fence = panel(Converted(level), "fence");
    EXPECT_EQ(fence.a, (Vec2{6, -4}));
    EXPECT_EQ(fence.b, (Vec2{4, -4}));
}

TEST(ConvertPanels, GiveEachSideItsPictureWhereTheyDiffer) {
    Level level = small_level();
    const Linedef& line = level.map.lines[11];
    level.map.sides[line.left].middle = level.map.sides[line.right].middle;
    level.map.sides[line.left].x_offset = 5;
    std::vector<PanelRecord> fences;
    const Converted c(level);
    for (const SectorRecord& sector : c.file.sectors)
        for (const PanelRecord& panel : sector.panels)
            if (panel.texture.name == "fence") fences.push_back(panel);
    ASSERT_EQ(fences.size(), 2u);
    EXPECT_TRUE(fences[0].one_sided && fences[1].one_sided);
    EXPECT_EQ(fences[0].a, fences[1].b);
    EXPECT_EQ(fences[0].b, fences[1].a);
    EXPECT_NE(fences[0].texture.offset_tx, fences[1].texture.offset_tx);
}

TEST(ConvertPanels, BlockWhereTheLineDoes) {
    Level level = small_level();
    EXPECT_FALSE(panel(Converted(level), "fence").blocks);
    for (const std::size_t line : {11u, 12u}) level.map.lines[line].flags |= kBlocking;
    const Converted c(level);
    EXPECT_TRUE(panel(c, "fence").blocks);
    EXPECT_FALSE(panel(c, "fence").doom);
    EXPECT_TRUE(panel(c, "-").blocks) << "without a picture, too";
}

TEST(ConvertPanels, BlockWhereALineDrawnOverAnotherDoes) {
    Doorway d;
    Linedef& over = d.level.map.lines[static_cast<std::size_t>(d.level.line({64, 64}, {64, 0}, 0, 1))];
    over.flags |= kBlocking;
    EXPECT_TRUE(panel(Converted(d.level), "-").blocks);
}

TEST(ConvertPanels, KeepWhatALineWithoutPictureMeans) {
    const Converted c(small_level());
    EXPECT_EQ(panel(c, "-").doom, (DoomRecord{97, 0, 0}));
    EXPECT_EQ(c.report.lines_left.at(97), 1u);
    EXPECT_THAT(c.noted(Kind::self_unseen), ElementsAre(12u));
}

// Freedoom MAP20 has fences that run through a column of another sector.
TEST(ConvertPanels, AreCutWhereTheyLeaveTheirSector) {
    Level level;
    level.sector();
    level.sector();
    level.box(0, 0, 128, 128, 0);
    level.box(48, 48, 80, 80, 1, 0);
    const int line = level.line({32, 64}, {96, 64}, 0, 0);
    level.map.sides[level.map.lines[static_cast<std::size_t>(line)].right].middle = "FENCE";
    const Converted c(level);
    ASSERT_THAT(c.file.sectors[0].panels, SizeIs(2));
    ASSERT_THAT(c.file.sectors[1].panels, SizeIs(1));
    EXPECT_EQ(c.file.sectors[1].panels[0].a, (Vec2{1.5, -2}));
    EXPECT_EQ(c.file.sectors[1].panels[0].b, (Vec2{2.5, -2}));
    EXPECT_EQ(c.file.sectors[1].panels[0].texture.offset_tx.x, -16);
}

TEST(ConvertPanels, DoWhatALineDrawnOverAnotherDoes) {
    Doorway d;
    d.level.map.lines[static_cast<std::size_t>(d.level.line({64, 64}, {64, 0}, 0, 1))].special = 52;
    const Converted c(d.level);
    ASSERT_THAT(panel(c, "-").triggers, SizeIs(1));
    EXPECT_EQ(panel(c, "-").triggers[0].action, TriggerAction::leave_map);
    EXPECT_FALSE(panel(c, "-").doom);
}

TEST(OpenDoors, RaiseTheSectorBehindAPushedDoor) {
    Doorway d(0, 0);
    d.line().special = 1;
    const Converted c(d.level, {.open_doors = true});
    EXPECT_EQ(c.file.sectors[1].ceiling.z, 124 / 32.);
    EXPECT_THAT(c.noted(Kind::opened_door), ElementsAre(1u));
}

TEST(OpenDoors, RaiseTheSectorsOfARemoteDoorsTag) {
    Doorway d(0, 0);
    d.level.map.lines[0].special = 103;
    d.level.map.lines[0].tag = d.level.map.sectors[1].tag = 7;
    EXPECT_EQ(Converted(d.level, {.open_doors = true}).file.sectors[1].ceiling.z, 124 / 32.);
}

TEST(OpenDoors, LeaveAloneWhatNoDoorOpens) {
    const Converted c(Doorway(0, 0).level, {.open_doors = true});
    EXPECT_EQ(c.file.sectors[1].ceiling.z, 0);
    EXPECT_THAT(c.noted(Kind::closed_door), ElementsAre(1u));
}

TEST(OpenDoors, OpenOnlyWhenAsked) {
    Doorway d(0, 0);
    d.line().special = 1;
    EXPECT_EQ(Converted(d.level).file.sectors[1].ceiling.z, 0);
}

TEST(ConvertMap, SaysWhyItRefuses) {
    DoomMap doom = Doorway().level.map;
    doom.lines.erase(doom.lines.begin(), doom.lines.begin() + 2);
    doom.lines.erase(doom.lines.begin() + 1);
    const WadPile pile = pile_of({picture_wad().finish()});
    const Conversion conversion = convert_map(doom, Pictures::list(pile, {}).value(), {}, {});
    EXPECT_FALSE(conversion.file);
    EXPECT_NE(conversion.report.refused, "");
}

}  // namespace
}  // namespace enfilade::wadconv
