// Pictures with holes that stand or hang in rooms: things, panels, and what hangs in portals.
#pragma once
#include <limits>
#include <optional>
#include <variant>

#include "render/frame.h"
#include "render/sprite.h"
#include "render/stencil/wall_on_screen.h"

namespace enfilade::stencil {

// Where a thing's picture stands on the screen, as seen in one sector of one layer.

/// A picture that is met in a room. Its place is like a wall's that faces the eye squarely: all of it has one depth.
struct ThingOnScreen {
    WallOnScreen place;
    ThingId thing;
    Vec2 position;  ///< of the thing, in the sector's space
    PixelSurface id = kNothing;
    TextureId texture;
    Lighting lighting;
    double depth = 0;            ///< along `forward`; in tilted pictures maybe behind the eye, below 0 [m]
    double top = 0, height = 0;  ///< of the whole picture; top: above the eye [m]
    RelativeHeights shown;       ///< the part of it that no floor or ceiling cuts off, above the eye
};

/// In no column yet. none: too near, or no picture, or all of it is cut off. room: above the eye; what cuts the
/// picture.
std::optional<ThingOnScreen> in_view(const Map& map, const TextureSet& textures, const Snapshot& snapshot,
                                     const Presence& presence, const Pose& pose, const RelativeHeights& room);

/// The room of a thing that nothing cuts.
inline constexpr RelativeHeights kNoRoom{-std::numeric_limits<double>::infinity(),
                                         std::numeric_limits<double>::infinity()};

/// Finds the columns of a thing ahead of the eye. False: there are none.
bool put_on_screen(ThingOnScreen& thing, const Screen& screen);

/// A panel, from the side on which the eye is.
struct PanelOnScreen {
    PanelId panel;
    WallOnScreen place;
    RelativeHeights shown;       ///< the part of it that is inside the room, above the eye
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
