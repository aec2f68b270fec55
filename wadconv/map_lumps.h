// Finding the maps in a pile of WADs.
#pragma once
#include <string>
#include <vector>

#include "base/result.h"
#include "wadconv/doom_records.h"
#include "wadconv/wad.h"

namespace enfilade::wadconv {

/// True for "E1M1" … "E9M9" and "MAP00" … "MAP99".
bool is_map_name(std::string_view name);

/// The names of all maps in the pile: in the order of their first appearance, each once.
std::vector<std::string> map_names(const WadPile& pile);

/// The lumps of a map, from the last archive that has it. An Error where there is none of that name, where a lump is
/// missing, and where the map is in Hexen's format or in UDMF, which are told by their lumps BEHAVIOR and TEXTMAP.
Result<MapLumps> find_map(const WadPile& pile, std::string_view name);

}  // namespace enfilade::wadconv
