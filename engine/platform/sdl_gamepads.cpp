#include "platform/sdl_gamepads.h"

#include <algorithm>

namespace enfilade {

bool Gamepads::note(const SDL_Event& event) {
    if (event.type == SDL_CONTROLLERDEVICEADDED) open(event.cdevice.which);
    return event.type == SDL_CONTROLLERDEVICEREMOVED && close(event.cdevice.which);
}

void Gamepads::open(int device) {
    if (SDL_GameController* gamepad = SDL_GameControllerOpen(device)) open_.emplace_back(gamepad);
}

bool Gamepads::close(SDL_JoystickID instance) {
    return std::erase_if(open_, [&](const auto& gamepad) {
               return SDL_JoystickInstanceID(SDL_GameControllerGetJoystick(gamepad.get())) == instance;
           }) > 0;
}

}  // namespace enfilade
