// What is written once is written out by hostile maps, too: in a moment, and only so much.
#include <gmock/gmock.h>

#include <ctime>

#include "formats/findings.h"
#include "formats/map_toml.h"
#include "formats/text_parts.h"

namespace enfilade {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// What a map of a MiB may take [s of the processor]. Sanitizers and builds that are not optimised take longer.
#if defined(__OPTIMIZE__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
constexpr double kMostSeconds = 2;
#else
constexpr double kMostSeconds = 20;
#endif

double seconds_to_read(const std::string& text, const FileReader& prefabs) {
    const std::clock_t start = std::clock();
    read_map(text, prefabs);
    return double(std::clock() - start) / CLOCKS_PER_SEC;
}

constexpr std::size_t kMiB = std::size_t{1} << 20;

std::string filled(std::string text, const std::string& part, std::size_t size = kMiB) {
    while (text.size() + part.size() < size) text += part;
    return text;
}

std::string only_rooms() {
    return "format = 1\nsectors = [{ name = 'hall', rect = [0,0,4,4], wall = { texture = 'brick' } }, "
           "{ name = 'yard', rect = [4.5,0,8,4], wall = { texture = 'hedge' } }]\n";
}

std::string zigzag() {
    std::string v = "[[sectors]]\nname = \"big\"\nwall = {}\n[[sectors.loops]]\nv = [";
    for (int i = 0; i < 40000; ++i) v += std::to_string(i % 30000) + "," + std::to_string(i % 7) + ",";
    return "format = 1\n" + v + "]\n";
}

std::string openings_along_one_wall() {
    std::string text =
        "format = 1\nsectors = [{ name = 'a', rect = [0,0,9999,1], wall = {} }, "
        "{ name = 'b', rect = [0,1,9999,2], wall = {} }]\nopenings = [\n";
    for (int i = 1; i < 20000; ++i) text += "{between=['a','b'],width=0.1,at=[" + number_text(i * 0.45) + ",1]},\n";
    return text + "]\n";
}

/// Two rooms of thousands of walls, and thousands of openings that are on none of them, or have nothing that faces
/// them.
std::string openings_between_many_walls(const std::string& opening) {
    std::string text = "format = 1\n";
    for (const char* name : {"a", "b"}) {
        text += std::string("[[sectors]]\nname = \"") + name + "\"\nwall = {}\n[[sectors.loops]]\nv = [";
        for (int i = 0; i < 6000; ++i) text += std::to_string(i) + "," + std::to_string(i % 7) + ",";
        text += "6000,100,0,100]\n";
    }
    return filled(text, "[[openings]]\nbetween = [\"a\", \"b\"]\n" + opening);
}

std::string openings_off_many_walls() { return openings_between_many_walls("at = [50.5, 50]\nwidth = 0.5\n"); }
std::string openings_of_many_walls() { return openings_between_many_walls("width = 0.5\n"); }

std::string one_long_wall() {
    const std::string texture(kMiB / 2, 'x');
    return filled("format = 1\n[[sectors]]\nname = \"a\"\nwall = { texture = \"" + texture +
                      "\" }\n[[sectors.loops]]\nv = [",
                  "0,0,") +
           "]\n";
}

// The texts are made where they are read: every process of this program lists these maps, one of them reads one.
struct Hostile {
    const char* name;
    std::string (*text)();
};
void PrintTo(const Hostile& hostile, std::ostream* out) { *out << hostile.name; }

const Hostile kHostileMaps[] = {
    {"OpeningsInOnePlace", [] { return filled(only_rooms(), "[[openings]]\nbetween = [\"hall\", \"yard\"]\n"); }},
    {"OpeningsAlongOneWall", openings_along_one_wall},
    {"OpeningsOffManyWalls", openings_off_many_walls},
    {"OpeningsOfManyWalls", openings_of_many_walls},
    {"OpeningsBetweenLargeRooms", [] { return filled(zigzag(), "[[openings]]\nbetween = [\"big\", \"big\"]\n"); }},
    {"LinksOfALargeRoom",
     [] { return filled(zigzag(), "[[openings]]\nbetween=['big','big']\nat=[0,0]\nto=[1,1]\nwidth=1\n"); }},
    {"StairsWithoutEnd",
     [] { return filled(only_rooms(), "[[openings]]\nbetween=['hall','yard']\nat=[4,1]\nwidth=1\nsteps=256\n"); }},
    {"Polygons",
     [] {
         return filled("format = 1\n[[sectors]]\nname = \"a\"\nwall = {}\n",
                       "[[sectors.loops]]\npolygon={x=0,y=0,radius=9,corners=256}\n");
     }},
    {"OneLongWall", one_long_wall},
    {"UnknownRooms", [] { return filled(only_rooms(), "[[openings]]\nbetween = [\"hlal\", \"yrad\"]\n"); }},
    {"Prefabs", [] { return filled("format = 1\nsectors = []\n", "[[prefabs]]\nname='p'\nfile='big'\n"); }},
    {"MissingPrefabs", [] { return filled("format = 1\nsectors = []\n", "[[prefabs]]\nname='p'\nfile='none'\n"); }},
};

class HostileShortWords : public testing::TestWithParam<Hostile> {};

TEST_P(HostileShortWords, AreWrittenOutInAMoment) {
    const std::string big = filled("format = 1\nsectors = []\n", "[[sounds]]\nname='s'\nfile='f'\n", kMiB / 2);
    const FileReader only_big = [&](const std::string& path) -> Result<Bytes> {
        if (path != "big") return Error{path, "no such file"};
        const auto bytes = std::as_bytes(std::span(big));
        return Bytes(bytes.begin(), bytes.end());
    };
    EXPECT_LT(seconds_to_read(GetParam().text(), only_big), kMostSeconds);
}

INSTANTIATE_TEST_SUITE_P(All, HostileShortWords, testing::ValuesIn(kHostileMaps),
                         [](const auto& hostile) { return std::string(hostile.param.name); });

TEST(ShortWords, MakeOnlySoMuch) {
    const std::string polygon = "[[sectors.loops]]\npolygon = { x = 0, y = 0, radius = 9, corners = 256 }\n";
    const std::string start = "format = 1\n[[sectors]]\nname = \"a\"\nwall = {}\n";
    const auto text_with = [&](std::size_t count) {
        std::string text = start;
        for (std::size_t i = 0; i < count; ++i) text += polygon;
        return text;
    };
    constexpr std::size_t kFit = 262'144 / 512;  // corners, and as many walls
    EXPECT_THAT(read_map(text_with(kFit)).findings, IsEmpty());
    const MapReading beyond = read_map(text_with(kFit + 100));
    EXPECT_THAT(codes_and_places(beyond.findings), ElementsAre("too-large " + std::to_string(6 + 2 * kFit) + ":11"));
}

}  // namespace
}  // namespace enfilade
