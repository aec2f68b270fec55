// What of a text a terminal shows as letters, instead of obeying it.
#pragma once
#include <string>
#include <string_view>

namespace enfilade {

/// The text with a question mark for each character that a terminal would obey: control characters (C0, DEL, C1; line
/// feeds and tabs, too), separators of lines and paragraphs, overrides and isolates of direction (Boucher and Anderson,
/// "Trojan Source", 2021); and for each byte that is not UTF-8. Cost: a few ns a byte.
std::string printable_line(std::string_view text);

/// The same of several lines: line feeds and tabs stay.
std::string printable(std::string_view text);

/// Whether the text is a line that can be printed as it is.
bool is_printable_line(std::string_view text);

}  // namespace enfilade
