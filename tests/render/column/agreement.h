// The column renderer held against the reference in small maps made in code.
#pragma once
#include <cstdint>

#include "base/hash.h"
#include "render/column/column_renderer.h"
#include "render/frame.h"
#include "render/view.h"
#include "support/furnish.h"
#include "support/map_builder.h"
#include "world/snapshot.h"

namespace enfilade::test {

/// A map and its pictures.
struct TexturedMap {
    Map map;
    TextureSet textures;
    Snapshot snapshot;

    explicit TexturedMap(const MapFile& file)
        : map(built(file)), textures(textures_for(file)), snapshot(at_rest(map)) {}
};

/// Nine rooms of different heights, a pillar, a pit, a closed door, a window and a yard under the sky.
MapFile palace();

/// Anywhere in the map; half of the eyes on a lattice of half metres, half of the looks along eighths of a turn.
View random_view(const Map& map, Random& random);

struct ColumnComparison {
    std::size_t not_once = 0;  ///< pixels not written exactly once
    std::size_t wrong_ids = 0;
    std::size_t wrong_colors = 0;  ///< differ by more than 2 of 255 where ids agree, off texel edges
    std::size_t pixels = 0;
};

/// The column renderer and the reference, of one world.
class Comparer {
public:
    /// The world outlives it; its snapshot may change from view to view.
    explicit Comparer(const TexturedMap& world);

    /// Draws a view with both and adds up how they differ.
    void compare(const View& view, int width, int height, ColumnComparison& sum);

private:
    const TexturedMap& world_;
    LightGrids lights_;  ///< of the reference
    ColumnRenderer columns_;
};

/// Fails where any of `poses` random views differs.
void expect_agreement(const TexturedMap& world, std::uint64_t seed, int poses);

/// Fails where a picture put together from strips, of any widths and by any number of threads, differs from the whole.
void expect_strips_equal_the_whole(const TexturedMap& world, std::uint64_t seed, int poses);

/// Fails where drawing a view for the second time takes anything from the heap.
void expect_no_allocations(const TexturedMap& world, std::uint64_t seed, int poses);

}  // namespace enfilade::test
