// The README says only what is true: its map loads without a finding, and its links lead somewhere.
#include <gmock/gmock.h>

#include <filesystem>
#include <regex>

#include "base/files.h"
#include "map/load.h"

namespace enfilade::house {
namespace {

const std::string kTop = std::string(ENFILADE_SOURCE_DIR) + "/";

std::string readme() {
    const auto bytes = read_file(kTop + "README.md");
    return bytes.ok() ? std::string(as_text(bytes.value())) : "";
}

/// What stands in the first block that starts with ```toml.
std::string map_in(const std::string& text) {
    const std::string opening = "```toml\n";
    const auto begin = text.find(opening);
    if (begin == std::string::npos) return "";
    const auto end = text.find("```", begin + opening.size());
    return text.substr(begin + opening.size(), end - begin - opening.size());
}

TEST(Readme, HasAMapThatLoadsWithoutAFinding) {
    const std::string path = kTop + "maps/mine.toml";
    const std::string text = map_in(readme());
    const FileReader read = [&](const std::string& asked) -> Result<Bytes> {
        if (asked != path) return read_file(asked);
        const auto bytes = std::as_bytes(std::span(text));
        return Bytes(bytes.begin(), bytes.end());
    };
    const LoadedMap loaded = load_map(path, {}, read);
    for (const Finding& finding : loaded.findings) ADD_FAILURE() << to_text("README.md", finding);
    EXPECT_TRUE(loaded.map);
}

TEST(Readme, LinksOnlyToWhatIsThere) {
    const std::string text = readme();
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
