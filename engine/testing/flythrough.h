// A flythrough as a test, for those who build on the engine: whether it looks as it was recorded.
#pragma once
#include <string>
#include <vector>

#include "base/parallel.h"
#include "base/result.h"
#include "flight/comparison.h"

namespace enfilade {

/// Draws every frame of the script by its own renderer and compares it with its recording, which
/// `enfilade fly SCRIPT --record` made. The frames that differ; empty: it looks as it was recorded.
/// An error where script, map, tape or recording cannot be read, with all their errors, one a line; or where the
/// renderer needs OpenGL.
/// threads : that draw, >= 1
Result<std::vector<Mismatch>> check_flythrough(const std::string& script_path,
                                               std::size_t threads = hardware_threads());

}  // namespace enfilade
