// Columns, steps, ledges, metal, and what one can look through.
#include "album.h"
#include "layout.h"
#include "stone.h"

namespace draw_textures {
namespace {

Painter slab(const Marble& marble, int seed) {
    return [=](double, double, double u, double v) { return Surface{marble_at(marble, u, v, 0, seed), 0}; };
}

// A fluted column, one face of it from capital to base: give it the column's height.
Surface fluted_column(double x, double y, double u, double v) {
    const double flute = fraction(x / 16) * 16 - 8;
    Color c = marble_at(kWhiteMarble, u, v, 0, 301);
    double h = 0;
    if (y < 10) {  // abacus
        h = 6 * ramp(10, 7, y) + 1;
    } else if (y < 40) {  // two rows of gilded leaves, the front row standing between the leaves of the other
        for (int row = 0; row < 2; ++row) {
            const double across = std::abs(fraction(x / 21.333 + 0.5 * row) - 0.5) * 21.333,
                         up = (40 - y) / (row == 0 ? 29 : 18);
            const double inside = 9.5 * std::sqrt(std::max(0.0, 1 - up * up * up)) - across;
            if (inside > 0 && up < 1) {
                h = 1 + 2 * row + 2.5 * ramp(0, 5, inside) + 2 * ramp(0.6, 0.95, up) - 1.5 * ramp(1.4, 0.4, across);
            }
        }
        c = mix(c * 0.8, gilding(u, v, 0.65, 302), 0.9 * ramp(0.4, 1.4, h));
    } else if (y < 46) {
        h = 3 * wave((y - 40) / 12);
        c = mix(c, gilding(u, v, 0.7, 303), 0.9);
    } else if (y < 226) {
        const double round = clamp01(1 - flute * flute / 40);
        h = -3.4 * round * ramp(46, 54, y) * ramp(226, 220, y);
    } else {  // torus, hollow, torus, plinth
        h = y < 244 ? 3 + 3 * std::abs(wave((y - 226) / 18)) : 6;
    }
    return {c, h};
}

// The front of a step: a rounded nosing on top, its shadow, a plain riser.
Painter step(const Marble& marble, int seed) {
    return [=](double x, double y, double u, double v) {
        const double nosing = ramp(11, 9, y), seam = ramp(1.2, 0.3, std::min(x, 128 - x));
        const Color c = marble_at(marble, u, v * 0.25, 0, seed) * (nosing > 0.5 ? 1.06 : 0.86 + 0.1 * ramp(10, 22, y));
        return Surface{c * (1 - 0.3 * seam) * (1 - 0.35 * ramp(29, 32, y)),
                       4 * nosing * wave(clamp01((y + 2) / 13) / 2) - seam};
    };
}

// Rough stone dressed to a ledge: steps and sills out of doors.
Surface stone_ledge(double x, double y, double u, double v) {
    const double grain = cloud(u, v, 24, 12, 4, 311), worn = cloud(u, v, 4, 2, 3, 312),
                 lip = ramp(15, 12, y + 2 * worn);
    const double seam = ramp(1.6, 0.5, std::min(x, 128 - x) + worn);
    const Color c =
        mix(rgb(0xb9ae97), rgb(0x978c78), 0.5 + 0.5 * worn) * (lip > 0.5 ? 1.06 : 0.84) * (1 + 0.08 * grain);
    return {c * (1 - 0.35 * seam), 3.5 * lip * ramp(-4, 5, y) + 0.8 * grain - 1.5 * seam};
}

// The upper side of the same stone: treads, sills, rims.
Surface dressed_stone(double, double, double u, double v) {
    const double grain = cloud(u, v, 24, 24, 4, 315), worn = cloud(u, v, 3, 3, 4, 316),
                 tooling = cloud(u, v, 4, 48, 2, 317);
    return {mix(rgb(0xbdb29b), rgb(0xa0957f), 0.5 + 0.5 * worn) * (1 + 0.05 * grain), 0.4 * grain + 0.5 * tooling};
}

// A gilded cornice: egg and dart between beads.
Surface cornice(double x, double y, double u, double v) {
    const double egg = std::sqrt(
        std::max(0.0, 1 - (fraction(x / 32) - 0.5) * (fraction(x / 32) - 0.5) * 7 - (y - 31) * (y - 31) / 210));
    const double bead = wave(fraction(x / 8) / 2) * ramp(4, 2, std::abs(y - 50)), top = 6 * ramp(17, 3, y);
    const double gold = std::max(ramp(0.1, 0.35, egg), ramp(0.2, 0.5, bead)), tone = cloud(u, v, 8, 4, 3, 321);
    const Color c = mix(mix(rgb(0xe6ddc8), rgb(0xc9bea6), y / 64) * (1 + 0.04 * tone), gilding(u, v, 0.75, 322), gold);
    return {c, top + 6 * egg + 3 * bead + 1.5 * ramp(5, 3, 64 - y)};
}

// The inside of a doorway: a long painted panel with a gilded line.
Surface reveal(double x, double y, double u, double v) {
    const bool low = y > 168;
    const double top = low ? 172 : 4, bottom = low ? 246 : 164,
                 edge = std::min(std::min(x, 64 - x), std::min(y - top, bottom - y));
    const double gold = ramp(2.4, 1.6, std::abs(edge - 11)), tone = cloud(u, v, 2, 6, 4, 331);
    const Color c = mix(mix(rgb(0xe6dfcf), rgb(0xd2c9b6), 0.5 + 0.5 * tone), gilding(u, v, 0.7, 332), gold);
    return {c * (0.9 + 0.1 * ramp(0, 5, std::min(x, 64 - x))), 1.6 * gold - 1.5 * ramp(13, 16, edge)};
}

// Plates of patinated bronze, riveted.
Surface bronze(double x, double y, double u, double v) {
    const Block b = block_at(x, y, 128, 128, 1, 2, 0.5, 0, 341);
    const double cx = std::min(b.x, b.width - b.x) - 8, cy = std::min(b.y, b.height - b.y) - 8;
    const double rivet = ramp(4, 2, std::sqrt(cx * cx + cy * cy)), grain = cloud(u, v, 16, 16, 4, 342),
                 run = cloud(u, v, 12, 2, 4, 343);
    Color c = mix(rgb(0x77592f), rgb(0x54401f), 0.5 + 0.5 * grain);
    c = mix(c, rgb(0x5d8573), 0.75 * ramp(0.05, 0.5, run + 0.25 * ramp(7, 1, b.edge)));
    return {mix(rgb(0x241c12), c, ramp(0.2, 1.3, b.edge)) + Color{1, 1, 0.8} * (0.08 * rivet),
            2.2 * ramp(0.3, 2.5, b.edge) + 3 * rivet + 0.4 * grain};
}

// Wrought iron: upright bars through two flats, with a scroll between. What is not iron is open.
Surface iron_grille(double x, double y, double u, double v) {
    const double px = fraction(x / 32) * 32 - 16, bar = 3.0 - std::abs(px);
    const double flat = 3.5 - std::min(std::abs(y - 12), std::min(std::abs(y - 116), std::abs(y - 44)));
    const double r = std::sqrt(px * px * 1.4 + (y - 28) * (y - 28)), scroll = 2.2 - std::abs(r - 12);
    const double iron = std::max(std::max(bar, flat), scroll), rust = cloud(u, v, 12, 12, 4, 351);
    const Color c = mix(rgb(0x33353a), rgb(0x4c3e35), ramp(0, 0.5, rust)) * (1 + 0.1 * rust);
    return {c, 2.5 * ramp(0, 2.5, iron), iron > 0 ? 1.0 : 0.0};
}

// A stone balustrade: turned balusters between rail and plinth; open between.
Surface balustrade(double x, double y, double u, double v) {
    const double px = std::abs(fraction(x / 32) * 32 - 16), t = (y - 24) / 84;
    const double belly = 4.2 + 6.2 * wave(clamp01((t - 0.22) / 0.70) / 2) * (0.55 + 0.45 * clamp01(t * 1.3)) +
                         3 * ramp(0.10, 0.04, t) + 2.5 * ramp(0.93, 0.98, t);
    const double baluster = belly - px, grain = cloud(u, v, 16, 16, 4, 361);
    const bool solid = y < 24 || y > 108;
    const Color c = mix(rgb(0xd3c8b0), rgb(0xb0a48b), 0.5 + 0.5 * grain);
    const double moulding = y < 24 ? 4 * ramp(24, 16, y) - 2 * ramp(2, 1, std::abs(y - 13)) : 3 * ramp(108, 113, y);
    const double h = solid ? moulding : std::sqrt(std::max(0.0, belly * belly - px * px)) * 0.8 - 5;
    return {c, h + 0.3 * grain, solid || baluster > 0 ? 1.0 : 0.0};
}

// A window of small leaded panes, some tinted. The glass lets most of the light through.
Surface leaded_window(double x, double y, double u, double v) {
    const double a = (x + y) / 32, b = (x - y) / 32, frame = std::min(std::min(x, 128 - x), std::min(y, 128 - y));
    const double lead = 23 * std::min(std::min(fraction(a), 1 - fraction(a)), std::min(fraction(b), 1 - fraction(b)));
    if (frame < 6) {
        return {rgb(0x6a5a46) * (1 + 0.1 * cloud(u, v, 16, 16, 3, 371)), 4 * ramp(0, 2, frame) * ramp(6, 4, frame), 1};
    }
    if (lead < 1.3) {
        return {rgb(0x3b3d40), 2, 1};
    }
    const double tint = random(wrap(static_cast<int>(std::floor(a)), 8), wrap(static_cast<int>(std::floor(b)), 8), 372);
    return {mix(rgb(0xb9cfc9), tint > 0.8 ? rgb(0xd9b45a) : rgb(0x8fb0b8), tint), 0, 0.35};
}

}  // namespace

void draw_trim(const Album& album) {
    album.add("marble_white", 128, 128, slab(kWhiteMarble, 381));
    album.add("marble_rose", 128, 128, slab(kRoseMarble, 382));
    album.add("marble_green", 128, 128, slab(kGreenMarble, 383));
    album.add("marble_black", 128, 128, slab(kBlackMarble, 384));
    album.add("column_fluted", 64, 256, fluted_column);
    album.add("step_marble", 128, 32, step(kWhiteMarble, 391));
    album.add("step_rose", 128, 32, step(kRoseMarble, 392));
    album.add("ledge", 128, 64, stone_ledge);
    album.add("stone", 128, 128, dressed_stone);
    album.add("cornice", 128, 64, cornice);
    album.add("reveal", 64, 256, reveal);
    album.add("bronze", 128, 128, bronze);
    album.add_with_alpha("iron_grille", 128, 128, iron_grille);
    album.add_with_alpha("balustrade", 128, 128, balustrade);
    album.add_with_alpha("leaded_window", 128, 128, leaded_window);
}

}  // namespace draw_textures
