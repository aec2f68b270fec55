#include "app/play/play_loop.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/attempt.h"
#include "platform/clock.h"

namespace enfilade {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;       ///< [ns]
constexpr std::int64_t kTick = kSecond / kTickRate;   ///< [ns]
constexpr std::int64_t kMostToCatchUp = kSecond / 4;  ///< after a longer pause the world just goes on [ns]
constexpr double kWelcomeSeconds = 6;

/// While R is held time runs backwards this fast [ticks a tick].
constexpr std::size_t kRewindSpeed = 2;

}  // namespace

PlayLoop::PlayLoop(Game& game, Window& window, const PlayOptions& options, std::unique_ptr<Renderer> renderer)
    : game_(game),
      window_(window),
      options_(options),
      renderer_(std::move(renderer)),
      outside_renderer_(std::make_unique<OutsideRenderer>(game.map(), game.textures())) {
    settings_.fullscreen = options.fullscreen;
    settings_.true_pitch = options.true_pitch;
}

Status PlayLoop::run() {
    Status ended;
    const Status broken = attempt([&] { ended = play(); });
    if (broken) return save_what_was_played(*broken);
    return ended ? Status(save_what_was_played(*ended)) : Status();
}

Status PlayLoop::play() {
    if (!options_.tape.empty())
        if (Status failed = game_.record(options_.tape)) return failed;
    started_ns_ = passed_until_ns_ = ticked_until_ns_ = looked_ns_ = now_ns();
    window_.grab_mouse(true);
    notices_.say("F1: keys   Esc: menu   Tab: map", 0, kWelcomeSeconds);
    begin_sounds();
    const auto frame_time = static_cast<std::int64_t>(kSecond / window_.refresh_hz());
    std::vector<InputEvent> events;
    while (!quit_) {
        const std::int64_t now = now_ns();
        events.clear();
        window_.poll(events);
        for (const InputEvent& event : events) handle(event);
        look_for_changes(now);
        pass_time(now);
        hear();
        if (Status failed = show(now)) return failed;
        sleep_until_ns(now + frame_time);
    }
    game_.end_recording();
    return game_.take_recording_fault();
}

double PlayLoop::now_s() const { return static_cast<double>(now_ns() - started_ns_) / kSecond; }

double PlayLoop::part_of_tick(std::int64_t now) const { return static_cast<double>(now - ticked_until_ns_) / kTick; }

void PlayLoop::tell(const std::string& text) { notices_.say(text, now_s()); }

void PlayLoop::handle(const InputEvent& event) {
    if (std::holds_alternative<QuitRequest>(event)) quit_ = true;
    if (const auto* focus = std::get_if<FocusChange>(&event)) change_focus(focus->focused);
    if (const auto* motion = std::get_if<MouseMotion>(&event)) mouse_ = *motion;
    if (const auto* key = std::get_if<KeyChange>(&event); key && key->key == KeyCode::f1 && key->down && !key->repeat)
        keys_open_ = !keys_open_;
    if (menu_.is_open()) return obey(menu_.handle(event, settings_));
    input_.handle(event, settings_.mouse_speed, window_.mouse_grabbed());
    if (const auto* key = std::get_if<KeyChange>(&event); key && key->key == KeyCode::r) rewinding_ = key->down;
    if (const auto* key = std::get_if<KeyChange>(&event); key && key->down && !key->repeat) handle_key(key->key);
    if (const auto* button = std::get_if<GamepadButtonChange>(&event); button && button->down)
        handle_gamepad(button->button);
    if (const auto* click = std::get_if<MouseButtonChange>(&event); click && click->down) window_.grab_mouse(true);
    if (const auto* wheel = std::get_if<MouseWheel>(&event)) turn_wheel(wheel->steps > 0 ? 1 : -1);
}

void PlayLoop::handle_key(KeyCode key) {
    switch (key) {
        case KeyCode::escape: return open_menu();
        case KeyCode::tab: return game_.automap().toggle();
        case KeyCode::plus: return zoom(1);
        case KeyCode::minus: return zoom(-1);
        case KeyCode::f2: change_renderer(); return;
        case KeyCode::f3: readout_open_ = !readout_open_; return;
        case KeyCode::f4: return outside_.show_next();
        case KeyCode::f8: return fly_or_land();
        case KeyCode::f7: pixel_text_open_ = !pixel_text_open_; return;
        case KeyCode::f6: return outside_.change_side();
        case KeyCode::f5: return save_game();
        case KeyCode::f9: return load_game();
        case KeyCode::f11: settings_.fullscreen = !settings_.fullscreen; return apply_settings();
        case KeyCode::f12: screenshot_wanted_ = true; return;
        default: return;
    }
}

void PlayLoop::change_focus(bool focused) {
    window_.grab_mouse(focused && !menu_.is_open());
    if (focused) return;
    rewinding_ = false;
    if (settings_.pauses_unfocused && !menu_.is_open()) open_menu();
}

void PlayLoop::fly_or_land() {
    if (free_camera_)
        free_camera_.reset();
    else
        free_camera_.emplace(eye_between_ticks(game_.map(), game_.world(), 1));
}

void PlayLoop::turn_wheel(int steps) {
    if (!input_.held(KeyCode::left_control) && !input_.held(KeyCode::right_control)) return zoom(steps);
    widen_view(settings_, -steps);
    notices_.update("fov", fmt::format("Field of view: {:.0f} degrees", settings_.fov_degrees), now_s());
}

void PlayLoop::zoom(int steps) {
    if (game_.automap().is_open())
        game_.automap().zoom(steps);
    else
        outside_.zoom(steps);
}

void PlayLoop::handle_gamepad(GamepadButton button) {
    if (button == GamepadButton::start) return open_menu();
    if (button == GamepadButton::back) game_.automap().toggle();
}

void PlayLoop::obey(MenuAction action) {
    switch (action) {
        case MenuAction::none: return;
        case MenuAction::resume: return close_menu();
        case MenuAction::restart: free_camera_.reset(), game_.restart(); return close_menu();
        case MenuAction::settings_changed: return apply_settings();
        case MenuAction::quit: quit_ = true; return;
    }
}

void PlayLoop::open_menu() {
    input_.release_all();
    rewinding_ = false;  // letting go of R is told to the menu
    menu_.open();
    window_.grab_mouse(false);
}

void PlayLoop::close_menu() {
    menu_.close();
    window_.grab_mouse(true);
}

void PlayLoop::apply_settings() {
    if (window_.fullscreen() != settings_.fullscreen) window_.set_fullscreen(settings_.fullscreen);
}

void PlayLoop::pass_time(std::int64_t now) {
    if (menu_.is_open()) ticked_until_ns_ += now - passed_until_ns_;
    passed_until_ns_ = now;
    ticked_until_ns_ = std::max(ticked_until_ns_, now - kMostToCatchUp);
    if (!rewinding_) rewound_ticks_ = 0;
    for (; now - ticked_until_ns_ >= kTick; ticked_until_ns_ += kTick) {
        const TickInput input =
            input_.take_tick(free_camera_ ? free_camera_->eye().pitch_steps : game_.player().pitch_steps);
        if (rewinding_) {
            const std::uint64_t before = game_.world().tick;
            game_.rewind(kRewindSpeed);
            rewound_ticks_ += before - game_.world().tick;
        } else {
            if (free_camera_) free_camera_->move(game_.map(), input);
            game_.tick(free_camera_ ? TickInput() : input);
        }
    }
    follow_events();
}

}  // namespace enfilade
