// What is shown while one plays: the view, by one of the renderers, and over it the map, notices and the menu.
#include <algorithm>
#include <array>
#include <cmath>

#include "app/messages.h"
#include "app/pixel_text.h"
#include "app/play/play_loop.h"
#include "app/play/player_input.h"
#include "app/play/saved_game.h"
#include "base/attempt.h"
#include "base/parallel.h"
#include "base/text.h"
#include "platform/clock.h"
#include "platform/gl_context.h"

namespace enfilade {
namespace {

constexpr std::int64_t kFlash = kSecond * 6 / 10;  ///< how long one sees that one is hurt [ns]
constexpr double kDeadShade = 0.6;                 ///< of the strongest flash

/// Every pixel's light to the power of 1 / brightness.
void brighten(Frame& frame, double brightness) {
    if (brightness == 1) return;
    std::array<std::uint32_t, 256> levels;
    for (std::uint32_t i = 0; i < 256; ++i)
        levels[i] = static_cast<std::uint32_t>(std::lround(255 * std::pow(i / 255.0, 1 / brightness)));
    for (std::uint32_t& pixel : frame.pixels)
        pixel = (pixel & 0xFF000000u) | levels[pixel & 255] | levels[pixel >> 8 & 255] << 8 |
                levels[pixel >> 16 & 255] << 16;
}

}  // namespace

void PlayLoop::remember_seen(std::int64_t now) {
    if (free_camera_ || now - remembered_ns_ < kBetweenLooks) return;
    remembered_ns_ = now;
    if (!renderer_) return;
    for (const ViewportShape& shape : renderer_->viewports()) game_.automap().see(shape.sector);
}

View PlayLoop::view_now(double part) const {
    Lens lens = lens_for(game_.map().render, settings().fov_degrees);
    lens.true_pitch = settings().true_pitch && drawn_by_ == RendererKind::stencil;
    if (free_camera_) return view_of(free_camera_->eye(), input_.ahead(part), lens);
    View view = game_.view(part, input_.ahead(part), lens);
    sway(view, part);
    return view;
}

void PlayLoop::sway(View& view, double part) const {
    constexpr double kBob = 0.04, kStepsPerSecond = 1.9, kFullSpeed = 6;  // [m], [1/s], [m/s]
    constexpr double kLying = 0.3, kFallSeconds = 0.6;                    // above the floor [m]
    const Player& player = game_.player();
    if (game_.world().health == 0) {
        const double fallen = std::clamp(static_cast<double>(now_ns() - died_ns_) * 1e-9 / kFallSeconds, 0.0, 1.0);
        const double lying_z = std::min(view.eye_z, player.feet_z + kLying);
        view.eye_z += (lying_z - view.eye_z) * fallen * fallen;
        return;
    }
    const double speed = std::sqrt(dot(player.velocity, player.velocity));
    const double pace = player.on_ground ? std::min(speed / kFullSpeed, 1.0) : 0;
    const double seconds = (static_cast<double>(game_.world().tick) - 1 + part) * tick_seconds(game_.tick_rate());
    const double turns = direction(Angle::from_degrees(std::fmod(seconds * kStepsPerSecond, 1) * 360)).y;
    view.eye_z += settings().view_bob * kBob * pace * turns;
}

PixelSize PlayLoop::picture_size() const {
    if (settings().size) return {settings().size->width, settings().size->height};
    const PixelSize window = window_.size();
    const int scale = std::max(1, static_cast<int>(settings().scale));
    return {std::max(1, window.width / scale), std::max(1, window.height / scale)};
}

bool PlayLoop::is_worth_showing(double part) {
    const std::int64_t now = now_ns();
    const bool is_flashing = now - hurt_ns_ < kFlash || now - died_ns_ < kSecond;
    if (is_changed_ || notices_.have_changed(now_s()) || is_flashing) return true;
    if (is_paused()) return false;
    if (readout_open_ || rewinding_ || free_camera_ || outside_.shown() != OutsideView::Shown::nowhere) return true;
    return !stillness_->is_same(view_now(part), game_.snapshot(part));
}

/// What is seen costs memory to ask for: only where one stands still.
void PlayLoop::note_drawn(double part) {
    const View view = view_now(part);
    is_changed_ = false;
    const bool stands = last_view_ && is_same_look(*last_view_, view);
    last_view_ = view;
    if (!stands || !renderer_ || !is_in_room(part)) return stillness_->forget();
    std::vector<SectorId> seen;
    for (const ViewportShape& shape : renderer_->viewports()) seen.push_back(shape.sector);
    stillness_->drew(view, game_.snapshot(part), seen);
}

Result<void> PlayLoop::show(std::int64_t now) {
    const double part = part_of_tick(now);
    if (window_.is_hidden() || !is_worth_showing(part)) return {};
    const PixelSize size = picture_size();
    frame_.resize(size.width, size.height);
    const std::int64_t began = now_ns();
    if (const Result<void> done = draw_view(part); !done.ok()) return done.error();
    const std::int64_t drawn = now_ns();
    remember_seen(now);
    if (frame_.is_cut_short && !was_cut_short_) tell(std::string("Here ") + kCutShort);
    was_cut_short_ = frame_.is_cut_short;
    if (!on_card_) brighten(frame_, settings().brightness);
    draw_over(part);
    note_drawn(part);
    const Result<void> presented = present();
    times_.add(drawn - began, now_ns());
    return presented;
}

Result<void> PlayLoop::present() {
    pacing_.drew(now_ns() - began_ns_);
    sleep_until_ns(pacing_.due());
    return on_card_ ? window_.present(*on_card_, frame_, settings().brightness) : window_.present(frame_);
}

void PlayLoop::draw_over(double part) {
    const View view = view_now(part);
    Overlay overlay(frame_, font_, comfortable_scale(frame_.height));
    if (!on_card_ && is_in_room(part))
        outside_.draw(overlay, frame_, *outside_renderer_, game_.snapshot(part), view, hardware_threads());
    const double since_hurt = static_cast<double>(now_ns() - hurt_ns_) / kFlash;
    draw_hurt(overlay, game_.world().health == 0 ? kDeadShade : hurt_ * (1 - since_hurt));
    draw_automap(overlay, view);
    draw_words(overlay, view, part);
    if (screenshot_wanted_) take_screenshot();
    const int below_notices = notices_.draw(overlay, now_s(), !keys_open_ && !menu_.is_open());
    if (free_camera_) draw_flight(overlay, free_camera_->text(game_.map(), game_.snapshot(part)), below_notices);
    if (end_) draw_end(overlay, *end_);
    if (keys_open_) {
        const auto lines = key_lines(settings().bindings);
        Overlay keys_overlay(frame_, font_, scale_for_lines(lines.size(), frame_.height));
        draw_keys(keys_overlay, lines);
    }
    menu_.draw(overlay, settings());
    if (menu_.is_open()) draw_pixel_text(overlay, view, part, overlay.height());
}

void PlayLoop::draw_automap(Overlay& overlay, const View& view) {
    const bool is_free = !menu_.is_open() && !end_;
    game_.automap().draw(overlay, game_.map(), {view.sector, view.eye}, view.forward,
                         {settings().automap_colors, game_.snapshot(1).taken,
                          is_free ? "Arrows move it, Home: back to you; + and - zoom" : ""});
}

void PlayLoop::draw_words(Overlay& overlay, const View& view, double part) {
    int bottom = overlay.height() - overlay.line_height() / 2;
    if (!menu_.is_open()) bottom = draw_pixel_text(overlay, view, part, bottom);
    if (readout_open_) bottom = std::min(bottom, draw_facts(overlay, view, part));
    draw_status(overlay, game_.map(), game_.world(), bottom);
    if (is_paused()) return;
    if (game_.world().health == 0) draw_death(overlay, settings().bindings);
    if (rewinding_) draw_rewind(overlay, static_cast<double>(rewound_ticks_) * tick_seconds(game_.tick_rate()));
}

int PlayLoop::draw_facts(Overlay& overlay, const View& view, double part) {
    const double degrees_per_step = 360 / 4294967296.0;
    const bool has_outlines = outside_.shown() != OutsideView::Shown::full && is_in_room(part) && renderer_;
    return draw_readout(overlay, times_,
                        {game_.map()[view.sector].name, name_of(drawn_by_), view.eye.x, view.eye.y, view.eye_z,
                         game_.player().yaw.degrees(), game_.player().pitch_steps * degrees_per_step},
                        has_outlines ? renderer_->viewports() : std::vector<ViewportShape>());
}

int PlayLoop::draw_pixel_text(Overlay& overlay, const View& view, double part, int bottom) {
    if (!pixel_text_open_ || !is_in_room(part)) return bottom;
    const bool by_mouse = !window_.mouse_grabbed();
    const int x = by_mouse ? int(std::clamp(mouse_.x, 0.0, frame_.width - 1.0)) : frame_.width / 2;
    const int y = by_mouse ? int(std::clamp(mouse_.y, 0.0, frame_.height - 1.0)) : frame_.height / 2;
    return draw_pointed(overlay, x, y,
                        pixel_text(game_.open_map(), game_.snapshot(part), {view, frame_.width, frame_.height, x, y},
                                   game_.path(), game_.places()),
                        bottom);
}

void PlayLoop::take_screenshot() {
    screenshot_wanted_ = false;
    const std::string folder = pictures_folder();
    const auto name = save_screenshot(frame_, folder);
    tell(name.ok() ? "Saved " + folder + "/" + name.value() : name.error().text());
}

// By which renderer the view is drawn, and what is done where one fails.

namespace {

/// From outside the rooms one sees those that are so near [m].
constexpr double kSeenFromOutside = 200;

}  // namespace

bool PlayLoop::change_renderer() {
    const RendererKind before = drawn_by_;
    const auto other = before == RendererKind::stencil ? RendererKind::column : RendererKind::stencil;
    if (const Result<void> done = use_renderer(other); !done.ok()) return tell(done.error().text()), false;
    tell("Drawn by the " + name_of(other) + " renderer.");
    return true;
}

Result<void> PlayLoop::use_renderer(RendererKind kind) {
    Result<void> made;
    const Result<void> unbroken = attempt([&] {
        renderer_.reset();  // its context goes before the window's
        on_card_.reset();
        const bool wants_gpu = has_gpu() && (kind == RendererKind::stencil || settings().vsync);
        window_.wait_for_display(settings().vsync);
        static_cast<void>(window_.show_by_gpu(wants_gpu));
        const GlContextOpener open_gl = window_.is_shown_by_gpu() ? window_.gl() : GlContextOpener(open_gl_for_play);
        const int most = kMaxPictureSide / std::max({1, picture_size().width, picture_size().height});
        Dials dials = dials_of(settings(), kind, game_.map());
        for (const std::string& dial : options_.dials) static_cast<void>(set_dial(dials, dial));  // they were checked
        dials = dials_for(kind, dials);
        dials.samples = std::clamp(dials.samples, 1, std::max(most, 1));
        auto renderer = make_renderer({kind, dials, hardware_threads(), open_gl}, game_.map(), game_.textures());
        if (renderer.ok())
            renderer_ = std::move(renderer).value();
        else
            made = renderer.error();
    });
    if (!unbroken.ok()) return unbroken;
    if (!made.ok()) return made;
    drawn_by_ = kind;
    is_changed_ = true;
    return {};
}

void PlayLoop::use_or_replace(RendererKind kind) {
    const Result<void> used = use_renderer(kind);
    if (used.ok()) return;
    tell(used.error().text());
    if (const Result<void> valid = use_renderer(RendererKind::column); !valid.ok()) tell(valid.error().text());
}

void PlayLoop::draw_another_map() {
    renderer_.reset();
    outside_renderer_ = std::make_unique<OutsideRenderer>(game_.map(), game_.textures());
    stillness_.emplace(game_.map());
    window_.set_title("Enfilade - " + printable_line(game_.map().name));
    use_or_replace(drawn_by_);
}

bool PlayLoop::is_in_room(double part) {
    return !free_camera_ || free_camera_->whereabouts(game_.snapshot(part)) == Whereabouts::in_room;
}

void PlayLoop::draw_surroundings(double part) {
    const View camera = view_of(free_camera_->eye(), input_.ahead(part), {settings().fov_degrees});
    const View body = game_.view(1, {}, lens_for(game_.map().render, settings().fov_degrees));
    OutsideLook look;
    look.camera = &camera;
    look.reach_m = kSeenFromOutside;
    look.seen_width = frame_.width;
    look.seen_height = frame_.height;
    outside_renderer_->render(frame_, game_.snapshot(part), body, look, hardware_threads());
}

bool PlayLoop::is_on_card(double part) {
    return window_.is_shown_by_gpu() && renderer_ && renderer_->keeps_on_card() && !screenshot_wanted_ &&
           outside_.shown() == OutsideView::Shown::nowhere && is_in_room(part);
}

Result<void> PlayLoop::try_to_draw(double part) {
    Result<void> drawn;
    on_card_.reset();
    const Result<void> unbroken = attempt([&] {
        if (!is_in_room(part)) return draw_surroundings(part);
        if (!renderer_) return void(drawn = Error{"", "there is nothing to draw the map with"});
        if (!is_on_card(part))
            return void(drawn = renderer_->render(frame_, nullptr, game_.snapshot(part), view_now(part)));
        auto picture = renderer_->render_on_card(frame_.width, frame_.height, game_.snapshot(part), view_now(part));
        if (!picture.ok()) return void(drawn = picture.error());
        on_card_ = picture.value();
        frame_.is_cut_short = on_card_->is_cut_short;
        std::ranges::fill(frame_.pixels, 0);
    });
    return unbroken.ok() ? drawn : unbroken;
}

/// A graphics card or a renderer that fails is no reason to stop playing.
Result<void> PlayLoop::draw_view(double part) {
    const Result<void> drawn = try_to_draw(part);
    if (drawn.ok()) return {};
    tell(drawn.error().text());
    return change_renderer() ? try_to_draw(part) : drawn;
}

}  // namespace enfilade
