// The window, by SDL. Frames are copied into the window's own surface, which is the fastest way for pictures that were
// drawn by the CPU; or all pictures are shown by OpenGL, which can wait for the display, and needs no copy of what it
// drew itself. SDL cannot do both in one window: it is made anew for the other.
#include <SDL.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string_view>

#include "base/file_name.h"
#include "platform/gl_context.h"
#include "platform/gl_screen.h"
#include "platform/sdl_events.h"
#include "platform/window.h"

namespace enfilade {
namespace {

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

/// The largest rectangle with the picture's proportions in the middle of the window [px].
SDL_Rect fit(int width, int height, PixelSize window) {
    const double scale = std::min(double(window.width) / width, double(window.height) / height);
    const int wide = std::clamp(int(std::lround(width * scale)), 1, window.width);
    const int high = std::clamp(int(std::lround(height * scale)), 1, window.height);
    return {(window.width - wide) / 2, (window.height - high) / 2, wide, high};
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

/// A window's OpenGL, and what shows pictures by it.
class WindowGl {
public:
    /// The window was made for OpenGL.
    static Result<std::unique_ptr<WindowGl>> open(SDL_Window* window, bool waits) {
        std::unique_ptr<WindowGl> gl(new WindowGl(window));
        if (gl->context_ == nullptr) return sdl_error("window", "make an OpenGL context for the window");
        if (const Result<void> done = gl->screen_->prepare(); !done.ok()) return done.error();
        gl->wait(waits);
        return gl;
    }
    WindowGl(const WindowGl&) = delete;
    WindowGl& operator=(const WindowGl&) = delete;
    ~WindowGl() {
        if (context_ == nullptr) return;
        static_cast<void>(make_current());
        screen_.reset();
        SDL_GL_DeleteContext(context_);
    }

    Result<void> make_current() const {
        if (SDL_GL_MakeCurrent(window_, context_) == 0) return {};
        return sdl_error("window", "get at its OpenGL context again, which was lost");
    }
    void release() const { SDL_GL_MakeCurrent(window_, nullptr); }

    void wait(bool waits) {
        static_cast<void>(make_current());
        waits_ = SDL_GL_SetSwapInterval(waits ? 1 : 0) == 0 && waits;
    }
    bool waits() const { return waits_; }

    template <class Show>
    Result<void> show(Show show) {
        if (const Result<void> done = make_current(); !done.ok()) return done.error();
        const Result<void> shown = show(*screen_);
        if (shown.ok()) SDL_GL_SwapWindow(window_);
        return shown;
    }

private:
    explicit WindowGl(SDL_Window* window) : window_(window), context_(SDL_GL_CreateContext(window)) {}

    SDL_Window* window_;
    SDL_GLContext context_;
    std::unique_ptr<GlScreen> screen_ = std::make_unique<GlScreen>();
    bool waits_ = false;
};

/// The window's context, for who draws in it.
class BorrowedGl final : public GlContext {
public:
    explicit BorrowedGl(const WindowGl& gl) : gl_(gl) {}
    Result<void> make_current() override { return gl_.make_current(); }
    void release() override { gl_.release(); }

private:
    const WindowGl& gl_;
};

struct WindowLook {
    std::string title;
    int x = SDL_WINDOWPOS_CENTERED, y = SDL_WINDOWPOS_CENTERED;
    PixelSize points;
    bool fullscreen = false;
};

void ask_for(GlApi api) {
    const bool is_desktop = api == GlApi::desktop;
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK,
                        is_desktop ? SDL_GL_CONTEXT_PROFILE_CORE : SDL_GL_CONTEXT_PROFILE_ES);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 3);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, is_desktop ? 3 : 0);
}

