#include "app/play/player_input.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "render/view.h"

namespace enfilade {

namespace {

constexpr double kStepsPerDegree = 4294967296.0 / 360;

/// What a pixel of the mouse turns at speed 1 [degrees]: 1600 px, a calm sweep, turn half round.
constexpr double kDegreesPerPixel = 180.0 / 1600;

constexpr double kKeyTurn = 150, kKeyTurnRunning = 240;  ///< keys turn this fast [degrees/s]
constexpr double kKeyLook = 90;                          ///< and look up and down this fast [degrees/s]
constexpr double kStickTurn = 220, kStickLook = 120;     ///< a stick that is fully pushed [degrees/s]

constexpr double kSlowly = 0.35;  ///< of the pace, while Alt is held: to the edge of a step, not over it [1]

/// Below this a stick counts as let go [1]: worn sticks do not come back to the middle.
constexpr double kDeadZone = 0.18;

/// The stick without its dead zone, still up to 1.
double pushed(double value) {
    const double beyond = std::abs(value) - kDeadZone;
    return beyond <= 0 ? 0 : std::copysign(std::min(beyond / (1 - kDeadZone), 1.0), value);
}

/// Finer near the middle, for aiming.
double curved(double value) { return pushed(value) * std::abs(pushed(value)); }

std::int8_t pace(double value) { return static_cast<std::int8_t>(std::lround(std::clamp(value, -1.0, 1.0) * 127)); }

std::int64_t steps_of(double degrees) { return std::llround(degrees * kStepsPerDegree); }

/// A tape holds 32 bits; a mouse that turns further than half round in a tick is not meant.
std::int32_t clamped(std::int64_t steps) {
    return static_cast<std::int32_t>(std::clamp<std::int64_t>(steps, INT32_MIN, INT32_MAX));
}

/// A mouse button as the key that bindings know; unknown for those they do not.
KeyCode key_of(MouseButton button) {
    switch (button) {
        case MouseButton::left: return KeyCode::mouse_left;
        case MouseButton::middle: return KeyCode::mouse_middle;
        case MouseButton::right: return KeyCode::mouse_right;
        case MouseButton::other: break;
    }
    return KeyCode::unknown;
}

}  // namespace

std::optional<KeyChange> as_key(const InputEvent& event) {
    if (const auto* key = std::get_if<KeyChange>(&event)) return *key;
    if (const auto* click = std::get_if<MouseButtonChange>(&event))
        return KeyChange{key_of(click->button), click->down, false};
    return {};
}

void PlayerInput::obey(const Settings& settings) {
    bindings_ = settings.bindings;
    mouse_speed_ = settings.mouse_speed;
    invert_ = settings.invert_mouse;
}

bool PlayerInput::held(Control control) const {
    return std::ranges::any_of(keys_for(bindings_, control),
                               [&](KeyCode key) { return key != KeyCode::unknown && held(key); });
}

void PlayerInput::handle(const InputEvent& event, bool mouse_looks) {
    if (const auto key = as_key(event)) {
        hold(key->key, key->down);
        if (key->down && std::ranges::count(keys_for(bindings_, Control::look_ahead), key->key) > 0) center_ = true;
        control_zooms_ = control_zooms_ && control_held();
    } else if (std::holds_alternative<MouseWheel>(event)) {
        control_zooms_ = control_held();
    } else if (const auto* motion = std::get_if<MouseMotion>(&event); motion && mouse_looks) {
        const double steps_per_pixel = mouse_speed_ * kDegreesPerPixel * kStepsPerDegree;
        mouse_yaw_ += motion->dx * steps_per_pixel;
        mouse_pitch_ -= motion->dy * steps_per_pixel * upward();
    } else if (const auto* button = std::get_if<GamepadButtonChange>(&event)) {
        hold(button->button, button->down);
    } else if (const auto* stick = std::get_if<GamepadAxisMotion>(&event)) {
        axes_[static_cast<std::size_t>(stick->axis)] = stick->value;
    } else if (std::holds_alternative<GamepadLost>(event)) {
        buttons_.fill(false);
        axes_.fill(0);
    } else if (const auto* focus = std::get_if<FocusChange>(&event); focus && !focus->focused) {
        release_all();
    }
    tapped_ |= pressed();
}

void PlayerInput::release_all() {
    PlayerInput fresh;
    fresh.bindings_ = bindings_;
    fresh.mouse_speed_ = mouse_speed_;
    fresh.invert_ = invert_;
    *this = fresh;
}

double PlayerInput::part_of_pace() const { return held(Control::slowly) ? kSlowly : 1; }

double PlayerInput::forward() const {
    return balance(Control::forward, Control::back) - pushed(axis(GamepadAxis::left_y));
}

double PlayerInput::strafe() const {
    return balance(Control::step_right, Control::step_left) + pushed(axis(GamepadAxis::left_x));
}

LookSteps PlayerInput::held_look(double seconds) const {
    const double key_turn = pressed() & kButtonRun ? kKeyTurnRunning : kKeyTurn;
    const double turn =
        balance(Control::turn_right, Control::turn_left) * key_turn + curved(axis(GamepadAxis::right_x)) * kStickTurn;
    const double look = balance(Control::look_up, Control::look_down) * kKeyLook -
                        curved(axis(GamepadAxis::right_y)) * kStickLook * upward();
    return {steps_of(turn * seconds), steps_of(look * seconds)};
}

bool PlayerInput::crouches() const {
    return std::ranges::any_of(keys_for(bindings_, Control::crouch), [&](KeyCode key) {
        const bool is_control = key == KeyCode::left_control || key == KeyCode::right_control;
        return key != KeyCode::unknown && held(key) && !(is_control && control_zooms_);
    });
}

std::uint8_t PlayerInput::pressed() const {
    const bool run = held(Control::run) || held(GamepadButton::left_shoulder) || held(GamepadButton::left_stick);
    const bool crouch = crouches() || held(GamepadButton::b);
    const bool use = held(Control::use) || held(GamepadButton::a) || held(GamepadButton::x);
    return static_cast<std::uint8_t>((run ? kButtonRun : 0) | (crouch ? kButtonCrouch : 0) | (use ? kButtonUse : 0));
}

TickInput PlayerInput::take_tick(std::int32_t pitch_steps, double seconds) {
    mouse_tick_ = {std::llround(mouse_yaw_), std::llround(mouse_pitch_)};
    mouse_yaw_ = mouse_pitch_ = 0;
    LookSteps look = held_look(seconds);
    look.yaw += mouse_tick_.yaw;
    look.pitch += mouse_tick_.pitch;
    if (std::exchange(center_, false)) {
        look.pitch = -std::int64_t{pitch_steps};
        mouse_tick_.pitch = 0;
    }
    const auto buttons = static_cast<std::uint8_t>(pressed() | (std::exchange(tapped_, std::uint8_t{0}) & kButtonUse));
    const double part = part_of_pace();
    return {pace(forward() * part), pace(strafe() * part), clamped(look.yaw), clamped(look.pitch), buttons};
}

LookSteps PlayerInput::ahead(double part) const {
    return {std::llround(mouse_yaw_ + static_cast<double>(mouse_tick_.yaw) * (1 - part)),
            std::llround(mouse_pitch_ + static_cast<double>(mouse_tick_.pitch) * (1 - part))};
}

namespace {

/// The angle of pitch_steps, within ±kMaxPitchSteps.
Angle pitch_of(std::int64_t steps) {
    const std::int64_t within = std::clamp<std::int64_t>(steps, -kMaxPitchSteps, kMaxPitchSteps);
    return Angle{static_cast<std::uint32_t>(within)};
}

}  // namespace

View view_of(const Eye& eye, const LookSteps& ahead, const Lens& lens) {
    Eye turned = eye;
    turned.yaw = eye.yaw + Angle{static_cast<std::uint32_t>(ahead.yaw)};
    turned.pitch_steps = static_cast<std::int32_t>(pitch_of(eye.pitch_steps + ahead.pitch).steps);
    return view_from(turned, lens);
}

}  // namespace enfilade
