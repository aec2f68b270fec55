// What the effects of a map cost, measured: the same views drawn with each of them and without it.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/effects.h"
#include "map/textures.h"

namespace enfilade {

struct EffectPrice {
    EffectUse use;
    std::optional<double> ms;  ///< of a frame, more than without the effect; none where it cannot be taken out [ms]
};

struct Prices {
    double frame_ms = 0;  ///< of a frame with everything [ms]
    std::vector<EffectPrice> effects;
};

/// Draws eight looks around from the player's start at 640 x 400 by the column renderer on one thread, in turn with and
/// without each effect, and takes each view's fastest time. file: sound, with a player; else every price is none.
/// Cost: some seconds for each effect that can be taken out.
Prices effect_prices(const MapFile& file, const TextureSet& textures);

/// The prices as aligned lines for a terminal.
std::string to_text(const Prices& prices);

}  // namespace enfilade
