// A window that shows frames and tells what the person in front of it does.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "platform/input_event.h"
#include "render/frame.h"

namespace enfilade {

struct WindowOptions {
    std::string title;
    int width = 1280, height = 800;  ///< [px]; made smaller where the display is smaller
    bool fullscreen = false;
};

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
    virtual Status present(const Frame& frame) = 0;

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
