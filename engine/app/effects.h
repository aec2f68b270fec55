// What a map calls for beyond plain rooms, and what each of it costs.
#pragma once
#include <string>
#include <vector>

#include "formats/map_file.h"

namespace enfilade {

/// One kind of effect that a map uses.
struct EffectUse {
    std::string name;     ///< "linked portals"
    std::size_t count;    ///< how many surfaces, walls or things
    std::string counted;  ///< what is counted: "walls"
    std::string cost;     ///< in words: what is paid, and when
};

/// In a fixed order; what the map does not use is not in the list.
std::vector<EffectUse> effects_in(const MapFile& map);

/// The list as aligned lines for a terminal.
std::string to_text(const std::vector<EffectUse>& effects);

}  // namespace enfilade
