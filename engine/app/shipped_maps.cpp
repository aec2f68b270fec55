#include "app/shipped_maps.h"

#include <array>
#include <filesystem>

#include "app/child_program.h"

namespace enfilade {

namespace fs = std::filesystem;

std::string shipped_map(const std::string& name) {
    std::error_code unknown;
    const fs::path program = this_program();
    const std::array<fs::path, 2> folders{program.parent_path() / "../share/enfilade/maps", ENFILADE_MAPS_DIR};
    for (const fs::path& folder : folders)
        if (fs::exists(folder / name, unknown)) return (folder / name).lexically_normal().string();
    return "maps/" + name;
}

}  // namespace enfilade
