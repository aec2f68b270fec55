// Every finding has a map in tests/data/bad_maps that shows it. The first line of each says which finding is expected
// and where: "# expect: edges-cross at 17:5", the line and column of the key's value that is wrong, or of the record
// that lacks a key. 0:0 is the file as a whole.
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>

#include "formats/png.h"
#include "map/load.h"

namespace enfilade {
namespace {

const std::string kSourceFolder = ENFILADE_SOURCE_DIR;

/// Files in the order of their names.
std::vector<std::string> files_in(const std::string& folder, const std::string& ending) {
    std::vector<std::string> paths;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ending) paths.push_back(entry.path().string());
    std::sort(paths.begin(), paths.end());
    return paths;
}

std::string text_in(const std::string& path) {
    const auto bytes = read_file(path);
    return bytes ? std::string(as_text(bytes.value())) : std::string();
}

/// Maps come from the disk; of pictures, "missing" is not there, from whichever side, "broken" is no picture, all
/// others are one pixel.
Result<Bytes> read_map_or_picture(const std::string& path) {
    if (!path.ends_with(".png")) return read_file(path);
    if (path.find("/missing") != std::string::npos) return Error{path, "no such file"};
    if (path.ends_with("/broken.png")) return Bytes(100, std::byte{'?'});
    return write_png({1, 1, {0xFF808080u}});
}

/// "edges-cross at 17:5"
std::string in_short(const Finding& finding) {
    return finding.code + " at " + std::to_string(finding.place.line) + ":" + std::to_string(finding.place.column);
}

std::string expectation_of(const std::string& path) {
    const std::string text = text_in(path), start = "# expect: ";
    const std::string first_line = text.substr(0, text.find('\n'));
    return first_line.starts_with(start) ? first_line.substr(start.size()) : "(no '# expect:' line)";
}

class BadMap : public testing::TestWithParam<std::string> {};

// hard cases R18, T1
TEST_P(BadMap, HasExactlyTheFindingItNames) {
    const LoadedMap loaded = load_map(GetParam(), {}, read_map_or_picture);
    std::vector<std::string> found;
    std::string sentences;
    for (const Finding& finding : loaded.findings) {
        found.push_back(in_short(finding));
        sentences += to_text(GetParam(), finding) + "\n";
    }
    EXPECT_THAT(found, testing::ElementsAre(expectation_of(GetParam()))) << sentences;
}

TEST_P(BadMap, IsRefusedExactlyIfTheFindingIsAnError) {
    const LoadedMap loaded = load_map(GetParam(), {}, read_map_or_picture);
    EXPECT_EQ(loaded.map.has_value(), !has_errors(loaded.findings));
}

/// "edges_cross" as EdgesCross.
std::string test_name(const testing::TestParamInfo<std::string>& param) {
    std::string name;
    bool upper = true;
    for (char c : std::filesystem::path(param.param).stem().string()) {
        if (c != '_') name += upper ? static_cast<char>(std::toupper(c)) : c;
        upper = c == '_';
    }
    return name;
}

INSTANTIATE_TEST_SUITE_P(All, BadMap, testing::ValuesIn(files_in(kSourceFolder + "/tests/data/bad_maps", ".toml")),
                         test_name);

/// Codes no small file can show: each has a test of its own.
const std::set<std::string> kShownElsewhere{"too-large",         "too-many-findings", "too-many-errors",
                                            "too-many-warnings", "too-many-panels",   "too-many-lights",
                                            "too-many-targets",  "too-many-keys",     "too-many-pictures"};

/// Files in engine/formats that read something else than maps, or have words that only look like codes, by the start of
/// their names.
constexpr std::string_view kOtherReaders[] = {"script", "tape", "views", "frame_hashes", "toml_words"};

bool is_about_maps(const std::string& path) {
    const std::string name = std::filesystem::path(path).filename().string();
    return std::none_of(std::begin(kOtherReaders), std::end(kOtherReaders),
                        [&](std::string_view start) { return name.starts_with(start); });
}

/// Every "like-this" that the readers and the builder of maps note as a finding's code.
std::set<std::string> codes_in_the_source() {
    const std::regex code("\"([a-z]+(-[a-z0-9]+)+)\"");
    std::set<std::string> codes;
    for (const char* folder : {"/engine/formats", "/engine/map"})
        for (const char* ending : {".cpp", ".h"})
            for (const std::string& path : files_in(kSourceFolder + folder, ending)) {
                const std::string text = is_about_maps(path) ? text_in(path) : "";
                for (std::sregex_iterator it(text.begin(), text.end(), code), end; it != end; ++it)
                    codes.insert((*it)[1]);
            }
    return codes;
}

TEST(BadMaps, ShowEveryCodeInTheSource) {
    std::set<std::string> shown = kShownElsewhere;
    for (const std::string& path : files_in(kSourceFolder + "/tests/data/bad_maps", ".toml")) {
        const std::string expectation = expectation_of(path);
        shown.insert(expectation.substr(0, expectation.find(' ')));
    }
    for (const std::string& code : codes_in_the_source())
        EXPECT_TRUE(shown.count(code)) << code << " has no bad map";  // or belongs to kOtherReaders
}

}  // namespace
}  // namespace enfilade
