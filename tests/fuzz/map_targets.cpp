// Maps: as text in both dialects, and legal ones made of bytes.
#include "base/files.h"
#include "formats/map_toml.h"
#include "fuzz/targets.h"
#include "support/map_builder.h"
#include "wild/trial.h"
#include "wild/worlds.h"

namespace enfilade::test {
namespace {

/// What is written is read again as the same, and so is what is written then.
void check_writing(const MapFile& file) {
    const std::string text = write_map(file);
    const MapReading again = read_map(text);
    ENFILADE_CHECK(!has_errors(again.findings));
    ENFILADE_CHECK(write_map(again.map) == text);
}

void expect_no_fault(const TrialMap& on, const TrialPlan& plan) {
    const std::optional<Fault> fault = first_fault(on, plan);
    if (fault) contract_broken(__FILE__, __LINE__, fault->what.c_str());
}

}  // namespace

void fuzz_map(std::span<const std::byte> bytes) {
    const std::string_view text = as_text(bytes);
    MapReading reading = read_map(text);
    is_map(text);
    if (!has_errors(reading.findings)) check_writing(reading.map);
    const TextureSet textures = textures_for(reading.map);
    const std::optional<Map> map = build_map(reading.map, textures, reading.findings);
    ENFILADE_CHECK(map.has_value() == !has_errors(reading.findings));
    if (map) expect_no_fault({*map, textures}, {.seed = text.size(), .poses = 1, .largest = {16, 12}, .ticks = 60});
}

void fuzz_world(std::span<const std::byte> bytes) {
    Choices choices(bytes);
    const MapFile file = wild_world(choices);
    check_writing(file);
    const TextureSet textures = textures_for(file);
    Findings findings;
    const std::optional<Map> map = build_map(file, textures, findings);
    if (!map) contract_broken(__FILE__, __LINE__, text_of(findings).c_str());
    expect_no_fault({*map, textures}, {.seed = bytes.size(), .poses = 2, .largest = {24, 16}, .ticks = 60});
}

}  // namespace enfilade::test
