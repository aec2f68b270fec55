// What a map calls for beyond plain rooms, and what each of it costs.
#pragma once
#include <string>
#include <vector>

#include "formats/map_file.h"

namespace enfilade {

/// One kind of effect.
struct Effect {
    const char* name;     ///< "linked portals"
    const char* counted;  ///< what is counted, one of it: "wall"
    const char* cost;     ///< in words: what is paid, and when
    /// How many of them the map has.
    std::size_t (*count)(const MapFile&);
    /// Takes it out of the map, so that the map can be drawn without it; null: then it would be another map.
    void (*take_out)(MapFile&);
};

/// All kinds, in a fixed order.
const std::vector<Effect>& all_effects();

/// One kind of effect that a map uses.
struct EffectUse {
    const Effect* effect;
    std::size_t count;  ///< > 0
};

/// In the order of all_effects(); what the map does not use is not in the list.
std::vector<EffectUse> effects_in(const MapFile& map);

}  // namespace enfilade
