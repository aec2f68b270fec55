// The guide for authors: after each step the map is sound, and what it says of a wrong line is what is said.
#include <gmock/gmock.h>

#include "base/files.h"
#include "formats/text_parts.h"
#include "formats/toml.h"
#include "map/load.h"

namespace enfilade {
namespace {

const std::string kMaps = ENFILADE_SOURCE_DIR "/maps/";

std::string text_in(const std::string& path) {
    const auto bytes = read_file(path);
    return bytes.ok() ? std::string(as_text(bytes.value())) : "";
}

struct Block {
    std::string language, text;
};

/// What stands between lines of three backquotes.
std::vector<Block> blocks_of(const std::string& markdown) {
    std::vector<Block> blocks;
    bool inside = false;
    for (LineReader lines(markdown); const auto line = lines.next();) {
        if (line->text.starts_with("```")) {
            inside = !inside;
            if (inside) blocks.push_back({std::string(line->text.substr(3)), ""});
        } else if (inside) {
            blocks.back().text += std::string(line->text) + "\n";
        }
    }
    return blocks;
}

/// What `enfilade check house.toml` would say of a text in maps/.
std::string said_about(const std::string& text) {
    const std::string path = kMaps + "house.toml";
    const LoadedMap loaded = load_map(path, {}, [&](const std::string& wanted) -> Result<Bytes> {
        if (wanted != path) return read_file(wanted);
        const auto bytes = std::as_bytes(std::span(text));
        return Bytes(bytes.begin(), bytes.end());
    });
    std::string said;
    for (const Finding& finding : loaded.findings)
        said += to_text("house.toml", finding) + "\n" + caret_lines(text, finding.place);
    return said;
}

TEST(Guide, IsASoundMapAfterEachStep) {
    std::string map;
    int steps = 0;
    for (const Block& block : blocks_of(text_in(kMaps + "GUIDE.md"))) {
        if (block.language != "toml") continue;
        map += (map.empty() ? "" : "\n") + block.text;
        EXPECT_EQ(said_about(map), "") << block.text;
        const auto laid_out = lay_out_toml(map);
        ASSERT_TRUE(laid_out.ok()) << laid_out.error().what;
        EXPECT_EQ(laid_out.value(), map) << "as fmt would lay it out";
        ++steps;
    }
    EXPECT_EQ(steps, 9);
}

TEST(Guide, SaysWhatIsSaidAboutAWrongLine) {
    std::string map;
    const std::vector<Block> blocks = blocks_of(text_in(kMaps + "GUIDE.md"));
    for (std::size_t i = 0; i + 1 < blocks.size(); ++i) {
        if (blocks[i].language.starts_with("toml")) map += (map.empty() ? "" : "\n") + blocks[i].text;
        if (blocks[i].language != "toml wrong") continue;
        EXPECT_EQ(said_about(map), blocks[i + 1].text);
        return;
    }
    ADD_FAILURE() << "the guide shows no wrong line";
}

}  // namespace
}  // namespace enfilade
