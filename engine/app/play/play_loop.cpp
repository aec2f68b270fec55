// The loop of playing, and what keys, mouse, gamepad and menu do in it.
#include "app/play/play_loop.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "base/attempt.h"
#include "platform/clock.h"

namespace enfilade {
namespace {

constexpr std::int64_t kMostToCatchUp = kSecond / 4;  ///< after a longer pause the world just goes on [ns]
constexpr double kWelcomeSeconds = 6;

/// While R is held time runs backwards this fast [ticks a tick].
constexpr std::size_t kRewindSpeed = 2;

/// A display that is waited for sets the pace; the limit only keeps those from racing that do not wait after all.
constexpr double kSpareForDisplay = 1.25;

}  // namespace

PlayLoop::PlayLoop(Game& game, Window& window, SettingsStore& store, const PlayOptions& options,
                   std::unique_ptr<Renderer> renderer)
    : game_(game),
      window_(window),
      store_(store),
      options_(options),
      renderer_(std::move(renderer)),
      outside_renderer_(std::make_unique<OutsideRenderer>(game.map(), game.textures())),
      stillness_(game.map()),
      drawn_by_(store.now().renderer) {}

Result<void> PlayLoop::run() {
    Result<void> ended;
    if (const Result<void> unbroken = attempt([&] { ended = play(); }); !unbroken.ok()) ended = unbroken;
    if (!ended.ok()) return save_what_was_played(ended.error());
    return {};
}

void PlayLoop::begin() {
    started_ns_ = passed_until_ns_ = ticked_until_ns_ = looked_ns_ = acted_ns_ = now_ns();
    hurt_ns_ = died_ns_ = started_ns_ - kSecond;
    last_health_ = game_.world().health;
    input_.obey(settings());
    if (!renderer_) use_or_replace(settings().renderer);
    window_.grab_mouse(true);
    notices_.say("F1: keys   Esc: menu   Tab: map", 0, kWelcomeSeconds);
    for (const std::string& note : store_.notes()) notices_.say(note, 0, 2 * kWelcomeSeconds);
    if (!options_.note.empty()) notices_.say(options_.note, 0, 2 * kWelcomeSeconds);
    tell_warnings();
    begin_sounds();
}

Result<void> PlayLoop::play() {
    if (!options_.tape.empty())
        if (const Result<void> done = game_.record(options_.tape); !done.ok()) return done.error();
    begin();
    std::vector<InputEvent> events;
    while (!quit_ && !to_title_) {
        set_pace(now_ns());
        sleep_until_ns(pacing_.begin());
        const std::int64_t now = began_ns_ = now_ns();
        events.clear();
        window_.poll(events);
        if (!events.empty()) is_changed_ = true, acted_ns_ = now;
        for (const InputEvent& event : events) handle(event);
        look_for_changes(now);
        pass_time(now);
        hear();
        if (const Result<void> done = show(now); !done.ok()) return done.error();
        pacing_.go_on(now_ns());
    }
    if (const Result<void> done = store_.save(); !done.ok()) tell(done.error().text());
    game_.end_recording();
    if (const auto fault = game_.take_recording_fault()) return *fault;
    return {};
}

void PlayLoop::set_pace(std::int64_t now) {
    double hz = settings().frame_limit > 0 ? settings().frame_limit : window_.refresh_hz();
    if (window_.waits_for_display() && hz >= window_.refresh_hz()) hz = window_.refresh_hz() * kSpareForDisplay;
    if (is_paused() && now - acted_ns_ > kUntilIdle) hz = std::min(hz, kIdleHz);
    if (window_.is_hidden()) hz = std::min(hz, kHiddenHz);
    pacing_.set_period(static_cast<std::int64_t>(kSecond / hz));
}

double PlayLoop::now_s() const { return static_cast<double>(now_ns() - started_ns_) / kSecond; }

std::int64_t PlayLoop::tick_ns() const { return kSecond / ticks_per_second(game_.tick_rate()); }

double PlayLoop::part_of_tick(std::int64_t now) const {
    return static_cast<double>(now - ticked_until_ns_) / static_cast<double>(tick_ns());
}

void PlayLoop::tell(const std::string& text) { notices_.say(text, now_s()); }

void PlayLoop::pass_time(std::int64_t now) {
    if (is_paused()) ticked_until_ns_ += now - passed_until_ns_;
    passed_until_ns_ = now;
    ticked_until_ns_ = std::max(ticked_until_ns_, now - kMostToCatchUp);
    if (!rewinding_) rewound_ticks_ = 0;
    const double seconds = tick_seconds(game_.tick_rate());
    for (; now - ticked_until_ns_ >= tick_ns() && !end_; ticked_until_ns_ += tick_ns()) {
        const TickInput input =
            input_.take_tick(free_camera_ ? free_camera_->eye().pitch_steps : game_.player().pitch_steps, seconds);
        if (rewinding_) {
            const std::uint64_t before = game_.world().tick;
            game_.rewind(kRewindSpeed);
            rewound_ticks_ += before - game_.world().tick;
        } else {
            if (free_camera_) free_camera_->move(game_.map(), input, seconds);
            game_.tick(free_camera_ ? TickInput() : input);
        }
    }
    follow_events();
    follow_health(now);
}

// Keys, mouse, gamepad and menu.

namespace {

bool is_tap(const InputEvent& event) {
    if (const auto* click = std::get_if<MouseButtonChange>(&event)) return click->down;
    if (const auto* button = std::get_if<GamepadButtonChange>(&event)) return button->down;
    const auto* const key = std::get_if<KeyChange>(&event);
    return key && key->down && !key->repeat;
}

std::optional<Control> control_of(const Bindings& bindings, KeyCode key) {
    const auto found = std::ranges::find_if(bindings, [&](const ControlKeys& keys) {
        return key != KeyCode::unknown && std::ranges::count(keys, key) > 0;
    });
    if (found == bindings.end()) return {};
    return static_cast<Control>(found - bindings.begin());
}

}  // namespace

void PlayLoop::handle(const InputEvent& event) {
    if (std::holds_alternative<QuitRequest>(event)) quit_ = true;
    if (const auto* focus = std::get_if<FocusChange>(&event)) change_focus(focus->focused);
    if (const auto* motion = std::get_if<MouseMotion>(&event)) mouse_ = *motion;
    const auto key = as_key(event);
    const auto control = key ? control_of(settings().bindings, key->key) : std::optional<Control>();
    if (control == Control::show_keys && is_tap(event)) keys_open_ = !keys_open_;
    if (menu_.is_open()) {
        Settings changed = settings();
        const MenuChoice choice = menu_.handle(event, changed);
        if (choice.action == MenuAction::settings_changed) return change_settings(changed);
        return obey(choice);
    }
    if (end_ && is_tap(event)) return enter_next_map();
    if (move_automap(event)) return;
    input_.handle(event, window_.mouse_grabbed());
    if (control == Control::rewind) rewinding_ = key->down;
    if (control && is_tap(event)) press(*control);
    if (const auto* typed = std::get_if<KeyChange>(&event); typed && typed->key == KeyCode::escape && is_tap(event))
        open_menu();
    if (const auto* button = std::get_if<GamepadButtonChange>(&event); button && button->down)
        press_gamepad(button->button);
    if (const auto* click = std::get_if<MouseButtonChange>(&event); click && click->down) window_.grab_mouse(true);
    if (const auto* wheel = std::get_if<MouseWheel>(&event)) turn_wheel(wheel->steps > 0 ? 1 : -1);
}

void PlayLoop::press(Control control) {
    is_changed_ = true;
    switch (control) {
        case Control::automap: return game_.automap().toggle();
        case Control::zoom_in: return zoom(1);
        case Control::zoom_out: return zoom(-1);
        case Control::change_renderer: {
            Settings other = settings();
            other.renderer = drawn_by_ == RendererKind::stencil ? RendererKind::column : RendererKind::stencil;
            return change_settings(other);
        }
        case Control::readout: readout_open_ = !readout_open_; return;
        case Control::outside: return outside_.show_next();
        case Control::outside_side: return outside_.change_side();
        case Control::fly: return fly_or_land();
        case Control::pixel: pixel_text_open_ = !pixel_text_open_; return;
        case Control::save: return save_game();
        case Control::load: return load_game();
        case Control::fullscreen: {
            Settings other = settings();
            other.fullscreen = !other.fullscreen;
            return change_settings(other);
        }
        case Control::screenshot: screenshot_wanted_ = true; return;
        default: return;
    }
}

bool PlayLoop::move_automap(const InputEvent& event) {
    if (!game_.automap().is_open()) return false;
    const auto* const key = std::get_if<KeyChange>(&event);
    const auto* const button = std::get_if<GamepadButtonChange>(&event);
    const auto is = [&](KeyCode code, GamepadButton pad) {
        return (key && key->key == code) || (button && button->button == pad);
    };
    const int right = int{is(KeyCode::right, GamepadButton::right)} - int{is(KeyCode::left, GamepadButton::left)};
    const int up = int{is(KeyCode::up, GamepadButton::up)} - int{is(KeyCode::down, GamepadButton::down)};
    if (key && key->down && key->key == KeyCode::home) game_.automap().follow();
    if (right == 0 && up == 0) return false;
    if ((key && key->down) || (button && button->down)) game_.automap().pan(right, up);
    return true;
}

void PlayLoop::change_focus(bool focused) {
    window_.grab_mouse(focused && !menu_.is_open());
    if (focused) return;
    rewinding_ = false;
    if (settings().pause_when_away && !menu_.is_open()) open_menu();
}

void PlayLoop::fly_or_land() {
    if (free_camera_)
        free_camera_.reset();
    else
        free_camera_.emplace(eye_between_ticks(game_.map(), game_.world(), 1));
}

void PlayLoop::turn_wheel(int steps) {
    if (!input_.held(KeyCode::left_control) && !input_.held(KeyCode::right_control)) return zoom(steps);
    const Setting& fov = setting_named("fov");
    Settings wider = settings();
    fov.turn(fov, -steps, wider);
    change_settings(wider);
    notices_.update("fov", fmt::format("Field of view: {:.0f} degrees", wider.fov_degrees), now_s());
}

void PlayLoop::zoom(int steps) {
    if (game_.automap().is_open())
        game_.automap().zoom(steps);
    else
        outside_.zoom(steps);
}

void PlayLoop::press_gamepad(GamepadButton button) {
    if (button == GamepadButton::start) return open_menu();
    if (button == GamepadButton::back) game_.automap().toggle();
}

void PlayLoop::obey(const MenuChoice& choice) {
    switch (choice.action) {
        case MenuAction::resume: return close_menu();
        case MenuAction::restart: free_camera_.reset(), end_.reset(), game_.restart(); return close_menu();
        case MenuAction::save: save_game(); return close_menu();
        case MenuAction::load: load_game(); return close_menu();
        case MenuAction::control: close_menu(); return press(choice.control);
        case MenuAction::to_title: to_title_ = true; return;
        case MenuAction::quit: quit_ = true; return;
        default: return;
    }
}

void PlayLoop::open_menu() {
    input_.release_all();
    rewinding_ = false;  // letting go of R is told to the menu
    menu_.open(MenuPage::pause);
    window_.grab_mouse(false);
}

void PlayLoop::close_menu() {
    menu_.close();
    window_.grab_mouse(true);
    if (const Result<void> done = store_.save(); !done.ok()) tell(done.error().text());
}

void PlayLoop::change_settings(Settings changed) {
    const Settings before = settings();
    if (changed.true_pitch && !before.true_pitch) {
        untilted_renderer_ = before.renderer;
        changed.renderer = RendererKind::stencil;
    } else if (!changed.true_pitch && before.true_pitch && untilted_renderer_) {
        changed.renderer = *std::exchange(untilted_renderer_, std::nullopt);
    }
    store_.change(changed);
    is_changed_ = true;
    input_.obey(changed);
    if (window_.fullscreen() != changed.fullscreen) window_.set_fullscreen(changed.fullscreen);
    const Map& map = game_.map();
    const bool is_drawn_alike = changed.renderer == before.renderer &&
                                dials_of(changed, changed.renderer, map) == dials_of(before, before.renderer, map);
    if (is_drawn_alike && changed.vsync == before.vsync) return;
    use_or_replace(changed.renderer);
    if (changed.renderer != before.renderer) tell("Drawn by the " + name_of(drawn_by_) + " renderer.");
}

}  // namespace enfilade
