// Where a place lies in a bond of blocks, boards or tiles.
#pragma once

#include "noise.h"

namespace draw_textures {

struct Block {
    double edge;  // distance to the block's border, in texels; the joint is where it is below half the joint's width
    double tint;  // a random number that belongs to the block
    double x, y;  // from the block's upper left corner, in texels
    double width, height;
};

// Rows of blocks across a tile; each next row is shifted by `shift` of a block, and lengths vary by `unequal`.
inline Block block_at(double x, double y, int tile_width, int tile_height, int per_row, int rows, double shift,
                      double unequal, int seed) {
    const double height = static_cast<double>(tile_height) / rows, width = static_cast<double>(tile_width) / per_row;
    const double fy = y / height;
    const int row = wrap(static_cast<int>(std::floor(fy)), rows);
    const double along = x / width + shift * row + 16 * per_row;
    const auto start = [&](int k) { return k + unequal * (random(wrap(k, per_row), row, seed) - 0.5); };
    int k = static_cast<int>(std::floor(along));
    k += along < start(k) ? -1 : along >= start(k + 1) ? 1 : 0;
    Block b{};
    b.x = (along - start(k)) * width;
    b.y = fraction(fy) * height;
    b.width = (start(k + 1) - start(k)) * width;
    b.height = height;
    b.tint = random(wrap(k, per_row), row, seed + 1);
    const double dx = std::min(b.x, b.width - b.x), dy = std::min(b.y, height - b.y);
    b.edge = std::min(dx, dy) - 0.8 * std::max(0.0, 2.5 - std::max(dx, dy));  // corners are worn round
    return b;
}

}  // namespace draw_textures
