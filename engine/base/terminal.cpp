#include "base/terminal.h"

#include "base/printable.h"

namespace enfilade {

void print_text(std::FILE* stream, std::string_view text) {
    const std::string shown = printable(text);
    std::fwrite(shown.data(), 1, shown.size(), stream);
}

void redraw_line(std::string_view text) {
    constexpr std::string_view kBackAndWipe = "\r\033[K";
    const std::string line = std::string(kBackAndWipe) + printable_line(text);
    std::fwrite(line.data(), 1, line.size(), stderr);
    std::fflush(stderr);
}

}  // namespace enfilade
