// What a person does at the keyboard, the mouse and the gamepad, as plain values that no library leaks into.
#pragma once
#include <cstdint>
#include <variant>

namespace enfilade {

/// Keys by their place on the keyboard, named as on a US keyboard: WASD stays a cross on every layout.
enum class KeyCode : std::uint8_t {
    unknown,
    w,
    a,
    s,
    d,
    c,
    e,
    n,
    r,
    y,
    up,
    down,
    left,
    right,
    page_up,
    page_down,
    home,
    left_shift,
    right_shift,
    left_control,
    right_control,
    left_alt,
    right_alt,
    space,
    tab,
    enter,
    escape,
    plus,
    minus,
    f1,
    f2,
    f3,
    f4,
    f5,
    f6,
    f7,
    f8,
    f9,
    f11,
    f12
};
inline constexpr int kKeyCount = static_cast<int>(KeyCode::f12) + 1;

enum class MouseButton : std::uint8_t { left, middle, right, other };

/// Buttons by their place, as on an Xbox controller.
enum class GamepadButton : std::uint8_t {
    a,
    b,
    x,
    y,
    back,
    start,
    left_shoulder,
    right_shoulder,
    left_stick,
    right_stick,
    up,
    down,
    left,
    right,
    other
};

enum class GamepadAxis : std::uint8_t { left_x, left_y, right_x, right_y, left_trigger, right_trigger, other };

struct KeyChange {
    KeyCode key = KeyCode::unknown;
    bool down = false;
    bool repeat = false;  ///< made by holding the key
};

struct MouseMotion {
    double dx = 0, dy = 0;  ///< [px of the window], y down; also counts while the mouse is grabbed
    double x = 0, y = 0;    ///< position in the picture last presented [px of the picture]
};

struct MouseButtonChange {
    MouseButton button = MouseButton::left;
    bool down = false;
    double x = 0, y = 0;  ///< as in MouseMotion
};

struct MouseWheel {
    double steps = 0;  ///< away from the person is positive
};

struct GamepadButtonChange {
    GamepadButton button = GamepadButton::other;
    bool down = false;
};

struct GamepadAxisMotion {
    GamepadAxis axis = GamepadAxis::other;
    double value = 0;  ///< sticks -1..1, right and down positive; triggers 0..1
};

/// The gamepad was pulled out: whatever was held on it is let go.
struct GamepadLost {};

struct FocusChange {
    bool focused = false;  ///< without focus the mouse is already released and keys count as let go
};

/// Window::size() may have changed.
struct WindowResize {};

/// The person closed the window, or the system asked the program to end.
struct QuitRequest {};

using InputEvent = std::variant<KeyChange, MouseMotion, MouseButtonChange, MouseWheel, GamepadButtonChange,
                                GamepadAxisMotion, GamepadLost, FocusChange, WindowResize, QuitRequest>;

}  // namespace enfilade
