#include "app/play/saved_game.h"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>

#include "app/pictures.h"
#include "base/hash.h"

namespace enfilade {

Result<TapeRecorder> TapeRecorder::begin(const std::string& path, const Tape& tape) {
    auto file = OutputFile::open(path);
    if (!file.ok()) return file.error();
    const Bytes beginning = tape_beginning(tape);
    if (Status failed = file.value().write(beginning)) return *failed;
    for (const InputRecord& tick : tape.ticks)
        if (Status failed = file.value().write(tape_tick(tick))) return *failed;
    if (Status failed = file.value().put_in_place()) return *failed;
    return TapeRecorder(std::move(file).value(), beginning.size());
}

Status TapeRecorder::add(const InputRecord& tick) { return file_.write(tape_tick(tick)); }

Status TapeRecorder::cut_to(std::size_t ticks) { return file_.cut_to(beginning_bytes_ + ticks * kTapeTickBytes); }

Status TapeRecorder::finish(std::uint64_t final_hash) {
    if (Status failed = file_.write(tape_end(final_hash))) return failed;
    return file_.commit();
}

namespace {

namespace fs = std::filesystem;

fs::path data_folder() {
    if (const char* data = std::getenv("XDG_DATA_HOME"); data && *data) return fs::path(data) / "enfilade";
    if (const char* home = std::getenv("HOME"); home && *home) return fs::path(home) / ".local/share/enfilade";
    return ".";
}

}  // namespace

std::string saved_game_of(const std::string& map_path) {
    std::error_code unknown;
    const fs::path map = fs::weakly_canonical(map_path, unknown);
    const std::uint64_t folder = hash_of_text(map.parent_path().string());
    return (data_folder() / fmt::format("{}-{:08x}.save", map.stem().string(), folder & 0xFFFFFFFFu)).string();
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
        if (Status failed = write_picture(path.string(), image_of(frame))) return *failed;
        return name;
    }
    return Error{folder, fmt::format("there are {} screenshots already; move some away", kMostScreenshots)};
}

}  // namespace enfilade
