#include "app/open_flight.h"

#include <filesystem>

#include "app/exit_codes.h"
#include "app/file_kind.h"
#include "base/files.h"
#include "base/hash.h"
#include "base/terminal.h"
#include "formats/script_toml.h"
#include "formats/tape.h"

namespace enfilade {
namespace {

/// Prints them; true where one is an error.
bool print_findings(const std::string& path, const Findings& findings) {
    for (const Finding& finding : findings) print_text(stderr, to_text(path, finding) + "\n");
    return has_errors(findings);
}

/// A path as the script gives it, seen from the script's folder.
std::string beside(const std::string& script_path, const std::string& path) {
    return (std::filesystem::path(script_path).parent_path() / path).lexically_normal().string();
}

std::optional<ScriptFile> open_script(const std::string& path) {
    const auto bytes = read_file(path);
    if (!bytes.ok()) {
        fail(refuse_as_script(path).value_or(bytes.error()));
        return {};
    }
    ScriptReading reading = read_script(as_text(bytes.value()));
    const Status other = has_errors(reading.findings) ? refuse_as_script(path) : Status();
    if (other) fail(*other);
    if (other || print_findings(path, reading.findings)) return {};
    return std::move(reading.script);
}

/// The tape that a script names, if it was recorded with the map as it is now.
Result<Tape> open_tape(const std::string& path, const std::string& map_path) {
    const auto bytes = read_file(path), map = read_file(map_path);
    if (!bytes.ok()) return bytes.error();
    auto tape = read_tape(bytes.value());
    if (!tape.ok()) return Error{path + ": " + tape.error().where, tape.error().what};
    if (map.ok() && hash_of_text(as_text(map.value())) != tape.value().map_hash)
        return Error{path, "the tape was recorded with another version of " + map_path + "; record it again"};
    return tape;
}

std::optional<Flight> plan(const std::string& script_path, const ScriptFile& script, const Map& map,
                           Findings& findings) {
    if (script.tape.empty()) return Flight::plan(script, map, findings);
    auto tape = open_tape(beside(script_path, script.tape), beside(script_path, script.map));
    if (tape.ok()) return Flight::plan(script, map, std::move(tape).value(), findings);
    findings.push_back({script.tape_place, Severity::error, "tape-unreadable", tape.error().text()});
    return {};
}

}  // namespace

std::optional<OpenFlight> open_flight(const std::string& script_path, const std::vector<std::string>& texture_folders,
                                      int skill) {
    auto script = open_script(script_path);
    if (!script) return {};
    auto map = open_map(beside(script_path, script->map), texture_folders, skill);
    if (!map) return {};
    Findings findings;
    auto flight = plan(script_path, *script, map->map, findings);
    print_findings(script_path, findings);
    if (!flight) return {};
    return OpenFlight{std::move(*script), std::move(*map), std::move(*flight)};
}

}  // namespace enfilade
