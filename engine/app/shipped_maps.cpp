#include "app/shipped_maps.h"

#include <array>
#include <filesystem>

namespace enfilade {

namespace fs = std::filesystem;

std::string shipped_map(const std::string& name) {
    std::error_code unknown;
    const fs::path program = fs::read_symlink("/proc/self/exe", unknown);
    const std::array<fs::path, 2> folders{program.parent_path() / "../share/enfilade/maps", ENFILADE_MAPS_DIR};
    for (const fs::path& folder : folders)
        if (fs::exists(folder / name, unknown)) return (folder / name).lexically_normal().string();
    return "maps/" + name;
}

}  // namespace enfilade
