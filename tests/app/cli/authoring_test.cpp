// The commands for authors of maps, from outside: new, expand, fmt, draw; and what is said about a line that is wrong.
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <regex>

#include "app/cli/program.h"
#include "formats/map_toml.h"
#include "support/shipped_maps.h"

namespace enfilade {
namespace {

using test::Ended;
using test::Program;
using test::shipped_maps;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

const std::string kMaps = ENFILADE_SOURCE_DIR "/maps/";
const std::string kLodge = kMaps + "lodge.toml";

std::string text_in(const std::string& path) {
    const auto bytes = read_file(path);
    return bytes.ok() ? std::string(as_text(bytes.value())) : "";
}

/// What the reader makes of a map in maps/, but for the places.
std::string meaning_of(const std::string& path) {
    return write_map(read_map(text_in(path), [](const std::string& name) { return read_file(kMaps + name); }).map);
}

TEST(New, WritesASoundMapAndOverwritesNothing) {
    const Program program;
    const Ended ended = program.run({"new", "mine"});
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    EXPECT_THAT(ended.out, HasSubstr("enfilade play mine.toml"));
    const Ended checked = program.run({"check", "mine.toml"});
    EXPECT_EQ(checked.out, "1 map checked, 0 refused: 0 errors, 0 warnings\n") << "its pictures are found, too";
    program.write("mine.toml", "changed");
    for (const char* name : {"mine", "mine.toml"}) {
        const Ended again = program.run({"new", name});
        EXPECT_EQ(again.exit_code, 1);
        EXPECT_THAT(again.err, HasSubstr("mine.toml: there is such a file already"));
    }
    EXPECT_EQ(program.text("mine.toml"), "changed");
    EXPECT_EQ(program.run({"new", "no/such/folder/mine"}).exit_code, 1);
}

TEST(New, IsLaidOutAsFmtWouldAndDrawn) {
    const Program program;
    ASSERT_EQ(program.run({"new", "a \"b\"/../my \"map\""}).exit_code, 1);
    ASSERT_EQ(program.run({"new", "my \"map\""}).exit_code, 0);
    EXPECT_EQ(program.run({"fmt", "--check", "my \"map\".toml"}).exit_code, 0);
    EXPECT_EQ(program.run({"render", "my \"map\".toml", "--out", "a.png", "--size", "32x20"}).exit_code, 0);
}

TEST(Expand, GivesTheSameMapOfEveryMapThatCame) {
    const Program program;
    for (const std::string& path : shipped_maps()) {
        const Ended ended = program.run({"expand", path});
        ASSERT_EQ(ended.exit_code, 0) << path << ended.err;
        const MapReading again = read_map(ended.out);
        EXPECT_FALSE(has_errors(again.findings)) << path;
        EXPECT_EQ(ended.out, meaning_of(path)) << path;
        EXPECT_EQ(write_map(again.map), ended.out) << path;
        EXPECT_THAT(ended.out, Not(HasSubstr("[[openings]]"))) << path;
    }
}

TEST(Expand, DrawsTheSamePicture) {
    const Program program;
    const std::string expanded = program.path("expanded.toml"), pictures = kMaps + "textures";
    ASSERT_EQ(program.run({"expand", kLodge, "--out", expanded}).exit_code, 0);
    for (const std::string& map : {kLodge, expanded}) {
        const std::string out = map == kLodge ? "a.png" : "b.png";
        ASSERT_EQ(program.run({"render", map, "--textures", pictures, "--size", "160x100", "--out", out}).exit_code, 0);
    }
    EXPECT_EQ(program.text("a.png"), program.text("b.png"));
}

TEST(Expand, PutsPrefabsIn) {
    const Program program;
    program.write("prefabs/cell.toml", "format = 1\n[[sectors]]\nname = \"cell\"\nrect = [0, 0,  2, 2]\nwall = {}\n");
    program.write("map.toml",
                  "format = 1\nsectors = []\n[[prefabs]]\nname = \"a\"\nfile = \"prefabs/cell.toml\"\nat = [5, 5]\n");
    const Ended ended = program.run({"expand", "map.toml"});
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    EXPECT_THAT(ended.out, HasSubstr("name = \"a.cell\""));
    EXPECT_THAT(ended.out, HasSubstr("v = [5, 5,  7, 5,  7, 7,  5, 7]"));
}

TEST(Expand, RefusesWhatIsWrongAndWritesNothing) {
    const Program program;
    program.write("map.toml", "format = 1\n[[sectors]]\nname = 7\nrect = [0, 0,  2, 2]\nwall = {}\n");
    const Ended ended = program.run({"expand", "map.toml", "--out", "out.toml"});
    EXPECT_EQ(ended.exit_code, 1);
    EXPECT_EQ(ended.err,
              "map.toml:3:8: error: 'name' must be a string, found a whole number [wrong-type]\n  3 | name = 7\n"
              "    |        ^\n");
    EXPECT_FALSE(program.exists("out.toml"));
    EXPECT_EQ(program.run({"expand", "missing.toml"}).exit_code, 1);
}

TEST(Fmt, LaysOutAndTellsWhatItChanged) {
    const Program program;
    program.write("map.toml", "format=1 # one\nsectors=[]\n");
    const Ended checked = program.run({"fmt", "--check", "map.toml"});
    EXPECT_EQ(checked.exit_code, 1);
    EXPECT_EQ(checked.out, "map.toml\n1 map looked at, 1 would be laid out anew\n");
    EXPECT_EQ(program.text("map.toml"), "format=1 # one\nsectors=[]\n");
    EXPECT_EQ(program.run({"fmt", "map.toml"}).exit_code, 0);
    EXPECT_EQ(program.text("map.toml"), "format = 1  # one\nsectors = []\n");
    EXPECT_EQ(program.run({"fmt", "map.toml"}).out, "1 map looked at, 0 laid out anew\n");
    EXPECT_EQ(program.run({"fmt", "--check", "map.toml"}).exit_code, 0);
    EXPECT_EQ(program.hidden_files(), 0u);
}

TEST(Fmt, LeavesWhatItCannotRead) {
    const Program program;
    program.write("map.toml", "sectors = [\n");
    const Ended ended = program.run({"fmt", "map.toml"});
    EXPECT_EQ(ended.exit_code, 1);
    EXPECT_THAT(ended.err, StartsWith("enfilade: map.toml: "));
    EXPECT_EQ(program.text("map.toml"), "sectors = [\n");
}

TEST(New, SaysHowAShellOpensAMapWithABlankInItsName) {
    const Program program;
    EXPECT_THAT(program.run({"new", "my map"}).out,
                HasSubstr("my map.toml is a map of two rooms. `enfilade play 'my map.toml'`"));
    EXPECT_THAT(program.run({"new", "nowhere/map"}).err, HasSubstr("there is no folder 'nowhere'; make it first"));
}

TEST(Draw, ShowsNamesNumbersLinksTriggersAndALegend) {
    const Program program;
    const Ended ended = program.run({"draw", kLodge, "--out", "plan.svg"});
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    const std::string svg = program.text("plan.svg");
    EXPECT_THAT(svg, StartsWith("<svg xmlns="));
    for (const char* word : {">hall<", ">crypt<", "→ crypt", "use: door (key brass)", "use: lift", ">0 to 3.5 m<",
                             ">11<", "the player's start", "hall, wall 1 to hall-garden, line 8", "lamp, line"})
        EXPECT_THAT(svg, HasSubstr(word));
}

TEST(Draw, DrawsEveryMapThatCame) {
    const Program program;
    for (const std::string& path : shipped_maps()) {
        const Ended ended = program.run({"draw", path, "--out", "-"});
        EXPECT_EQ(ended.exit_code, 0) << path;
        EXPECT_TRUE(ended.out.ends_with("</svg>\n")) << path;
    }
}

/// Where a word of a plan is written [px].
struct WrittenWord {
    std::string text;
    double left, right, top, bottom;
};

std::vector<WrittenWord> words_of(const std::string& svg) {
    static const std::regex text(
        "<text x=\"([-0-9.]+)\" y=\"([-0-9.]+)\" font-size=\"([0-9]+)\" text-anchor=[^>]*>([^<]*)<");
    std::vector<WrittenWord> words;
    for (std::sregex_iterator it(svg.begin(), svg.end(), text), end; it != end; ++it) {
        const double x = std::stod((*it)[1]), y = std::stod((*it)[2]), size = std::stod((*it)[3]);
        const double half = 0.25 * size * static_cast<double>((*it)[4].length());  // narrow letters
        words.push_back({(*it)[4], x - half, x + half, y - 0.7 * size, y});
    }
    return words;
}

TEST(Draw, WritesNoWordOverAnother) {
    std::size_t count = 0;
    for (const std::string& path : shipped_maps()) {
        std::vector<WrittenWord> words = words_of(Program().run({"draw", path, "--out", "-"}).out);
        count += words.size();
        std::ranges::sort(words, {}, &WrittenWord::left);
        for (std::size_t i = 0; i < words.size(); ++i)
            for (std::size_t k = i + 1; k < words.size() && words[k].left < words[i].right; ++k)
                EXPECT_FALSE(words[i].top < words[k].bottom && words[k].top < words[i].bottom)
                    << path << ": " << words[i].text << ", " << words[k].text;
    }
    EXPECT_GT(count, 1000u);
}

TEST(Draw, EscapesNames) {
    const Program program;
    program.write("map.toml", "format = 1\n[[sectors]]\nname = \"<a> & \\\"b\\\"\"\nrect = [0, 0,  4, 4]\nwall = {}\n");
    EXPECT_EQ(program.run({"draw", "map.toml", "--out", "plan.svg"}).exit_code, 0);
    EXPECT_THAT(program.text("plan.svg"), HasSubstr("&lt;a&gt; &amp; &quot;b&quot;"));
    EXPECT_THAT(program.text("plan.svg"), Not(HasSubstr("<a>")));
}

// A line of the lodge is changed, and is the one that is named.

struct Slip {
    const char *right, *wrong, *code;
};
void PrintTo(const Slip& slip, std::ostream* out) { *out << slip.wrong; }

class LodgeWithASlip : public ::testing::TestWithParam<Slip> {};

TEST_P(LodgeWithASlip, NamesTheAuthorsLine) {
    std::string text = text_in(kLodge);
    const std::size_t at = text.find(GetParam().right);
    ASSERT_NE(at, std::string::npos);
    text.replace(at, std::string(GetParam().right).size(), GetParam().wrong);
    const auto line = std::count(text.begin(), text.begin() + std::ptrdiff_t(at), '\n') + 1;
    const Program program;
    program.write("lodge.toml", text);
    for (const char* folder : {"sounds", "prefabs"})
        std::filesystem::create_directory_symlink(kMaps + folder, program.path(folder));
    const Ended ended = program.run({"check", "lodge.toml", "--textures", kMaps + "textures"});
    EXPECT_THAT(ended.out, StartsWith("lodge.toml:" + std::to_string(line) + ":"));
    EXPECT_THAT(ended.out, HasSubstr(std::string("[") + GetParam().code + "]\n  " + std::to_string(line) + " | "));
}

INSTANTIATE_TEST_SUITE_P(
    All, LodgeWithASlip,
    ::testing::Values(Slip{"[\"hall\", \"gallery\"]", "[\"hall\", \"galery\"]", "unknown-sector"},
                      Slip{"at = [0, 2.5]", "at = [0.5, 2.5]", "opening-off-wall"},
                      Slip{"at = [0, 2.5]", "at = [0, 5.75]", "opening-beyond-wall"},
                      Slip{"steps = 7", "stepz = 7", "unknown-key"},
                      Slip{"rect = [8.25, 0,  13.25, 6]", "rect = [8.25, 0,  13.25]", "wrong-type"},
                      Slip{"wall = { texture = \"salon_green 1.75,3.5\" }",
                           "wall = { texture = \"salon_gren 1.75,3.5\" }", "missing-texture"},
                      Slip{"corners = 8", "corners = 2", "out-of-range"},
                      Slip{"do = \"door\"", "do = \"dor\"", "unknown-word"},
                      Slip{"at = [-4.75, 0.5] }", "at = [-4.75, 0.5], tunr = 90 }", "unknown-key"},
                      Slip{"leaf = \"door 1,2\", top = 0.75", "leaf = \"door 1\", top = 0.75", "bad-texture-spec"}));

}  // namespace
}  // namespace enfilade
