// The README and the manual say only what is true: their maps load without a finding, what they list is there.
#include <gmock/gmock.h>

#include <filesystem>
#include <regex>

#include "base/files.h"
#include "map/load.h"

namespace enfilade::house {
namespace {

const std::string kTop = std::string(ENFILADE_SOURCE_DIR) + "/";

std::string text_of(const std::string& path) {
    const auto bytes = read_file(kTop + path);
    return bytes.ok() ? std::string(as_text(bytes.value())) : "";
}

/// What stands in the blocks that start with ```toml and are whole maps: those with a player.
std::vector<std::string> maps_in(const std::string& text) {
    const std::string opening = "```toml\n";
    std::vector<std::string> maps;
    for (auto begin = text.find(opening); begin != std::string::npos; begin = text.find(opening, begin)) {
        begin += opening.size();
        const std::string block = text.substr(begin, text.find("```", begin) - begin);
        if (block.find("[player]") != std::string::npos) maps.push_back(block);
    }
    return maps;
}

/// Loads the text as a map in maps/ and reports all that is found.
void expect_no_finding(const std::string& text) {
    const std::string path = kTop + "maps/mine.toml";
    const FileReader read = [&](const std::string& asked) -> Result<Bytes> {
        if (asked != path) return read_file(asked);
        const auto bytes = std::as_bytes(std::span(text));
        return Bytes(bytes.begin(), bytes.end());
    };
    const LoadedMap loaded = load_map(path, {}, read);
    for (const Finding& finding : loaded.findings) ADD_FAILURE() << to_text("the example", finding) << "\n" << text;
    EXPECT_TRUE(loaded.map);
}

TEST(Readme, HasAMapThatLoadsWithoutAFinding) {
    const std::vector<std::string> maps = maps_in(text_of("README.md"));
    EXPECT_EQ(maps.size(), 1u);
    for (const std::string& map : maps) expect_no_finding(map);
}

TEST(MapManual, HasMapsThatLoadWithoutAFinding) {
    const std::vector<std::string> maps = maps_in(text_of("maps/FORMAT.md"));
    EXPECT_EQ(maps.size(), 3u);
    for (const std::string& map : maps) expect_no_finding(map);
}

TEST(MapManual, ListsEveryPictureThereIsAndNoOther) {
    const std::string text = text_of("maps/FORMAT.md");
    const auto begin = text.find("### Pictures that come"), end = text.find("Sounds are in", begin);
    ASSERT_NE(end, std::string::npos);
    const std::regex name("`([a-z0-9_]+)`");
    std::vector<std::string> listed;
    for (std::sregex_iterator it(text.begin() + std::ptrdiff_t(begin), text.begin() + std::ptrdiff_t(end), name), last;
         it != last; ++it)
        listed.push_back(std::string((*it)[1]) + ".png");
    EXPECT_THAT(listed, ::testing::UnorderedElementsAreArray(list_folder(kTop + "maps/textures")));
}

TEST(Readme, LinksOnlyToWhatIsThere) {
    const std::string text = text_of("README.md");
    const std::regex link(R"(\]\(([^)#]+))");
    int links = 0;
    for (auto found = std::sregex_iterator(text.begin(), text.end(), link); found != std::sregex_iterator(); ++found) {
        const std::string target = (*found)[1];
        if (target.starts_with("http")) continue;
        EXPECT_TRUE(std::filesystem::exists(kTop + target)) << target;
        ++links;
    }
    EXPECT_GT(links, 3);
}

}  // namespace
}  // namespace enfilade::house
