// The window, by SDL: frames are copied into the window's own surface, which is the fastest way for pictures that were
// drawn by the CPU.
#include <SDL.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>

#include "platform/sdl_events.h"
#include "platform/window.h"

namespace enfilade {
namespace {

Error sdl_error(const std::string& doing) { return {"window", "cannot " + doing + ": " + SDL_GetError()}; }

/// SDL between start and end.
class Session {
public:
    Session() = default;
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;
    ~Session() { SDL_Quit(); }
};

struct WindowCloser {
    void operator()(SDL_Window* w) const { SDL_DestroyWindow(w); }
};
struct SurfaceFreer {
    void operator()(SDL_Surface* s) const { SDL_FreeSurface(s); }
};
using WindowHandle = std::unique_ptr<SDL_Window, WindowCloser>;
using SurfaceHandle = std::unique_ptr<SDL_Surface, SurfaceFreer>;

/// The largest rectangle with the frame's proportions in the middle of the surface [px].
SDL_Rect fit(const Frame& frame, const SDL_Surface& surface) {
    const double scale = std::min(double(surface.w) / frame.width, double(surface.h) / frame.height);
    const int width = std::clamp(int(std::lround(frame.width * scale)), 1, surface.w);
    const int height = std::clamp(int(std::lround(frame.height * scale)), 1, surface.h);
    return {(surface.w - width) / 2, (surface.h - height) / 2, width, height};
}

/// Black where the picture does not reach.
void fill_bars(SDL_Surface& surface, const SDL_Rect& picture) {
    const int right = picture.x + picture.w, below = picture.y + picture.h;
    const SDL_Rect bars[] = {{0, 0, surface.w, picture.y},
                             {0, below, surface.w, surface.h - below},
                             {0, 0, picture.x, surface.h},
                             {right, 0, surface.w - right, surface.h}};
    SDL_FillRects(&surface, bars, 4, SDL_MapRGB(surface.format, 0, 0, 0));
}

/// The frame's own pixels as a surface, without a copy. SDL only reads them.
SurfaceHandle surface_over(const Frame& frame) {
    auto* pixels = const_cast<std::uint32_t*>(frame.pixels.data());
    SurfaceHandle over(SDL_CreateRGBSurfaceWithFormatFrom(pixels, frame.width, frame.height, 32, frame.width * 4,
                                                          SDL_PIXELFORMAT_ABGR8888));
    if (over) SDL_SetSurfaceBlendMode(over.get(), SDL_BLENDMODE_NONE);
    return over;
}

class SdlWindow final : public Window {
public:
    SdlWindow(std::unique_ptr<Session> session, WindowHandle window)
        : session_(std::move(session)), window_(std::move(window)) {}

    void poll(std::vector<InputEvent>& events) override {
        for (SDL_Event event; SDL_PollEvent(&event) != 0;) {
            if (gamepads_.note(event)) events.push_back(GamepadLost{});
            if (auto ours = translate(event, placement_)) {
                if (const auto* focus = std::get_if<FocusChange>(&*ours); focus && !focus->focused) grab_mouse(false);
                events.push_back(*ours);
            }
        }
    }

    Status present(const Frame& frame) override {
        SDL_Surface* surface = SDL_GetWindowSurface(window_.get());  // a resize makes a new one
        if (surface == nullptr) return sdl_error("get at the window's pixels");
        const SurfaceHandle picture = surface_over(frame);
        if (!picture) return sdl_error("show the picture");
        SDL_Rect target = fit(frame, *surface);
        if (target.w != surface->w || target.h != surface->h) fill_bars(*surface, target);
        remember_placement(frame, target, *surface);
        const bool same_size = target.w == frame.width && target.h == frame.height;
        const int failed = same_size ? SDL_BlitSurface(picture.get(), nullptr, surface, &target)
                                     : SDL_BlitScaled(picture.get(), nullptr, surface, &target);
        if (failed != 0 || SDL_UpdateWindowSurface(window_.get()) != 0) return sdl_error("show the picture");
        return {};
    }

