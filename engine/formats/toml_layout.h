// TOML laid out as this project writes it: for authors who would rather not count blanks.
#pragma once
#include <string>
#include <string_view>

#include "base/result.h"

namespace enfilade {

/// The same document with the same comments, laid out anew:
///
/// - one blank around `=` and inside braces, one behind a comma, two between the corners of `v` and `rect`
/// - what stands in an array of several lines is indented by two blanks; the lines stay as the author broke them
/// - an empty line above each header (or above the comments right above it), never two; none at either end
/// - comments behind what they are about, two blanks away, those of neighbouring lines below one another
///
/// Keys, strings and numbers stay as they are written. What is laid out already is the same, byte for byte.
/// text : a document that TomlDocument::parse accepts; an error otherwise
Result<std::string> lay_out_toml(std::string_view text);

}  // namespace enfilade
