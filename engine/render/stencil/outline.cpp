#include "render/stencil/outline.h"

#include <utility>

namespace enfilade::stencil {

void Outline::set(double left, double right, double top, double bottom) {
    corners_ = {{left, top}, {right, top}, {right, bottom}, {left, bottom}};
}

void Outline::keep(const Even& where) {
    cut_.clear();
    for (std::size_t i = 0; i < corners_.size(); ++i) {
        const Corner p = corners_[i], q = corners_[(i + 1) % corners_.size()];
        const double at_p = where.at(p.x, p.y), at_q = where.at(q.x, q.y);
        if (at_p >= 0) cut_.push_back(p);
        if ((at_p >= 0) == (at_q >= 0)) continue;
        const bool in_order = p.x < q.x || (p.x == q.x && p.y < q.y);
        const Corner a = in_order ? p : q, b = in_order ? q : p;
        const double at_a = in_order ? at_p : at_q, at_b = in_order ? at_q : at_p, part = at_a / (at_a - at_b);
        cut_.push_back({a.x + (b.x - a.x) * part, a.y + (b.y - a.y) * part});
    }
    std::swap(corners_, cut_);
}

}  // namespace enfilade::stencil
