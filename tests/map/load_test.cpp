// Maps from files: where pictures are looked for, and what happens when nothing can be read.
#include "map/load.h"

#include <gmock/gmock.h>

#include <map>
#include <sstream>

#include "formats/map_toml.h"
#include "formats/png.h"

namespace enfilade {
namespace {

using ::testing::ElementsAre;

/// Files in memory. Reading is noted, so that a test can see what was looked for.
struct Folder {
    std::map<std::string, std::string> texts;
    std::vector<std::string> pictures;
    std::vector<std::string> asked_for;

    FileReader reader() {
        return [this](const std::string& path) -> Result<Bytes> {
            asked_for.push_back(path);
            for (const std::string& picture : pictures)
                if (picture == path) return write_png({2, 1, {0xFF0000FFu, 0xFF0000FFu}});
            const auto it = texts.find(path);
            if (it == texts.end()) return Error{path, "no such file"};
            const auto bytes = std::as_bytes(std::span(it->second));
            return Bytes(bytes.begin(), bytes.end());
        };
    }
};

const std::string kRoom = R"(format = 1
[player]
sector = "hall"
x = 1
y = 1
z = 1
[[sectors]]
name = "hall"
floor = { texture = "-" }
ceiling = { texture = "-" }
[[sectors.loops]]
v = [0, 0,  4, 0,  4, 4]
walls = [{ texture = "Brick" }, { texture = "-" }, { texture = "-" }]
)";

TEST(LoadMap, LooksForPicturesBesideTheMap) {
    Folder folder{{{"maps/hall.toml", kRoom}}, {"maps/textures/Brick.png"}, {}};
    const LoadedMap loaded = load_map("maps/hall.toml", {}, folder.reader());
    ASSERT_TRUE(loaded.map);
    EXPECT_TRUE(loaded.findings.empty());
    EXPECT_EQ(loaded.textures[(*loaded.map)[loaded.map->walls[0].texture].texture].width, 2u);
}

TEST(LoadMap, LeavesOutThingsOfOtherSkillsAndOfCompany) {
    const std::string things = R"(
things = [
  { class = "always", x = 3, y = 1 },
  { class = "easy", x = 3, y = 1, skills = [1, 2] },
  { class = "hard", x = 3, y = 1, skills = [4, 5] },
  { class = "company", x = 3, y = 1, multiplayer = true },
]
)";
    Folder folder{
        {{"hall.toml", "format = 1" + things + kRoom.substr(kRoom.find('\n'))}}, {"./textures/Brick.png"}, {}};
    const auto kinds_at = [&](std::optional<int> skill) {
        const LoadedMap loaded = load_map("hall.toml", {}, folder.reader(), skill);
        std::vector<std::string> kinds;
        for (const Thing& thing : loaded.map.value().things) kinds.push_back(thing.kind);
        return kinds;
    };
    EXPECT_THAT(kinds_at(4), ElementsAre("always", "hard"));
    EXPECT_THAT(kinds_at(1), ElementsAre("always", "easy"));
    EXPECT_THAT(kinds_at({}), ElementsAre("always", "easy", "hard", "company"));
}

TEST(LoadMap, LooksInTheCallersFoldersFirst) {
    Folder folder{{{"hall.toml", kRoom}}, {"mine/brick.png", "./textures/brick.png"}, {}};
    load_map("hall.toml", {"mine"}, folder.reader());
    EXPECT_THAT(folder.asked_for, ElementsAre("hall.toml", "mine/Brick.png", "mine/brick.png"));
}

TEST(LoadMap, TakesFoldersFromTheMap) {
    Folder folder{{{"/maps/hall.toml", "textures = [\"art\", \"/shared\"]\n" + kRoom}}, {"/shared/brick.png"}, {}};
    EXPECT_TRUE(load_map("/maps/hall.toml", {}, folder.reader()).findings.empty());
    EXPECT_THAT(folder.asked_for, ElementsAre("/maps/hall.toml", "/maps/art/Brick.png", "/maps/art/brick.png",
                                              "/shared/Brick.png", "/shared/brick.png"));
}

TEST(LoadMap, CallsAMapWithoutANameLikeItsFile) {
    Folder folder{{{"maps/north.hall.toml", kRoom}}, {}, {}};
    EXPECT_EQ(load_map("maps/north.hall.toml", {}, folder.reader()).map->name, "north.hall");
}

TEST(LoadMap, SuggestsThePictureThatIsCalledNearlySo) {
    Folder folder{{{"hall.toml", kRoom}}, {}, {}};
    const FolderLister list = [](const std::string& path) -> std::vector<std::string> {
        return path == "./textures" ? std::vector<std::string>{"BRICKS.PNG", "brik.txt", "Brik.png"}
                                    : std::vector<std::string>{};
    };
    const LoadedMap loaded = load_map("hall.toml", {}, folder.reader(), {}, list);
    ASSERT_EQ(loaded.findings.size(), 1u);
    EXPECT_THAT(loaded.findings[0].sentence, ::testing::EndsWith("a placeholder is drawn; did you mean 'brik'?"));
}

