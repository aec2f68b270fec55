// Walls of stone, brick and plaster.
#include "album.h"
#include "layout.h"

namespace draw_textures {
namespace {

// Dressed stone in even courses: each block a little different, its face flat, its edges worn.
Painter ashlar(Color stone, Color other, Color mortar, int per_row, int rows, int seed) {
    return [=](double x, double y, double u, double v) {
        const double wobble = 1.2 * cloud(u, v, 12, 12, 2, seed + 9);
        const Block b = block_at(x + wobble, y + wobble, 256, 256, per_row, rows, 0.5, 0.5, seed);
        const double grain = cloud(u, v, 32, 32, 3, seed + 1), stain = cloud(u, v, 3, 3, 4, seed + 2);
        const double face = ramp(0.6, 4.5, b.edge + 0.8 * grain);
        const double pit = ramp(0.5, 0.75, cloud(u, v, 24, 24, 2, seed + 3));
        Color c = mix(stone, other, clamp01(b.tint * 1.1 - 0.05 + 0.3 * stain));
        c = c * (1 + 0.05 * grain + 0.08 * stain - 0.12 * pit + 0.12 * (fraction(b.tint * 7) - 0.5));
        c = c * (1 + 0.06 * (1 - ramp(0, b.height, b.y)));  // the light comes from above
        return Surface{mix(mortar * (1 + 0.06 * grain), c, ramp(0.2, 1.8, b.edge)),
                       1.8 * face + 0.3 * grain - 0.6 * pit};
    };
}

// Brick in running bond, every brick burnt differently, some blackened.
Painter brick(Color light, Color dark, Color mortar, double soot, int seed) {
    return [=](double x, double y, double u, double v) {
        const Block b = block_at(x + 0.9 * cloud(u, v, 16, 16, 2, seed), y + 0.7 * cloud(u, v, 16, 16, 2, seed + 4),
                                 256, 256, 5, 16, 0.5, 0.12, seed);
        const double grain = cloud(u, v, 40, 40, 3, seed + 1), stain = cloud(u, v, 2, 3, 4, seed + 2);
        const double burnt = ramp(0.82, 1.0, b.tint) * soot;
        Color c = mix(light, dark, clamp01(b.tint + 0.25 * grain)) * (1 + 0.09 * grain + 0.1 * stain);
        c = mix(c, dark * 0.55, 0.7 * burnt);
        const double chipped = ramp(0.35, 0.6, grain) * ramp(4, 0, b.edge);
        const double face = ramp(0.7, 2.6, b.edge - 1.5 * chipped);
        return Surface{mix(mortar * (1 + 0.1 * grain + 0.08 * stain), c, face), 1.1 * face + 0.3 * grain};
    };
}

// Field stones set in mortar.
Painter rubble(Color warm, Color cool, Color mortar, int seed) {
    return [=](double, double, double u, double v) {
        const double wu = u + 0.018 * cloud(u, v, 8, 8, 2, seed + 5), wv = v + 0.018 * cloud(u, v, 8, 8, 2, seed + 6);
        const Cell c = cell_at(wu, wv, 5, 8, 0.62, seed);
        const double grain = cloud(u, v, 24, 24, 4, seed + 1), stain = cloud(u, v, 2, 2, 3, seed + 2);
        const double face = ramp(0.05, 0.13, c.edge), dome = ramp(0.05, 0.42, c.edge);
        const Color stone = mix(warm, cool, c.tint) * (0.86 + 0.2 * fraction(c.tint * 7) + 0.13 * grain + 0.08 * stain);
        return Surface{mix(mortar * (0.95 + 0.08 * grain + 0.08 * stain), stone, face),
                       3.2 * face + 3 * dome + 0.9 * grain};
    };
}

// Plaster put on by hand: broad trowel marks, faint clouds.
Painter plaster(Color base, Color shade, int seed) {
    return [=](double, double, double u, double v) {
        const double broad = cloud(u, v, 2, 2, 4, seed), grain = cloud(u, v, 48, 48, 2, seed + 1);
        const double trowel = cloud(u + 0.2 * cloud(u, v, 3, 3, 2, seed + 2), v, 5, 14, 3, seed + 3);
        const Color c = mix(base, shade, clamp01(0.35 + 0.55 * broad)) * (1 + 0.03 * trowel + 0.02 * grain);
        return Surface{c, 0.8 * trowel + 0.25 * grain};
    };
}

// A plastered room: a dado in another colour under a painted line, and a line below the ceiling.
Painter with_dado(const Painter& field, const Painter& dado, Color line) {
    return [=](double x, double y, double u, double v) {
        constexpr double kDado = 180, kSkirting = 246;
        const Surface low = dado(x, y, u, v), high = field(x, y, u, v);
        Surface s = y > kDado ? low : high;
        const double hand = 0.4 * cloud(u, v, 16, 2, 2, 47);
        const double stripe =
            std::max(ramp(2.4, 1.6, std::abs(y - kDado + hand)), ramp(1.2, 0.5, std::abs(y - kDado + 8 + hand)));
        s.color = mix(s.color, line, 0.85 * std::max(stripe, ramp(2.0, 1.2, std::abs(y - 14 + hand))));
        const double skirting = ramp(kSkirting - 1, kSkirting + 1, y);
        s.color = mix(s.color, line * 0.8, 0.8 * skirting);
        s.height += 1.5 * skirting;
        return s;
    };
}

// Old brickwork showing where the plaster has come off.
Painter broken_plaster(const Painter& whole, const Painter& behind, int seed) {
    return [=](double x, double y, double u, double v) {
        const double hole = cloud(u, v, 3, 2, 5, seed) - 0.16;
        const Surface a = whole(x, y, u, v), b = behind(x, y, u, v);
        const double t = ramp(0.0, 0.03, hole);
        return Surface{mix(a.color * (1 - 0.1 * ramp(-0.08, 0, hole)), b.color * 0.92, t),
                       a.height + (b.height - 2.5 - a.height) * t};
    };
}

// Glazed tiles, painted blue on white: a star of eight leaves, a ring, quarter flowers in the corners.
Surface majolica(double x, double y, double u, double v) {
    const double px = fraction(x / 24) * 32 - 16, py = fraction(y / 24) * 32 - 16;
    const double ax = std::abs(px), ay = std::abs(py), r = std::sqrt(px * px + py * py);
    const double edge = 16 - std::max(ax, ay), cx = 16 - ax, cy = 16 - ay, corner = std::sqrt(cx * cx + cy * cy);
    const double straight = std::min(ax, ay), diagonal = std::abs(ax - ay) * 0.707;
    const double leaf_a = ramp(0.8, 0, straight - 1.9 * wave(clamp01((r - 1.5) / 9) / 2));
    const double leaf_b = ramp(0.8, 0, diagonal - 1.4 * wave(clamp01((r - 2) / 7) / 2));
    const double ring = ramp(0.9, 0.2, std::abs(r - 11.5)),
                 flower = ramp(5.6, 4.8, corner) - 0.75 * ramp(3.2, 2.4, corner);
    const double tone = cloud(u, v, 4, 3, 3, 71), tint = random(static_cast<int>(x / 24), static_cast<int>(y / 24), 72);
    Color c = mix(rgb(0xe9e6d8), rgb(0xd9dcd8), tint) * (1 + 0.03 * tone);
    c = mix(c, rgb(0x24458c), clamp01(std::max(leaf_a, ring) + flower) * (0.85 + 0.15 * tone));
    c = mix(c, rgb(0x6f93c8), leaf_b * (1 - leaf_a) * 0.9);
    c = mix(c, rgb(0xc79a3c), ramp(2.2, 1.6, r));
    const double face = ramp(0.3, 1.7, edge);
    return {mix(rgb(0x8d8678), c, ramp(0.2, 1, edge)), 1.6 * face};
}

}  // namespace

void draw_masonry(const Album& album) {
    const Painter red_brick = brick(rgb(0xa65f48), rgb(0x8c4b3c), rgb(0x97755f), 0.45, 21);
    album.add("ashlar", 256, 256, ashlar(rgb(0xcbb892), rgb(0xbba986), rgb(0xa3926f), 3, 6, 11));
    album.add("ashlar_grey", 256, 256, ashlar(rgb(0x9a9a98), rgb(0x8b8781), rgb(0x74716c), 3, 6, 12));
    album.add("brick", 256, 256, red_brick);
    album.add("brick_pale", 256, 256, brick(rgb(0xc9b79c), rgb(0xb39c80), rgb(0xa8987e), 0.2, 22));
    album.add("rubble", 256, 256, rubble(rgb(0xa3947b), rgb(0x7f8081), rgb(0x6b6152), 31));
    album.add("plaster_white", 256, 256, plaster(rgb(0xe6dfd0), rgb(0xcfc5b2), 41));
    album.add("plaster_ochre", 256, 256, plaster(rgb(0xd3ac6d), rgb(0xb98d56), 42));
    album.add(
        "plaster_dado", 256, 256,
        with_dado(plaster(rgb(0xd9b67a), rgb(0xc59d66), 42), plaster(rgb(0x9c5648), rgb(0x874a40), 46), rgb(0x5b3a2e)));
    album.add("plaster_rose", 256, 256, plaster(rgb(0xc9988a), rgb(0xb08073), 43));
    album.add("plaster_broken", 256, 256, broken_plaster(plaster(rgb(0xd8c7a2), rgb(0xbfa67c), 44), red_brick, 45));
    album.add("majolica", 96, 72, majolica);
}

}  // namespace draw_textures
