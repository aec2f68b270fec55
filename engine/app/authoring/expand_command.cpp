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
    if (!bytes.ok()) return fail(refuse_as_map(request.map).value_or(bytes.error()));
    MapReading reading = read_map_at(request.map, as_text(bytes.value()), read_file);
    if (has_errors(reading.findings))
        if (Status other = refuse_as_map(request.map)) return fail(*other);
    tell_files(reading.findings, reading.sources);
    if (print_findings(request.map, reading.findings, Talk::usual)) return kFailed;
    const std::string text = write_map(reading.map);
    if (request.out.empty()) {
        print_text(stdout, text);
        return kDone;
    }
    if (Status failed = write_file(request.out, std::string_view(text))) return fail(*failed);
    return kDone;
}

}  // namespace enfilade
