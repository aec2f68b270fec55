// `enfilade expand`: a map with all its short words written out.
#include "app/commands.h"
#include "app/file_kind.h"
#include "app/open_map.h"
#include "base/files.h"
#include "base/terminal.h"
#include "formats/map_toml.h"

namespace enfilade {

int run_expand(const ExpandRequest& request) {
    const auto bytes = read_file(request.map);
    if (!bytes.ok()) return fail(refuse_as_map(request.map).error_or(bytes.error()));
    MapReading reading = read_map_at(request.map, as_text(bytes.value()), read_file);
    if (has_errors(reading.findings))
        if (const Result<void> valid = refuse_as_map(request.map); !valid.ok()) return fail(valid.error());
    tell_files(reading.findings, reading.sources);
    if (print_findings(request.map, reading.findings, Talk::usual)) return kFailed;
    const std::string text = write_map(reading.map);
    if (request.out.empty()) {
        print_text(stdout, text);
        return kDone;
    }
    if (const Result<void> done = write_file(request.out, std::string_view(text)); !done.ok())
        return fail(done.error());
    return kDone;
}

}  // namespace enfilade
