// `enfilade new`: a small map to begin from.
#include <fmt/format.h>

#include <filesystem>

#include "app/commands.h"
#include "app/file_kind.h"
#include "base/files.h"
#include "base/terminal.h"
#include "formats/text_parts.h"

namespace enfilade {
namespace {

namespace fs = std::filesystem;

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
    if (is_plain) return path;
    std::string quoted = "'";
    for (const char c : path) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

std::string first_map(const fs::path& path) {
    const fs::path shipped = fs::path(shipped_map("enfilade.schema.json"));
    const bool is_beside = is_same_folder(path.parent_path(), shipped.parent_path());
    std::vector<std::string> folders{"textures"};
    if (!is_beside) folders.push_back((shipped.parent_path() / "textures").string());
    const std::string schema = "#:schema " + (is_beside ? shipped.filename() : shipped).string() + "\n";
    return fmt::format(kFirstMap, schema, string_text(path.stem().string()), value_text(folders));
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
    print_text(stdout, fmt::format("{} is a map of two rooms. `enfilade play {}` opens it; change it meanwhile.\n",
                                   path.string(), in_shell(path.string())));
    return kDone;
}

}  // namespace enfilade
