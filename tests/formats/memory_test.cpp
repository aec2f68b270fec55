// What reading a map takes: no more for each value that is counted than is promised, whatever the text is made of.
#include <gmock/gmock.h>

#include <ostream>

#include "formats/map_toml.h"
#include "formats/toml_tree.h"
#include "support/count_allocations.h"

namespace enfilade {
namespace {

using namespace test;

/// Texts that consist of one thing over and over, with an end.
struct Shape {
    const char* name;
    const char* start;
    std::string (*part)(std::size_t i);
    const char* end;

    friend void PrintTo(const Shape& shape, std::ostream* out) { *out << shape.name; }
};

template <char... text>
std::string same(std::size_t) {
    return {text...};
}

/// What the text itself may take again and again: in the tree, in the library's strings, and in the records.
constexpr std::size_t kBytesPerTextByte = 5;

constexpr const char* kSector = "format = 1\n[[sectors]]\nname = 'hall'\n";
constexpr const char* kLoop = "format = 1\n[[sectors]]\nname = 'hall'\n[[sectors.loops]]\n";

const Shape kShapes[] = {
    {"Sectors", "format = 1\n", [](std::size_t) -> std::string { return "[[sectors]]\n"; }, ""},
    {"SectorsInBraces", "format = 1\nsectors = [", [](std::size_t) -> std::string { return "{},"; }, "]\n"},
    {"Loops", kSector, [](std::size_t) -> std::string { return "[[sectors.loops]]\n"; }, ""},
    {"Panels", kSector, [](std::size_t) -> std::string { return "[[sectors.panels]]\n"; }, ""},
    {"Things", "format = 1\n", [](std::size_t) -> std::string { return "[[things]]\n"; }, ""},
    {"Walls", kLoop, [](std::size_t i) -> std::string { return i ? "{}," : "walls = [{},"; }, "]\n"},
    {"WallsWithTriggers", kLoop,
     [](std::size_t i) -> std::string { return std::string(i ? "" : "walls = [") + "{triggers=[{}]},"; }, "]\n"},
    {"WallsWithEverything", kLoop,
     [](std::size_t i) -> std::string {
         return std::string(i ? "" : "walls = [") + "{texture='a', upper='b', lower='c', middle='d'},";
     },
     "]\n"},
    {"Triggers", kSector, [](std::size_t i) -> std::string { return i ? "{}," : "triggers = [{},"; }, "]\n"},
    {"Vertices", kLoop, [](std::size_t i) -> std::string { return i ? "0," : "v = [0,"; }, "]\n"},
    {"Tags", kSector, [](std::size_t i) -> std::string { return i ? "'t'," : "tags = ['t',"; }, "]\n"},
    {"LongTags", kSector,
     [](std::size_t i) -> std::string {
         return std::string(i ? "" : "tags = [") + "'a tag of thirty-two letters, or so',";
     },
     "]\n"},
    {"Frames", "format = 1\n[[things]]\nx = 0\ny = 0\n",
     [](std::size_t i) -> std::string { return i ? "{}," : "frames = [{},"; }, "]\n"},
    {"Arrays", "format = 1\n", [](std::size_t i) -> std::string { return i ? "[]," : "a = [[],"; }, "]\n"},
    {"Tables", "format = 1\n", [](std::size_t i) -> std::string { return "[a" + std::to_string(i) + "]\n"; }, ""},
    {"Keys", "format = 1\n", [](std::size_t i) -> std::string { return "a" + std::to_string(i) + "=0\n"; }, ""},
    {"KeysOfStrings", "format = 1\n", [](std::size_t i) -> std::string { return "a" + std::to_string(i) + "=''\n"; },
     ""},
    {"KeysOfArrays", "format = 1\n", [](std::size_t i) -> std::string { return "a" + std::to_string(i) + "=[]\n"; },
     ""},
    {"KeysInBraces", "format = 1\n[[sectors]]\n",
     [](std::size_t i) -> std::string { return (i ? ",a" : "a = {a") + std::to_string(i) + "=0"; }, "}\n"},
    {"DottedKeys", "format = 1\n", [](std::size_t i) -> std::string { return "a" + std::to_string(i) + ".b.c=0\n"; },
     ""},
    {"DottedTables", "format = 1\n", [](std::size_t i) -> std::string { return "[a" + std::to_string(i) + ".b.c]\n"; },
     ""},
    {"Sounds", "format = 1\n", [](std::size_t) -> std::string { return "[[sounds]]\n"; }, ""},
    {"Lights", "format = 1\n", [](std::size_t) -> std::string { return "[[lights]]\n"; }, ""},
    {"Animations", "format = 1\n", [](std::size_t) -> std::string { return "[[animations]]\n"; }, ""},
};

std::string text_of(const Shape& shape, std::size_t parts, bool for_the_library) {
    std::string text = for_the_library ? "name = \"\\u0041\"\n" : "";
    text += shape.start;
    for (std::size_t i = 0; i < parts; ++i) text += shape.part(i);
    return text + shape.end;
}

/// How many values the guard counts.
std::size_t values_in(const std::string& text) {
    std::size_t low = 0, high = text.size() * 64;
    while (low < high) {
        const std::size_t middle = (low + high) / 2;
        if (scan_toml(text, {text.size(), middle}))
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/// Just beyond a power of two, where vectors that double have the most room to spare.
constexpr std::size_t kTableParts = 16'500;

class Memory : public testing::TestWithParam<Shape> {};

TEST_P(Memory, OfEachValueIsAsPromised) {
    for (const bool for_the_library : {false, true}) {
        const std::string text = text_of(GetParam(), kTableParts, for_the_library);
        const std::size_t values = values_in(text);
        const std::size_t before = restart_peak();
        read_map(text);
        const std::size_t taken = peak_bytes() - before;
        EXPECT_LE(taken, values * kBytesPerValue + text.size() * kBytesPerTextByte)
            << (for_the_library ? "library" : "plain parser");
    }
}

TEST(MapMemory, IsRefusedBeforeItIsTaken) {
    std::string text;
    while (text.size() + 12 < kMaxMapBytes) text += "[[sectors]]\n";
    const std::size_t before = restart_peak();
    EXPECT_EQ(read_map(text).findings.at(0).code, "too-large");
    EXPECT_LT(peak_bytes() - before, std::size_t{1} << 20);
}

INSTANTIATE_TEST_SUITE_P(OfMaps, Memory, testing::ValuesIn(kShapes),
                         [](const auto& shape) { return std::string(shape.param.name); });

}  // namespace
}  // namespace enfilade
