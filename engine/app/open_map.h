// A map for a command: loaded, or its findings on stderr.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/messages.h"
#include "flight/flight.h"
#include "formats/script.h"
#include "map/load.h"

namespace enfilade {

// Where maps that take long to read are kept, compiled, from one start of the program to the next.

/// What all kept maps may take together [bytes]: some of the largest there are, at 450 bytes a sector.
inline constexpr std::uint64_t kMostCacheBytes = std::uint64_t{2} << 30;

/// The store of one map: a file in the user's folder for caches (XDG base directories), named after the map and the
/// place where it lies. What this program did not write itself is not taken: another version may build another map
/// from the same text. Once the files take more than kMostCacheBytes together, those that were written longest ago go.
///
/// Keeps nothing where there is no home, or where ENFILADE_MAP_CACHE is "off": find() is then always an error.
MapStore cache_of(const std::string& map_path);

/// A map and its pictures, fit for drawing.
struct OpenMap {
    Map map;
    TextureSet textures;
};

/// The map file that an exit of the map at `map_path` leads to: beside it, with or without its ending.
std::string next_map_path(const std::string& map_path, const std::string& name);

/// Where there are errors, they are printed and there is no map. Warnings are counted in one line of usual talk.
/// skill : 1..kMostSkill; things that do not stand at it are left out; none: all stand
std::optional<OpenMap> open_map(const std::string& path, const std::vector<std::string>& texture_folders,
                                std::optional<int> skill, Talk talk = Talk::usual);

/// Findings as people read them, a line each, and below it the line of the file with a caret under the place.
/// path : of the file that was read; what is in another one says so
std::string findings_text(const std::string& path, const Findings& findings, Talk talk);

/// Prints findings_text on stderr; true where a finding is an error.
bool print_findings(const std::string& path, const Findings& findings, Talk talk);

// A flythrough for a command: script, map and pictures, or what is wrong with them on stderr.

struct OpenFlight {
    ScriptFile script;
    OpenMap map;
    Flight flight;
};

/// Reads the script, and the map and tape it names, which are seen from the script's folder; `skill` as for open_map.
std::optional<OpenFlight> open_flight(const std::string& script_path, const std::vector<std::string>& texture_folders,
                                      int skill, Talk talk = Talk::usual);

}  // namespace enfilade
