// By which renderer the view is drawn, and what is done where one fails.
#include <algorithm>

#include "app/play/play_loop.h"
#include "base/attempt.h"
#include "base/parallel.h"
#include "base/terminal.h"
#include "platform/gl_context.h"

namespace enfilade {
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
