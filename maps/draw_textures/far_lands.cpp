// What lies behind the odder doors: sand, snow, red stone, glazed stars, and a night sky.
#include "album.h"
#include "layout.h"

namespace draw_textures {
namespace {

// Wind has drawn ripples over it.
Surface sand(double, double, double u, double v) {
    const double broad = cloud(u, v, 2, 2, 4, 901), grain = cloud(u, v, 96, 96, 2, 902);
    const double bent = v + 0.05 * cloud(u, v, 3, 2, 3, 903), ripple = wave(9 * bent + 0.6 * cloud(u, v, 4, 4, 2, 904));
    const double fade = 0.55 + 0.45 * cloud(u, v, 3, 3, 2, 905);
    const Color c = mix(rgb(0xdcb878), rgb(0xc99f5f), clamp01(0.5 + 0.5 * broad)) * (1 + 0.05 * grain + 0.03 * ripple);
    return {c, 1.5 * fade * ripple + 0.4 * grain};
}

// Drifts, with a blue breath in the hollows and here and there a glint.
Surface snow(double, double, double u, double v) {
    const double drift = cloud(u + 0.06 * cloud(u, v, 3, 3, 2, 911), v, 2, 4, 5, 912);
    const double grain = cloud(u, v, 80, 80, 2, 913),
                 glint = ramp(0.985, 1, random(static_cast<int>(u * 256), static_cast<int>(v * 256), 914));
    const Color c = mix(rgb(0xb9c8dd), rgb(0xf1f5f8), clamp01(0.62 + 0.6 * drift)) * (1 + 0.025 * grain + 0.05 * glint);
    return {c, 4.5 * drift + 0.35 * grain};
}

// Big blocks of red stone; every second course carries a row of suns cut into it.
Surface red_stone(double x, double y, double u, double v) {
    const Block b = block_at(x, y, 256, 256, 2, 4, 0.5, 0.1, 921);
    const double grain = cloud(u, v, 40, 24, 4, 922), beds = cloud(u, v, 2, 14, 3, 923),
                 stain = cloud(u, v, 2, 2, 4, 924);
    const double px = fraction(x / 32) * 32 - 16, py = fraction(y / 128) * 128 - 32, r = std::sqrt(px * px + py * py);
    const double disc = ramp(4.6, 3.8, r), rays = ramp(11.5, 10.5, r) * ramp(5.8, 6.6, r) *
                                                  ramp(1.3, 0.7,
                                                       std::min(std::min(std::abs(px), std::abs(py)),
                                                                0.707 * std::abs(std::abs(px) - std::abs(py))));
    const double cut = std::max(disc, rays), face = ramp(0.6, 3.5, b.edge + 0.8 * grain);
    Color c = mix(rgb(0xb9744a), rgb(0x9d5a39), clamp01(b.tint + 0.3 * beds)) * (1 + 0.06 * grain + 0.09 * stain);
    c = mix(c, rgb(0x6f3b28), 0.55 * cut);
    return {mix(rgb(0x7a4a33), c, ramp(0.2, 1.8, b.edge)), 2 * face + 0.5 * grain - 1.8 * cut};
}

// Eight-pointed stars and crosses of glazed clay.
Surface zellige(double x, double y, double u, double v) {
    const double px = std::abs(fraction(x / 64) * 64 - 32), py = std::abs(fraction(y / 64) * 64 - 32);
    const double square = std::max(px, py), diamond = (px + py) * 0.7071;
    const double star = 24 - std::min(square, diamond), heart = 11 - std::max(square, diamond);
    const double tone = cloud(u, v, 6, 6, 3, 931);
    const int cell = static_cast<int>(x / 64) + 7 * static_cast<int>(y / 64);
    Color c = mix(rgb(0x1f6f74), rgb(0x16555f), random(cell, 3, 932));
    c = mix(c, rgb(0xe9e2cf), ramp(-0.6, 0.6, star));
    c = mix(c, rgb(0x224a8f), ramp(-0.6, 0.6, star - 5));
    c = mix(c, rgb(0xd39a3b), ramp(-0.6, 0.6, heart));
    const double joint =
        std::max({ramp(1.5, 0.6, std::abs(star)), ramp(1.3, 0.5, std::abs(star - 5)), ramp(1.3, 0.5, std::abs(heart))});
    return {mix(c * (1 + 0.07 * tone), rgb(0xb5a78b), joint), 1.4 * (1 - joint)};
}

// Stars, more of them along the Milky Way, a moon, and mountains with snow on them.
Surface night(double x, double y, double u, double v) {
    const double rise = 1.2 * (1 - v), river = cloud(u, v, 6, 3, 5, 942);
    const double way = ramp(0.34, 0.0, std::abs(rise - 0.62 - 0.3 * wave(u + 0.1)) + 0.12 * river);
    Color c = mix(rgb(0x0b1230), rgb(0x27395f), ramp(0.7, 0.0, rise));
    c = c + rgb(0x3a4470) * (0.55 * way * (0.7 + 0.5 * river));
    const Cell star = cell_at(u, v, 150, 30, 1, 943);
    const double bright = fraction(star.tint * 13), size = 0.035 + 0.09 * bright * bright * bright * bright;
    const double shine = ramp(size + 0.06, size * 0.3, star.nearest) * (0.35 + 0.65 * bright) *
                         (fraction(star.tint * 5) < 0.45 + 0.5 * way ? 1 : 0);
    c = mix(c, mix(rgb(0xfff0d0), rgb(0xcfe0ff), fraction(star.tint * 31)), shine);
    const double mx = x - 1320, my = y - 150, moon = std::sqrt(mx * mx + my * my);
    c = c + rgb(0x8fa3c8) * (0.5 * ramp(120, 20, moon) * ramp(120, 20, moon));
    c = mix(c, rgb(0xf3efdd) * (1 + 0.16 * cloud(u, v, 120, 24, 3, 944)), ramp(27, 25, moon));
    for (int range = 0; range < 3; ++range) {
        const double crest =
            0.16 - 0.05 * range + (0.10 - 0.02 * range) * cloud(u, 0.21, 9 + 5 * range, 1, 6, 950 + range);
        const double cap = ramp(0.02, 0.05, rise - 0.05 * range - 0.05 + 0.04 * cloud(u, v, 60, 30, 3, 960 + range));
        const Color side = mix(mix(rgb(0x27395f), rgb(0x141c33), 0.3 + 0.3 * range), rgb(0x7f8fb0), 0.5 * cap);
        c = mix(c, side, ramp(0.003, 0.0, rise - crest));
    }
    return {c, 0};
}

}  // namespace

void draw_far_lands(const Album& album) {
    album.add("sand", 256, 256, sand);
    album.add("snow", 256, 256, snow);
    album.add("red_stone", 256, 256, red_stone);
    album.add("zellige", 256, 256, zellige);
    album.add("sky_night", 2048, 384, night);
}

}  // namespace draw_textures
