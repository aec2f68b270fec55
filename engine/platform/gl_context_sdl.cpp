#include <SDL.h>

#include <string>

#include "platform/gl_context.h"
#include "platform/sdl_error.h"

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

}  // namespace enfilade
