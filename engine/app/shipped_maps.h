// The maps that come with Enfilade.
#pragma once
#include <string>

namespace enfilade {

/// The path of one of them, e.g. "effects.toml": beside the program's share folder where it is installed, else in the
/// source tree it was built from.
std::string shipped_map(const std::string& name);

}  // namespace enfilade
