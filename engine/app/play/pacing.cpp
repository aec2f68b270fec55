#include "app/play/pacing.h"

#include <algorithm>

namespace enfilade {

std::int64_t Pacing::begin() const {
    const std::int64_t slowest = *std::ranges::max_element(took_);
    return due_ - std::min(slowest + kSpare, period_);
}

void Pacing::drew(std::int64_t took) { took_[count_++ % kKept] = took; }

void Pacing::go_on(std::int64_t now) {
    due_ += period_;
    if (due_ < now || due_ > now + 2 * period_) due_ = now + period_;
}

}  // namespace enfilade
