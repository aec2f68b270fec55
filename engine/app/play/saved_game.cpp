#include "app/play/saved_game.h"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>

#include "base/hash.h"

namespace enfilade {
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

}  // namespace enfilade
