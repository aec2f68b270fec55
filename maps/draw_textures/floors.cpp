// Floors: marble, tiles, paving, carpet.
#include "album.h"
#include "layout.h"
#include "stone.h"

namespace draw_textures {
namespace {

// Octagons of one marble with small squares of another set between them.
Painter octagons(const Marble& field, const Marble& inset, int seed) {
    return [=](double x, double y, double u, double v) {
        const int column = static_cast<int>(std::floor(x / 64)), row = static_cast<int>(std::floor(y / 64));
        const double px = std::abs(fraction(x / 64) * 64 - 32), py = std::abs(fraction(y / 64) * 64 - 32);
        const double cut = (50 - px - py) * 0.707;  // distance to the octagon's slanting side
        const bool is_inset = cut < 0;
        const double edge = is_inset ? -cut : std::min(cut, 32 - std::max(px, py));
        const int piece = is_inset ? wrap(static_cast<int>(std::floor(x / 64 + 0.5)), 4) * 5 +
                                         wrap(static_cast<int>(std::floor(y / 64 + 0.5)), 4) * 9
                                   : column * 7 + row * 13;
        const double tint = random(piece, 1, seed);
        Color c = marble_at(is_inset ? inset : field, u, v, std::floor(tint * 9), seed);
        c = c * (0.95 + 0.08 * tint + 0.03 * cloud(u, v, 2, 2, 3, seed + 1));
        const double face = ramp(0.3, 1.4, edge);
        return Surface{mix(rgb(0x6d6558), c, ramp(0.2, 0.9, edge)), 1.1 * face};
    };
}

// Diamonds of two marbles, laid cornerwise.
Painter diamonds(const Marble& light, const Marble& dark, int seed) {
    return [=](double x, double y, double u, double v) {
        const double a = (x + y) / 64, b = (x - y) / 64;
        const int ia = static_cast<int>(std::floor(a)), ib = static_cast<int>(std::floor(b));
        const double fa = fraction(a), fb = fraction(b);
        const double edge = 45 * std::min(std::min(fa, 1 - fa), std::min(fb, 1 - fb));
        // the next tile moves (ia, ib) by (2, 2) or (2, -2): name the piece so that it stays the same
        const double tint = random(wrap(ia + ib, 4), wrap(ia - ib, 4), seed);
        Color c = marble_at(wrap(ia + ib, 2) == 0 ? light : dark, u, v, std::floor(tint * 9), seed);
        c = c * (0.94 + 0.1 * tint);
        return Surface{mix(rgb(0x5b5348), c, ramp(0.15, 0.9, edge)), 1.0 * ramp(0.2, 1.4, edge)};
    };
}

// Six-sided clay tiles.
Surface clay_hexagons(double x, double y, double u, double v) {
    // pointed-top hexagons: 8 across, 8 rows of 32 * 0.75... stretched a little so that they close on a square tile
    const double px = x / 32, py = y / 32;
    double best = 1e9, second = 1e9, tint = 0;
    for (int j = -1; j <= 1; ++j) {
        for (int i = -1; i <= 1; ++i) {
            const int row = static_cast<int>(std::floor(py)) + j, column = static_cast<int>(std::floor(px)) + i;
            const double cx = column + 0.5 + 0.5 * wrap(row, 2), cy = row + 0.5;
            const double dx = (px - cx) * 32, dy = (py - cy) * 32;
            const double distance = std::sqrt(dx * dx + dy * dy);
            if (distance < best) {
                second = best;
                best = distance;
                tint = random(wrap(column, 8), wrap(row, 8), 81);
            } else if (distance < second) {
                second = distance;
            }
        }
    }
    const double grain = cloud(u, v, 32, 32, 3, 82), worn = cloud(u, v, 3, 3, 4, 83), edge = (second - best) / 2;
    Color c = mix(rgb(0xb5694a), rgb(0x96503a), tint) * (1 + 0.07 * grain + 0.08 * worn);
    c = mix(c, rgb(0xc98e66), 0.35 * ramp(0.15, 0.6, worn));
    return {mix(rgb(0x6e5a49), c, ramp(0.4, 1.3, edge)), 1.5 * ramp(0.3, 2.4, edge) + 0.3 * grain};
}

// Large paving stones, worn hollow, with earth in the joints.
Surface flagstones(double x, double y, double u, double v) {
    const double wx = x + 1.5 * cloud(u, v, 8, 8, 2, 91), wy = y + 1.5 * cloud(u, v, 8, 8, 2, 92);
    const Block b = block_at(wx, wy, 256, 256, 3, 4, 0.37, 0.5, 93);
    const double grain = cloud(u, v, 32, 32, 3, 94), stain = cloud(u, v, 3, 3, 4, 95);
    const double hollow = ramp(0, 30, b.edge), moss = ramp(3.5, 0.5, b.edge) * ramp(-0.1, 0.35, stain);
    Color c = mix(rgb(0xb3a78f), rgb(0x948b7c), b.tint) * (1 + 0.06 * grain + 0.07 * stain + 0.05 * hollow);
    c = mix(mix(rgb(0x5c5446), c, ramp(0.3, 1.9, b.edge)), rgb(0x68703f), 0.55 * moss);
    return {c, 1.9 * ramp(0.5, 3.5, b.edge) - 0.8 * hollow + 0.45 * grain};
}

// Round-headed cobbles.
Surface cobbles(double, double, double u, double v) {
    const Cell c = cell_at(u, v, 8, 8, 0.35, 101);
    const double grain = cloud(u, v, 32, 32, 3, 102), stain = cloud(u, v, 2, 2, 3, 103);
    const double top = 1 - clamp01(c.edge / 0.40), dome = std::sqrt(1 - top * top) + 0.4 * ramp(0.6, 0, c.nearest);
    const Color stone =
        mix(rgb(0x8b867d), rgb(0x6f6a66), c.tint) * (0.9 + 0.16 * fraction(c.tint * 9) + 0.08 * grain + 0.1 * stain);
    return {mix(rgb(0x625a4e), stone, ramp(0.03, 0.12, c.edge)), 2.8 * dome + 0.3 * grain};
}

// A runner: a border of gold lines, leaves on a lattice, wool that lies in rows.
Surface carpet(double x, double y, double u, double v) {
    const double px = x / 128, py = fraction(y / 128 * 2);
    const double side = std::min(px, 1 - px) * 128;
    const double mx = std::abs(fraction(px * 4) - 0.5) * 2, my = std::abs(py - 0.5) * 2;
    const double lattice = mx + my - 1 + 0.12 * wave(mx * 1.0 + my);
    const double flower = 1 - 2.2 * std::min(mx + 0.6 * my, (1 - mx) + 0.6 * (1 - my));
    const double wool = cloud(u, v, 64, 64, 1, 111), worn = cloud(u, v, 3, 3, 3, 112);
    Color c = mix(rgb(0x7d1f28), rgb(0x8f2a30), ramp(-0.3, 0.3, worn));
    c = mix(c, rgb(0xb98b45), 0.75 * ramp(0.10, 0.05, std::abs(lattice)));
    c = mix(c, rgb(0xd2b37a), 0.85 * ramp(0.45, 0.6, flower));
    if (side < 18) {
        c = mix(rgb(0x27304d), rgb(0x343f60), 0.5 + 0.5 * wave(y / 16));
        c = mix(c, rgb(0xc49a4e), std::max(ramp(1.6, 0.9, std::abs(side - 15)), ramp(1.4, 0.7, std::abs(side - 4))));
        c = mix(c, rgb(0xb4803c), ramp(3.2, 2.6, std::abs(side - 9.5) + std::abs(fraction(y / 16) - 0.5) * 8));
    }
    const double row = 0.5 + 0.5 * wave(y / 2);
    return {c * (0.93 + 0.05 * wool + 0.05 * row + 0.05 * worn), 0.35 * wool};
}

}  // namespace

void draw_floors(const Album& album) {
    album.add("marble_octagons", 256, 256, octagons(kWhiteMarble, kBlackMarble, 61));
    album.add("marble_diamonds", 128, 128, diamonds(kWhiteMarble, kRoseMarble, 62));
    album.add("marble_court", 128, 128, diamonds(kYellowMarble, kGreenMarble, 63));
    album.add("clay_hexagons", 256, 256, clay_hexagons);
    album.add("flagstones", 256, 256, flagstones);
    album.add("cobbles", 256, 256, cobbles);
    album.add("carpet", 128, 128, carpet);
    album.add("runner", 128, 128, [](double x, double y, double u, double v) { return carpet(y, x, v, u); });
}

}  // namespace draw_textures
