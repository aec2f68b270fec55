// `enfilade draw`: the plan of a map.
#include "app/authoring/plan.h"
#include "app/commands.h"
#include "app/file_kind.h"
#include "app/open_map.h"
#include "base/files.h"
#include "formats/map_toml.h"

namespace enfilade {

int run_draw(const DrawRequest& request) {
    const auto bytes = read_file(request.map);
    if (!bytes.ok()) return fail(refuse_as_map(request.map).error_or(bytes.error()));
    MapReading reading = read_map_at(request.map, as_text(bytes.value()), read_file);
    if (has_errors(reading.findings))
        if (const Result<void> valid = refuse_as_map(request.map); !valid.ok()) return fail(valid.error());
    tell_files(reading.findings, reading.sources);
    const bool has_faults = print_findings(request.map, reading.findings, Talk::errors_only);
    if (const Result<void> done = write_file(request.out, std::string_view(plan_svg(reading.map))); !done.ok())
        return fail(done.error());
    return has_faults ? kFailed : kDone;
}

}  // namespace enfilade
