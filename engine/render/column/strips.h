// One picture drawn by several threads, each a strip of columns at a time.
#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "base/parallel.h"
#include "render/column/canvas.h"
#include "render/column/column_renderer.h"

namespace enfilade {

/// The columns [0, width) of a picture, cut into at most `most` strips (>= 1), left to right. All but the first and the
/// last are equally wide. They meet where a row has a cache line's end, so that no two threads write to one line: if
/// every row of a picture has its first such end before column `first_line`, in 0..kLinePixels - 1.
/// A picture of few columns gets fewer strips, none of them empty. The list is overwritten: it keeps its memory.
void cut_into_strips(int width, int first_line, std::size_t most, std::vector<ColumnRange>& strips);

/// Pixels of a cache line of 64 bytes, as all x86-64 and most others have.
inline constexpr int kLinePixels = 16;

/// Column renderers and threads that share a picture. There are more strips than threads, taken in turn: one that meets
/// simple rooms draws more of them. A large picture is cut for one thread, too, so that what is drawn stays in cache.
/// The picture is the same, bit for bit, for any number of threads, because every pixel is computed from its own column
/// and row.
class ColumnStrips {
public:
    /// threads >= 1. They end with this.
    explicit ColumnStrips(std::size_t threads);

    /// As ColumnRenderer::render.
    void render(Frame& frame, FrameFacts* facts, const Map& map, const TextureSet& textures, const Snapshot& snapshot,
                const View& view);

    /// The viewports of each strip of the last frame, left to right. Allocates; for overlays and tests.
    std::vector<std::vector<ViewportOutline>> viewports() const;

private:
    std::size_t threads_;
    std::unique_ptr<LightGrids> lights_;
    std::vector<ColumnRenderer> renderers_;  ///< by strip: each remembers its viewports
    std::vector<ColumnRange> strips_;        ///< of the last frame
    std::vector<column::Canvas> canvases_;   ///< by thread: it draws strip after strip into memory that stays in cache
    ThreadPool pool_;
};

}  // namespace enfilade
