#include "platform/input_event.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>

#include "platform/sdl_events.h"

namespace enfilade {
namespace {

/// By KeyCode.
constexpr std::array<std::string_view, kKeyCount> kNames{
    // clang-format off
    "", "A", "B", "C", "D", "E", "F", "G", "H", "I", "J", "K", "L", "M", "N", "O", "P", "Q", "R", "S", "T", "U",
    "V", "W", "X", "Y", "Z", "0", "1", "2", "3", "4", "5", "6", "7", "8", "9", "Up", "Down", "Left", "Right",
    "Page Up", "Page Down", "Home", "End", "Insert", "Delete", "Backspace", "Left Shift", "Right Shift",
    "Left Ctrl", "Right Ctrl", "Left Alt", "Right Alt", "Space", "Tab", "Enter", "Esc", "+", "-", ",", ".", "/",
    ";", "'", "[", "]", "\\", "`", "F1", "F2", "F3", "F4", "F5", "F6", "F7", "F8", "F9", "F10", "F11", "F12",
    "Mouse Left", "Mouse Middle", "Mouse Right"
    // clang-format on
};

char lower(char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; }

bool is_same_word(std::string_view a, std::string_view b) { return std::ranges::equal(a, b, {}, lower, lower); }

}  // namespace

std::string_view name_of(KeyCode key) { return kNames[static_cast<std::size_t>(key)]; }

KeyCode key_named(std::string_view name) {
    const auto found = std::ranges::find_if(kNames, [&](std::string_view known) { return is_same_word(known, name); });
    return found == kNames.end() ? KeyCode::unknown : static_cast<KeyCode>(found - kNames.begin());
}

namespace {

struct KeyPlace {
    SDL_Scancode code;
    KeyCode key;
};

constexpr KeyPlace kKeyPlaces[] = {
    // clang-format off
    {SDL_SCANCODE_A, KeyCode::a}, {SDL_SCANCODE_B, KeyCode::b}, {SDL_SCANCODE_C, KeyCode::c},
    {SDL_SCANCODE_D, KeyCode::d}, {SDL_SCANCODE_E, KeyCode::e}, {SDL_SCANCODE_F, KeyCode::f},
    {SDL_SCANCODE_G, KeyCode::g}, {SDL_SCANCODE_H, KeyCode::h}, {SDL_SCANCODE_I, KeyCode::i},
    {SDL_SCANCODE_J, KeyCode::j}, {SDL_SCANCODE_K, KeyCode::k}, {SDL_SCANCODE_L, KeyCode::l},
    {SDL_SCANCODE_M, KeyCode::m}, {SDL_SCANCODE_N, KeyCode::n}, {SDL_SCANCODE_O, KeyCode::o},
    {SDL_SCANCODE_P, KeyCode::p}, {SDL_SCANCODE_Q, KeyCode::q}, {SDL_SCANCODE_R, KeyCode::r},
    {SDL_SCANCODE_S, KeyCode::s}, {SDL_SCANCODE_T, KeyCode::t}, {SDL_SCANCODE_U, KeyCode::u},
    {SDL_SCANCODE_V, KeyCode::v}, {SDL_SCANCODE_W, KeyCode::w}, {SDL_SCANCODE_X, KeyCode::x},
    {SDL_SCANCODE_Y, KeyCode::y}, {SDL_SCANCODE_Z, KeyCode::z}, {SDL_SCANCODE_0, KeyCode::digit_0},
    {SDL_SCANCODE_1, KeyCode::digit_1}, {SDL_SCANCODE_2, KeyCode::digit_2}, {SDL_SCANCODE_3, KeyCode::digit_3},
    {SDL_SCANCODE_4, KeyCode::digit_4}, {SDL_SCANCODE_5, KeyCode::digit_5}, {SDL_SCANCODE_6, KeyCode::digit_6},
    {SDL_SCANCODE_7, KeyCode::digit_7}, {SDL_SCANCODE_8, KeyCode::digit_8}, {SDL_SCANCODE_9, KeyCode::digit_9},
    {SDL_SCANCODE_UP, KeyCode::up}, {SDL_SCANCODE_DOWN, KeyCode::down}, {SDL_SCANCODE_LEFT, KeyCode::left},
    {SDL_SCANCODE_RIGHT, KeyCode::right}, {SDL_SCANCODE_PAGEUP, KeyCode::page_up},
    {SDL_SCANCODE_PAGEDOWN, KeyCode::page_down}, {SDL_SCANCODE_HOME, KeyCode::home},
    {SDL_SCANCODE_END, KeyCode::end}, {SDL_SCANCODE_INSERT, KeyCode::insert},
    {SDL_SCANCODE_DELETE, KeyCode::remove}, {SDL_SCANCODE_BACKSPACE, KeyCode::backspace},
    {SDL_SCANCODE_LSHIFT, KeyCode::left_shift}, {SDL_SCANCODE_RSHIFT, KeyCode::right_shift},
    {SDL_SCANCODE_LCTRL, KeyCode::left_control}, {SDL_SCANCODE_RCTRL, KeyCode::right_control},
    {SDL_SCANCODE_LALT, KeyCode::left_alt}, {SDL_SCANCODE_RALT, KeyCode::right_alt},
    {SDL_SCANCODE_SPACE, KeyCode::space}, {SDL_SCANCODE_TAB, KeyCode::tab}, {SDL_SCANCODE_RETURN, KeyCode::enter},
    {SDL_SCANCODE_ESCAPE, KeyCode::escape}, {SDL_SCANCODE_EQUALS, KeyCode::plus},
    {SDL_SCANCODE_MINUS, KeyCode::minus}, {SDL_SCANCODE_COMMA, KeyCode::comma},
    {SDL_SCANCODE_PERIOD, KeyCode::period}, {SDL_SCANCODE_SLASH, KeyCode::slash},
    {SDL_SCANCODE_SEMICOLON, KeyCode::semicolon}, {SDL_SCANCODE_APOSTROPHE, KeyCode::apostrophe},
    {SDL_SCANCODE_LEFTBRACKET, KeyCode::left_bracket}, {SDL_SCANCODE_RIGHTBRACKET, KeyCode::right_bracket},
    {SDL_SCANCODE_BACKSLASH, KeyCode::backslash}, {SDL_SCANCODE_GRAVE, KeyCode::grave},
    {SDL_SCANCODE_F1, KeyCode::f1}, {SDL_SCANCODE_F2, KeyCode::f2}, {SDL_SCANCODE_F3, KeyCode::f3},
    {SDL_SCANCODE_F4, KeyCode::f4}, {SDL_SCANCODE_F5, KeyCode::f5}, {SDL_SCANCODE_F6, KeyCode::f6},
    {SDL_SCANCODE_F7, KeyCode::f7}, {SDL_SCANCODE_F8, KeyCode::f8}, {SDL_SCANCODE_F9, KeyCode::f9},
    {SDL_SCANCODE_F10, KeyCode::f10}, {SDL_SCANCODE_F11, KeyCode::f11}, {SDL_SCANCODE_F12, KeyCode::f12},
    {SDL_SCANCODE_KP_ENTER, KeyCode::enter}, {SDL_SCANCODE_KP_PLUS, KeyCode::plus},
    {SDL_SCANCODE_KP_MINUS, KeyCode::minus}
    // clang-format on
};

KeyCode key_of(SDL_Scancode code) {
    const auto found = std::ranges::find(kKeyPlaces, code, &KeyPlace::code);
    return found == std::end(kKeyPlaces) ? KeyCode::unknown : found->key;
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
        case SDL_WINDOWEVENT_SIZE_CHANGED:
        case SDL_WINDOWEVENT_EXPOSED:
        case SDL_WINDOWEVENT_SHOWN:
        case SDL_WINDOWEVENT_RESTORED: return WindowResize{};
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
