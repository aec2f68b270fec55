// The recorded flythroughs once more, without the program: what another compiler has to draw alike needs no window.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "flight/comparison.h"
#include "flight/draw_frames.h"
#include "formats/script_toml.h"
#include "map/load.h"

namespace enfilade::test {
namespace {

namespace fs = std::filesystem;

const fs::path kScripts = ENFILADE_SOURCE_DIR "/maps/flythroughs";

std::vector<fs::path> recorded_scripts() {
    std::vector<fs::path> paths;
    for (const auto& entry : fs::directory_iterator(kScripts))
        if (entry.path().extension() == ".hashes") paths.push_back(fs::path(entry.path()).replace_extension(".toml"));
    std::sort(paths.begin(), paths.end());
    return paths;
}

std::string text_of(const fs::path& path) {
    const auto bytes = read_file(path.string());
    EXPECT_TRUE(bytes.ok()) << path;
    return bytes.ok() ? std::string(as_text(bytes.value())) : "";
}

std::vector<std::uint64_t> hashes_of(const FlightScene& scene, const ScriptFile& script) {
    std::vector<std::uint64_t> hashes;
    const int last = scene.flight.frames() - 1;
    const DrawPlan plan{RendererKind::column, script.width, script.height, 0, last, 1, {}};
    EXPECT_FALSE(draw_frames_in_order(scene, plan, [&](int, const Frame& frame, std::size_t) {
        hashes.push_back(hash_of(frame));
        return Status{};
    }));
    return hashes;
}

class RecordedFlythrough : public testing::TestWithParam<fs::path> {};

TEST_P(RecordedFlythrough, IsDrawnAsItWasRecorded) {
    const fs::path path = GetParam();
    const ScriptReading reading = read_script(text_of(path));
    ASSERT_TRUE(reading.script.tape.empty()) << "flown by what was pressed: hold it to its record by the program";
    const LoadedMap loaded = load_map((path.parent_path() / reading.script.map).string(), {}, read_file);
    ASSERT_TRUE(loaded.map);
    Findings findings;
    const auto flight = Flight::plan(reading.script, *loaded.map, findings);
    ASSERT_TRUE(flight);
    const auto recorded = read_frame_hashes(text_of(fs::path(path).replace_extension(".hashes")));
    ASSERT_TRUE(recorded.ok());
    const auto drawn = hashes_of({*flight, *loaded.map, loaded.textures}, reading.script);
    ASSERT_EQ(recorded.value().frames.size(), drawn.size());
    const auto others = mismatches(recorded.value().frames, 0, drawn);
    EXPECT_TRUE(others.empty()) << others.size() << " frames, the first is " << others.front().frame;
}

std::string name_of(const testing::TestParamInfo<fs::path>& info) {
    std::string name = info.param.stem().string();
    std::erase_if(name, [](unsigned char c) { return !std::isalnum(c); });
    return name;
}

INSTANTIATE_TEST_SUITE_P(Maps, RecordedFlythrough, testing::ValuesIn(recorded_scripts()), name_of);

}  // namespace
}  // namespace enfilade::test