TEST(LoadMap, NamesTheFilesThatSoundsAndExitsNeed) {
    const std::string sounds = "\nsounds = [{ name = \"hum\", file = \"hum.wav\" }]\n";
    std::string text = "format = 1" + sounds + kRoom.substr(kRoom.find('\n'));
    text += "[[sectors.panels]]\nv = [2, 1,  3, 1]\nbottom = 0\ntop = 1\ntexture = \"-\"\n";
    text += "triggers = [{ on = \"use\", do = \"exit\", target = \"attic\" }]\n";
    text += "[[things]]\nx = 3\ny = 1\ntriggers = [{ on = \"touch\", do = \"exit\", target = \"cellar\" }]\n";
    Folder folder{{{"hall.toml", text}}, {"./textures/Brick.png"}, {}};
    const LoadedMap loaded = load_map("hall.toml", {}, folder.reader());
    ASSERT_EQ(loaded.sounds.size(), 1u);
    EXPECT_EQ(loaded.sounds[0].name, "hum.wav");
    EXPECT_EQ(loaded.sounds[0].place.line, 2u);
    ASSERT_EQ(loaded.next_maps.size(), 2u);
    EXPECT_EQ(loaded.next_maps[0].name, "attic");
    EXPECT_EQ(loaded.next_maps[0].place.line, 21u);
    EXPECT_EQ(loaded.next_maps[1].name, "cellar");
    EXPECT_EQ(loaded.next_maps[1].place.line, 25u);
}

TEST(LoadMap, SaysInOneFindingThatAFileCannotBeRead) {
    Folder folder;
    const LoadedMap loaded = load_map("nowhere.toml", {}, folder.reader());
    EXPECT_FALSE(loaded.map);
    ASSERT_EQ(loaded.findings.size(), 1u);
    EXPECT_EQ(to_text("nowhere.toml", loaded.findings[0]), "nowhere.toml: error: no such file [unreadable]");
}

TEST(LoadMap, SortsWhatReaderAndBuilderFoundByPlace) {
    std::string text = kRoom;
    text.replace(text.find("\"-\" }, {"), 3, "\"-\", next = \"cellar\"");  // unknown-sector, in the last line
    text.replace(text.find("z = 1\n"), 6, "z = 1\nq = 2\n");               // unknown-key, above it
    Folder folder{{{"hall.toml", text}}, {"./textures/brick.png"}, {}};
    const LoadedMap loaded = load_map("hall.toml", {}, folder.reader());
    std::vector<std::string> codes;
    for (const Finding& finding : loaded.findings) codes.push_back(finding.code);
    EXPECT_THAT(codes, ElementsAre("unknown-key", "unknown-sector"));
}

/// Line n of a text, counted from 1.
std::string line_of(const std::string& text, std::uint32_t number) {
    std::istringstream lines(text);
    std::string line;
    for (std::uint32_t i = 0; i < number; ++i) std::getline(lines, line);
    return line;
}

TEST(MapPlaces, SayWhereEachPartIsWritten) {
    const MapPlaces places = places_in(kRoom);
    EXPECT_THAT(places.sectors, ElementsAre(TextPlace{7, 1}));
    EXPECT_EQ(places.floors.at(0).line, 9u);
    EXPECT_EQ(places.ceilings.at(0).line, 10u);
    ASSERT_EQ(places.walls.size(), 3u);
    for (const TextPlace& wall : places.walls) EXPECT_EQ(wall.line, 13u);
}

TEST(MapPlaces, CountOnlyTheThingsOfTheSkill) {
    const std::string text = kRoom + "[[things]]\nx = 3\ny = 1\nskills = [5]\n[[things]]\nx = 3\ny = 1\n";
    EXPECT_EQ(places_in(text).things.size(), 2u);
    const MapPlaces places = places_in(text, 3);
    ASSERT_EQ(places.things.size(), 1u);
    EXPECT_EQ(places.things[0].line, 18u);
}

TEST(MapPlaces, FindEveryWallOfMapsThatCame) {
    const std::string maps = std::string(ENFILADE_SOURCE_DIR) + "/maps/";
    std::size_t walls = 0;
    for (const std::string& file : list_folder(maps)) {
        if (!file.ends_with(".toml")) continue;
        const Bytes bytes = read_file(maps + file).value();
        const std::string text(as_text(bytes));
        const auto no_pictures = [&](const std::string& path) -> Result<Bytes> {
            return path.ends_with(".toml") ? read_file(path) : Error{path, "not read here"};
        };
        const Map map = *load_map(maps + file, {}, no_pictures).map;
        // As it is, and as the converter and every other program of ours would write it.
        for (const std::string& written : {text, write_map(read_map_at(maps + file, text, read_file).map)}) {
            const MapPlaces places = places_in(written, {}, maps + file, read_file);
            ASSERT_EQ(places.walls.size(), map.walls.size()) << file;
            for (std::size_t i = 0; i < map.walls.size(); ++i) {
                if (map.walls[i].kind != WallKind::portal) continue;
                const std::string& next = map[map.walls[i].behind].name;
                // An opening stands for all portals that it makes, and names the rooms at its ends.
                ASSERT_THAT(
                    line_of(written, places.walls[i].line),
                    ::testing::AnyOf(::testing::HasSubstr('"' + next + '"'), ::testing::HasSubstr("between = ")))
                    << file;
                ++walls;
            }
        }
    }
    EXPECT_GT(walls, 1000u);
}

}  // namespace
}  // namespace enfilade