    PixelSize size() const override {
        PixelSize pixels;
        SDL_GetWindowSizeInPixels(window_.get(), &pixels.width, &pixels.height);
        return {std::max(pixels.width, 1), std::max(pixels.height, 1)};
    }

    void grab_mouse(bool grab) override {
        if (grab == grabbed_) return;
        // Drivers without a pointer refuse; their motion arrives all the same.
        grabbed_ = SDL_SetRelativeMouseMode(grab ? SDL_TRUE : SDL_FALSE) == 0 && grab;
    }
    bool mouse_grabbed() const override { return grabbed_; }

    void set_title(const std::string& title) override { SDL_SetWindowTitle(window_.get(), title.c_str()); }

    void set_fullscreen(bool fullscreen) override {
        SDL_SetWindowFullscreen(window_.get(), fullscreen ? SDL_WINDOW_FULLSCREEN_DESKTOP : 0);
    }
    bool fullscreen() const override {
        return (SDL_GetWindowFlags(window_.get()) & SDL_WINDOW_FULLSCREEN_DESKTOP) == SDL_WINDOW_FULLSCREEN_DESKTOP;
    }

    double refresh_hz() const override {
        SDL_DisplayMode mode{};
        const bool known = SDL_GetWindowDisplayMode(window_.get(), &mode) == 0 && mode.refresh_rate > 0;
        return known ? mode.refresh_rate : 60;
    }

private:
    void remember_placement(const Frame& frame, const SDL_Rect& target, const SDL_Surface& surface) {
        int points_wide = surface.w, points_high = surface.h;
        SDL_GetWindowSize(window_.get(), &points_wide, &points_high);
        const double points_per_px = double(points_wide) / surface.w;
        placement_ = {target.x * points_per_px, target.y * points_per_px, target.w * points_per_px / frame.width};
    }

    std::unique_ptr<Session> session_;
    WindowHandle window_;
    Gamepads gamepads_;
    Placement placement_;
    bool grabbed_ = false;
};

/// Without a display SDL would choose a driver that draws where nobody looks. Only who asks for it gets that.
Status refuse_unseen_driver() {
    const std::string_view driver = SDL_GetCurrentVideoDriver() ? SDL_GetCurrentVideoDriver() : "";
    const bool unseen = driver == "offscreen" || driver == "dummy";
    if (!unseen || std::getenv("SDL_VIDEODRIVER") != nullptr) return {};
    return Error{"window",
                 "no display can be reached; run this on a desktop (DISPLAY or WAYLAND_DISPLAY set), or use `enfilade "
                 "fly` or `enfilade render`, which need none"};
}

Result<std::unique_ptr<Session>> start_sdl() {
    SDL_SetMainReady();
    // Through the GPU SDL would upload each picture as a texture, 5 to 18 times slower where GL is software.
    SDL_SetHint(SDL_HINT_FRAMEBUFFER_ACCELERATION, "0");
    if (SDL_Init(SDL_INIT_VIDEO) != 0) return sdl_error("reach a display");
    auto session = std::make_unique<Session>();
    if (Status refused = refuse_unseen_driver()) return *refused;
    SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER);  // without gamepads everything else still works
    return session;
}

PixelSize no_larger_than_display(int width, int height) {
    SDL_Rect usable{0, 0, width, height};
    SDL_GetDisplayUsableBounds(0, &usable);
    return {std::min(width, usable.w), std::min(height, usable.h)};
}

}  // namespace

Result<std::unique_ptr<Window>> open_window(const WindowOptions& options) {
    auto session = start_sdl();
    if (!session.ok()) return session.error();
    const PixelSize size = no_larger_than_display(options.width, options.height);
    std::uint32_t flags = SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI;
    if (options.fullscreen) flags |= SDL_WINDOW_FULLSCREEN_DESKTOP;
    WindowHandle window(SDL_CreateWindow(options.title.c_str(), SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED,
                                         size.width, size.height, flags));
    if (!window) return sdl_error("open a window");
    SDL_SetWindowMinimumSize(window.get(), 160, 100);
    return std::unique_ptr<Window>(std::make_unique<SdlWindow>(std::move(session).value(), std::move(window)));
}

}  // namespace enfilade
