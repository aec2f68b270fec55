// Tab: the rooms one has been in or seen, as lines over the picture. Rooms are laid out as one would walk to them from
// where the player stands, so a doorway that leads elsewhere joins what it joins, and nothing jumps when one goes
// through.
#pragma once
#include <vector>

#include "app/draw/overlay.h"
#include "map/map.h"
#include "space/trace.h"

namespace enfilade {

class Automap {
public:
    Automap() = default;
    explicit Automap(const Map& map) : known_(map.sectors.size(), Known::unknown) {}

    /// The player is in this sector: its walls are drawn brightly from now on.
    void visit(SectorId sector) { known_[sector.index] = Known::visited; }
    /// The player has looked into this sector: its walls are drawn dimly until it is visited.
    void see(SectorId sector);

    bool is_open() const { return open_; }
    void toggle() { open_ = !open_; }
    /// steps > 0 shows a smaller part, larger.
    void zoom(int steps);

    /// The player in the middle, looking up. Draws nothing while closed.
    /// Cost: the walls of the rooms near the player, each room once.
    void draw(Overlay& overlay, const Map& map, const Place& player, Vec2 forward) const;

private:
    enum class Known : std::uint8_t { unknown, seen, visited };

    std::vector<Known> known_;
    bool open_ = false;
    int zoom_steps_ = 0;
};

}  // namespace enfilade
