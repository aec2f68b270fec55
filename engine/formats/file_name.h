// Which texts of a hostile file may become names of other files.
#pragma once
#include <string_view>

#include "base/result.h"

namespace enfilade {

/// Nothing where the text names a file below a folder: parts with a single '/' between them, none of them "." or "..",
/// and no character that a terminal would obey (base/printable.h). So a file has one name only, apart from upper and
/// lower case, and no name leads elsewhere. Otherwise what was expected, without a place.
Status refuse_as_file_name(std::string_view text);

/// Nothing where the text is a path that may lead anywhere: no character that a terminal would obey. For what people
/// set up by hand, as the folder of their pictures.
Status refuse_as_path(std::string_view text);

}  // namespace enfilade
