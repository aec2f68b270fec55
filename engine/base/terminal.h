// The one way by which words reach stdout and stderr. Names and texts of files may be in them, and files may be
// hostile: what a terminal would obey is not printed.
#pragma once
#include <cstdio>
#include <string_view>

namespace enfilade {

/// Writes printable(text), which brings its line feeds along. stream : stdout or stderr. What cannot be written is
/// lost.
void print_text(std::FILE* stream, std::string_view text);

/// Replaces the line that the cursor of stderr is in; without a text, wipes it.
void redraw_line(std::string_view text);

}  // namespace enfilade
