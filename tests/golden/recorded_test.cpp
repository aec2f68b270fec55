// The recorded flythroughs once more, without the program: what another compiler has to draw alike needs no window.
#include <gmock/gmock.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>

#include "flight/comparison.h"
#include "flight/flight.h"
#include "formats/frame_hashes.h"
#include "formats/png.h"
#include "formats/script.h"
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

/// Every so-many-th frame is drawn: all, unless somebody has no time for that.
int frame_step() {
    const char* step = std::getenv("ENFILADE_FRAME_STEP");
    return step ? std::max(std::atoi(step), 1) : 1;
}

/// Frames that are not drawn as they were recorded, of those that are drawn.
std::vector<std::uint32_t> other_frames(const FlightScene& scene, const ScriptFile& script,
                                        const std::vector<FrameHash>& recorded) {
    std::vector<std::uint32_t> others;
    const auto renderer = make_renderer({}, scene.map, scene.textures);
    Frame frame;
    frame.resize(script.width, script.height);
    for (int number = 0; number < scene.flight.frames(); number += frame_step()) {
        EXPECT_TRUE(draw_frame(scene, number, *renderer.value(), frame).ok());
        const FrameHash drawn{static_cast<std::uint32_t>(number), hash_of(frame)};
        if (recorded[drawn.frame] != drawn) others.push_back(drawn.frame);
    }
    return others;
}

/// The hash of the picture in a file; none where there is no picture.
std::optional<std::uint64_t> hash_of_picture(const fs::path& path) {
    const auto bytes = read_file(path.string());
    auto image = bytes.ok() ? read_png(bytes.value()) : bytes.error();
    if (!image.ok()) return {};
    return hash_of(frame_of(image.value()));
}

/// The hash of the sheet of small pictures as it is drawn now.
std::uint64_t hash_of_sheet(const FlightScene& scene, const ScriptFile& script) {
    ContactSheet sheet(scene.flight.frames(), script.width, script.height);
    const auto renderer = make_renderer({}, scene.map, scene.textures);
    Frame frame;
    frame.resize(script.width, script.height);
    for (const int number : frames_on_sheet(scene.flight.frames())) {
        EXPECT_TRUE(draw_frame(scene, number, *renderer.value(), frame).ok());
        sheet.put(number, frame);
    }
    return hash_of(sheet.image());
}

class RecordedFlythrough : public testing::TestWithParam<fs::path> {};

// hard case I13
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
    const auto& hashes = recorded.value().frames;
    ASSERT_EQ(hashes.size(), static_cast<std::size_t>(flight->frames()));
    const FlightScene scene{*flight, *loaded.map, loaded.textures};
    EXPECT_THAT(other_frames(scene, reading.script, hashes), testing::IsEmpty());
    EXPECT_EQ(recorded.value().sheet, hash_of_sheet(scene, reading.script));
    EXPECT_EQ(recorded.value().sheet, hash_of_picture(fs::path(path).replace_extension(".sheet.png")));
}

std::string name_of(const testing::TestParamInfo<fs::path>& info) {
    std::string name = info.param.stem().string();
    std::erase_if(name, [](unsigned char c) { return !std::isalnum(c); });
    return name;
}

INSTANTIATE_TEST_SUITE_P(Maps, RecordedFlythrough, testing::ValuesIn(recorded_scripts()), name_of);

}  // namespace
}  // namespace enfilade::test
