// What a person does at the keyboard, the mouse and the gamepad, as plain values that no library leaks into.
#pragma once
#include <cstdint>
#include <string_view>
#include <variant>

namespace enfilade {

/// Keys by their place on the keyboard, named as on a US keyboard: WASD stays a cross on every layout. The buttons of
/// the mouse are among them, because whatever a key can do, they can.
enum class KeyCode : std::uint8_t {
    unknown,
    // clang-format off
    a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w, x, y, z,
    digit_0, digit_1, digit_2, digit_3, digit_4, digit_5, digit_6, digit_7, digit_8, digit_9,
    up, down, left, right, page_up, page_down, home, end, insert, remove, backspace,
    left_shift, right_shift, left_control, right_control, left_alt, right_alt,
    space, tab, enter, escape, plus, minus, comma, period, slash, semicolon, apostrophe,
    left_bracket, right_bracket, backslash, grave,
    f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12,
    mouse_left, mouse_middle, mouse_right
    // clang-format on
};
inline constexpr int kKeyCount = static_cast<int>(KeyCode::mouse_right) + 1;

/// "W", "Left Shift", "Page Up": how people and files call it; empty for none of those above.
std::string_view name_of(KeyCode key);

/// The key of that name, in capitals or not; unknown where there is none.
KeyCode key_named(std::string_view name);

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

/// Window::size() may have changed, or what the window showed was lost.
struct WindowResize {};

/// The person closed the window, or the system asked the program to end.
struct QuitRequest {};

using InputEvent = std::variant<KeyChange, MouseMotion, MouseButtonChange, MouseWheel, GamepadButtonChange,
                                GamepadAxisMotion, GamepadLost, FocusChange, WindowResize, QuitRequest>;

}  // namespace enfilade
