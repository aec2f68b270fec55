// The README and the manual say only what is true: their maps load without a finding, what they list is there.
#include <gmock/gmock.h>

#include <cctype>
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

const std::vector<std::string> kDocuments{"README.md",
                                          "CHANGELOG.md",
                                          "engine/README.md",
                                          "engine/app/README.md",
                                          "maps/FORMAT.md",
                                          "maps/GUIDE.md",
                                          "tests/README.md",
                                          "tests/accuracy/README.md",
                                          "tests/bench/FIGURES.md",
                                          "wadconv/README.md",
                                          "tests/hard_cases/CASES.md"};

/// All that matches the pattern's first group.
std::vector<std::string> matches(const std::string& text, const std::string& pattern) {
    const std::regex regex(pattern);
    std::vector<std::string> all;
    for (std::sregex_iterator it(text.begin(), text.end(), regex), end; it != end; ++it) all.push_back((*it)[1]);
    return all;
}

/// The anchors of a document's headings, as code hosts make them.
std::vector<std::string> anchors_of(const std::string& text) {
    std::vector<std::string> anchors;
    for (const std::string& heading : matches(text, "\n#+ ([^\n]+)")) {
        std::string anchor;
        for (const char c : heading)
            if (std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_')
                anchor += static_cast<char>(std::tolower(c));
            else if (c == ' ')
                anchor += '-';
        anchors.push_back(anchor);
    }
    return anchors;
}

/// Of one link in a document: that it leads to a file or folder that is there, and to a heading in it.
void expect_target(const std::string& document, const std::string& link) {
    const std::string path = link.substr(0, link.find('#'));
    const auto target = std::filesystem::path(kTop + document).parent_path() / path;
    EXPECT_TRUE(path.empty() || std::filesystem::exists(target)) << document << ": " << link;
    if (link.find('#') == std::string::npos) return;
    const std::string there = path.empty() ? document : std::filesystem::relative(target, kTop).string();
    EXPECT_THAT(anchors_of("\n" + text_of(there)), ::testing::Contains(link.substr(link.find('#') + 1)))
        << document << ": " << link;
}

TEST(Documents, LinkOnlyToWhatIsThere) {
    std::size_t count = 0;
    for (const std::string& document : kDocuments) {
        const std::string text = text_of(document);
        EXPECT_NE(text, "") << document;
        for (const std::string& link : matches(text, R"(\]\(([^)\s]+)\))")) {
            if (link.starts_with("http")) continue;
            expect_target(document, link);
            ++count;
        }
    }
    EXPECT_GT(count, 100u);
}

TEST(Documents, AreAllLookedAt) {
    for (const char* folder : {"engine", "maps", "tests", "wadconv"})
        for (const auto& entry : std::filesystem::recursive_directory_iterator(kTop + folder)) {
            const std::string document = std::filesystem::relative(entry.path(), kTop).string();
            if (!document.ends_with(".md")) continue;
            EXPECT_THAT(kDocuments, ::testing::Contains(document));
        }
}

TEST(Documents, SayWhatEachPackageIsFor) {
    const std::string run = text_of("run"), manual = text_of("engine/README.md");
    std::vector<std::string> packages;
    for (const std::string& list : matches(run, "packages=\"([^\"]+)\""))
        for (const std::string& package : matches(list, "([a-z0-9+-]+)")) packages.push_back(package);
    EXPECT_GT(packages.size(), 10u);
    const auto begin = manual.find("| package | what for |");
    const std::string table = manual.substr(begin, manual.find("\n\n", begin) - begin);
    for (const std::string& package : packages) EXPECT_THAT(table, ::testing::HasSubstr("`" + package + "`"));
}

}  // namespace
}  // namespace enfilade::house
