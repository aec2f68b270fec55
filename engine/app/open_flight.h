// A flythrough for a command: script, map and pictures, or what is wrong with them on stderr.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/open_map.h"
#include "flight/flight.h"
#include "formats/script.h"

namespace enfilade {

struct OpenFlight {
    ScriptFile script;
    OpenMap map;
    Flight flight;
};

/// Reads the script, and the map and tape it names, which are seen from the script's folder; `skill` as for open_map.
std::optional<OpenFlight> open_flight(const std::string& script_path, const std::vector<std::string>& texture_folders,
                                      int skill);

}  // namespace enfilade
