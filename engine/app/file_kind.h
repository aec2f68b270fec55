// What somebody named where a map or a script was wanted, and which command takes it.
#pragma once
#include <string>
#include <vector>

#include "base/result.h"

namespace enfilade {

/// Whether the path leads to a file, not to a folder or nowhere.
bool is_file(const std::string& path);

/// Whether the file begins as a WAD of Doom does.
bool is_wad_file(const std::string& path);

/// An error where the path leads to something that is no map and is not meant to be one: a folder, a flythrough script,
/// a tape or saved game, a WAD, or nothing at all. It says what it is and which command takes it; of what is not there,
/// which file is called nearly so. None for everything else, whose own findings say more.
/// Cost: reads the file, so ask only where it was refused as a map.
Result<void> refuse_as_map(const std::string& path);

/// The same where a script was wanted: a map is one of the others there.
Result<void> refuse_as_script(const std::string& path);

/// "found a map; …": what a file is and which command takes it, for where neither was wanted.
std::string about_file(const std::string& path);

/// The paths, with every folder replaced by the maps in it (*.toml), in the order of their names and without the
/// scripts. A folder without maps stays.
std::vector<std::string> maps_in_folders(const std::vector<std::string>& paths);

}  // namespace enfilade
