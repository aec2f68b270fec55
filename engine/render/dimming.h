// The light of one surface at many depths: shade_at() with all that does not depend on the depth worked out before.
#pragma once
#include "render/shade.h"

namespace enfilade {

/// shade_at() of one surface, made ready for many depths.
class Dimming {
public:
    Dimming() = default;
    Dimming(LightModel model, double light, double contrast);

    Shade at(double depth) const { return model_ == LightModel::classic ? classic(depth) : smooth(depth); }

    /// shades[i] of depths[i]; both [count].
    void at_all(const double* depths, int count, Shade* shades) const;

private:
    Shade classic(double depth) const;
    Shade smooth(double depth) const;

    LightModel model_ = LightModel::smooth;
    int dark_levels_ = 0;       ///< classic: where nothing is won back
    double per_metre_ = 0;      ///< smooth: 1 / reach; 0 at full light
    double brightest_ = kFull;  ///< smooth: at depth 0

    static constexpr double kFull = 256;
    static constexpr int kClassicLevels = 32;         ///< COLORMAP's levels from full to black
    static constexpr double kClassicDepth = 40;       ///< levels won back at 1 m: 1280 map units / 32
    static constexpr double kClassicNearest = 23;     ///< most levels that are won back, as for Doom's walls
    static constexpr double kClassicTouching = 0.01;  ///< nearer than this counts as this [m]
    static constexpr double kFarthest = 1e9;          ///< stands for infinity, which times 0 would be no number [m]
};

inline Shade Dimming::classic(double depth) const {
    const double touching = depth > kClassicTouching ? depth : kClassicTouching;
    const double won = on_nearest_step(kClassicDepth / touching);
    const int level = dark_levels_ - static_cast<int>(won < kClassicNearest ? won : kClassicNearest);
    const int seen = level > 0 ? (level < kClassicLevels ? level : kClassicLevels - 1) : 0;
    return static_cast<Shade>((kClassicLevels - seen) * (static_cast<int>(kFull) / kClassicLevels));
}

inline Shade Dimming::smooth(double depth) const {
    const double nearness = per_metre_ * (depth < kFarthest ? depth : kFarthest);
    return static_cast<Shade>(static_cast<int>(brightest_ * (1 / (1 + nearness * nearness)) + 0.5));
}

}  // namespace enfilade
