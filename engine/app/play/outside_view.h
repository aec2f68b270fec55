// F4: the world from outside, in a corner or instead of the player's own view, which then takes the corner.
#pragma once
#include "app/draw/overlay.h"
#include "render/outside/outside_renderer.h"

namespace enfilade {

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
    void draw(Overlay& overlay, Frame& frame, const Map& map, const TextureSet& textures, const Snapshot& snapshot,
              const View& view, std::size_t threads);

private:
    Shown shown_ = Shown::nowhere;
    OutsideFrom from_ = OutsideFrom::above;
    int zoom_steps_ = 0;
    OutsideRenderer renderer_;
    Frame large_, inset_;
};

}  // namespace enfilade
