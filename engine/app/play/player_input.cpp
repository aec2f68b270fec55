#include "app/play/player_input.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "render/view_from.h"

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

std::int64_t steps_per_tick(double degrees_per_second) {
    return std::llround(degrees_per_second * kTickSeconds * kStepsPerDegree);
}

/// A tape holds 32 bits; a mouse that turns further than half round in a tick is not meant.
std::int32_t clamped(std::int64_t steps) {
    return static_cast<std::int32_t>(std::clamp<std::int64_t>(steps, INT32_MIN, INT32_MAX));
}

}  // namespace

void PlayerInput::handle(const InputEvent& event, double mouse_speed, bool mouse_looks) {
    if (const auto* key = std::get_if<KeyChange>(&event)) {
        hold(key->key, key->down);
        if (key->key == KeyCode::home && key->down) center_ = true;
        control_zooms_ = control_zooms_ && control_held();
    } else if (std::holds_alternative<MouseWheel>(event)) {
        control_zooms_ = control_held();
    } else if (const auto* motion = std::get_if<MouseMotion>(&event); motion && mouse_looks) {
        mouse_yaw_ += motion->dx * mouse_speed * kDegreesPerPixel * kStepsPerDegree;
        mouse_pitch_ -= motion->dy * mouse_speed * kDegreesPerPixel * kStepsPerDegree;
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

void PlayerInput::release_all() { *this = {}; }

double PlayerInput::part_of_pace() const { return held(KeyCode::left_alt) || held(KeyCode::right_alt) ? kSlowly : 1; }

double PlayerInput::forward() const {
    const int keys = int{held(KeyCode::w) || held(KeyCode::up)} - int{held(KeyCode::s) || held(KeyCode::down)};
    return keys - pushed(axis(GamepadAxis::left_y));
}

double PlayerInput::strafe() const { return balance(KeyCode::d, KeyCode::a) + pushed(axis(GamepadAxis::left_x)); }

LookSteps PlayerInput::held_look() const {
    const double key_turn = pressed() & kButtonRun ? kKeyTurnRunning : kKeyTurn;
    return {steps_per_tick(balance(KeyCode::right, KeyCode::left) * key_turn +
                           curved(axis(GamepadAxis::right_x)) * kStickTurn),
            steps_per_tick(balance(KeyCode::page_up, KeyCode::page_down) * kKeyLook -
                           curved(axis(GamepadAxis::right_y)) * kStickLook)};
}

std::uint8_t PlayerInput::pressed() const {
    const bool run = held(KeyCode::left_shift) || held(KeyCode::right_shift) || held(GamepadButton::left_shoulder) ||
                     held(GamepadButton::left_stick);
    const bool crouch = held(KeyCode::c) || (control_held() && !control_zooms_) || held(GamepadButton::b);
    const bool use = held(KeyCode::e) || held(KeyCode::space) || held(GamepadButton::a) || held(GamepadButton::x);
    return static_cast<std::uint8_t>((run ? kButtonRun : 0) | (crouch ? kButtonCrouch : 0) | (use ? kButtonUse : 0));
}

TickInput PlayerInput::take_tick(std::int32_t pitch_steps) {
    mouse_tick_ = {std::llround(mouse_yaw_), std::llround(mouse_pitch_)};
    mouse_yaw_ = mouse_pitch_ = 0;
    LookSteps look = held_look();
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

View view_of(const Eye& eye, const LookSteps& ahead, double fov_degrees, double stretch, bool true_pitch) {
    Eye turned = eye;
    turned.yaw = eye.yaw + Angle{static_cast<std::uint32_t>(ahead.yaw)};
    turned.pitch_steps = static_cast<std::int32_t>(pitch_of(eye.pitch_steps + ahead.pitch).steps);
    return view_from(turned, {fov_degrees, stretch, true_pitch});
}

}  // namespace enfilade
