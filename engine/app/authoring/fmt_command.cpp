// `enfilade fmt`: maps laid out as this project writes them.
#include <fmt/format.h>

#include <algorithm>

#include "app/commands.h"
#include "app/file_kind.h"
#include "base/files.h"
#include "base/terminal.h"
#include "formats/text_parts.h"
#include "formats/toml.h"

namespace enfilade {
namespace {

enum class Outcome { same, other, failed };

Outcome lay_out(const std::string& path, bool only_check) {
    const auto bytes = read_file(path);
    if (!bytes.ok()) {
        fail(refuse_as_map(path).error_or(bytes.error()));
        return Outcome::failed;
    }
    const auto text = lay_out_toml(as_text(bytes.value()));
    if (!text.ok()) {
        fail({path, text.error().what});
        return Outcome::failed;
    }
    if (text.value() == as_text(bytes.value())) return Outcome::same;
    if (only_check) return Outcome::other;
    if (const Result<void> done = write_file(path, std::string_view(text.value())); !done.ok()) {
        fail(done.error());
        return Outcome::failed;
    }
    return Outcome::other;
}

}  // namespace

int run_fmt(const FmtRequest& request) {
    std::size_t others = 0, failures = 0;
    const std::vector<std::string> maps = maps_in_folders(request.maps);
    for (const std::string& map : maps) {
        const Outcome outcome = lay_out(map, request.check);
        others += outcome == Outcome::other;
        failures += outcome == Outcome::failed;
        if (outcome == Outcome::other) print_text(stdout, map + "\n");
    }
    print_text(stdout, fmt::format("{} looked at, {} {}\n", counted(maps.size(), "map"), others,
                                   request.check ? "would be laid out anew" : "laid out anew"));
    return failures > 0 || (request.check && others > 0) ? kFailed : kDone;
}

}  // namespace enfilade
