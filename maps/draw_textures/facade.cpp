// Whole fronts of houses, one bay wide and as high as the house: a wall that shows its storeys, windows and cornice.
#include "album.h"
#include "layout.h"
#include "stone.h"

namespace draw_textures {
namespace {

constexpr double kScale = 64;    // texels per metre in every front
constexpr int kFrontRows = 512;  // 8 m

// Where the parts of a front begin, in rows from its top.
constexpr double kCorniceTop = 48, kFrieze = 84, kUpper = 104, kString = 256, kGround = 276, kBase = 472;

struct Window {
    double across, up;  // from its middle and from its foot, in texels
    double half_width, height;
};

// How far inside the opening; negative on the frame around it.
double inside(const Window& w) { return std::min(w.half_width - std::abs(w.across), std::min(w.up, w.height - w.up)); }

// Glass between bars: panes a little out of plane, so that each mirrors another piece of sky.
Surface glass(const Window& w, Color low, Color high, double pane, int seed) {
    const double column = (w.across + w.half_width) / pane, row = w.up / pane;
    const double bar =
        pane * std::min(std::min(fraction(column), 1 - fraction(column)), std::min(fraction(row), 1 - fraction(row)));
    const double tint = random(static_cast<int>(std::floor(column)), static_cast<int>(std::floor(row)), seed);
    const double rise = clamp01(w.up / w.height + 0.35 * (tint - 0.5));
    const bool is_bar = bar < 1.6 || inside(w) < 3;
    return {is_bar ? rgb(0xd9d1bf) : mix(low, high, rise) * (0.9 + 0.2 * tint), is_bar ? 1.5 : -2.0};
}

// A dressed frame with ears, a keystone and a sill. Adds to the wall it is set in.
Surface framed(const Surface& wall, const Window& w, double frame, const Surface& pane, Color stone) {
    const double d = inside(w);
    if (d > 0) {
        return {pane.color * (0.72 + 0.28 * ramp(0, 14, w.height - w.up)), pane.height - 3};
    }
    const bool key = std::abs(w.across) < 7 + 0.16 * (w.up - w.height) && w.up > w.height && w.up < w.height + 20;
    const bool sill = w.up < 0 && w.up > -9 && std::abs(w.across) < w.half_width + frame + 5;
    if (key || sill) {
        return {stone * 1.06, 5};
    }
    return d > -frame ? Surface{stone, 3 + 1.2 * ramp(2, 0, std::abs(d + frame - 3))} : wall;
}

// The mouldings above the upper storey: a row of blocks under a projecting slab.
Surface top_moulding(double x, double y, double depth, Color stone) {
    const double t = y / depth, block = ramp(0.2, 0.3, std::abs(fraction(x / 16) - 0.5));
    const bool blocks = t > 0.5 && t < 0.8;
    const double h = t < 0.5 ? 9 - 8 * t : t < 0.8 ? 5 - 4 * block : 2;
    return {stone * (1.05 - 0.25 * t - (blocks ? 0.22 * block : 0)), h};
}

// A balustrade against the sky's shade: what lies behind the balusters is dark.
Surface parapet(double x, double y, Color stone) {
    if (y < 9 || y > kCorniceTop - 8) {
        return {stone * 1.05, 4};
    }
    const double t = (y - 9) / (kCorniceTop - 17), px = std::abs(fraction(x / 16) - 0.5) * 16;
    const double belly = 2.6 + 3.2 * wave(clamp01(t * 0.9 + 0.1) / 2), pier = std::abs(x - 96) > 84 ? 8 : 0;
    const double solid = std::max(ramp(0, 1.2, belly - px), pier > 0 ? 1.0 : 0.0);
    return {mix(rgb(0x6b6d6c), stone, solid), 3 * solid};
}

// The palace out of doors: rusticated below, plastered and windowed above, a balustrade along the roof.
Surface palace_front(double x, double y, double u, double v) {
    const double grain = cloud(u, v, 48, 128, 2, 501), stain = cloud(u, v, 3, 6, 4, 502);
    const Color stone = mix(rgb(0xd6c8a8), rgb(0xc0b08c), 0.5 + 0.5 * stain) * (1 + 0.03 * grain);
    if (y < kCorniceTop) {
        return parapet(x, y, stone);
    }
    if (y < kFrieze) {
        return top_moulding(x, y - kCorniceTop, kFrieze - kCorniceTop, stone);
    }
    if (y < kUpper) {
        return {stone * 0.94, 1};
    }
    if (y < kString) {
        const Window w{x - 96, 238 - y, 40, 114};
        const Surface wall{mix(rgb(0xdbb981), rgb(0xc9a56c), 0.5 + 0.5 * stain) * (1 + 0.02 * grain), 0};
        const Surface pier{stone, 2};
        return framed(std::abs(x - 96) > 82 ? pier : wall, w, 10, glass(w, rgb(0x2c3d4c), rgb(0x8fb0c8), 20, 503),
                      stone);
    }
    if (y < kGround) {
        return {stone * (1.06 - 0.2 * (y - kString) / (kGround - kString)), 5 - 4 * ramp(kString + 8, kGround, y)};
    }
    if (y < kBase) {
        const Block b = block_at(x, y - kGround, 192, static_cast<int>(kBase - kGround), 2, 7, 0.5, 0, 504);
        return {stone * (0.93 + 0.07 * b.tint), 3 * ramp(0.8, 4, b.edge)};
    }
    return {mix(stone, rgb(0x8d8878), 0.75) * (1 - 0.12 * ramp(kBase, kFrontRows, y)),
            3 + 2 * ramp(kBase + 8, kBase, y)};
}

// A town house at dusk: brick, stone trim, and behind the leaded panes somebody has lit the lamps.
Surface brick_front(double x, double y, double u, double v) {
    const double grain = cloud(u, v, 52, 128, 2, 511), stain = cloud(u, v, 3, 6, 4, 512);
    const Color stone = mix(rgb(0xcabc9e), rgb(0xae9f82), 0.5 + 0.5 * stain) * (1 + 0.04 * grain);
    if (y < 40) {
        return top_moulding(x * 16 / 13, y, 40, stone);
    }
    if (y > kString && y < kGround) {
        return {stone * (1.05 - 0.2 * (y - kString) / (kGround - kString)), 5 - 4 * ramp(kString + 8, kGround, y)};
    }
    const Block b = block_at(x, y, 208, kFrontRows, 4, 32, 0.5, 0.1, 513);
    const double face = ramp(0.5, 2.4, b.edge);
    const Color brick = mix(rgb(0xa4614a), rgb(0x8a4d3d), b.tint) * (1 + 0.05 * grain + 0.06 * stain);
    const Surface wall{mix(rgb(0x94705c), brick, face), 1.1 * face};
    const Window w{x - 104, 232 - y, 34, 134};
    return y < kString ? framed(wall, w, 9, glass(w, rgb(0xf3c873), rgb(0xb9763c), 17, 514), stone) : wall;
}

}  // namespace

void draw_facades(const Album& album) {
    album.add("palace_front", static_cast<int>(3 * kScale), kFrontRows, palace_front);
    album.add("brick_front", static_cast<int>(3.25 * kScale), kFrontRows, brick_front);
}

}  // namespace draw_textures
