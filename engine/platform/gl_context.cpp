#include "platform/gl_context.h"

#include <SDL.h>
#include <epoxy/egl.h>

#include <string>

#include "platform/sdl_events.h"

namespace enfilade {
namespace {

/// SDL counts who uses its video.
class Video {
public:
    Video() : started_(SDL_InitSubSystem(SDL_INIT_VIDEO) == 0) {}
    Video(const Video&) = delete;
    Video& operator=(const Video&) = delete;
    ~Video() {
        if (started_) SDL_QuitSubSystem(SDL_INIT_VIDEO);
    }
    bool started() const { return started_; }

private:
    bool started_;
};

struct HiddenWindowCloser {
    void operator()(SDL_Window* w) const { SDL_DestroyWindow(w); }
};

class Hidden final : public GlContext {
public:
    Result<void> open(GlApi api) {
        if (!video_.started()) return sdl_error("OpenGL", "reach a display");
        SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK,
                            api == GlApi::desktop ? SDL_GL_CONTEXT_PROFILE_CORE : SDL_GL_CONTEXT_PROFILE_ES);
        SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 3);
        SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, api == GlApi::desktop ? 3 : 0);
        window_.reset(SDL_CreateWindow("", 0, 0, 16, 16, SDL_WINDOW_OPENGL | SDL_WINDOW_HIDDEN));
        if (!window_) return sdl_error("OpenGL", "open a window for OpenGL");
        context_ = SDL_GL_CreateContext(window_.get());
        if (context_ == nullptr) return sdl_error("OpenGL", "make an OpenGL context");
        release();
        return {};
    }

    Hidden() = default;
    Hidden(const Hidden&) = delete;
    Hidden& operator=(const Hidden&) = delete;
    ~Hidden() override {
        if (context_ != nullptr) SDL_GL_DeleteContext(context_);
    }

    Result<void> make_current() override {
        if (SDL_GL_MakeCurrent(window_.get(), context_) == 0) return {};
        return sdl_error("OpenGL", "get at its OpenGL context again, which was lost");
    }
    void release() override { SDL_GL_MakeCurrent(window_.get(), nullptr); }

private:
    Video video_;
    std::unique_ptr<SDL_Window, HiddenWindowCloser> window_;
    SDL_GLContext context_ = nullptr;
};

}  // namespace

Result<std::unique_ptr<GlContext>> open_desktop_gl(GlApi api) {
    auto hidden = std::make_unique<Hidden>();
    if (const Result<void> done = hidden->open(api); !done.ok()) return done.error();
    return std::unique_ptr<GlContext>(std::move(hidden));
}

namespace {

constexpr const char* kWhere = "OpenGL without a display";

Error egl_error(const std::string& doing) {
    char number[16];
    std::snprintf(number, sizeof number, "0x%x", static_cast<unsigned>(eglGetError()));
    return {kWhere, "EGL cannot " + doing + " (error " + number + "); Mesa's libegl1 and libgl1-mesa-dri can"};
}

/// One more user of a display; the last one to go closes it.
class Surfaceless final : public GlContext {
public:
    Surfaceless(EGLDisplay display, EGLContext context) : display_(display), context_(context) {}
    Surfaceless(const Surfaceless&) = delete;
    Surfaceless& operator=(const Surfaceless&) = delete;
    ~Surfaceless() override {
        // Displays are shared by all of a program, and other contexts may be using this one: it stays open.
        eglDestroyContext(display_, context_);
    }

    Result<void> make_current() override {
        if (eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE) return {};
        return egl_error("get at its context again, which was lost");
    }
    void release() override { eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT); }

private:
    EGLDisplay display_;
    EGLContext context_;
};

EGLDisplay surfaceless_display() {
    const bool known = epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless") &&
                       epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_base");
    if (!known) return EGL_NO_DISPLAY;
    return eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
}

EGLContext make_context(EGLDisplay display, GlApi api) {
    const EGLint desktop[] = {
        EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    const EGLint es[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 0, EGL_NONE};
    const bool is_desktop = api == GlApi::desktop;
    if (eglBindAPI(is_desktop ? EGL_OPENGL_API : EGL_OPENGL_ES_API) != EGL_TRUE) return EGL_NO_CONTEXT;
    return eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, is_desktop ? desktop : es);
}

}  // namespace

Result<std::unique_ptr<GlContext>> open_headless_gl(GlApi api) {
    const EGLDisplay display = surfaceless_display();
    if (display == EGL_NO_DISPLAY) return egl_error("draw without a display");
    if (eglInitialize(display, nullptr, nullptr) != EGL_TRUE) return egl_error("start");
    const EGLContext context = make_context(display, api);
    if (context == EGL_NO_CONTEXT)
        return egl_error(api == GlApi::desktop ? "make a context of OpenGL 3.3 or newer"
                                               : "make a context of OpenGL ES 3.0 or newer");
    return std::unique_ptr<GlContext>(std::make_unique<Surfaceless>(display, context));
}

Result<std::unique_ptr<GlContext>> open_gl_for_pictures() {
    auto desktop = open_headless_gl(GlApi::desktop);
    if (desktop.ok()) return desktop;
    auto es = open_headless_gl(GlApi::es);
    return es.ok() ? std::move(es) : std::move(desktop);
}

Result<std::unique_ptr<GlContext>> open_gl_for_play() {
    auto desktop = open_desktop_gl(GlApi::desktop);
    return desktop.ok() ? std::move(desktop) : open_gl_for_pictures();
}

}  // namespace enfilade