WindowHandle make_window(const WindowLook& look, bool for_gl) {
    std::uint32_t flags = SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI;
    if (look.fullscreen) flags |= SDL_WINDOW_FULLSCREEN_DESKTOP;
    if (for_gl) flags |= SDL_WINDOW_OPENGL;
    WindowHandle window(
        SDL_CreateWindow(look.title.c_str(), look.x, look.y, look.points.width, look.points.height, flags));
    if (window) SDL_SetWindowMinimumSize(window.get(), 160, 100);
    return window;
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

    Result<void> show_by_gpu(bool by_gpu) override {
        if (by_gpu == (gl_ != nullptr)) return {};
        gl_.reset();
        if (!by_gpu) return remake(false);
        Result<void> remade;
        for (const GlApi api : {GlApi::desktop, GlApi::es}) {
            ask_for(api);
            remade = remake(true);
            if (remade.ok()) return {};
        }
        static_cast<void>(remake(false));
        return remade;
    }
    bool is_shown_by_gpu() const override { return gl_ != nullptr; }
    void wait_for_display(bool waits) override {
        waits_ = waits;
        if (gl_) gl_->wait(waits);
    }
    bool waits_for_display() const override { return gl_ && gl_->waits(); }
    GlContextOpener gl() override {
        if (!gl_) return {};
        return [this]() -> Result<std::unique_ptr<GlContext>> {
            return std::unique_ptr<GlContext>(std::make_unique<BorrowedGl>(*gl_));
        };
    }

    Result<void> present(const Frame& frame) override {
        if (gl_) {
            const PictureArea area = place(frame.width, frame.height);
            return gl_->show([&](GlScreen& screen) { return screen.show(frame, area); });
        }
        SDL_Surface* surface = SDL_GetWindowSurface(window_.get());  // a resize makes a new one
        if (surface == nullptr) return sdl_error("window", "get at the window's pixels");
        const SurfaceHandle picture = surface_over(frame);
        if (!picture) return sdl_error("window", "show the picture");
        const PictureArea area = place(frame.width, frame.height);
        SDL_Rect target{area.left, area.top, area.width, area.height};
        if (target.w != surface->w || target.h != surface->h) fill_bars(*surface, target);
        const bool same_size = target.w == frame.width && target.h == frame.height;
        const int failed = same_size ? SDL_BlitSurface(picture.get(), nullptr, surface, &target)
                                     : SDL_BlitScaled(picture.get(), nullptr, surface, &target);
        if (failed != 0 || SDL_UpdateWindowSurface(window_.get()) != 0) return sdl_error("window", "show the picture");
        return {};
    }

    Result<void> present(const GlPicture& picture, const Frame& over, double brightness) override {
        ENFILADE_CHECK(gl_ != nullptr);
        const PictureArea area = place(picture.width, picture.height);
        return gl_->show([&](GlScreen& screen) { return screen.show(picture, over, brightness, area); });
    }

    bool is_hidden() const override {
        return (SDL_GetWindowFlags(window_.get()) & (SDL_WINDOW_MINIMIZED | SDL_WINDOW_HIDDEN)) != 0;
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
    /// The window again, where and as it was. What happened to the old one is no news.
    Result<void> remake(bool for_gl) {
        WindowLook look{SDL_GetWindowTitle(window_.get()), 0, 0, {}, fullscreen()};
        SDL_GetWindowPosition(window_.get(), &look.x, &look.y);
        SDL_GetWindowSize(window_.get(), &look.points.width, &look.points.height);
        const bool was_grabbed = grabbed_;
        grab_mouse(false);
        WindowHandle fresh = make_window(look, for_gl);
        if (!fresh) return sdl_error("window", "open a window");
        window_ = std::move(fresh);
        SDL_PumpEvents();
        SDL_FlushEvent(SDL_WINDOWEVENT);
        grab_mouse(was_grabbed);
        if (!for_gl) return {};
        auto gl = WindowGl::open(window_.get(), waits_);
        if (!gl.ok()) return gl.error();
        gl_ = std::move(gl).value();
        return {};
    }

    /// Where the picture goes, which is remembered for the mouse.
    PictureArea place(int width, int height) {
        const PixelSize window = size();
        const SDL_Rect target = fit(width, height, window);
        int points_wide = window.width, points_high = window.height;
        SDL_GetWindowSize(window_.get(), &points_wide, &points_high);
        const double points_per_px = double(points_wide) / window.width;
        placement_ = {target.x * points_per_px, target.y * points_per_px, target.w * points_per_px / width};
        return {target.x, target.y, target.w, target.h, window.width, window.height};
    }

    std::unique_ptr<Session> session_;
    WindowHandle window_;
    std::unique_ptr<WindowGl> gl_;  ///< none: pictures are copied
    Gamepads gamepads_;
    Placement placement_;
    bool grabbed_ = false, waits_ = true;
};

/// Without a display SDL would choose a driver that draws where nobody looks. Only who asks for it gets that.
Result<void> refuse_unseen_driver() {
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
    if (SDL_Init(SDL_INIT_VIDEO) != 0) return sdl_error("window", "reach a display");
    auto session = std::make_unique<Session>();
    if (const Result<void> valid = refuse_unseen_driver(); !valid.ok()) return valid.error();
    SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER);  // without gamepads everything else still works
    return session;
}

PixelSize no_larger_than_display(int width, int height) {
    SDL_Rect usable{0, 0, width, height};
    SDL_GetDisplayUsableBounds(0, &usable);
    return {std::min(width, usable.w), std::min(height, usable.h)};
}

}  // namespace

Result<void> Window::show_by_gpu(bool) { return Error{"window", "this window knows no OpenGL"}; }

Result<void> Window::present(const GlPicture&, const Frame&, double) {
    ENFILADE_CHECK(is_shown_by_gpu());
    return {};
}

bool has_gpu() {
    if (const char* wish = std::getenv("ENFILADE_GPU")) return std::string_view(wish) != "off";
#ifdef __linux__
    namespace fs = std::filesystem;
    std::error_code none;
    for (const auto& device : fs::directory_iterator("/dev/dri", none))
        if (file_name_of(device.path()).starts_with("render")) return true;
    return fs::exists("/dev/nvidiactl", none);
#else
    return true;
#endif
}

Result<std::unique_ptr<Window>> open_window(const WindowOptions& options) {
    auto session = start_sdl();
    if (!session.ok()) return session.error();
    WindowLook look;
    look.title = options.title;
    look.points = no_larger_than_display(options.width, options.height);
    look.fullscreen = options.fullscreen;
    WindowHandle handle = make_window(look, false);
    if (!handle) return sdl_error("window", "open a window");
    auto window = std::make_unique<SdlWindow>(std::move(session).value(), std::move(handle));
    if (options.by_gpu) static_cast<void>(window->show_by_gpu(true));
    return std::unique_ptr<Window>(std::move(window));
}

}  // namespace enfilade
