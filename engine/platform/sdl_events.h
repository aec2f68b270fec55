// SDL's events and faults in words of our own. Included by the files of platform/ only.
#pragma once
#include <SDL.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "platform/input_event.h"

namespace enfilade {

/// Where the last picture lies in the window, to turn window points into picture pixels.
struct Placement {
    double left = 0, top = 0;  ///< of the picture within the window [window points]
    double scale = 1;          ///< window points per picture pixel
};

/// The event in our words, or none where it means nothing to us.
std::optional<InputEvent> translate(const SDL_Event& event, const Placement& placement);

// The gamepads that are plugged in.

/// Opens gamepads as they appear and closes them as they go: SDL reports only those that are open.
class Gamepads {
public:
    /// True where the event took a gamepad away.
    bool note(const SDL_Event& event);

private:
    struct Closer {
        void operator()(SDL_GameController* gamepad) const { SDL_GameControllerClose(gamepad); }
    };
    void open(int device);
    bool close(SDL_JoystickID instance);

    std::vector<std::unique_ptr<SDL_GameController, Closer>> open_;
};

/// "WHERE: cannot DOING: REASON", with SDL's newest reason.
inline Error sdl_error(const char* where, const std::string& doing) {
    return {where, "cannot " + doing + ": " + SDL_GetError()};
}

}  // namespace enfilade
