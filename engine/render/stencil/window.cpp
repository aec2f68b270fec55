#include "render/stencil/window.h"

#include <algorithm>

namespace enfilade::stencil {

void Window::open(int x, OpenRows more) {
    if (rows.empty()) begin = x;
    if (x < begin) {
        rows.insert(rows.begin(), static_cast<std::size_t>(begin - x), OpenRows{});
        begin = x;
    }
    if (x >= end()) rows.resize(static_cast<std::size_t>(x - begin) + 1);
    OpenRows& now = at(x);
    now = now.is_closed() ? more : OpenRows{std::min(now.top, more.top), std::max(now.bottom, more.bottom)};
}

void Window::open(const Window& other) {
    for (int x = other.begin; x < other.end(); ++x)
        if (!other.at(x).is_closed()) open(x, other.at(x));
}

Box box_around(const Window& window) {
    Box box{window.begin, window.end(), 0, 0};
    for (const OpenRows& rows : window.rows) {
        if (rows.is_closed()) continue;
        const bool is_first = box.begin_y >= box.end_y;
        box.begin_y = is_first ? rows.top : std::min(box.begin_y, rows.top);
        box.end_y = is_first ? rows.bottom : std::max(box.end_y, rows.bottom);
    }
    return box;
}

}  // namespace enfilade::stencil
