#include "app/play/play_loop.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/play/saved_game.h"
#include "app/play/screenshot.h"
#include "base/files.h"
#include "base/parallel.h"
#include "platform/clock.h"
#include "platform/gl_context.h"

namespace enfilade {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;       ///< [ns]
constexpr std::int64_t kTick = kSecond / kTickRate;   ///< [ns]
constexpr std::int64_t kMostToCatchUp = kSecond / 4;  ///< after a longer pause the world just goes on [ns]
constexpr std::int64_t kBetweenLooks = kSecond / 4;   ///< between two looks at the map's files [ns]
constexpr double kWelcomeSeconds = 6;

double seconds(std::int64_t ns) { return static_cast<double>(ns) / kSecond; }

std::vector<std::string> split_lines(const std::string& text) {
    std::vector<std::string> lines;
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        lines.push_back(text.substr(at, end - at));
        at = end + 1;
    }
    return lines;
}

/// While R is held time runs backwards this fast [ticks a tick].
constexpr std::size_t kRewindSpeed = 2;

/// More findings than fit a screen help nobody.
constexpr std::size_t kMostLines = 12;

}  // namespace

PlayLoop::PlayLoop(Game& game, Window& window, const PlayOptions& options, std::unique_ptr<Renderer> renderer)
    : game_(game), window_(window), options_(options), renderer_(std::move(renderer)) {
    settings_.fullscreen = options.fullscreen;
    settings_.true_pitch = options.true_pitch;
    if (!options_.tape.empty()) game_.record();
}

Status PlayLoop::run() {
    started_ns_ = passed_until_ns_ = ticked_until_ns_ = looked_ns_ = now_ns();
    window_.grab_mouse(true);
    notices_.say("Esc: menu   Tab: map   F2: renderer   F3: times   F12: picture", 0, kWelcomeSeconds);
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
    return save_tape();
}

void PlayLoop::handle(const InputEvent& event) {
    if (std::holds_alternative<QuitRequest>(event)) quit_ = true;
    if (const auto* focus = std::get_if<FocusChange>(&event)) window_.grab_mouse(focus->focused && !menu_.is_open());
    if (menu_.is_open()) return obey(menu_.handle(event, settings_));
    input_.handle(event, settings_.mouse_speed, window_.mouse_grabbed());
    if (const auto* key = std::get_if<KeyChange>(&event); key && key->key == Key::r) rewinding_ = key->down;
    if (const auto* key = std::get_if<KeyChange>(&event); key && key->down && !key->repeat) handle_key(key->key);
    if (const auto* button = std::get_if<GamepadButtonChange>(&event); button && button->down)
        handle_gamepad(button->button);
    if (const auto* click = std::get_if<MouseButtonChange>(&event); click && click->down) window_.grab_mouse(true);
    if (const auto* wheel = std::get_if<MouseWheel>(&event)) game_.automap().zoom(wheel->steps > 0 ? 1 : -1);
}

void PlayLoop::handle_key(Key key) {
    switch (key) {
        case Key::escape: return open_menu();
        case Key::tab: return game_.automap().toggle();
        case Key::plus: return game_.automap().zoom(1);
        case Key::minus: return game_.automap().zoom(-1);
        case Key::f2: return change_renderer();
        case Key::f3: readout_open_ = !readout_open_; return;
        case Key::f5: return save_game();
        case Key::f9: return load_game();
        case Key::f11: settings_.fullscreen = !settings_.fullscreen; return apply_settings();
        case Key::f12: screenshot_wanted_ = true; return;
        default: return;
    }
}

void PlayLoop::handle_gamepad(GamepadButton button) {
    if (button == GamepadButton::start) return open_menu();
    if (button == GamepadButton::back) game_.automap().toggle();
}

void PlayLoop::obey(MenuAction action) {
    switch (action) {
        case MenuAction::none: return;
        case MenuAction::resume: return close_menu();
        case MenuAction::restart: game_.restart(); return close_menu();
        case MenuAction::settings_changed: return apply_settings();
        case MenuAction::quit: quit_ = true; return;
    }
}

