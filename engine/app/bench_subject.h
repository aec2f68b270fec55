// What `enfilade bench` measures: a map, a walk through one, or a flythrough.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/open_flight.h"

namespace enfilade {

/// A map with what its player sees at the start, a map with a list of views, or a flythrough. Open until it goes.
class BenchSubject {
public:
    /// name : MAP, SCRIPT or MAP:WALK.csv, the views of which formats/views_csv.h reads. None where a file has errors,
    /// which then are on stderr.
    static std::optional<BenchSubject> open(const std::string& name, const std::vector<std::string>& texture_folders);

    const Map& map() const { return flight_ ? flight_->map.map : map_->map; }
    const TextureSet& textures() const { return flight_ ? flight_->map.textures : map_->textures; }
    /// How many pictures there are, >= 1.
    int frames() const { return flight_ ? flight_->flight.frames() : static_cast<int>(views_.size()); }
    /// number : in [0, frames()). Of a map and a walk the world is that of the start.
    FlightFrame frame(int number) const;

private:
    std::optional<OpenFlight> flight_;
    std::optional<OpenMap> map_;
    std::vector<View> views_;
    Snapshot snapshot_;
};

/// The map and the list of a subject's name MAP:WALK.csv; none where it is another one.
struct WalkName {
    std::string map, views;
};
std::optional<WalkName> walk_name(const std::string& name);

}  // namespace enfilade
