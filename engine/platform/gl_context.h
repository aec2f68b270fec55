// OpenGL contexts for the stencil renderer: without a display, or of the desktop that SDL has found.
#pragma once
#include "render/stencil/gl_context.h"

namespace enfilade {

enum class GlApi { desktop, es };

/// A context that needs no display, by EGL without a surface; on a machine without a graphics card by Mesa's llvmpipe.
/// Works on any thread. An error where EGL or its driver is missing or too old.
Result<std::unique_ptr<GlContext>> open_headless_gl(GlApi api);

/// A context of the desktop's own driver, by SDL and a window that is never shown; only on the thread that opened it.
/// An error where no display can be reached.
Result<std::unique_ptr<GlContext>> open_desktop_gl(GlApi api);

/// What a command draws with where nothing may be shown: the first of headless OpenGL and OpenGL ES that opens.
Result<std::unique_ptr<GlContext>> open_gl_for_pictures();

/// What a player draws with: the desktop's driver, or where it has none that will do, the one for pictures.
Result<std::unique_ptr<GlContext>> open_gl_for_play();

}  // namespace enfilade
