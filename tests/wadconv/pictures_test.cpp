// Patches, composed textures, flats and sprites, down to the written files.
#include "wadconv/pictures.h"

#include <gmock/gmock.h>

#include <filesystem>

#include "support/temp_dir.h"
#include "wadconv/wad_builder.h"

namespace enfilade::wadconv {
namespace {

using namespace test;
using enfilade::test::TempDir;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Rows with '.' for holes and 'a' + n for palette number n.
std::vector<std::string> rows_of(const Picture& picture) {
    std::vector<std::string> rows(picture.height);
    for (std::uint32_t y = 0; y < picture.height; ++y)
        for (std::uint32_t x = 0; x < picture.width; ++x)
            rows[y] += picture.at(x, y) == kHole ? '.' : static_cast<char>('a' + picture.at(x, y));
    return rows;
}

std::vector<std::string> rows_of(const Result<Picture>& picture) {
    return picture.ok() ? rows_of(picture.value()) : std::vector<std::string>{picture.error().text()};
}

Bytes put(Bytes bytes, std::size_t at, int value) {
    bytes[at] = static_cast<std::byte>(value);
    return bytes;
}

TEST(ReadPatch, DrawsPostsAndLeavesHoles) {
    EXPECT_THAT(rows_of(read_patch(patch({"a.c", ".b.", "aa."}))), ElementsAre("a.c", ".b.", "aa."));
}

TEST(ReadPatch, KeepsTheOffsets) {
    const PatchHeader header = read_patch_header(patch({"ab"}, -3, 7)).value();
    EXPECT_EQ(header.left, -3);
    EXPECT_EQ(header.top, 7);
}

TEST(ReadPatch, CountsPostsThatDoNotGoDownFromTheOneBefore) {
    // One column of 300 rows: a post at row 200, then one that counts 99 from there.
    ByteWriter out;
    for (int field : {1, 300, 0, 0}) out.u16(static_cast<std::uint16_t>(field));
    out.u32(12);
    for (int byte : {200, 1, 0, 5, 0, 99, 1, 0, 6, 0, 255}) out.u8(static_cast<std::uint8_t>(byte));
    const Picture picture = read_patch(out.bytes()).value();
    EXPECT_EQ(picture.at(0, 200), 5);
    EXPECT_EQ(picture.at(0, 299), 6);
}

TEST(ReadPatch, NamesAColumnThatStartsOutside) {
    EXPECT_THAT(read_patch(put(patch({"ab"}), 13, 0x40)).error().what, HasSubstr("column 1 starts at byte"));
}

TEST(ReadPatch, NamesAColumnThatLeadsOutside) {
    EXPECT_THAT(read_patch(put(patch({"ab"}), 17, 200)).error().what, HasSubstr("column 0 leads out"));
}

TEST(ReadPatch, NamesAColumnWithoutEnd) {
    Bytes bytes = patch({"a"});
    bytes.pop_back();
    EXPECT_THAT(read_patch(bytes).error().what, HasSubstr("column 0 has no end"));
}

// hard case W12
TEST(ReadPatch, RefusesColumnsThatPaintForEver) {
    ByteWriter out;
    for (int field : {1, 1, 0, 0}) out.u16(static_cast<std::uint16_t>(field));
    out.u32(12);
    for (int i = 0; i < 100000; ++i) out.u32(0);  // posts without texels
    EXPECT_THAT(read_patch(out.bytes()).error().what, HasSubstr("more rows"));
}

TEST(ReadPatch, RefusesSizesBeyondTheLimit) {
    EXPECT_THAT(read_patch(put(patch({"ab"}), 1, 0x7F)).error().what, HasSubstr("texels a side"));
    EXPECT_THAT(read_patch(put(patch({"ab"}), 2, 0)).error().what, HasSubstr("texels a side"));
}

TEST(ReadPatch, SurvivesEveryTruncation) {
    const Bytes whole = patch({"ab.d", "ef.h"});
    for (std::size_t length = 0; length < whole.size(); ++length) {
        const Bytes cut(whole.begin(), whole.begin() + std::ptrdiff_t(length));
        EXPECT_FALSE(read_patch(cut).ok()) << length;
    }
}

/// A pile with one texture "TEX" of the given size and patches.
struct OneTexture {
    WadPile pile;
    OneTexture(int width, int height, const std::vector<PatchPlace>& places, const std::vector<Bytes>& patches)
        : pile(make(width, height, places, patches)) {}

