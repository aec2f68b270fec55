// Maps: as text in both dialects, and legal ones made of bytes.
#include "base/files.h"
#include "formats/map_toml.h"
#include "formats/toml.h"
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

/// What prefabs of a map find: the map itself under the name "self", otherwise a room.
Result<Bytes> prefab_of(std::span<const std::byte> map, const std::string& name) {
    constexpr std::string_view kRoom = "format = 1\n[[sectors]]\nname = 'room'\nrect = [0, 0, 2, 1]\nwall = {}\n";
    const auto room = std::as_bytes(std::span(kRoom));
    return name == "self" ? Bytes(map.begin(), map.end()) : Bytes(room.begin(), room.end());
}

/// Laid out anew it says the same, and is laid out already.
void check_layout(std::string_view text) {
    const auto once = lay_out_toml(text);
    if (!once.ok()) return ENFILADE_CHECK(once.error().what.find("please report") == std::string::npos);
    const auto twice = lay_out_toml(once.value());
    ENFILADE_CHECK(twice.ok() && twice.value() == once.value());
}

}  // namespace

void fuzz_map(std::span<const std::byte> bytes) {
    const std::string_view text = as_text(bytes);
    check_layout(text);
    MapReading reading = read_map(text, [&](const std::string& name) { return prefab_of(bytes, name); });
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
