// Names of files: those of a path, to be shown, and what a foreign name becomes where a file is named after it.
#pragma once
#include <string>
#include <string_view>

namespace enfilade {

/// "g.wad" of "a/g.wad", and "g": to be shown or compared. Where a file or folder is to be named after them, they go
/// through safe_file_name(): the stem of "...wad" is "..".
std::string file_name_of(const std::string& path);
std::string file_stem_of(const std::string& path);

/// The longest name that safe_file_name() gives [bytes]: most file systems take 255, and something may be put behind
/// it.
inline constexpr std::size_t kMostNameBytes = 160;

/// One component of a path, whatever the name is: of an archive, a map, a setting, with any bytes in it. Never empty,
/// "." or "..", hidden or like an option; without separators, control characters, what shells and other systems keep
/// for themselves, and a blank or dot at its end; at most kMostNameBytes. Such bytes become '%' and two digits, so that
/// different names stay different; a name that is too long is cut, and its hash put behind it. Others stay as they are.
std::string safe_file_name(std::string_view foreign);

}  // namespace enfilade
