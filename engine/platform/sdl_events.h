// From SDL's events to our own. Included by the files of platform/ only.
#pragma once
#include <SDL.h>

#include <optional>

#include "platform/input_event.h"

namespace enfilade {

/// Where the last picture lies in the window, to turn window points into picture pixels.
struct Placement {
    double left = 0, top = 0;  ///< of the picture within the window [window points]
    double scale = 1;          ///< window points per picture pixel
};

/// The event in our words, or none where it means nothing to us.
std::optional<InputEvent> translate(const SDL_Event& event, const Placement& placement);

}  // namespace enfilade
