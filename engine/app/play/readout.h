// F3: how long pictures take, where the player is, and the outlines of the picture's viewports. F7: what a pixel shows.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "app/draw/overlay.h"
#include "flight/renderer.h"

namespace enfilade {

/// The last second or so of frame times.
class FrameTimes {
public:
    /// draw_ns: the renderer alone. shown_ns: when the picture was presented.
    void add(std::int64_t draw_ns, std::int64_t shown_ns);

    struct Summary {
        double mean_draw_ms = 0, worst_draw_ms = 0;
        double per_second = 0;  ///< pictures presented
    };
    Summary summary() const;

private:
    static constexpr std::size_t kKept = 60;  ///< frames: about a second
    std::array<std::int64_t, kKept> draw_ns_{}, shown_ns_{};
    std::size_t count_ = 0;
};

/// What the read-out tells besides times.
struct ReadoutFacts {
    std::string sector, renderer;
    double x = 0, y = 0, eye_z = 0, yaw_degrees = 0, pitch_degrees = 0;
};

void draw_readout(Overlay& overlay, const FrameTimes& times, const ReadoutFacts& facts,
                  const std::vector<ViewportShape>& viewports);

/// A small cross around a pixel, and at the foot of the picture what is there, wrapped.
void draw_pointed(Overlay& overlay, int x, int y, const std::string& text);

}  // namespace enfilade
