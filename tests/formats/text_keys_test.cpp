// Names of files in maps and scripts: one rule, which no key forgets; and specifications of textures.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "formats/map_keys.h"
#include "formats/map_toml.h"
#include "formats/script.h"
#include "formats/text_parts.h"

namespace enfilade {
namespace {

constexpr std::string_view kGood[] = {"a",     "a b", "a/b", "a/b.c", "..a",  "a..",
                                      "a/...", "-",   "é漢", "~",     "a\\b", "%2e"};

/// Names that leave their folder, or are not the only one of their file.
constexpr std::string_view kAstray[] = {"..",   "../a", "a/..", "a/../b", "/",     "/a", "//a",
                                        "a//b", "a/",   ".",    "./a",    "a/./b", "a/."};

/// Names that must not even be printed.
constexpr std::string_view kUnprintable[] = {std::string_view("\0", 1),
                                             std::string_view("a\0b", 3),
                                             "a\nb",
                                             "a\tb",
                                             "\x1B[2J",
                                             "\x7F",
                                             "a\u009B",
                                             "\u202Ea",
                                             "a\u2067",
                                             "\u2028"};

TEST(FileName, LeadsBelowItsFolder) {
    for (std::string_view name : kGood) EXPECT_TRUE(refuse_as_file_name(name).ok()) << name;
    for (std::string_view name : kAstray) EXPECT_FALSE(refuse_as_file_name(name).ok()) << name;
    for (std::string_view name : kUnprintable) EXPECT_FALSE(refuse_as_file_name(name).ok()) << name;
    EXPECT_FALSE(refuse_as_file_name("").ok());
}

std::string refusal(std::string_view name) { return refuse_as_file_name(name).error_or(Error{"", "none"}).what; }

TEST(FileName, SaysWhatIsWrong) {
    EXPECT_EQ(refusal("a/../b"), "expected a file's name, found 'a/../b'; it must not lead out of its folder by '..'");
    EXPECT_EQ(refusal("/a"), "expected a file's name, found '/a'; it must not start with '/', but below its folder");
    EXPECT_EQ(refusal("./a"), "expected a file's name, found './a'; leave '.' out of it");
    EXPECT_EQ(
        refusal("a//b"),
        "expected a file's name, found 'a//b'; parts of a name have one '/' between them, and none at either end");
    EXPECT_EQ(refusal("a\x1B"), "expected a file's name, found 'a?' with characters that are not printed");
}

TEST(Path, MayLeadAnywhere) {
    for (std::string_view path : kGood) EXPECT_TRUE(refuse_as_path(path).ok()) << path;
    for (std::string_view path : kAstray) EXPECT_TRUE(refuse_as_path(path).ok()) << path;
    for (std::string_view path : kUnprintable) EXPECT_FALSE(refuse_as_path(path).ok()) << path;
}

/// Keys of tables that stand alone; those of all others stand in arrays.
bool is_single(std::string_view table) {
    for (std::string_view single :
         {"render", "player", "floor", "ceiling", "light_effect", "effect", "doom", "start", "wall"})
        if (table == single) return true;
    return false;
}

/// "sectors = [{ floor = { KEY = VALUE } }]" for the path "sectors.floor.KEY". An exit's target is a file, too.
std::string text_with(std::string_view path, const std::string& value) {
    const std::size_t dot = path.find('.');
    const std::string name(path.substr(0, dot));
    if (dot == std::string_view::npos) return (name == "target" ? "do = \"exit\", " : "") + name + " = " + value;
    const std::string inner = "{ " + text_with(path.substr(dot + 1), value) + " }";
    return name + " = " + (is_single(name) ? inner : "[" + inner + "]");
}

/// What is said where the value stands.
std::vector<std::string> codes_at(const Findings& findings, std::size_t column) {
    std::vector<std::string> codes;
    for (const Finding& finding : findings)
        if (finding.place.column == column) codes.push_back(finding.code);
    return codes;
}

struct FileKey {
    KeyInfo key;
    bool in_script;
};

void PrintTo(const FileKey& file_key, std::ostream* out) { *out << file_key.key.path; }

std::vector<FileKey> file_keys() {
    std::vector<FileKey> all;
    for (const bool in_script : {false, true})
        for (KeyInfo key : in_script ? script_keys() : map_keys()) {
            if (key.path.ends_with("triggers.target")) key.files = Files::below_folder;
            if (key.files != Files::none) all.push_back({key, in_script});
        }
    return all;
}

/// What the reader says at a key's value.
std::vector<std::string> said_at(const FileKey& file_key, std::string_view name) {
    const bool is_list = file_key.key.path == "textures" || file_key.key.path == "animations.frames";
    const std::string start = file_key.in_script ? "" : "format = 1\n";
    const std::string value = string_text(name);
    const std::string line = text_with(file_key.key.path, is_list ? "[" + value + "]" : value);
    const std::size_t column = line.find(value) + 1;
    return codes_at(file_key.in_script ? read_script(start + line).findings : read_map(start + line).findings, column);
}

class FileKeys : public testing::TestWithParam<FileKey> {};

TEST_P(FileKeys, RefuseNamesThatAreNone) {
    const bool is_path = GetParam().key.files == Files::anywhere;
    const auto refuses = testing::Contains(testing::AnyOf("bad-file-name", "bad-texture-spec", "empty-string"));
    for (std::string_view name : kUnprintable)
        EXPECT_THAT(said_at(GetParam(), name), refuses) << testing::PrintToString(name);
    for (std::string_view name : kAstray) {
        if (is_path)
            EXPECT_THAT(said_at(GetParam(), name), testing::Not(refuses)) << name;
        else
            EXPECT_THAT(said_at(GetParam(), name), refuses) << name;
    }
    EXPECT_THAT(said_at(GetParam(), ""), refuses);
    EXPECT_THAT(said_at(GetParam(), "a/b"), testing::Not(refuses));
}

INSTANTIATE_TEST_SUITE_P(All, FileKeys, testing::ValuesIn(file_keys()));

TEST(FileKeys, AreMany) { EXPECT_GE(file_keys().size(), 25u); }

// Texture specifications: every shape that is allowed, and those that look like one.

struct SpecCase {
    const char* text;
    TextureSpec spec;
};

void PrintTo(const SpecCase& spec, std::ostream* out) { *out << spec.text; }

class GoodSpec : public testing::TestWithParam<SpecCase> {};

TEST_P(GoodSpec, IsRead) {
    const auto spec = parse_texture_spec(GetParam().text);
    ASSERT_TRUE(spec.ok()) << spec.error().text();
    EXPECT_TRUE(spec.value() == GetParam().spec);
}

TEST_P(GoodSpec, ReadsBackAsTheSame) {
    const auto spec = parse_texture_spec(to_text(GetParam().spec));
    ASSERT_TRUE(spec.ok()) << spec.error().text();
    EXPECT_TRUE(spec.value() == GetParam().spec);
}

INSTANTIATE_TEST_SUITE_P(Shapes, GoodSpec,
                         testing::Values(SpecCase{"BRICK", {"BRICK", {}, {}, {}}}, SpecCase{"-", {"-", {}, {}, {}}},
                                         SpecCase{"- 1,1", {"-", Vec2{1, 1}, {}, {}}},
                                         SpecCase{"A 2,0.5", {"A", Vec2{2, 0.5}, {}, {}}},
                                         SpecCase{"A -2,1e1", {"A", Vec2{-2, 10}, {}, {}}},
                                         SpecCase{"A 1,1 -3,4.5", {"A", Vec2{1, 1}, {-3, 4.5}, {}}},
                                         SpecCase{" \tA  1 , 1\t3 ,4 ", {"A", Vec2{1, 1}, {3, 4}, {}}},
                                         SpecCase{"A - 3,4", {"A", {}, {3, 4}, {}}},
                                         SpecCase{"A 1,1 -1.5m,0m", {"A", Vec2{1, 1}, {}, {}, Vec2{-1.5, 0}}},
                                         SpecCase{"A 1,1 3,4 1e1m , 2m", {"A", Vec2{1, 1}, {3, 4}, {}, Vec2{10, 2}}},
                                         SpecCase{"A - 2m,0m", {"A", {}, {}, {}, Vec2{2, 0}}},
                                         SpecCase{"a/b,c", {"a/b,c", {}, {}, {}}}, SpecCase{"..a", {"..a", {}, {}, {}}},
                                         SpecCase{"é漢", {"é漢", {}, {}, {}}}));

class BadSpec : public testing::TestWithParam<const char*> {};

TEST_P(BadSpec, IsRefused) { EXPECT_FALSE(parse_texture_spec(GetParam()).ok()); }

INSTANTIATE_TEST_SUITE_P(Shapes, BadSpec,
                         testing::Values("", "  ", "A 1", "A 1,", "A ,1", "A 1 1", "A 1,1,1", "A 1,1 2", "A 1,1 2,",
                                         "A 1,1 2,2 3", "A 1,1 2,2 3,3", "A -", "A - -", "A x,y", "A nan,1", "A inf,1",
                                         "A 0,1", "A 1,0", "A 1e9,1", "A 1e-9,1", "A 1,1 1e9,0", "A 1,1 1m",
                                         "A 1,1 1m,", "A 1,1 1m,1", "A 1,1 1,1m", "A 1m,1m", "A 1,1 m,m",
                                         "A 1,1 1mm,1m", "A 1,1 1m,1m 1,1", "A 1,1 1m,1m 1m,1m", "A 1,1 1e9m,0m",
                                         "../a", "a/../b", "a/..", "/a", "a\x01", "A 0x1,1"));

TEST(TextureSpec, SaysWhichPairIsHalf) {
    EXPECT_EQ(parse_texture_spec("A 1,1 2").error().what,
              "expected \"NAME [SU,SV [OU,OV] [OUm,OVm]]\": OU,OV is a pair, the second number is missing");
}

TEST(TextureSpec, SaysWhatItFoundInsteadOfANumber) {
    EXPECT_EQ(parse_texture_spec("A 1,b").error().what,
              "expected \"NAME [SU,SV [OU,OV] [OUm,OVm]]\": SU,SV is a pair of numbers, found 'b'");
}

TEST(TextureSpec, SaysThatNoBlankIsBeforeTheMetres) {
    EXPECT_EQ(parse_texture_spec("A 1,1 -2.5 m,0m").error().what,
              "expected 'm' right behind its number, found a blank between them");
}

TEST(TextureSpec, SaysWhereMetresAreMissing) {
    EXPECT_EQ(
        parse_texture_spec("A 1,1 2m,3").error().what,
        "expected \"NAME [SU,SV [OU,OV] [OUm,OVm]]\": OUm,OVm is a pair of numbers with 'm' behind each, found '3'");
}

}  // namespace
}  // namespace enfilade
