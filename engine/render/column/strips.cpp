#include "render/column/strips.h"

#include <algorithm>

#include "base/parallel.h"

namespace enfilade {

ColumnStrips::ColumnStrips(std::size_t threads) : lights_(std::make_unique<LightGrids>()) {
    for (std::size_t i = 0; i < threads; ++i) renderers_.emplace_back(*lights_);
}

void ColumnStrips::render(Frame& frame, FrameFacts* facts, const Map& map, const TextureSet& textures,
                          const Snapshot& snapshot, const View& view) {
    const std::size_t width = static_cast<std::size_t>(frame.width);
    const std::size_t strips = std::min(renderers_.size(), width);
    parallel_for(strips, strips, [&](std::size_t strip, std::size_t) {
        const ColumnRange columns{static_cast<int>(width * strip / strips),
                                  static_cast<int>(width * (strip + 1) / strips)};
        renderers_[strip].render_columns(frame, facts, map, textures, snapshot, view, columns);
    });
    frame.is_cut_short = std::any_of(renderers_.begin(), renderers_.begin() + static_cast<std::ptrdiff_t>(strips),
                                     [](const ColumnRenderer& strip) { return strip.counts().is_cut_short; });
}

}  // namespace enfilade
