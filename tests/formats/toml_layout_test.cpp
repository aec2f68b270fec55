// Maps laid out anew: the same values, the same comments, the same again.
#include <gmock/gmock.h>

#include "base/files.h"
#include "formats/map_toml.h"
#include "formats/random_map.h"
#include "formats/toml.h"

namespace enfilade {
namespace {

std::string laid_out(const std::string& text) {
    auto result = lay_out_toml(text);
    return result.ok() ? std::move(result).value() : "refused: " + result.error().what;
}

std::string text_in(const std::string& path) {
    const auto bytes = read_file(path);
    return bytes.ok() ? std::string(as_text(bytes.value())) : "";
}

/// The comments of a text that has no '#' in strings.
std::vector<std::string> comments_of(const std::string& text) {
    std::vector<std::string> comments;
    for (std::size_t at = text.find('#'); at != std::string::npos; at = text.find('#', at)) {
        const std::size_t end = text.find('\n', at);
        std::string comment = text.substr(at, end - at);
        while (comment.ends_with(' ')) comment.pop_back();
        comments.push_back(comment);
        at = std::min(end, text.size());
    }
    return comments;
}

TEST(Layout, PutsBlanksAndLinesWhereTheyBelong) {
    EXPECT_EQ(laid_out("\n\n# about all\nformat=1   # one\nname='x'\n\n\n\n# a room\n[[ sectors ]]\nname  =\"a\"#what\n"
                       "floor={z=0,texture='b' }\nempty={ }\n[sectors.ceiling]\nz=1_000.5\n\n"),
              "# about all\nformat = 1  # one\nname = 'x'\n\n# a room\n[[sectors]]\nname = \"a\"  #what\n"
              "floor = { z = 0, texture = 'b' }\nempty = {}\n\n[sectors.ceiling]\nz = 1_000.5\n");
}

TEST(Layout, SetsCornersApart) {
    EXPECT_EQ(laid_out("v=[0,0,4,0,4,3]\nrect=[0,0,1,1]\nscroll=[0,1]\n"),
              "v = [0, 0,  4, 0,  4, 3]\nrect = [0, 0,  1, 1]\nscroll = [0, 1]\n");
}

TEST(Layout, KeepsTheLinesOfArrays) {
    EXPECT_EQ(
        laid_out("walls=[ {a=1},{}, # both\n\n\n   # alone  \n{a=[1,2]} # long\n, {b=2}\n]\nnext=[\n[1,\n2],[]]\n"),
        "walls = [{ a = 1 }, {},  # both\n\n  # alone\n  { a = [1, 2] },  # long\n  { b = 2 },\n]\n"
        "next = [\n  [1,\n    2,\n  ], [],\n]\n");
}

TEST(Layout, SetsCommentsBelowOneAnother) {
    EXPECT_EQ(laid_out("a = 1 # x\nlonger = 2  # y\nb = 3\nc = 4     # z\n"),
              "a = 1       # x\nlonger = 2  # y\nb = 3\nc = 4  # z\n");
}

TEST(Layout, LeavesStringsAndTimesAsTheyAre) {
    const std::string text =
        "a = \"# no \\\" comment\"\nb = '[ , ]'\nc = \"\"\"\n  kept   \n\"\"\"\nd = 1979-05-27 07:32:00Z\n"
        "\"key with = \" = '''a''b'''\ne.f = 0x1F\n";
    EXPECT_EQ(laid_out(text), text);
}

TEST(Layout, EndsLinesInOneWay) { EXPECT_EQ(laid_out("a = 1\r\n\r\n\r\nb = 2"), "a = 1\n\nb = 2\n"); }

TEST(Layout, RefusesWhatIsNoToml) { EXPECT_THAT(laid_out("a = \n"), testing::StartsWith("refused: ")); }

class LayoutOfMaps : public testing::TestWithParam<std::string> {};

TEST_P(LayoutOfMaps, KeepsValuesAndCommentsAndIsTheSameAgain) {
    const std::string path = ENFILADE_SOURCE_DIR "/maps/" + GetParam(), text = text_in(path);
    const std::string once = laid_out(text);
    EXPECT_EQ(laid_out(once), once);
    EXPECT_EQ(comments_of(once), comments_of(text));
    EXPECT_EQ(write_map(read_map(once).map), write_map(read_map(text).map));
}

std::vector<std::string> shipped() {
    std::vector<std::string> names;
    for (const std::string& name : list_folder(ENFILADE_SOURCE_DIR "/maps"))
        if (name.ends_with(".toml")) names.push_back(name);
    return names;
}

INSTANTIATE_TEST_SUITE_P(All, LayoutOfMaps, testing::ValuesIn(shipped()));

TEST(Layout, OfWhatTheProgramsWriteKeepsValues) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const std::string text = write_map(RandomMap(seed).map()), once = laid_out(text);
        EXPECT_EQ(write_map(read_map(once).map), text);
        EXPECT_EQ(laid_out(once), once);
    }
}

}  // namespace
}  // namespace enfilade
