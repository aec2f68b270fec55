// What one sees when a map lies behind one.
#pragma once
#include <string>

#include "app/draw/overlay.h"
#include "map/map.h"

namespace enfilade {

/// How a map went, and where it goes on.
struct MapEnd {
    std::string left, next;  ///< names; next: as the exit says it, may be empty
    std::string next_path;   ///< empty: it is not there
    double seconds = 0;
    std::size_t found = 0, secrets = 0;
};

/// How many secrets there are to find: sectors that move as one are one.
std::size_t count_of_secrets(const Map& map);

/// Time, secrets, the next map, and what to press.
void draw_end(Overlay& overlay, const MapEnd& end);

}  // namespace enfilade
