// What is shown while one plays: the view, and over it the map, notices and the menu.
#include <algorithm>

#include "app/messages.h"
#include "app/pixel_text.h"
#include "app/play/play_loop.h"
#include "app/play/player_input.h"
#include "app/play/saved_game.h"
#include "base/attempt.h"
#include "base/parallel.h"
#include "platform/clock.h"
#include "platform/gl_context.h"

namespace enfilade {
namespace {

/// From outside the rooms one sees those that are so near [m].
constexpr double kSeenFromOutside = 200;

}  // namespace

void PlayLoop::remember_seen(std::int64_t now) {
    if (free_camera_ || now - remembered_ns_ < kBetweenLooks) return;
    remembered_ns_ = now;
    if (!renderer_) return;
    for (const ViewportShape& shape : renderer_->viewports()) game_.automap().see(shape.sector);
}

bool PlayLoop::change_renderer() {
    const auto other = options_.renderer == RendererKind::stencil ? RendererKind::column : RendererKind::stencil;
    if (const Status failed = use_renderer(other)) return tell(failed->text()), false;
    tell("Drawn by the " + name_of(other) + " renderer.");
    return true;
}

Status PlayLoop::use_renderer(RendererKind kind) {
    Status failed;
    const Status broken = attempt([&] {
        auto renderer = make_renderer({kind, {}, hardware_threads(), open_gl_for_play}, game_.map(), game_.textures());
        if (!renderer.ok()) failed = renderer.error();
        if (!failed) renderer_ = std::move(renderer).value();
    });
    if (broken || failed) return broken ? broken : failed;
    options_.renderer = kind;
    return {};
}

void PlayLoop::draw_another_map() {
    renderer_.reset();
    outside_renderer_ = std::make_unique<OutsideRenderer>(game_.map(), game_.textures());
    const Status failed = use_renderer(options_.renderer);
    if (!failed) return;
    tell(failed->text());
    if (const Status still = use_renderer(RendererKind::column)) tell(still->text());
}

View PlayLoop::view_now(double part) const {
    const bool tilts = settings_.true_pitch && options_.renderer == RendererKind::stencil;
    if (free_camera_)
        return view_of(free_camera_->eye(), input_.ahead(part), settings_.fov_degrees, game_.map().render.stretch,
                       tilts);
    return game_.view(part, input_.ahead(part), settings_.fov_degrees, tilts);
}

bool PlayLoop::is_in_room(double part) {
    return !free_camera_ || free_camera_->whereabouts(game_.snapshot(part)) == Whereabouts::in_room;
}

void PlayLoop::draw_surroundings(double part) {
    const View camera = view_of(free_camera_->eye(), input_.ahead(part), settings_.fov_degrees, 1, false);
    const View body = game_.view(1, {}, settings_.fov_degrees);
    OutsideLook look;
    look.camera = &camera;
    look.reach_m = kSeenFromOutside;
    look.seen_width = frame_.width;
    look.seen_height = frame_.height;
    outside_renderer_->render(frame_, game_.snapshot(part), body, look, hardware_threads());
}

Status PlayLoop::try_to_draw(double part) {
    Status failed;
    const Status broken = attempt([&] {
        if (!is_in_room(part)) return draw_surroundings(part);
        failed = renderer_ ? renderer_->render(frame_, nullptr, game_.snapshot(part), view_now(part))
                           : Error{"", "there is nothing to draw the map with"};
    });
    return broken ? broken : failed;
}

/// A graphics card or a renderer that fails is no reason to stop playing.
Status PlayLoop::draw_view(double part) {
    const Status failed = try_to_draw(part);
    if (!failed) return {};
    tell(failed->text());
    return change_renderer() ? try_to_draw(part) : failed;
}

Status PlayLoop::show(std::int64_t now) {
    const PixelSize size = options_.size ? PixelSize{options_.size->width, options_.size->height} : window_.size();
    frame_.resize(size.width, size.height);
    const double part = part_of_tick(now);
    const std::int64_t began = now_ns();
    if (Status failed = draw_view(part)) return failed;
    const std::int64_t drawn = now_ns();
    remember_seen(now);
    if (frame_.is_cut_short && !was_cut_short_) tell(std::string("Here ") + kCutShort);
    was_cut_short_ = frame_.is_cut_short;
    draw_over(part);
    Status failed = window_.present(frame_);
    times_.add(drawn - began, now_ns());
    return failed;
}

void PlayLoop::draw_over(double part) {
    const View view = view_now(part);
    Overlay overlay(frame_, font_, comfortable_scale(frame_.height));
    if (is_in_room(part))
        outside_.draw(overlay, frame_, *outside_renderer_, game_.snapshot(part), view, hardware_threads());
    game_.automap().draw(overlay, game_.map(), {view.sector, view.eye}, view.forward);
    if (readout_open_) {
        const double degrees_per_step = 360 / 4294967296.0;
        draw_readout(overlay, times_,
                     {game_.map()[view.sector].name, name_of(options_.renderer), view.eye.x, view.eye.y, view.eye_z,
                      game_.player().yaw.degrees(), game_.player().pitch_steps * degrees_per_step},
                     outside_.shown() == OutsideView::Shown::full || !is_in_room(part) ? std::vector<ViewportShape>()
                                                                                       : renderer_->viewports());
    }
    draw_status(overlay, game_.map(), game_.world());
    if (game_.world().health == 0) draw_death(overlay);
    if (rewinding_) draw_rewind(overlay, rewound_ticks_);
    if (free_camera_) draw_flight(overlay, free_camera_->text(game_.map(), game_.snapshot(part)));
    if (!menu_.is_open()) draw_pixel_text(overlay, view, part);
    if (screenshot_wanted_) take_screenshot();
    notices_.draw(overlay, now_s());
    if (keys_open_) {
        Overlay keys_overlay(frame_, font_, scale_for_keys(frame_.height));
        draw_keys(keys_overlay);
    }
    Overlay menu_overlay(frame_, font_, Menu::scale_for(frame_.height));
    menu_.draw(menu_overlay, settings_);
    if (menu_.is_open()) draw_pixel_text(overlay, view, part);
}

void PlayLoop::draw_pixel_text(Overlay& overlay, const View& view, double part) {
    if (!pixel_text_open_ || !is_in_room(part)) return;
    const bool by_mouse = !window_.mouse_grabbed();
    const int x = by_mouse ? int(std::clamp(mouse_.x, 0.0, frame_.width - 1.0)) : frame_.width / 2;
    const int y = by_mouse ? int(std::clamp(mouse_.y, 0.0, frame_.height - 1.0)) : frame_.height / 2;
    draw_pointed(overlay, x, y,
                 pixel_text(game_.open_map(), game_.snapshot(part), {view, frame_.width, frame_.height, x, y},
                            game_.path(), game_.places()));
}

void PlayLoop::take_screenshot() {
    screenshot_wanted_ = false;
    const auto name = save_screenshot(frame_, ".");
    tell(name.ok() ? "Saved " + name.value() : name.error().text());
}

}  // namespace enfilade
