// Tab: the rooms one has been in or seen, as lines over the picture. Rooms are laid out as one would walk to them from
// where the player stands, so a doorway that leads elsewhere joins what it joins, and nothing jumps when one goes
// through.
#pragma once
#include <vector>

#include <span>

#include "app/draw/overlay.h"
#include "app/play/settings.h"
#include "map/map.h"
#include "space/trace.h"

namespace enfilade {

/// What else there is to know for drawing it.
struct AutomapLook {
    AutomapColors colors = AutomapColors::usual;
    std::span<const ThingId> taken{};  ///< things that are gone, in the order of their numbers
    std::string_view keys{};           ///< a line that says how it is moved; empty: neither that nor the legend
};

class Automap {
public:
    Automap() = default;
    explicit Automap(const Map& map);

    /// The player is in this sector: its walls are drawn brightly from now on.
    void visit(SectorId sector) { known_[sector.index] = Known::visited; }
    /// The player has looked into this sector: its walls are drawn dimly until it is visited.
    void see(SectorId sector);

    bool is_open() const { return open_; }
    void toggle() { open_ = !open_; }
    /// steps > 0 shows a smaller part, larger.
    void zoom(int steps);

    /// Moves what is shown by so many steps, an eighth of the picture's height each, right and up.
    void pan(int right, int up);
    /// The player is in the middle again.
    void follow() { panned_m_ = {}; }

    /// The player in the middle, unless it was moved, looking up. Draws nothing while closed.
    /// Cost: the walls of the rooms near the player, each room once.
    void draw(Overlay& overlay, const Map& map, const Place& player, Vec2 forward, const AutomapLook& look = {}) const;

private:
    enum class Known : std::uint8_t { unknown, seen, visited };

    double half_height_m() const;

    std::vector<Known> known_;
    std::vector<bool> is_door_;  ///< by sector
    Vec2 panned_m_;              ///< to the right of the player, and ahead
    bool open_ = false;
    int zoom_steps_ = 0;
};

}  // namespace enfilade