void PlayLoop::open_menu() {
    input_.release_all();
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

void PlayLoop::look_for_changes(std::int64_t now) {
    if (now - looked_ns_ < kBetweenLooks) return;
    looked_ns_ = now;
    if (game_.map_changed()) reload();
}

void PlayLoop::reload() {
    const double now_s = seconds(now_ns() - started_ns_);
    const bool was_recording = game_.is_recording();
    const Status unsaved = was_recording ? save_tape() : Status{};
    if (Status refused = game_.reload()) {
        std::vector<std::string> lines = split_lines(refused->text());
        const std::size_t all = lines.size();
        lines.resize(std::min(all, kMostLines));
        if (all > kMostLines) lines.push_back(fmt::format("and {} more", all - kMostLines));
        lines.emplace_back("The map before is kept until this is put right.");
        return notices_.pin(std::move(lines));
    }
    begin_sounds();
    notices_.pin({});
    notices_.say("The map was changed and loaded again.", now_s);
    if (unsaved) notices_.say(unsaved->text(), now_s);
    if (was_recording) notices_.say("The recording ended with the map before.", now_s);
}

void PlayLoop::pass_time(std::int64_t now) {
    if (menu_.is_open()) ticked_until_ns_ += now - passed_until_ns_;
    passed_until_ns_ = now;
    ticked_until_ns_ = std::max(ticked_until_ns_, now - kMostToCatchUp);
    if (!rewinding_) rewound_ticks_ = 0;
    for (; now - ticked_until_ns_ >= kTick; ticked_until_ns_ += kTick) {
        const TickInput input = input_.take_tick(game_.player().pitch_steps);
        if (rewinding_) {
            const std::uint64_t before = game_.world().tick;
            game_.rewind(kRewindSpeed);
            rewound_ticks_ += before - game_.world().tick;
        } else {
            game_.tick(input);
        }
    }
    follow_events();
}

void PlayLoop::follow_events() {
    const World& world = game_.world();
    if (world.tick < told_) told_ = world.tick;
    if (world.news && world.news->tick > told_) {
        told_ = world.news->tick;
        const std::string text = news_text(game_.map(), *world.news);
        if (!text.empty()) notices_.say(text, seconds(now_ns() - started_ns_));
    }
    if (world.left_by) leave_map();
}

/// The next map lies beside this one; where there is none, one begins again.
void PlayLoop::leave_map() {
    namespace fs = std::filesystem;
    const double now_s = seconds(now_ns() - started_ns_);
    const std::string left = game_.map().name, next = game_.map()[*game_.world().left_by].leads_to;
    fs::path path = fs::path(game_.path()).parent_path() / next;
    if (path.extension() != ".toml") path += ".toml";
    std::error_code unknown;
    told_ = 0;
    if (next.empty() || !fs::exists(path, unknown)) {
        game_.restart();
        return notices_.say(next.empty() ? fmt::format("You left {}.", left)
                                         : fmt::format("You left {}; the next map, {}, is not here.", left, next),
                            now_s);
    }
    if (Status failed = game_.enter(path.string())) {
        game_.restart();
        return notices_.pin(split_lines(failed->text()));
    }
    options_.save = saved_game_of(game_.path());
    begin_sounds();
    notices_.say(fmt::format("{} lies behind you. This is {}.", left, game_.map().name), now_s);
}

void PlayLoop::begin_sounds() {
    if (options_.mute) return;
    for (const std::string& fault : sounds_.begin(game_.map(), game_.path()))
        notices_.say(fault, seconds(now_ns() - started_ns_));
}

void PlayLoop::hear() {
    if (menu_.is_open() || rewinding_)
        sounds_.fall_silent();
    else
        sounds_.hear(game_.map(), game_.world(), settings_.volume);
}

void PlayLoop::save_game() {
    const Status failed = game_.save(options_.save);
    notices_.say(failed ? failed->text() : "Saved. F9 comes back here.", seconds(now_ns() - started_ns_));
}

void PlayLoop::load_game() {
    const Status failed = game_.load_saved(options_.save);
    told_ = game_.world().tick;
    notices_.say(failed ? failed->text() : "Back where you saved.", seconds(now_ns() - started_ns_));
}

void PlayLoop::remember_seen(std::int64_t now) {
    if (now - remembered_ns_ < kBetweenLooks) return;
    remembered_ns_ = now;
    for (const ViewportShape& shape : renderer_->viewports()) game_.automap().see(shape.sector);
}

void PlayLoop::change_renderer() {
    const double now_s = seconds(now_ns() - started_ns_);
    const auto other = options_.renderer == RendererKind::stencil ? RendererKind::column : RendererKind::stencil;
    auto renderer = make_renderer(other, hardware_threads(), open_gl_for_play);
    if (!renderer.ok()) return notices_.say(renderer.error().text(), now_s);
    renderer_ = std::move(renderer).value();
    options_.renderer = other;
    notices_.say("Drawn by the " + name_of(other) + " renderer.", now_s);
}

View PlayLoop::view_now(double part) const {
    const bool tilts = settings_.true_pitch && options_.renderer == RendererKind::stencil;
    return game_.view(part, input_.ahead(part), settings_.fov_degrees, tilts);
}

/// A graphics card that fails is no reason to stop playing.
Status PlayLoop::draw_view(double part) {
    const auto draw = [&] {
        return renderer_->render(frame_, nullptr, game_.map(), game_.textures(), game_.snapshot(part), view_now(part));
    };
    const Status failed = draw();
    if (!failed || options_.renderer != RendererKind::stencil) return failed;
    change_renderer();
    notices_.say(failed->text(), seconds(now_ns() - started_ns_));
    return draw();
}

Status PlayLoop::show(std::int64_t now) {
    const PixelSize size = options_.size ? PixelSize{options_.size->width, options_.size->height} : window_.size();
    frame_.resize(size.width, size.height);
    const double part = static_cast<double>(now - ticked_until_ns_) / kTick;
    const std::int64_t began = now_ns();
    if (Status failed = draw_view(part)) return failed;
    const std::int64_t drawn = now_ns();
    remember_seen(now);
    draw_over(view_now(part), seconds(now - started_ns_));
    Status failed = window_.present(frame_);
    times_.add(drawn - began, now_ns());
    return failed;
}

void PlayLoop::draw_over(const View& view, double now_s) {
    Overlay overlay(frame_, font_, comfortable_scale(frame_.height));
    game_.automap().draw(overlay, game_.map(), {view.sector, view.eye}, view.forward);
    if (readout_open_) {
        const double degrees_per_step = 360 / 4294967296.0;
        draw_readout(overlay, times_,
                     {game_.map()[view.sector].name, name_of(options_.renderer), view.eye.x, view.eye.y, view.eye_z,
                      game_.player().yaw.degrees(), game_.player().pitch_steps * degrees_per_step},
                     renderer_->viewports());
    }
    draw_status(overlay, game_.map(), game_.world());
    if (game_.world().health == 0) draw_death(overlay);
    if (rewinding_) draw_rewind(overlay, rewound_ticks_);
    if (screenshot_wanted_) take_screenshot(now_s);
    notices_.draw(overlay, now_s);
    Overlay menu_overlay(frame_, font_, Menu::scale_for(frame_.height));
    menu_.draw(menu_overlay, settings_);
}

void PlayLoop::take_screenshot(double now_s) {
    screenshot_wanted_ = false;
    const auto name = save_screenshot(frame_, ".");
    notices_.say(name.ok() ? "Saved " + name.value() : name.error().text(), now_s);
}

Status PlayLoop::save_tape() {
    if (!game_.is_recording()) return {};
    const Bytes bytes = write_tape(game_.tape());
    return write_file(options_.tape, bytes);
}

}  // namespace enfilade
