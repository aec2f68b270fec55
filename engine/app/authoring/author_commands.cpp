// What `enfilade` does for authors of maps: new, expand, fmt and draw.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/authoring/plan.h"
#include "app/commands.h"
#include "app/messages.h"
#include "app/open_map.h"
#include "app/programs.h"
#include "base/file_name.h"
#include "base/files.h"
#include "formats/map_toml.h"
#include "formats/text_parts.h"
#include "formats/toml.h"

namespace enfilade {
namespace {

namespace fs = std::filesystem;

// `enfilade new`: a small map to begin from.

/// Two rooms, a door and a lamp: one of everything that a house begins with. {0}: what stands before, {1}: the name,
/// {2}: the folders of pictures.
constexpr const char* kFirstMap =
    R"({0}# Lengths are in metres; x grows to the right, y down, as on a drawing. GUIDE.md goes on from here.
format = 1
name = {1}
textures = {2}
player = {{ sector = "hall", x = 1, y = 1.5 }}

[[sectors]]
name = "hall"
rect = [0, 0,  4, 3]
wall = {{ texture = "plaster_ochre 2,2" }}
floor = {{ z = 0, texture = "boards 2,2" }}
ceiling = {{ z = 3, texture = "beams 2,2" }}
light = 0.6

[[sectors]]
name = "yard"
rect = [4.25, -1,  9, 4]
wall = {{ texture = "brick 2,2" }}
floor = {{ z = 0, texture = "cobbles 2,2" }}
ceiling = {{ z = 4, texture = "sky_day 1,1.2", parallax = true }}

# A door between the two rooms: it cuts both walls, and what lies between them is its frame.
[[openings]]
between = ["hall", "yard"]
width = 1
top = 2.25
leaf = "door 1,2"
texture = "reveal 1,1"

[[lights]]
x = 1
y = 0.5
z = 2.25
color = "#ffc070"
reach = 5
)";

bool is_same_folder(const fs::path& a, const fs::path& b) {
    std::error_code unknown;
    return fs::equivalent(a.empty() ? "." : a, b, unknown);
}

/// As a shell takes it.
std::string in_shell(const std::string& path) {
    const bool is_plain =
        path.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._-/") ==
        std::string::npos;
    return is_plain ? path : shell_word(path);
}

std::string first_map(const fs::path& path) {
    const fs::path shipped = fs::path(shipped_map("enfilade.schema.json"));
    const bool is_beside = is_same_folder(path.parent_path(), shipped.parent_path());
    std::vector<std::string> folders{"textures"};
    if (!is_beside) folders.push_back((shipped.parent_path() / "textures").string());
    const std::string schema = "#:schema " + (is_beside ? file_name_of(shipped) : shipped.string()) + "\n";
    return fmt::format(kFirstMap, schema, string_text(file_stem_of(path)), value_text(folders));
}

}  // namespace

int run_new(const NewRequest& request) {
    fs::path path = request.name;
    if (path.extension() != ".toml") path += ".toml";
    std::error_code unknown;
    if (fs::exists(fs::symlink_status(path, unknown)))
        return fail({path.string(), "there is such a file already, and it is not overwritten; choose another name"});
    if (path.has_parent_path() && !fs::is_directory(path.parent_path(), unknown))
        return fail(
            {path.string(), "there is no folder " + in_quotes(path.parent_path().string()) + "; make it first"});
    if (const Result<void> done = write_file(path.string(), std::string_view(first_map(path))); !done.ok())
        return fail(done.error());
    return status_of(
        print_to_stdout(fmt::format("{} is a map of two rooms. `enfilade play {}` opens it; change it meanwhile.\n",
                                    path.string(), in_shell(path.string()))));
}

// `enfilade expand`: a map with all its short words written out; and `enfilade draw`: its plan.

namespace {

/// A map as the reader leaves it, its findings with the names of their files. An error where there is none to read, or
/// it is something else.
Result<MapReading> read_for_author(const std::string& path) {
    const auto bytes = read_file(path);
    if (!bytes.ok()) return refuse_as_map(path).error_or(bytes.error());
    MapReading reading = read_map_at(path, as_text(bytes.value()), read_file);
    if (has_errors(reading.findings))
        if (const Result<void> valid = refuse_as_map(path); !valid.ok()) return valid.error();
    tell_files(reading.findings, reading.sources);
    return reading;
}

}  // namespace

int run_expand(const ExpandRequest& request) {
    const auto reading = read_for_author(request.map);
    if (!reading.ok()) return fail(reading.error());
    if (print_findings(request.map, reading.value().findings, Talk::usual)) return kFailed;
    const std::string text = write_map(reading.value().map);
    return status_of(request.out.empty() ? print_to_stdout(text) : write_file(request.out, std::string_view(text)));
}

int run_draw(const DrawRequest& request) {
    const auto reading = read_for_author(request.map);
    if (!reading.ok()) return fail(reading.error());
    const bool has_faults = print_findings(request.map, reading.value().findings, Talk::errors_only);
    if (const Result<void> done = write_file(request.out, std::string_view(plan_svg(reading.value().map))); !done.ok())
        return fail(done.error());
    return has_faults ? kFailed : kDone;
}

// `enfilade fmt`: maps laid out as this project writes them.

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
        if (outcome != Outcome::other) continue;
        if (const Result<void> done = print_to_stdout(map + "\n"); !done.ok()) return fail(done.error());
    }
    const std::string summary = fmt::format("{} looked at, {} {}\n", counted(maps.size(), "map"), others,
                                            request.check ? "would be laid out anew" : "laid out anew");
    if (const Result<void> done = print_to_stdout(summary); !done.ok()) return fail(done.error());
    return failures > 0 || (request.check && others > 0) ? kFailed : kDone;
}

}  // namespace enfilade
