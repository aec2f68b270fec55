#include "app/play/saved_game.h"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>

#include "app/pictures.h"
#include "app/play/game.h"
#include "app/user_folders.h"
#include "base/file_name.h"
#include "base/files.h"
#include "base/hash.h"
#include "formats/text_parts.h"

namespace enfilade {

Result<TapeRecorder> TapeRecorder::begin(const std::string& path, const Tape& tape) {
    auto file = OutputFile::open(path);
    if (!file.ok()) return file.error();
    const Bytes beginning = tape_beginning(tape);
    if (const Result<void> done = file.value().write(beginning); !done.ok()) return done.error();
    for (const InputRecord& tick : tape.ticks)
        if (const Result<void> done = file.value().write(tape_tick(tick)); !done.ok()) return done.error();
    if (const Result<void> done = file.value().put_in_place(); !done.ok()) return done.error();
    return TapeRecorder(std::move(file).value(), beginning.size());
}

Result<void> TapeRecorder::add(const InputRecord& tick) { return file_.write(tape_tick(tick)); }

Result<void> TapeRecorder::cut_to(std::size_t ticks) { return file_.cut_to(beginning_bytes_ + ticks * kTapeTickBytes); }

Result<void> TapeRecorder::finish(std::uint64_t final_hash) {
    if (const Result<void> done = file_.write(tape_end(final_hash)); !done.ok()) return done.error();
    return file_.commit();
}

namespace fs = std::filesystem;

std::string saved_game_of(const std::string& map_path) {
    std::error_code unknown;
    const fs::path map = fs::weakly_canonical(map_path, unknown);
    const std::uint64_t folder = hash_of_text(map.parent_path().string());
    const std::string name = safe_file_name(file_stem_of(map.string()));
    return in_user_folder(UserFolder::data, fmt::format("{}-{:08x}.save", name, folder & 0xFFFFFFFFu));
}

namespace {

std::string last_map_path() { return in_user_folder(UserFolder::data, "last_map"); }

}  // namespace

std::string last_game_path() { return in_user_folder(UserFolder::data, "last_game.save"); }

Result<void> keep_last_game(const Game& game) {
    if (game.check_savable().ok())
        if (const Result<void> done = game.save(last_game_path()); !done.ok()) return done.error();
    if (last_map_path().empty()) return {};
    std::error_code unknown;
    fs::create_directories(user_folder(UserFolder::data), unknown);
    return write_file(last_map_path(), std::string_view(fs::absolute(game.path(), unknown).string()));
}

std::string last_map() {
    const auto bytes = read_file(last_map_path());
    std::error_code unknown;
    const std::string path = bytes.ok() ? std::string(as_text(bytes.value())) : "";
    return fs::is_regular_file(path, unknown) ? path : "";
}

namespace {

/// Of a line XDG_PICTURES_DIR="$HOME/Pictures".
std::string folder_in(std::string_view user_dirs, const std::string& home) {
    constexpr std::string_view kName = "XDG_PICTURES_DIR=\"";
    LineReader lines(user_dirs);
    while (const auto line = lines.next()) {
        if (!line->text.starts_with(kName)) continue;
        std::string path(line->text.substr(kName.size()));
        path = path.substr(0, path.find('"'));
        return path.starts_with("$HOME") ? home + path.substr(5) : path;
    }
    return "";
}

}  // namespace

std::string pictures_folder() {
    std::error_code unknown;
    if (const char* named = std::getenv("XDG_PICTURES_DIR"); named && fs::is_directory(named, unknown)) return named;
    const std::string home = home_folder();
    if (home.empty()) return ".";
    const fs::path config = fs::path(user_folder(UserFolder::config)).parent_path();
    const auto bytes = read_file((config / "user-dirs.dirs").string());
    const std::string named = bytes.ok() ? folder_in(as_text(bytes.value()), home) : "";
    for (const std::string& path : {named, home + "/Pictures"})
        if (!path.empty() && fs::is_directory(path, unknown)) return fs::path(path).lexically_normal().string();
    return ".";
}

namespace {

constexpr int kMostScreenshots = 9999;

}  // namespace

Result<std::string> save_screenshot(const Frame& frame, const std::string& folder) {
    for (int number = 1; number <= kMostScreenshots; ++number) {
        const std::string name = fmt::format("enfilade-{:04}.png", number);
        const auto path = std::filesystem::path(folder) / name;
        std::error_code unknown;
        if (std::filesystem::exists(path, unknown)) continue;
        if (const Result<void> done = write_picture(path.string(), image_of(frame)); !done.ok()) return done.error();
        return name;
    }
    return Error{folder, fmt::format("there are {} screenshots already; move some away", kMostScreenshots)};
}

}  // namespace enfilade
