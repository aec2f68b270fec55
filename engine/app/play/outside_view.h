// F4: the world from outside, in a corner or instead of the player's own view, which then takes the corner.
#pragma once
#include <string>

#include "app/draw/overlay.h"
#include "app/play/player_input.h"
#include "map/map.h"
#include "render/outside/outside_renderer.h"
#include "world/snapshot.h"
#include "world/world.h"

namespace enfilade {

// F8: an eye that leaves the player's body and flies, through walls and out of rooms. It is nothing to the world: the
// body stands where it was left, the world goes on, and no tape knows of the flight.

/// Where the camera is.
enum class Whereabouts : std::uint8_t { in_room, above_ceiling, below_floor, outside };

class FreeCamera {
public:
    /// Begins where the eye is.
    explicit FreeCamera(const Eye& eye) : eye_(eye) {}

    /// Flies for a tick, the way it looks; use rises, crouch sinks, run is four times as fast. Through portals it goes
    /// as a body would, wherever they lead, at any height; through what is solid straight on, into the room that has
    /// that place (of several the first in the map) or out of all rooms.
    void move(const Map& map, const TickInput& input);

    /// Its sector contains its point unless it is outside; then it is the last one that did.
    const Eye& eye() const { return eye_; }

    Whereabouts whereabouts(const Snapshot& snapshot) const;

    /// "Free flight: above the ceiling of 'hall', x 1.00 y 2.00 z 9.00. F8 goes back."
    std::string text(const Map& map, const Snapshot& snapshot) const;

private:
    void go_to(const Map& map, Vec2 to);

    Eye eye_;
    bool is_outside_ = false;
};

class OutsideView {
public:
    enum class Shown : std::uint8_t { nowhere, inset, full };

    Shown shown() const { return shown_; }
    /// Nowhere, in a corner, in full, nowhere.
    void show_next();
    OutsideFrom from() const { return from_; }
    void change_side() { from_ = from_ == OutsideFrom::above ? OutsideFrom::behind : OutsideFrom::above; }
    /// steps > 0 shows a smaller part, larger.
    void zoom(int steps);

    /// Puts it into the frame, which holds the player's view. Draws nothing where it is shown nowhere.
    /// threads: to draw with, >= 1. Cost: that of OutsideRenderer.
    void draw(Overlay& overlay, Frame& frame, OutsideRenderer& renderer, const Snapshot& snapshot, const View& view,
              std::size_t threads);

private:
    Shown shown_ = Shown::nowhere;
    OutsideFrom from_ = OutsideFrom::above;
    int zoom_steps_ = 0;
    Frame large_, inset_;
};

}  // namespace enfilade
