#include "app/draw/wrapped.h"

#include <algorithm>

namespace enfilade {

std::vector<std::string> wrapped(std::string_view text, std::size_t most) {
    std::vector<std::string> lines;
    for (std::string indent; !text.empty(); indent = "  ") {
        const std::size_t room = most - indent.size();
        const std::size_t space = text.size() > room ? text.rfind(' ', room) : std::string_view::npos;
        const bool between_words = space != std::string_view::npos && space > 0;
        const std::size_t cut = std::min(between_words ? space : room, text.size());
        lines.push_back(indent + std::string(text.substr(0, cut)));
        text.remove_prefix(between_words ? cut + 1 : cut);
    }
    return lines;
}

}  // namespace enfilade
