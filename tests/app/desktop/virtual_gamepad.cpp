// Loaded before SDL (LD_PRELOAD), it plugs a gamepad in that nobody holds: each line of the pipe that
// ENFILADE_TEST_GAMEPAD names pushes it, "button NUMBER 0|1" or "axis NUMBER -32768..32767", as SDL numbers them.
#include <SDL.h>
#include <dlfcn.h>
#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <string>

namespace {

class VirtualGamepad {
public:
    VirtualGamepad() {
        SDL_SetHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "1");
        const int device = SDL_JoystickAttachVirtual(SDL_JOYSTICK_TYPE_GAMECONTROLLER, SDL_CONTROLLER_AXIS_MAX,
                                                     SDL_CONTROLLER_BUTTON_MAX, 0);
        if (device >= 0) stick_ = SDL_JoystickOpen(device);
        if (const char* path = std::getenv("ENFILADE_TEST_GAMEPAD")) pipe_ = open(path, O_RDONLY | O_NONBLOCK);
    }

    void obey() {
        char bytes[256];
        for (ssize_t got; pipe_ >= 0 && (got = read(pipe_, bytes, sizeof bytes)) > 0;)
            said_.append(bytes, static_cast<std::size_t>(got));
        for (std::size_t end; (end = said_.find('\n')) != std::string::npos; said_.erase(0, end + 1)) {
            int number = 0, value = 0;
            if (std::sscanf(said_.c_str(), "button %d %d", &number, &value) == 2)
                SDL_JoystickSetVirtualButton(stick_, number, value != 0);
            else if (std::sscanf(said_.c_str(), "axis %d %d", &number, &value) == 2)
                SDL_JoystickSetVirtualAxis(stick_, number, static_cast<Sint16>(value));
        }
    }

private:
    SDL_Joystick* stick_ = nullptr;
    int pipe_ = -1;
    std::string said_;
};

}  // namespace

extern "C" int SDL_PollEvent(SDL_Event* event) {
    using Poll = int (*)(SDL_Event*);
    static const auto poll = reinterpret_cast<Poll>(dlsym(RTLD_NEXT, "SDL_PollEvent"));
    if (SDL_WasInit(SDL_INIT_JOYSTICK) != 0) {
        static VirtualGamepad gamepad;
        gamepad.obey();
    }
    return poll(event);
}
