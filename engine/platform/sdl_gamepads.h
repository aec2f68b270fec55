// The gamepads that are plugged in. Included by the files of platform/ only.
#pragma once
#include <SDL.h>

#include <memory>
#include <vector>

namespace enfilade {

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

}  // namespace enfilade
