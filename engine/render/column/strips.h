// One picture drawn by several threads, each a strip of columns.
#pragma once
#include <vector>

#include "render/column/column_renderer.h"

namespace enfilade {

/// A column renderer per thread. The picture is the same, bit for bit, for any number of threads, because every pixel
/// is computed from its own column and row.
class ColumnStrips {
public:
    /// threads >= 1.
    explicit ColumnStrips(std::size_t threads);

    /// As ColumnRenderer::render.
    void render(Frame& frame, FrameFacts* facts, const Map& map, const TextureSet& textures, const Snapshot& snapshot,
                const View& view);

    /// The renderer of each strip, left to right.
    const std::vector<ColumnRenderer>& renderers() const { return renderers_; }

private:
    std::unique_ptr<LightGrids> lights_;
    std::vector<ColumnRenderer> renderers_;
};

}  // namespace enfilade
