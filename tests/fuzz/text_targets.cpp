// Scripts, lists of views, recorded hashes and texture specifications.
#include <cmath>

#include "base/files.h"
#include "flight/flight.h"
#include "formats/both_parsers.h"
#include "formats/frame_hashes.h"
#include "formats/map_keys.h"
#include "formats/script.h"
#include "formats/toml_tree.h"
#include "formats/views_csv.h"
#include "fuzz/targets.h"
#include "support/map_builder.h"

namespace enfilade::test {
namespace {

/// Two rooms side by side and a link out of one of them.
Map flown_map() {
    MapFile file = map_of({box_room("left", 0, 0, 8, 4, 0, 3), box_room("right", 8, 0, 16, 4, 0.5, 3),
                           box_room("far", 100, 0, 104, 4, 7, 9)});
    join_all(file);
    link(file, "left", {0, 4}, {0, 0}, "far", {100, 0}, {104, 0});
    sector(file, "right").triggers.emplace_back();  // a door that opens when it is used
    place_player(file, "left", {2, 2}, 1.5);
    return built(file);
}

void check_frame(const Map& map, const FlightFrame& frame) {
    ENFILADE_CHECK(contains(map, frame.view.sector, frame.view.eye));
    ENFILADE_CHECK(std::isfinite(frame.view.eye_z) && std::isfinite(frame.view.pitch_tangent));
}

}  // namespace

void fuzz_toml(std::span<const std::byte> bytes) {
    const std::string_view text = as_text(bytes);
    Findings findings, of_the_library;
    const auto document = TomlDocument::parse(text, {}, findings);
    ENFILADE_CHECK(document.has_value() == !has_errors(findings));
    const ParsedTwice parsed = parse_twice(text);
    ENFILADE_CHECK(!parsed.is_plain || parsed.plain == parsed.any);
    const bool is_read = parse_any_toml(text, of_the_library).has_value();
    ENFILADE_CHECK(is_read == !has_errors(of_the_library));
    ENFILADE_CHECK(!document || is_read);
}

void fuzz_script(std::span<const std::byte> bytes) {
    static const Map map = flown_map();
    ScriptReading reading = read_script(as_text(bytes));
    is_script(as_text(bytes));
    if (has_errors(reading.findings) || !reading.script.tape.empty()) return;
    const auto flight = Flight::plan(reading.script, map, reading.findings);
    ENFILADE_CHECK(flight.has_value() == !has_errors(reading.findings));
    if (!flight) return;
    for (int i = 0; i <= 8; ++i)
        check_frame(map, flight->at(map, static_cast<int>((flight->frames() - 1) * std::int64_t{i} / 8)));
}

void fuzz_views(std::span<const std::byte> bytes) {
    const ViewsReading reading = read_views(as_text(bytes));
    for (const ViewRow& view : reading.views)
        for (const double number : {view.x, view.y, view.z, view.yaw_degrees, view.pitch_degrees})
            ENFILADE_CHECK(has_errors(reading.findings) || std::isfinite(number));
    if (const auto view = parse_view(as_text(bytes))) ENFILADE_CHECK(std::fabs(view.value().pitch_degrees) <= 89);
}

void fuzz_hashes(std::span<const std::byte> bytes) {
    const auto recording = read_frame_hashes(as_text(bytes));
    if (!recording.ok()) return;
    const auto again = read_frame_hashes(write_frame_hashes(recording.value()));
    ENFILADE_CHECK(again.ok() && again.value() == recording.value());
}

void fuzz_texture(std::span<const std::byte> bytes) {
    const auto spec = parse_texture_spec(as_text(bytes));
    if (!spec.ok()) return;
    ENFILADE_CHECK(!spec.value().name.empty());
    ENFILADE_CHECK(std::isfinite(spec.value().offset_tx.x) && std::isfinite(spec.value().offset_tx.y));
    if (spec.value().tile_m) ENFILADE_CHECK(spec.value().tile_m->x != 0 && spec.value().tile_m->y != 0);
}

}  // namespace enfilade::test
