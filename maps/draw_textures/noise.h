// Noise that tiles: everything here repeats after a whole number of cells, so that a texture meets itself at its edges.
// Built on an integer hash and on +, -, *, / and floor alone, so every machine draws the same picture.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace draw_textures {

inline double clamp01(double t) { return std::clamp(t, 0.0, 1.0); }

// 0 below `from`, 1 above `to`, smooth between.
inline double ramp(double from, double to, double t) {
    t = clamp01((t - from) / (to - from));
    return t * t * (3 - 2 * t);
}

inline int wrap(int i, int period) { return (i % period + period) % period; }

inline double fraction(double t) { return t - std::floor(t); }

// A sine of a whole turn per unit, by Bhaskara's formula: close enough for ornaments, and the same everywhere.
inline double wave(double turns) {
    const double t = fraction(turns) * 2;
    const double p = t < 1 ? t * (1 - t) : (t - 1) * (2 - t);
    return (t < 1 ? 16 : -16) * p / (5 - 4 * p);
}

// A number in [0, 1) that belongs to the cell (x, y).
inline double random(int x, int y, int seed) {
    std::uint32_t h = static_cast<std::uint32_t>(x) * 0x8da6b343u ^ static_cast<std::uint32_t>(y) * 0xd8163841u ^
                      static_cast<std::uint32_t>(seed) * 0xcb1ab31fu;
    h = (h ^ h >> 16) * 0x7feb352du;
    h = (h ^ h >> 15) * 0x846ca68bu;
    return (h ^ h >> 16) / 4294967296.0;
}

// Smooth noise in [-1, 1] over cells of size 1; repeats after `across` and `down` cells.
inline double value_noise(double x, double y, int across, int down, int seed) {
    const double fx = std::floor(x), fy = std::floor(y);
    const int ix = static_cast<int>(fx), iy = static_cast<int>(fy);
    const double tx = ramp(0, 1, x - fx), ty = ramp(0, 1, y - fy);
    const auto at = [&](int i, int j) { return random(wrap(ix + i, across), wrap(iy + j, down), seed); };
    const double top = at(0, 0) + (at(1, 0) - at(0, 0)) * tx;
    const double bottom = at(0, 1) + (at(1, 1) - at(0, 1)) * tx;
    return 2 * (top + (bottom - top) * ty) - 1;
}

// Several octaves of it, over a tile u, v in [0, 1) that the coarsest octave divides into across x down cells.
inline double cloud(double u, double v, int across, int down, int octaves, int seed) {
    double sum = 0, weight = 1, total = 0;
    for (int octave = 0; octave < octaves; ++octave, weight *= 0.5) {
        const int scale = 1 << octave;
        sum += weight * value_noise(u * across * scale, v * down * scale, across * scale, down * scale, seed + octave);
        total += weight;
    }
    return sum / total;
}

// Cells around scattered points: pebbles, cobbles, leaves, the facets of a rock.
struct Cell {
    double nearest;  // distance to the nearest point, in cells
    double edge;     // distance to the cell's border, in cells
    double tint;     // a random number that belongs to the cell
    double x, y;     // from the point to here, in cells
};

inline Cell cell_at(double u, double v, int across, int down, double scatter, int seed) {
    const double x = u * across, y = v * down;
    const int ix = static_cast<int>(std::floor(x)), iy = static_cast<int>(std::floor(y));
    Cell best{1e9, 1e9, 0, 0, 0};
    struct Point {
        double x, y;
    } points[25];
    int count = 0, winner = 0;
    for (int j = -2; j <= 2; ++j) {
        for (int i = -2; i <= 2; ++i) {
            const int cx = wrap(ix + i, across), cy = wrap(iy + j, down);
            const Point p{ix + i + 0.5 + scatter * (random(cx, cy, seed) - 0.5) - x,
                          iy + j + 0.5 + scatter * (random(cx, cy, seed + 1) - 0.5) - y};
            const double distance = std::sqrt(p.x * p.x + p.y * p.y);
            if (distance < best.nearest) {
                best = {distance, 1e9, random(cx, cy, seed + 2), -p.x, -p.y};
                winner = count;
            }
            points[count++] = p;
        }
    }
    const Point home = points[winner];
    for (int k = 0; k < count; ++k) {
        const double dx = points[k].x - home.x, dy = points[k].y - home.y, length = std::sqrt(dx * dx + dy * dy);
        if (k != winner) {
            best.edge = std::min(best.edge, ((points[k].x + home.x) * dx + (points[k].y + home.y) * dy) / (2 * length));
        }
    }
    return best;
}

}  // namespace draw_textures
