#include "testing/flythrough.h"

#include <utility>

#include "base/files.h"
#include "flight/comparison.h"
#include "formats/script.h"
#include "map/load.h"

namespace enfilade {
namespace {

/// All errors about one file, one a line.
Error errors_in(const std::string& path, const Findings& findings) {
    std::string lines;
    for (const Finding& finding : findings)
        if (finding.severity == Severity::error) lines += (lines.empty() ? "" : "\n") + to_text(path, finding);
    return {"", lines};
}

Result<std::unique_ptr<GlContext>> no_open_gl() {
    return Error{"", "a test without a window has no OpenGL; let `enfilade fly --check` check this script"};
}

Result<std::vector<Mismatch>> check_frames(const std::string& script_path, const FlightScene& scene,
                                           const DrawPlan& plan) {
    const auto recording = read_recording(script_path, read_file);
    if (!recording.ok()) return recording.error();
    if (const Result<void> valid = refuse_recording(recording.value(), plan, scene.flight.frames(), script_path);
        !valid.ok())
        return valid.error();
    const auto hashes = hash_frames(scene, plan);
    if (!hashes.ok()) return hashes.error();
    return mismatches(recording.value().frames, plan.first, hashes.value());
}

}  // namespace

Result<std::vector<Mismatch>> check_flythrough(const std::string& script_path, std::size_t threads) {
    const auto bytes = read_file(script_path);
    if (!bytes.ok()) return bytes.error();
    const ScriptReading reading = read_script(as_text(bytes.value()));
    if (has_errors(reading.findings)) return errors_in(script_path, reading.findings);
    const ScriptFile& script = reading.script;
    const std::string map_path = beside_script(script_path, script.map);
    const LoadedMap loaded = load_map(map_path, {}, read_file, kUsualSkill);
    if (!loaded.map) return errors_in(map_path, loaded.findings);
    Findings findings;
    const auto flight = plan_flight(script_path, script, *loaded.map, read_file, findings);
    if (!flight) return errors_in(script_path, findings);
    const DrawPlan plan{script.renderer,      script.dials, script.width, script.height, 0,
                        flight->frames() - 1, threads,      no_open_gl};
    return check_frames(script_path, {*flight, *loaded.map, loaded.textures}, plan);
}

}  // namespace enfilade
