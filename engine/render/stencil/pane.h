// Pictures with holes that stand or hang in rooms: things, panels, and what hangs in portals.
#pragma once
#include <variant>

#include "render/stencil/thing_on_screen.h"

namespace enfilade::stencil {

/// A panel, from the side on which the eye is.
struct PanelOnScreen {
    PanelId panel;
    WallOnScreen place;
    Heights shown;               ///< the part of it that is inside the room, above the eye
    bool is_in_doorway = false;  ///< on the line of the doorway that one sees it through, whose room hides it
};

/// In no column yet; shown.is_empty(): not at all.
PanelOnScreen in_view(const Map& map, const Snapshot& snapshot, PanelId panel, const Pose& pose);

/// The picture that hangs in a portal.
struct Hanging {
    WallOnScreen place;
};

/// A picture with holes, in those columns of its place in which one chain of portals shows it.
using Pane = std::variant<ThingOnScreen, PanelOnScreen, Hanging>;

inline const WallOnScreen& place_of(const Pane& pane) {
    return std::visit([](const auto& it) -> const WallOnScreen& { return it.place; }, pane);
}
inline WallOnScreen& place_of(Pane& pane) {
    return std::visit([](auto& it) -> WallOnScreen& { return it.place; }, pane);
}

}  // namespace enfilade::stencil
