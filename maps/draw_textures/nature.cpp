// Rock, earth, water, leaves.
#include "album.h"

namespace draw_textures {
namespace {

struct Stone {
    Color light, dark, tint;
};

// Beds of rock, broken along joints.
Painter rock(const Stone& stone, double bedding, double relief, int seed) {
    return [=](double, double, double u, double v) {
        const double wu = u + 0.10 * cloud(u, v, 3, 3, 4, seed + 1), wv = v + 0.10 * cloud(u, v, 3, 3, 4, seed + 2);
        const Cell big = cell_at(wu, wv, 2, 5, 0.9, seed + 3), small = cell_at(wu, wv, 6, 11, 0.9, seed + 4);
        const double beds = cloud(wu, wv, 1, 9, 3, seed + 5), grain = cloud(u, v, 24, 24, 4, seed + 6),
                     broad = cloud(u, v, 2, 2, 4, seed + 7);
        const double facet = big.x * (fraction(big.tint * 13) - 0.5) + big.y * (fraction(big.tint * 29) - 0.5);
        const double chip = small.x * (fraction(small.tint * 17) - 0.5) + small.y * (fraction(small.tint * 23) - 0.5);
        const double crack = ramp(0.05, 0.0, big.edge), hairline = ramp(0.04, 0.0, small.edge) * 0.4;
        const double h = 26 * facet + 7 * chip + 6 * bedding * beds + 2.4 * grain - 1.6 * crack - 0.5 * hairline;
        Color c =
            mix(stone.light, stone.dark, clamp01(0.5 + 0.45 * broad + 0.35 * beds * bedding + 0.3 * (big.tint - 0.5)));
        c = mix(c, stone.tint, 0.5 * ramp(0.05, 0.5, cloud(u, v, 3, 3, 5, seed + 8)));
        return Surface{c * (1 + 0.07 * grain - 0.10 * crack - 0.03 * hairline), relief * h};
    };
}

// Loose ground: pebbles of several sizes in something finer.
Painter gravel(Color fine, Color light, Color dark, double pebbles, int seed) {
    return [=](double, double, double u, double v) {
        const double broad = cloud(u, v, 2, 2, 4, seed), grain = cloud(u, v, 64, 64, 2, seed + 1);
        Surface s{fine * (1 + 0.08 * broad + 0.09 * grain), 0.6 * grain};
        for (int size = 0; size < 2; ++size) {
            const int across = size == 0 ? 26 : 15;
            const Cell c =
                cell_at(u + 0.006 * cloud(u, v, 32, 32, 2, seed + 3), v + 0.006 * cloud(u, v, 32, 32, 2, seed + 4),
                        across, across, 0.8, seed + 7 + 10 * size);
            const double radius = (0.22 + 0.26 * fraction(c.tint * 11)) *
                                  (fraction(c.tint * 5) < pebbles * (size == 0 ? 1 : 0.6) ? 1 : 0);
            const double inside = std::min(radius - c.nearest, c.edge);
            const Color stone = mix(light, dark, fraction(c.tint * 3)) * (0.9 + 0.12 * grain + 0.06 * broad);
            const double t = ramp(0, 0.05, inside);
            s = {mix(s.color, stone, t), std::max(s.height, (size == 0 ? 1.7 : 2.8) * std::sqrt(clamp01(inside * 3)))};
        }
        return s;
    };
}

// Small leaves or blades in layers, each layer lighter than the one below; `slim` is how much longer than wide.
Painter leaves(Color light, Color dark, int across, int down, double slim, int seed) {
    return [=](double, double, double u, double v) {
        constexpr int kLayers = 6;
        const double broad = cloud(u, v, 3, 3, 4, seed);
        Surface s{dark * 0.85, 0};
        for (int layer = 0; layer < kLayers; ++layer) {
            const Cell c = cell_at(u + 0.37 * layer, v + 0.61 * layer, across, down, 0.95, seed + 7 * layer + 1);
            const double lean = 1.4 * (fraction(c.tint * 7) - 0.5), a = c.x + lean * c.y, b = c.y - lean * c.x / slim;
            const double inside = 0.46 - std::sqrt(a * a * slim + b * b), lit = layer / (kLayers - 1.0);
            if (inside > 0) {
                const Color green = mix(dark, light, clamp01(0.1 + 0.5 * lit + 0.4 * fraction(c.tint * 19)));
                s = {green * (0.86 + 0.18 * ramp(0, 0.25, inside) + 0.16 * broad),
                     1.1 * lit + 0.5 * ramp(0, 0.25, inside)};
            }
        }
        return s;
    };
}

// A bed in flower: blossoms of four petals over leaves.
Surface flowers(double x, double y, double u, double v) {
    static const Painter green = leaves(rgb(0x6f9045), rgb(0x3d5a2b), 20, 20, 2.4, 468);
    static const Color petals[4] = {rgb(0xc8423f), rgb(0xe8b23f), rgb(0xf0e6d6), rgb(0xb65a8e)};
    const Surface below = green(x, y, u, v);
    const Cell c = cell_at(u, v, 11, 11, 0.8, 469);
    const double r = c.nearest, four = std::abs(c.x * c.y) / (r * r + 1e-9);  // 0 along a petal's middle, 1/2 between
    const double inside = 0.40 * (0.75 + 0.25 * fraction(c.tint * 7)) * (1 - 0.5 * four) - r;
    const Color petal = petals[static_cast<int>(c.tint * 4)] * (0.85 + 0.4 * r);
    const Surface bloom{mix(petal, rgb(0xe6c35a), ramp(0.1, 0.06, r)), 2.5};
    return inside > 0 && fraction(c.tint * 31) < 0.75 ? bloom : below;
}

// Still water over dark stone: a net of light bent by ripples.
Surface water(double, double, double u, double v) {
    const double du = 0.05 * cloud(u, v, 4, 4, 3, 441), dv = 0.05 * cloud(u, v, 4, 4, 3, 442);
    const Cell a = cell_at(u + du, v + dv, 5, 5, 0.9, 443), b = cell_at(u - dv, v + du, 7, 7, 0.9, 444);
    const double light = 0.6 * ramp(0.11, 0.0, a.edge) + 0.4 * ramp(0.12, 0.0, b.edge),
                 deep = cloud(u, v, 2, 2, 4, 445);
    Color c = mix(rgb(0x2f6468), rgb(0x1f464f), 0.5 + 0.5 * deep);
    c = mix(c, rgb(0x8fc4bd), 0.42 * light * (0.7 + 0.3 * deep));
    return {c, 0.8 * cloud(u + du, v + dv, 5, 5, 3, 446)};
}

// Nothing but light on crests, clear between them: to be laid over water and moved another way.
Surface ripples(double, double, double u, double v) {
    const double du = 0.07 * cloud(u, v, 3, 3, 3, 447), dv = 0.07 * cloud(u, v, 3, 3, 3, 448);
    const Cell a = cell_at(u + du, v + dv, 6, 4, 0.95, 449);
    const double crest = ramp(0.10, 0.0, a.edge), patch = clamp01(0.55 + 0.9 * cloud(u, v, 2, 2, 4, 450));
    return {rgb(0xd4ece6), 0, 0.75 * crest * patch};
}

}  // namespace

void draw_nature(const Album& album) {
    album.add("rock", 256, 256, rock({rgb(0xa2937c), rgb(0x766a5b), rgb(0x8d7a55)}, 1.0, 0.7, 461));
    album.add("cave_rock", 256, 256, rock({rgb(0x8b8178), rgb(0x615b5c), rgb(0x6c7562)}, 0.4, 0.5, 462));
    album.add("cave_floor", 256, 256, gravel(rgb(0x6a6055), rgb(0x857a6c), rgb(0x57504a), 0.45, 463));
    album.add("gravel", 256, 256, gravel(rgb(0xc0ac86), rgb(0xd8c9a8), rgb(0x9d8a69), 0.85, 464));
    album.add("earth", 256, 256, gravel(rgb(0x6e5439), rgb(0x8a7558), rgb(0x5a4631), 0.12, 465));
    album.add("grass", 256, 256, leaves(rgb(0x7c9348), rgb(0x627d3d), 36, 18, 7, 467));
    album.add("hedge", 256, 256, leaves(rgb(0x6d8c42), rgb(0x2c4824), 20, 20, 2.4, 466));
    album.add("flowers", 256, 256, flowers);
    album.add("water", 256, 256, water);
    album.add_with_alpha("ripples", 256, 256, ripples);
}

}  // namespace draw_textures
