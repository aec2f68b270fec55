// The one way by which words reach stdout and stderr. Names and texts of files may be in them, and files may be
// hostile: what a terminal would obey is not printed.
#pragma once
#include <cstdio>
#include <string>
#include <string_view>

namespace enfilade {

// What of a text a terminal shows as letters, instead of obeying it.

/// The text with a question mark for each character that a terminal would obey: control characters (C0, DEL, C1; line
/// feeds and tabs, too), separators of lines and paragraphs, overrides and isolates of direction (Boucher and Anderson,
/// "Trojan Source", 2021); and for each byte that is not UTF-8. Cost: a few ns a byte.
std::string printable_line(std::string_view text);

/// The same of several lines: line feeds and tabs stay.
std::string printable(std::string_view text);

/// Whether the text is a line that can be printed as it is.
bool is_printable_line(std::string_view text);

/// Writes printable(text), which brings its line feeds along. stream : stdout or stderr. What cannot be written is
/// lost.
void print_text(std::FILE* stream, std::string_view text);

/// Replaces the line that the cursor of stderr is in; without a text, wipes it.
void redraw_line(std::string_view text);

}  // namespace enfilade
