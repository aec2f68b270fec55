#include "app/messages.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <iterator>
#include <optional>

#include "base/file_name.h"
#include "base/files.h"
#include "base/text.h"
#include "formats/map_toml.h"
#include "formats/script.h"
#include "formats/tape.h"
#include "formats/text_parts.h"

namespace enfilade {

int fail(const Error& error) { return fail("enfilade", error); }

int status_of(const Result<void>& done) { return done.ok() ? kDone : fail(done.error()); }

int refuse_usage(const Error& error) {
    fail(error);
    return kUsage;
}

CutShortNote::~CutShortNote() {
    if (count_ == 0 || talk_ == Talk::errors_only) return;
    print_to_stderr(fmt::format("{}: note: in {} {}\n", out_, counted(count_, "picture"), kCutShort));
}

namespace {

namespace fs = std::filesystem;

bool is_folder(const std::string& path) {
    std::error_code unknown;
    return fs::is_directory(path, unknown);
}

bool is_there(const std::string& path) {
    std::error_code unknown;
    return fs::exists(path, unknown);
}

constexpr std::size_t kWadMagicBytes = 4;

bool is_wad(std::string_view text) { return text.starts_with("IWAD") || text.starts_with("PWAD"); }

/// How tapes begin (formats/tape.cpp), also those that were cut off.
bool is_tape(std::string_view text) { return text.starts_with("ENFTAPE"); }

/// The paths of a folder's *.toml files, sorted.
std::vector<std::string> toml_files_in(const fs::path& folder) {
    std::vector<std::string> paths;
    for (const std::string& name : list_folder(folder.string()))
        if (name.ends_with(".toml")) paths.push_back((folder / name).string());
    return paths;
}

bool is_script_file(const std::string& path) {
    const auto bytes = read_beginning(path, kMaxScriptBytes + 1);  // more are no script
    return bytes.ok() && is_script(as_text(bytes.value()));
}

/// "; did you mean X?" with the file beside it that is called nearly so, or nothing.
std::string nearest_file(const std::string& path) {
    if (is_there(path + ".toml")) return fmt::format("; did you mean {}.toml?", path);
    const fs::path folder = fs::path(path).parent_path();
    const std::vector<std::string> names = list_folder(folder.empty() ? "." : folder.string());
    const fs::path ending = fs::path(path).extension();  // what files of one kind share makes none like another
    std::vector<std::string> stems;
    for (const std::string& name : names)
        if (fs::path(name).extension() == ending) stems.push_back(file_stem_of(name));
    const std::vector<std::string_view> known(stems.begin(), stems.end());
    const std::string_view near = nearest_word(file_stem_of(path), known);
    return near.empty() ? "" : fmt::format("; did you mean {}{}?", (folder / near).string(), ending.string());
}

/// With a file in it of the kind that is wanted, where there is one.
std::string about_folder(const std::string& path, bool wants_script) {
    const std::vector<std::string> files = toml_files_in(path);
    const auto file = std::ranges::find(files, wants_script, is_script_file);
    if (file == files.end()) return "found a folder without any";
    return fmt::format("found a folder; name a file in it, such as {}", *file);
}

std::string about_tape(const std::string& path, const Bytes& bytes) {
    const auto tape = read_tape(bytes);
    if (!tape.ok()) return "found a tape or saved game that cannot be read: " + tape.error().text();
    return fmt::format(
        "found a tape or saved game of {0}; `enfilade play {0} --load {1}` goes on where it ends, and a script of the "
        "lines map = \"{0}\" and tape = \"{1}\" lets `enfilade fly` film it",
        tape.value().map, path);
}

std::string about_script(const std::string& path) {
    return fmt::format("found a flythrough script; `enfilade fly {} --out FILM.mp4` films it", path);
}

std::string about_map(const std::string& path) {
    return fmt::format(
        "found a map; `enfilade play {0}` walks through it and `enfilade render {0} --out FILE.png` draws it; a script "
        "has map = \"{1}\" and says where the camera goes",
        path, file_name_of(path));
}

/// What every command that takes neither says about what is no text of ours; none where it may be one.
std::optional<std::string> about_others(const std::string& path, const Bytes& bytes) {
    if (is_wad(as_text(bytes)))
        return fmt::format("found a WAD of Doom; `wadconv {} --out FOLDER` makes maps of its levels", path);
    if (is_tape(as_text(bytes))) return about_tape(path, bytes);
    return {};
}

template <class About>
Result<void> refuse(const std::string& path, bool wants_script, const About& about_text) {
    const char* const wanted = wants_script ? "a flythrough script (.toml)" : "a map (.toml)";
    if (is_folder(path)) return Error{path, fmt::format("expected {}, {}", wanted, about_folder(path, wants_script))};
    if (!is_there(path)) return Error{path, "no such file" + nearest_file(path)};
    const auto bytes = read_file(path);
    if (!bytes.ok()) return bytes.error();
    std::optional<std::string> found = about_others(path, bytes.value());
    if (!found) found = about_text(as_text(bytes.value()));
    if (found) return Error{path, fmt::format("expected {}, {}", wanted, *found)};
    return {};
}

}  // namespace

bool is_wad_file(const std::string& path) {
    const auto magic = read_beginning(path, kWadMagicBytes);
    return magic.ok() && is_wad(as_text(magic.value()));
}

bool is_file(const std::string& path) {
    std::error_code unknown;
    return fs::is_regular_file(path, unknown);
}

Result<void> refuse_as_map(const std::string& path) {
    return refuse(path, false, [&](std::string_view text) -> std::optional<std::string> {
        if (is_script(text)) return about_script(path);
        return {};
    });
}

Result<void> refuse_as_script(const std::string& path) {
    return refuse(path, true, [&](std::string_view text) -> std::optional<std::string> {
        if (is_map(text)) return about_map(path);
        return {};
    });
}

std::string about_file(const std::string& path) {
    const auto bytes = read_file(path);
    if (!bytes.ok()) return bytes.error().what;
    if (const auto other = about_others(path, bytes.value())) return *other;
    if (is_script(as_text(bytes.value()))) return about_script(path);
    return fmt::format("found a map; `enfilade play {}` walks through it", path);
}

std::vector<std::string> maps_in_folders(const std::vector<std::string>& paths) {
    std::vector<std::string> maps;
    for (const std::string& path : paths) {
        const auto before = maps.size();
        if (is_folder(path)) std::ranges::remove_copy_if(toml_files_in(path), std::back_inserter(maps), is_script_file);
        if (maps.size() == before) maps.push_back(path);
    }
    return maps;
}

}  // namespace enfilade
