// From keys, mouse and gamepad to what is asked of the player in one tick.
#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "app/play/settings.h"
#include "platform/input_event.h"
#include "render/view.h"
#include "world/input.h"
#include "world/world.h"

namespace enfilade {

/// A turn of the head [2^-32 turn], right and up positive.
struct LookSteps {
    std::int64_t yaw = 0;
    std::int64_t pitch = 0;
};

/// Keys, and the buttons of the mouse as keys; none for all other events.
std::optional<KeyChange> as_key(const InputEvent& event);

/// Keeps its own account of what is held down, from events alone.
///
/// Keys do what the settings bind them to. Walking slowly is a part of the pace, as a stick that is pushed half way:
/// nothing that a tape would have to know. Control, where it crouches, does not while the wheel turns, which zooms.
/// Gamepad: left stick walks, right stick looks, left shoulder or stick runs, B crouches, A or X uses.
class PlayerInput {
public:
    /// From now on keys and mouse are as these settings say.
    void obey(const Settings& settings);

    /// The mouse turns the head only where `mouse_looks`.
    void handle(const InputEvent& event, bool mouse_looks);

    bool held(KeyCode key) const { return keys_[static_cast<std::size_t>(key)]; }
    bool held(Control control) const;

    /// Everything is let go, e.g. because a menu opened.
    void release_all();

    /// What is asked for in this tick; the mouse's motion since the last is used up. pitch_steps: where the player
    /// looks. seconds: that the tick lasts.
    TickInput take_tick(std::int32_t pitch_steps, double seconds);

    /// What the mouse has turned beyond what a picture `part` of the way from the tick before to this one shows, so
    /// that it can be shown at once instead of a tick later.
    LookSteps ahead(double part) const;

private:
    void hold(KeyCode key, bool down) { keys_[static_cast<std::size_t>(key)] = down; }
    void hold(GamepadButton button, bool down) { buttons_[static_cast<std::size_t>(button)] = down; }
    bool held(GamepadButton button) const { return buttons_[static_cast<std::size_t>(button)]; }
    double axis(GamepadAxis axis) const { return axes_[static_cast<std::size_t>(axis)]; }
    /// 1, 0 or -1.
    int balance(Control plus, Control minus) const { return int{held(plus)} - int{held(minus)}; }
    /// 1, or -1 where looking up and down is turned round.
    double upward() const { return invert_ ? -1 : 1; }

    /// The part of the pace that is asked for, 0..1.
    double part_of_pace() const;
    double forward() const;
    double strafe() const;
    LookSteps held_look(double seconds) const;
    bool crouches() const;
    std::uint8_t pressed() const;
    bool control_held() const { return held(KeyCode::left_control) || held(KeyCode::right_control); }

    Bindings bindings_ = usual_bindings();
    double mouse_speed_ = 1;
    bool invert_ = false;
    std::array<bool, kKeyCount> keys_{};
    std::array<bool, 16> buttons_{};
    std::array<double, 8> axes_{};
    double mouse_yaw_ = 0, mouse_pitch_ = 0;  ///< not yet used up [2^-32 turn]
    LookSteps mouse_tick_;                    ///< the mouse's share of the last tick
    std::uint8_t tapped_ = 0;                 ///< InputButton bits that were down at some time since the last tick
    bool center_ = false;                     ///< it was asked to look ahead
    bool control_zooms_ = false;              ///< the wheel has turned since Control was pressed
};

// From an eye and what the mouse adds to its look, to the view that renderers draw.

/// The eye's view, the head turned further by `ahead`, up and down within kMaxPitchSteps.
View view_of(const Eye& eye, const LookSteps& ahead, const Lens& lens);

}  // namespace enfilade
