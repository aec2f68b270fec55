#include "platform/sdl_events.h"

#include <algorithm>

namespace enfilade {

namespace {

KeyCode key_of(SDL_Scancode code) {
    switch (code) {
        case SDL_SCANCODE_W: return KeyCode::w;
        case SDL_SCANCODE_A: return KeyCode::a;
        case SDL_SCANCODE_S: return KeyCode::s;
        case SDL_SCANCODE_D: return KeyCode::d;
        case SDL_SCANCODE_C: return KeyCode::c;
        case SDL_SCANCODE_E: return KeyCode::e;
        case SDL_SCANCODE_N: return KeyCode::n;
        case SDL_SCANCODE_R: return KeyCode::r;
        case SDL_SCANCODE_Y: return KeyCode::y;
        case SDL_SCANCODE_UP: return KeyCode::up;
        case SDL_SCANCODE_DOWN: return KeyCode::down;
        case SDL_SCANCODE_LEFT: return KeyCode::left;
        case SDL_SCANCODE_RIGHT: return KeyCode::right;
        case SDL_SCANCODE_PAGEUP: return KeyCode::page_up;
        case SDL_SCANCODE_PAGEDOWN: return KeyCode::page_down;
        case SDL_SCANCODE_HOME: return KeyCode::home;
        case SDL_SCANCODE_LSHIFT: return KeyCode::left_shift;
        case SDL_SCANCODE_RSHIFT: return KeyCode::right_shift;
        case SDL_SCANCODE_LCTRL: return KeyCode::left_control;
        case SDL_SCANCODE_RCTRL: return KeyCode::right_control;
        case SDL_SCANCODE_LALT: return KeyCode::left_alt;
        case SDL_SCANCODE_RALT: return KeyCode::right_alt;
        case SDL_SCANCODE_SPACE: return KeyCode::space;
        case SDL_SCANCODE_TAB: return KeyCode::tab;
        case SDL_SCANCODE_RETURN:
        case SDL_SCANCODE_KP_ENTER: return KeyCode::enter;
        case SDL_SCANCODE_ESCAPE: return KeyCode::escape;
        case SDL_SCANCODE_EQUALS:
        case SDL_SCANCODE_KP_PLUS: return KeyCode::plus;
        case SDL_SCANCODE_MINUS:
        case SDL_SCANCODE_KP_MINUS: return KeyCode::minus;
        case SDL_SCANCODE_F1: return KeyCode::f1;
        case SDL_SCANCODE_F2: return KeyCode::f2;
        case SDL_SCANCODE_F3: return KeyCode::f3;
        case SDL_SCANCODE_F4: return KeyCode::f4;
        case SDL_SCANCODE_F5: return KeyCode::f5;
        case SDL_SCANCODE_F6: return KeyCode::f6;
        case SDL_SCANCODE_F7: return KeyCode::f7;
        case SDL_SCANCODE_F8: return KeyCode::f8;
        case SDL_SCANCODE_F9: return KeyCode::f9;
        case SDL_SCANCODE_F11: return KeyCode::f11;
        case SDL_SCANCODE_F12: return KeyCode::f12;
        default: return KeyCode::unknown;
    }
}

MouseButton button_of(std::uint8_t button) {
    switch (button) {
        case SDL_BUTTON_LEFT: return MouseButton::left;
        case SDL_BUTTON_MIDDLE: return MouseButton::middle;
        case SDL_BUTTON_RIGHT: return MouseButton::right;
        default: return MouseButton::other;
    }
}

GamepadButton gamepad_button_of(std::uint8_t button) {
    switch (button) {
        case SDL_CONTROLLER_BUTTON_A: return GamepadButton::a;
        case SDL_CONTROLLER_BUTTON_B: return GamepadButton::b;
        case SDL_CONTROLLER_BUTTON_X: return GamepadButton::x;
        case SDL_CONTROLLER_BUTTON_Y: return GamepadButton::y;
        case SDL_CONTROLLER_BUTTON_BACK: return GamepadButton::back;
        case SDL_CONTROLLER_BUTTON_START: return GamepadButton::start;
        case SDL_CONTROLLER_BUTTON_LEFTSHOULDER: return GamepadButton::left_shoulder;
        case SDL_CONTROLLER_BUTTON_RIGHTSHOULDER: return GamepadButton::right_shoulder;
        case SDL_CONTROLLER_BUTTON_LEFTSTICK: return GamepadButton::left_stick;
        case SDL_CONTROLLER_BUTTON_RIGHTSTICK: return GamepadButton::right_stick;
        case SDL_CONTROLLER_BUTTON_DPAD_UP: return GamepadButton::up;
        case SDL_CONTROLLER_BUTTON_DPAD_DOWN: return GamepadButton::down;
        case SDL_CONTROLLER_BUTTON_DPAD_LEFT: return GamepadButton::left;
        case SDL_CONTROLLER_BUTTON_DPAD_RIGHT: return GamepadButton::right;
        default: return GamepadButton::other;
    }
}

GamepadAxis axis_of(std::uint8_t axis) {
    switch (axis) {
        case SDL_CONTROLLER_AXIS_LEFTX: return GamepadAxis::left_x;
        case SDL_CONTROLLER_AXIS_LEFTY: return GamepadAxis::left_y;
        case SDL_CONTROLLER_AXIS_RIGHTX: return GamepadAxis::right_x;
        case SDL_CONTROLLER_AXIS_RIGHTY: return GamepadAxis::right_y;
        case SDL_CONTROLLER_AXIS_TRIGGERLEFT: return GamepadAxis::left_trigger;
        case SDL_CONTROLLER_AXIS_TRIGGERRIGHT: return GamepadAxis::right_trigger;
        default: return GamepadAxis::other;
    }
}

double in_picture(double window_point, double start, double scale) { return (window_point - start) / scale; }

/// SDL's wheel steps are turned round where the system scrolls "naturally".
double wheel_steps(const SDL_MouseWheelEvent& wheel) {
    return wheel.direction == SDL_MOUSEWHEEL_FLIPPED ? -wheel.preciseY : wheel.preciseY;
}

std::optional<InputEvent> translate_window(const SDL_WindowEvent& event) {
    switch (event.event) {
        case SDL_WINDOWEVENT_FOCUS_GAINED: return FocusChange{true};
        case SDL_WINDOWEVENT_FOCUS_LOST: return FocusChange{false};
        case SDL_WINDOWEVENT_SIZE_CHANGED: return WindowResize{};
        case SDL_WINDOWEVENT_CLOSE: return QuitRequest{};
        default: return {};
    }
}

std::optional<InputEvent> translate_mouse(const SDL_Event& event, const Placement& at) {
    if (event.type == SDL_MOUSEMOTION)
        return MouseMotion{double(event.motion.xrel), double(event.motion.yrel),
                           in_picture(event.motion.x, at.left, at.scale), in_picture(event.motion.y, at.top, at.scale)};
    return MouseButtonChange{button_of(event.button.button), event.type == SDL_MOUSEBUTTONDOWN,
                             in_picture(event.button.x, at.left, at.scale),
                             in_picture(event.button.y, at.top, at.scale)};
}

}  // namespace

std::optional<InputEvent> translate(const SDL_Event& event, const Placement& placement) {
    switch (event.type) {
        case SDL_QUIT: return QuitRequest{};
        case SDL_WINDOWEVENT: return translate_window(event.window);
        case SDL_KEYDOWN:
        case SDL_KEYUP:
            return KeyChange{key_of(event.key.keysym.scancode), event.type == SDL_KEYDOWN, event.key.repeat != 0};
        case SDL_MOUSEMOTION:
        case SDL_MOUSEBUTTONDOWN:
        case SDL_MOUSEBUTTONUP: return translate_mouse(event, placement);
        case SDL_MOUSEWHEEL: return MouseWheel{wheel_steps(event.wheel)};
        case SDL_CONTROLLERBUTTONDOWN:
        case SDL_CONTROLLERBUTTONUP:
            return GamepadButtonChange{gamepad_button_of(event.cbutton.button), event.type == SDL_CONTROLLERBUTTONDOWN};
        case SDL_CONTROLLERAXISMOTION:
            // -32768 and 32767 are the two ends of a stick.
            return GamepadAxisMotion{axis_of(event.caxis.axis), std::max(event.caxis.value / 32767.0, -1.0)};
        default: return {};
    }
}

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
