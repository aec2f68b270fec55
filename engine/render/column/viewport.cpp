#include "render/column/viewport.h"

namespace enfilade::column {

bool Viewport::trim() {
    int first = begin, last = end;
    while (first < last && rows_at(first).is_closed()) ++first;
    while (first < last && rows_at(last - 1).is_closed()) --last;
    rows.erase(rows.begin() + (last - begin), rows.end());
    rows.erase(rows.begin(), rows.begin() + (first - begin));
    boundary.erase(boundary.begin() + (last - begin), boundary.end());
    boundary.erase(boundary.begin(), boundary.begin() + (first - begin));
    begin = first;
    end = last;
    return begin < end;
}

Viewport& ViewportPool::take(int begin, int end) {
    if (used_ == viewports_.size()) viewports_.emplace_back();
    Viewport& viewport = viewports_[used_++];
    viewport.begin = begin;
    viewport.end = end;
    const auto count = static_cast<std::size_t>(end - begin);
    viewport.rows.assign(count, {});
    viewport.boundary.assign(count, 0);
    return viewport;
}

}  // namespace enfilade::column
