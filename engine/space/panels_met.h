// Panels on a path: which of them a leg of it goes through, in exact order. Only those that block or have triggers
// (Panel::is_active); to whoever moves, the others are air.
#pragma once
#include <functional>

#include "base/short_list.h"
#include "space/leg.h"

namespace enfilade {

/// A panel that a path goes through.
struct MetPanel {
    PanelId panel;
    bool from_behind = false;  ///< from its left to its right, as side_of_line() has it

    bool operator==(const MetPanel&) const = default;
};

/// Says whether a path may go through a panel.
using MayCross = std::function<bool(const MetPanel&)>;

/// As many as one stands between; more are as good, but take memory.
using MetPanels = ShortList<MetPanel, 8>;

/// Adds the active panels of the leg's sector that it goes through before it leaves by `exit` (none: to its end), in
/// order along it. A panel on the very line of a wall lies inside the sector: it is met after the leg came in through
/// that wall, and before it leaves by it. Of panels on one line the one listed first comes first.
/// Exact, by the tie rule. Cost: one comparison where the sector has no active panels, else its panels.
void add_panels_met(const Map& map, const Leg& leg, WallId exit, MetPanels& met);

/// The first of these that may not be crossed, or none. `may_cross` empty: all may be.
MetPanel first_barrier(const Map& map, const Leg& leg, WallId exit, const MayCross& may_cross);

}  // namespace enfilade
