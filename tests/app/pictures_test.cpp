// Frames as picture files.
#include "app/pictures.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "support/temp_dir.h"

namespace enfilade {
namespace {

TEST(IdsImage, PutsTheHighByteIntoRed) {
    FrameFacts facts;
    facts.ids = {0x123456};
    EXPECT_EQ(ids_image(facts, 1, 1).pixels[0], 0xFF563412u);
}

TEST(NumberedPicture, CountsFromZeroWithSixDigits) {
    EXPECT_EQ(numbered_picture("out", 0), "out/000000.png");
    EXPECT_EQ(numbered_picture("out", 1234567), "out/1234567.png");
}

TEST(NamesPicture, TellsFilesFromFolders) {
    EXPECT_TRUE(names_picture("a/b.png"));
    EXPECT_TRUE(names_picture("B.PNG"));
    EXPECT_FALSE(names_picture("a.png/b"));
    EXPECT_FALSE(names_picture("png"));
}

TEST(MakeFolder, MakesThoseAboveToo) {
    const test::TempDir dir;
    EXPECT_TRUE(make_folder(dir.path("a/b/c")).ok());
    EXPECT_TRUE(std::filesystem::is_directory(dir.path("a/b/c")));
    EXPECT_TRUE(make_folder(dir.path("a/b/c")).ok());
}

TEST(MakeFolder, RefusesAPathThroughAFile) {
    const test::TempDir dir;
    ASSERT_TRUE(write_file(dir.path("file"), std::string_view("x")).ok());
    EXPECT_FALSE(make_folder(dir.path("file")).ok());
    EXPECT_FALSE(make_folder(dir.path("file/below")).ok());
}

}  // namespace
}  // namespace enfilade
