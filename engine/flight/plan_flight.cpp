#include <filesystem>

#include "base/hash.h"
#include "flight/flight.h"
#include "formats/tape.h"

namespace enfilade {
namespace {

/// The tape that a script names, if it was recorded with the map as it is now.
Result<Tape> open_tape(const std::string& path, const std::string& map_path, const FileReader& read) {
    const auto bytes = read(path), map = read(map_path);
    if (!bytes.ok()) return bytes.error();
    auto tape = read_tape(bytes.value());
    if (!tape.ok()) return Error{path + ": " + tape.error().where, tape.error().what};
    if (map.ok() && hash_of_text(as_text(map.value())) != tape.value().map_hash)
        return Error{path, "the tape was recorded with another version of " + map_path + "; record it again"};
    return tape;
}

}  // namespace

std::string beside_script(const std::string& script_path, const std::string& path) {
    return (std::filesystem::path(script_path).parent_path() / path).lexically_normal().string();
}

std::optional<Flight> plan_flight(const std::string& script_path, const ScriptFile& script, const Map& map,
                                  const FileReader& read, Findings& findings) {
    if (script.tape.empty()) return Flight::plan(script, map, findings);
    auto tape = open_tape(beside_script(script_path, script.tape), beside_script(script_path, script.map), read);
    if (tape.ok()) return Flight::plan(script, map, std::move(tape).value(), findings);
    findings.push_back({script.tape_place, Severity::error, "tape-unreadable", tape.error().text()});
    return {};
}

}  // namespace enfilade
