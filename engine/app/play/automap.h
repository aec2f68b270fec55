// Tab: the rooms one has been in, as lines over the picture. Rooms are laid out as one would walk to them from where
// the player stands, so a doorway that leads elsewhere joins what it joins, and nothing jumps when one goes through.
#pragma once
#include <vector>

#include "app/draw/overlay.h"
#include "map/map.h"
#include "space/trace.h"

namespace enfilade {

class Automap {
public:
    explicit Automap(const Map& map) : visited_(map.sectors.size(), false) {}

    /// The player is, or was, in this sector.
    void visit(SectorId sector) { visited_[sector.index] = true; }

    bool is_open() const { return open_; }
    void toggle() { open_ = !open_; }
    /// steps > 0 shows a smaller part, larger.
    void zoom(int steps);

    /// The player in the middle, looking up. Draws nothing while closed.
    /// Cost: the walls of the rooms near the player, each room once.
    void draw(Overlay& overlay, const Map& map, const Place& player, Vec2 forward) const;

private:
    std::vector<bool> visited_;
    bool open_ = false;
    int zoom_steps_ = 0;
};

}  // namespace enfilade
