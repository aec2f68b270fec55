// The maps that ship, for tests that try each of them.
#pragma once
#include <string>
#include <vector>

#include "base/files.h"

namespace enfilade::test {

/// Paths of all maps in maps/, in the order of their names.
inline std::vector<std::string> shipped_maps() {
    const std::string folder = ENFILADE_SOURCE_DIR "/maps/";
    std::vector<std::string> paths;
    for (const std::string& name : list_folder(folder))
        if (name.ends_with(".toml")) paths.push_back(folder + name);
    return paths;
}

}  // namespace enfilade::test
