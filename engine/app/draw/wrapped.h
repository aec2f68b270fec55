// Text that is too long for its line.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace enfilade {

/// The text cut into lines of at most so many bytes, between words where there are any. most > 2: later lines are
/// indented by two.
std::vector<std::string> wrapped(std::string_view text, std::size_t most);

}  // namespace enfilade