    static WadPile make(int width, int height, const std::vector<PatchPlace>& places,
                        const std::vector<Bytes>& patches) {
        WadBuilder wad;
        std::vector<std::string> names;
        for (std::size_t i = 0; i < patches.size(); ++i) {
            names.push_back("P" + std::to_string(i));
            wad.add(names.back(), patches[i]);
        }
        wad.add("PNAMES", pnames(names));
        wad.add("TEXTURE1", texture_lump({{"TEX", width, height, places}}));
        return pile_of({wad.finish()});
    }

    Result<Picture> draw() const {
        const Result<std::vector<TextureDef>> defs = read_texture_defs(pile);
        if (!defs) return defs.error();
        return compose(defs.value()[0], pile);
    }
};

// hard case W12
TEST(Compose, DrawsLaterPatchesOverEarlierOnes) {
    const OneTexture t(3, 2, {{0, 0, 0}, {1, 0, 1}}, {patch({"aaa", "aaa"}), patch({"b.", ".b"})});
    EXPECT_THAT(rows_of(t.draw()), ElementsAre("aba", "aab"));
}

TEST(Compose, CutsPatchesAtTheTexturesEdges) {
    const OneTexture t(2, 2, {{-1, 1, 0}}, {patch({"abcd", "efgh"})});
    EXPECT_THAT(rows_of(t.draw()), ElementsAre("..", "bc"));
}

// hard case W12
TEST(Compose, LeavesHolesWhereNoPatchIs) {
    const OneTexture t(3, 1, {{1, 0, 0}}, {patch({"a"})});
    EXPECT_THAT(rows_of(t.draw()), ElementsAre(".a."));
}

TEST(Compose, HangsALonePatchFromTheTopAtMost) {
    const OneTexture t(1, 2, {{0, -1, 0}}, {patch({"a", "b", "c"})});
    EXPECT_THAT(rows_of(t.draw()), ElementsAre("a", "b"));
}

TEST(Compose, MovesPatchesDownThatBeginAboveTheTopOfSharedColumns) {
    const OneTexture t(1, 3, {{0, 0, 0}, {0, -1, 1}}, {patch({"x", "y", "z"}), patch({"a", "b", "c"})});
    EXPECT_THAT(rows_of(t.draw()), ElementsAre("a", "b", "z"));
}

TEST(Compose, NamesThePatchThatIsMissing) {
    WadBuilder wad;
    wad.add("PNAMES", pnames({"GONE"}));
    wad.add("TEXTURE1", texture_lump({{"TEX", 1, 1, {{0, 0, 0}}}}));
    const WadPile pile = pile_of({wad.finish()});
    EXPECT_THAT(compose(read_texture_defs(pile).value()[0], pile).error().text(), HasSubstr("patch GONE"));
}

TEST(ReadTextureDefs, RefusesAPatchNumberBeyondPnames) {
    EXPECT_THAT(OneTexture(1, 1, {{0, 0, 5}}, {patch({"a"})}).draw().error().what, HasSubstr("patch number 5"));
}

TEST(ReadTextureDefs, RefusesAnEmptyTexture) {
    EXPECT_THAT(OneTexture(0, 1, {}, {}).draw().error().what, HasSubstr("0 x 1"));
}

TEST(ReadTextureDefs, SurvivesEveryTruncation) {
    const Bytes whole = texture_lump({{"A", 1, 1, {{0, 0, 0}}}, {"B", 1, 1, {{0, 0, 0}}}});
    for (std::size_t length = 0; length < whole.size(); ++length) {
        WadBuilder wad;
        wad.add("PNAMES", pnames({"P"}));
        wad.add("TEXTURE1", Bytes(whole.begin(), whole.begin() + std::ptrdiff_t(length)));
        const WadPile pile = pile_of({wad.finish()});
        EXPECT_EQ(read_texture_defs(pile).ok(), false) << length;
    }
}

TEST(PictureName, IsSafeForFilesAndMaps) {
    EXPECT_EQ(picture_name("STARTAN3"), "startan3");
    EXPECT_EQ(picture_name("VILE\\1"), "vile^1");
    EXPECT_EQ(picture_name("A[B]-_"), "a[b]-_");
    EXPECT_EQ(picture_name("../X,?"), "%2e%2e%2fx%2c%3f");
}

TEST(SortSprites, KnowsMirroredViews) {
    const WadPile pile = pile_of({picture_wad().finish()});
    const SpriteFrames frames = sort_sprites(pile);
    const DoomSpriteFrame& frame = frames.at("POSSA");
    EXPECT_TRUE(frame.has_all_directions());
    EXPECT_EQ(frame.views[8].lump, frame.views[2].lump);
    EXPECT_TRUE(frame.views[8].is_mirrored);
    EXPECT_FALSE(frame.views[2].is_mirrored);
    EXPECT_FALSE(frames.at("BAR1A").has_all_directions());
}

/// A frame of two views; the rest is left out, so that only the first is drawn.
SpriteFrames frames_of(std::vector<std::pair<std::string, Bytes>> lumps, std::optional<WadPile>& pile) {
    WadBuilder wad;
    wad.add("S_START");
    for (auto& [name, bytes] : lumps) wad.add(name, std::move(bytes));
    wad.add("S_END");
    pile.emplace(pile_of({wad.finish()}));
    return sort_sprites(*pile);
}

TEST(DrawView, PutsTheThingsPositionOfAllViewsAtOneTexel) {
    std::optional<WadPile> pile;
    const SpriteFrames frames = frames_of({{"XXXXA1", patch({"a"}, 0, 1)},
                                           {"XXXXA2A8", patch({"bc", "de"}, 2, 1)},
                                           {"XXXXA3A7", patch({"f"})},
                                           {"XXXXA4A6", patch({"g"})},
                                           {"XXXXA5", patch({"h"})}},
                                          pile);
    const DoomSpriteFrame& frame = frames.at("XXXXA");
    const SpriteCanvas canvas = measure_frame(frame).value();
    ASSERT_TRUE(canvas.has_rotations);
    EXPECT_EQ(canvas.origin_x, 2);
    EXPECT_EQ(canvas.origin_y, 1);
    EXPECT_THAT(rows_of(draw_view(frame, canvas, 1)), ElementsAre("..a.", "...."));
    EXPECT_THAT(rows_of(draw_view(frame, canvas, 2)), ElementsAre("bc..", "de.."));
    EXPECT_THAT(rows_of(draw_view(frame, canvas, 8)), ElementsAre("..cb", "..ed"));
}

TEST(DrawView, ShowsAFrameWithoutAllDirectionsFromOne) {
    std::optional<WadPile> pile;
    const SpriteFrames frames = frames_of({{"XXXXA3", patch({"a"})}}, pile);
    const SpriteCanvas canvas = measure_frame(frames.at("XXXXA")).value();
    EXPECT_FALSE(canvas.has_rotations);
    EXPECT_THAT(rows_of(draw_view(frames.at("XXXXA"), canvas, 0)), ElementsAre("a"));
}

TEST(ToPng, KeepsColoursAndHoles) {
    Picture picture(3, 1);
    picture.at(0, 0) = 0;
    picture.at(2, 0) = 255;
    const Palette palette = read_palette(grey_palette()).value();
    const Image image = read_png(to_png(picture, palette)).value();
    EXPECT_THAT(image.pixels, ElementsAre(0xFF000000u, 0u, 0xFFFFFFFFu));
}

TEST(ToPng, HoldsAllColoursAndAHole) {
    Picture picture(257, 1);
    for (int i = 0; i < 256; ++i) picture.at(std::uint32_t(i), 0) = std::int16_t(i);
    const Image image = read_png(to_png(picture, read_palette(grey_palette()).value())).value();
    EXPECT_EQ(image.pixels[77], 0xFF4D4D4Du);
    EXPECT_EQ(image.pixels[256] >> 24, 0u);
}

TEST(MeasureColormap, FindsHowMuchLightEachLevelLeaves) {
    const Palette palette = read_palette(grey_palette()).value();
    const auto levels = measure_colormap(even_colormap(), palette).value();
    // Rounding down takes half a grey of 128 on average.
    for (int i = 0; i < 32; ++i) EXPECT_NEAR(levels[std::size_t(i)], (32 - i) / 32.0, 0.5 / 128) << i;
}

/// The pictures of picture_wad(), with the pile they look into.
struct Listed {
    WadPile pile = pile_of({picture_wad().finish()});
    Pictures pictures = Pictures::list(pile, {"POSSA", "BAR1A", "NONEA"}).value();
};

TEST(Pictures, HaveColormapAsAPictureOfAllColours) {
    const Listed l;
    const Picture table = l.pictures.color_table()->draw().value();
    EXPECT_EQ(std::pair(table.width, table.height), std::pair(256u, 33u));
    EXPECT_EQ(table.at(200, 0), 200);
    EXPECT_EQ(table.at(200, 1), 200);
    EXPECT_EQ(table.at(200, 1 + 16), 100);
    Texture texture;
    texture.width = table.width;
    texture.height = table.height;
    for (std::uint32_t x = 0; x < table.width; ++x)
        for (std::uint32_t y = 0; y < table.height; ++y)
            texture.pixels.push_back(l.pictures.palette()[std::size_t(table.at(x, y))]);
    EXPECT_TRUE(ColorTable::read(texture).ok());
    EXPECT_FALSE(color_table_picture(Bytes(8191)).ok());
}

TEST(Pictures, AreFoundByTheirNameInDoom) {
    const Listed l;
    EXPECT_EQ(l.pictures.wall("FENCE")->name, "fence");
    EXPECT_EQ(l.pictures.flat("FLOOR0_1")->name, "flats/floor0_1");
    EXPECT_EQ(l.pictures.wall("NONE"), nullptr);
    EXPECT_EQ(l.pictures.flat("WALL"), nullptr);
    EXPECT_TRUE(l.pictures.is_null_texture("AANULL"));
}

TEST(Pictures, OfferSpritesWithTheirOrigin) {
    const Listed l;
    const SpriteRecord* sprite = l.pictures.sprite("POSSA");
    ASSERT_NE(sprite, nullptr);
    EXPECT_EQ(sprite->name, "sprites/possa");
    EXPECT_TRUE(sprite->canvas.has_rotations);
    EXPECT_EQ(l.pictures.sprite("NONEA"), nullptr);
}

TEST(Pictures, NeedAPalette) {
    const WadPile pile = pile_of({WadBuilder().finish()});
    EXPECT_THAT(Pictures::list(pile, {}).error().what, HasSubstr("PLAYPAL"));
}

std::vector<std::string> files_below(const std::string& folder) {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.is_regular_file()) names.push_back(std::filesystem::relative(entry.path(), folder).string());
    std::ranges::sort(names);
    return names;
}

TEST(WritePictures, WritesEachIntoItsFolder) {
    const TempDir dir;
    const Listed l;
    EXPECT_THAT(write_pictures(l.pictures, dir.path(), 1, [](std::size_t) {}).value(), IsEmpty());
    EXPECT_THAT(files_below(dir.path()),
                ElementsAre("aanull.png", "color_table.png", "fence.png", "flats/ceil1_1.png", "flats/floor0_1.png",
                            "sky1.png", "sprites/bar1a.png", "sprites/possa1.png", "sprites/possa2.png",
                            "sprites/possa3.png", "sprites/possa4.png", "sprites/possa5.png", "sprites/possa6.png",
                            "sprites/possa7.png", "sprites/possa8.png", "sw1wall.png", "sw2wall.png", "wall.png"));
}

TEST(WritePictures, WritesTheSameBytesOnAnyNumberOfThreads) {
    const TempDir one, three;
    const Listed l;
    ASSERT_TRUE(write_pictures(l.pictures, one.path(), 1, [](std::size_t) {}).ok());
    ASSERT_TRUE(write_pictures(l.pictures, three.path(), 3, [](std::size_t) {}).ok());
    for (const std::string& file : files_below(one.path()))
        EXPECT_EQ(read_file(one.path(file)).value(), read_file(three.path(file)).value()) << file;
}

TEST(WritePictures, SaysWhatIsWrongAndWritesTheRest) {
    WadBuilder wad = picture_wad();
    wad.add("BARS", put(patch({"ab"}), 13, 0x40));
    const WadPile pile = pile_of({wad.finish()});
    const Pictures pictures = Pictures::list(pile, {}).value();
    const TempDir dir;
    const std::vector<Error> errors = write_pictures(pictures, dir.path(), 1, [](std::size_t) {}).value();
    ASSERT_EQ(errors.size(), 1u);
    EXPECT_THAT(errors[0].text(), HasSubstr("texture FENCE, patch BARS"));
    EXPECT_FALSE(std::filesystem::exists(dir.path("fence.png")));
    EXPECT_TRUE(std::filesystem::exists(dir.path("wall.png")));
}

TEST(WritePictures, FailsWhereOneCannotBeWritten) {
    const TempDir dir;
    const Listed l;
    std::filesystem::create_directories(dir.path("wall.png"));
    const auto problems = write_pictures(l.pictures, dir.path(), 1, [](std::size_t) {});
    ASSERT_FALSE(problems.ok());
    EXPECT_THAT(problems.error().text(), HasSubstr("wall.png: expected a file, found a folder"));
}

}  // namespace
}  // namespace enfilade::wadconv
