// F12: the picture on the screen as a file in the current folder.
#pragma once
#include <string>

#include "base/result.h"
#include "render/frame.h"

namespace enfilade {

/// Writes the frame as the first of enfilade-0001.png, enfilade-0002.png, … that `folder` does not have yet; gives the
/// file's name.
Result<std::string> save_screenshot(const Frame& frame, const std::string& folder);

}  // namespace enfilade
