// Words of hostile files in what the programs say: no terminal may obey them.
#include <gmock/gmock.h>

#include "app/cli/program.h"
#include "base/files.h"
#include "base/text.h"
#include "formats/tape.h"

namespace enfilade {
namespace {

using test::Ended;
using test::Program;

/// Clears the screen, colours, turns the text round, ends the line; and the same as an escaped TOML string.
const std::string kRaw = "a\x1B[2Jb\u009B31mc\u202Ed\u2067e\u2028f\x7Fg\rh\x9Bi";
const std::string kEscaped =
    R"(a\u001B[2Jb\u009B31mc\u202Ed\u2067e\u2028f\u007Fg\rh\u0000i\nmap.toml:1:1: error: false)";

/// Whether a terminal could take the character for something else than a letter. On purpose not the program's own rule.
bool is_obeyed(std::string_view character) {
    if (character.size() == 1)
        return (character[0] < ' ' && character != "\n" && character != "\t") || character == "\x7F";
    if (character.size() == 2) return character >= "\xC2\x80" && character <= "\xC2\x9F";
    if (character.size() != 3) return false;
    return (character >= "\xE2\x80\xA8" && character <= "\xE2\x80\xAE") ||
           (character >= "\xE2\x81\xA6" && character <= "\xE2\x81\xA9");
}

/// The number of characters in the text that a terminal obeys, and of bytes that are no characters.
std::size_t obeyed_in(std::string_view text) {
    std::size_t count = 0;
    while (!text.empty()) {
        const std::size_t length = utf8_length(text);
        count += length == 0 || is_obeyed(text.substr(0, length));
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return count;
}

/// The program says something, in letters only, and no name pretends to be a line of its own.
void expect_letters(const Ended& ended) {
    const std::string said = ended.out + ended.err;
    EXPECT_NE(said, "");
    EXPECT_EQ(obeyed_in(said), 0u) << said;
    EXPECT_EQ(said.find("\nmap.toml:1:1: error: false"), std::string::npos) << said;
    EXPECT_LE(ended.exit_code, 2) << said;
}

/// A text with the hostile string at every '@'.
std::string with_words(std::string text) {
    for (std::size_t at = 0; (at = text.find('@', at)) != std::string::npos; at += kEscaped.size())
        text.replace(at, 1, kEscaped);
    return text;
}

class HostileWords : public ::testing::TestWithParam<std::string> {};

/// Lines behind a sound map: those at its end belong to its last sector.
class HostileMaps : public HostileWords {};

TEST_P(HostileMaps, AreToldInLetters) {
    const Program program;
    const std::string lines = with_words(GetParam());
    const bool is_header = lines.starts_with('[');
    program.write("map.toml", is_header ? test::kTwoRooms + lines : lines + "\n" + test::kTwoRooms);
    expect_letters(program.run({"check", "map.toml"}));
    expect_letters(program.run({"render", "map.toml", "--size", "16x10", "--out", "x.png"}));
    expect_letters(program.run({"bench", "map.toml", "--size", "16x10", "--frames", "1"}));
}

INSTANTIATE_TEST_SUITE_P(
    Maps, HostileMaps,
    ::testing::Values("name = '\u009B\u202E'", "\"@\" = 1", "textures = [\"@\"]", "a = \u202E", "a = '\x9B'",
                      "a = '\x1B'", "a = 1 # \u202E\nb = \"\\u001B", "[[sounds]]\nname = \"@\"\nfile = \"x.wav\"",
                      "[[sounds]]\nname = \"x\"\nfile = \"@\"", "[[animations]]\nframes = [\"@\", \"b\"]",
                      "[[switches]]\noff = \"@\"\non = \"b\"", "[[switches]]\noff = \"b\"\non = \"@\"",
                      "[[sectors]]\nname = \"@\"",
                      "[[sectors]]\nname = \"x\"\n[[sectors.loops]]\nname = \"@\"\nv = [0]",
                      "[[sectors.loops]]\nname = \"l\"\nv = [8.5, 2.5, 8.5, 3, 9, 3]\nwalls = [{ texture = \"@\" }, { "
                      "next = \"@\" }, "
                      "{ next = \"hall\", via = \"@\" }]",
                      "[[sectors.panels]]\nv = [8.5, 2.5, 9, 3]\nbottom = 0\ntop = 1\ntexture = \"@\"",
                      "[[sectors.triggers]]\non = \"enter\"\ndo = \"exit\"\ntarget = \"@\"",
                      "[[sectors.triggers]]\non = \"enter\"\ndo = \"open\"\ntarget = [\"@\"]",
                      "[[sectors.triggers]]\non = \"enter\"\ndo = \"teleport\"\ntarget = \"@\"",
                      "[[sectors.triggers]]\non = \"@\"\ndo = \"@\"",
                      "[[sectors.triggers]]\non = \"enter\"\ndo = \"floor\"\nlike = \"@\"\ntexture = \"@\"\nsound = "
                      "\"@\"\nkey = \"@\"",
                      "[[things]]\nclass = \"@\"\nname = \"@\"\nx = 1\ny = 1\nframes = [{ texture = \"@\" }]",
                      "[[things]]\nclass = \"a\"\nsector = \"@\"\nx = 1\ny = 1\nsound = \"@\"",
                      "[[lights]]\nsector = \"@\"\nx = 1\ny = 1\nz = 1\ncolor = \"@\""));

/// Scripts of a sound map.
class HostileScripts : public HostileWords {};

TEST_P(HostileScripts, AreToldInLetters) {
    const Program program;
    program.write("map.toml", test::kTwoRooms);
    program.write("walk.toml", with_words(GetParam()));
    expect_letters(program.run({"fly", "walk.toml", "--out", "frames", "--size", "16x10"}));
}

INSTANTIATE_TEST_SUITE_P(Scripts, HostileScripts,
                         ::testing::Values("map = \"@\"\n[[legs]]\nwait = 1", "map = \"map.toml\"\ntape = \"@\"",
                                           "map = \"map.toml\"\nsamples = \"@\"\n[[legs]]\nwait = 1",
                                           "map = \"map.toml\"\nrenderer = \"@\"\n[[legs]]\nwait = 1",
                                           "map = \"map.toml\"\nstart = { sector = \"@\" }\n[[legs]]\nwait = 1",
                                           "map = \"map.toml\"\n\"@\" = 1\n[[legs]]\n\"@\" = 1"));

/// What was recorded of a flight.
class HostileRecordings : public HostileWords {};

TEST_P(HostileRecordings, AreToldInLetters) {
    const Program program;
    program.write("map.toml", test::kTwoRooms);
    program.write("walk.toml", "map = \"map.toml\"\nsize = [16, 10]\n[[legs]]\nwait = 0.1\n");
    program.write("walk.hashes", GetParam());
    expect_letters(program.run({"fly", "walk.toml", "--check"}));
}

INSTANTIATE_TEST_SUITE_P(Recordings, HostileRecordings,
                         ::testing::Values(kRaw, "picture 16x10 " + kRaw, "picture " + kRaw + " column",
                                           "picture 16x10 column\n0 " + kRaw, "sheet " + kRaw,
                                           kRaw + " 0123456789abcdef"));

/// Views that are read from a file.
class HostileViews : public HostileWords {};

TEST_P(HostileViews, AreToldInLetters) {
    const Program program;
    program.write("map.toml", test::kTwoRooms);
    program.write("views.csv", GetParam());
    expect_letters(program.run({"render", "map.toml", "--views", "views.csv", "--out", "frames"}));
}

INSTANTIATE_TEST_SUITE_P(Views, HostileViews,
                         ::testing::Values(kRaw, "x,y,z,yaw,pitch,sector\n1,1,1,0,0,\x1B[2J\u009B\u202E",
                                           "x,y,z,yaw,pitch\n1,1,1,0,\x1B[2J\u009B\u202E"));

/// Arguments are the user's own, but somebody else may have named the file.
class HostileArguments : public ::testing::TestWithParam<std::vector<std::string>> {};

TEST_P(HostileArguments, AreToldInLetters) {
    const Program program;
    program.write("map.toml", test::kTwoRooms);
    program.write(kRaw + ".toml", "nonsense");
    expect_letters(program.run(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(
    Arguments, HostileArguments,
    ::testing::Values(std::vector<std::string>{kRaw}, std::vector<std::string>{kRaw + ".toml"},
                      std::vector<std::string>{"--" + kRaw}, std::vector<std::string>{"check", kRaw},
                      std::vector<std::string>{"check", kRaw + ".toml"}, std::vector<std::string>{"play", kRaw},
                      std::vector<std::string>{"fly", kRaw + ".toml", "--check"},
                      std::vector<std::string>{"render", "map.toml", "--out", kRaw + ".jpg"},
                      std::vector<std::string>{"render", "map.toml", "--out", "x.png", "--sector", kRaw},
                      std::vector<std::string>{"render", "map.toml", "--out", "x.png", "--size", kRaw},
                      std::vector<std::string>{"render", "map.toml", "--out", "x.png", "--samples", kRaw},
                      std::vector<std::string>{"render", "map.toml", "--out", "x.png", "--renderer", kRaw},
                      std::vector<std::string>{"render", "map.toml", "--out", "x.png", "--fov", kRaw},
                      std::vector<std::string>{"render", "map.toml", "--out", "x.png", "--view", kRaw}));

TEST(HostileTapes, AreToldInLetters) {
    const Program program;
    Tape tape;
    tape.map = "a\u009B31mb\u202Ec\u2067d\u2028e\x7F";
    const Bytes bytes = write_tape(tape);
    program.write("map.toml", test::kTwoRooms);
    program.write("walk.tape", std::string(as_text(bytes)));
    program.write("walk.toml", "map = \"map.toml\"\ntape = \"walk.tape\"\n");
    expect_letters(program.run({"check", "walk.tape"}));
    expect_letters(program.run({"render", "walk.tape", "--out", "x.png"}));
    expect_letters(program.run({"fly", "walk.toml", "--out", "frames"}));
}

/// An archive with one lump of that name [8 bytes], which claims to reach far behind its end.
std::string archive_of(const std::string& lump) {
    ByteWriter wad;
    wad.text("PWAD");
    wad.u32(1);
    wad.u32(12);
    wad.u32(0x7FFFFFFF);
    wad.u32(1);
    wad.text(lump);
    return std::string(as_text(wad.bytes()));
}

TEST(HostileArchives, AreToldInLetters) {
    const Program program;
    program.write("a.wad", archive_of("\x1B[2J\u009B\x9B\x7F"));
    program.write("b.wad", "\x1B[2J" + kRaw);
    program.write(kRaw + ".wad", "PWAD");
    for (const std::string& wad : {std::string("a.wad"), std::string("b.wad"), kRaw + ".wad", kRaw})
        expect_letters(program.run_other(WADCONV_PROGRAM, {wad, "--out", "maps", "--map", kRaw}));
    expect_letters(program.run_other(WADCONV_PROGRAM, {"--" + kRaw}));
}

}  // namespace
}  // namespace enfilade
