// A window that shows frames and tells what the person in front of it does.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "platform/input_event.h"
#include "render/frame.h"
#include "render/stencil/gl_context.h"

namespace enfilade {

struct WindowOptions {
    std::string title;
    int width = 1280, height = 800;  ///< [px]; made smaller where the display is smaller
    bool fullscreen = false;
    bool by_gpu = false;  ///< as Window::show_by_gpu; where that cannot be had, it is done without
};

/// Whether this machine has a graphics card of its own, as far as can be told without asking OpenGL. One without it
/// shows pictures fastest by the CPU, those of OpenGL, too: 20 in a second against 7 by Mesa's llvmpipe. ENFILADE_GPU
/// in the environment, "on" or "off", says otherwise.
bool has_gpu();

/// A width and a height in pixels.
struct PixelSize {
    int width = 0;
    int height = 0;
    bool operator==(const PixelSize&) const = default;
};

/// One window. All calls from the thread that opened it.
class Window {
public:
    virtual ~Window() = default;

    /// Appends everything that happened since the last call, in order.
    virtual void poll(std::vector<InputEvent>& events) = 0;

    /// Shows the frame. A frame of another size than the window is scaled, its proportions kept, pixels staying sharp.
    virtual Result<void> present(const Frame& frame) = 0;

    /// From now on pictures are shown by OpenGL, or by copying them; the window is made anew. By OpenGL they wait for
    /// the display, if it lets them. Contexts of gl() must be gone before. An error leaves a window that copies.
    virtual Result<void> show_by_gpu(bool by_gpu);
    virtual bool is_shown_by_gpu() const { return false; }
    /// By OpenGL: wait until the display is ready for the next picture, or do not.
    virtual void wait_for_display(bool) {}
    virtual bool waits_for_display() const { return false; }

    /// The window's own OpenGL, for who draws what it shows. Only where it is shown by the GPU; must not outlive that.
    virtual GlContextOpener gl() { return {}; }

    /// Shows what was drawn by gl(), brightened, and the frame over it, which has the same size; its colours are
    /// multiplied by their alpha. brightness : the exponent of the light is 1 / brightness
    virtual Result<void> present(const GlPicture& picture, const Frame& over, double brightness);

    /// Nobody sees the window.
    virtual bool is_hidden() const { return false; }

    /// Drawable size [px]: on a high-density display more than the window's size in points.
    virtual PixelSize size() const = 0;

    /// Hides the pointer and reports its motion without end, or gives it back. Losing the focus gives it back too.
    virtual void grab_mouse(bool grab) = 0;
    virtual bool mouse_grabbed() const = 0;

    virtual void set_title(const std::string& title) = 0;
    virtual void set_fullscreen(bool fullscreen) = 0;
    virtual bool fullscreen() const = 0;

    /// How often the display shows a new picture [1/s]; 60 where it does not tell.
    virtual double refresh_hz() const = 0;
};

/// The window, or why there is none: usually that no display can be reached.
Result<std::unique_ptr<Window>> open_window(const WindowOptions& options);

}  // namespace enfilade
