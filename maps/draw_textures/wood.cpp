// Wood: floors, panelling, doors, beams, and a wall of books.
#include "album.h"
#include "layout.h"
#include "stone.h"

namespace draw_textures {
namespace {

struct Timber {
    Color light, dark;
};

constexpr Timber kOak{rgb(0xa97a48), rgb(0x7a5230)};
constexpr Timber kWalnut{rgb(0x6b452c), rgb(0x432a1c)};
constexpr Timber kFir{rgb(0x9c8561), rgb(0x735d40)};

// Grain that runs along `a` and varies across `b`, both in tiles; `piece` makes every board its own.
Color timber_at(const Timber& t, double a, double b, double piece, int seed) {
    const double shift = std::floor(piece * 31);
    const double bend = 0.02 * cloud(a, b + shift * 0.37, 2, 4, 2, seed);
    const double rings = cloud(a + shift * 0.23, b + bend + shift * 0.61, 2, 24, 3, seed + 1);
    const double pores = cloud(a, b + bend, 8, 128, 1, seed + 2);
    return mix(t.light, t.dark, clamp01(0.42 + 0.55 * rings + 0.35 * (piece - 0.5))) * (1 + 0.05 * pores);
}

// Herringbone: blocks of 1 x 4 in a repeating zigzag.
Surface herringbone(double x, double y, double, double) {
    constexpr int kUnit = 16, kLength = 4;  // texels a block is wide, and widths it is long
    const double gx = x / kUnit, gy = y / kUnit;
    const int ix = static_cast<int>(std::floor(gx)), iy = static_cast<int>(std::floor(gy));
    const int phase = wrap(ix - iy, 2 * kLength);
    const bool lying = phase < kLength;
    const double along = lying ? phase + fraction(gx) : wrap(iy - ix - 1, 2 * kLength) + fraction(gy);
    const double across = lying ? fraction(gy) : fraction(gx);
    const int head = lying ? ix - phase : ix, row = lying ? iy : iy - wrap(iy - ix - 1, 2 * kLength);
    const double piece = random(wrap(head, 16), wrap(row, 16), lying ? 121 : 122);
    const double a = along / 16 + piece, b = across / 16 + std::floor(piece * 16) / 16;
    const double edge = std::min(std::min(along, kLength - along), std::min(across, 1 - across)) * kUnit;
    Color c = timber_at(kOak, a, b, piece, 123) * (0.92 + 0.16 * piece);
    c = c * (lying ? 1.05 : 0.96);
    return {mix(rgb(0x54361f), c, ramp(0.0, 0.7, edge)), 0.45 * ramp(0.1, 1.0, edge)};
}

// Square panels with a woven inside, as in the great rooms of Versailles.
Surface woven_parquet(double x, double y, double u, double v) {
    const double px = fraction(x / 128) * 128, py = fraction(y / 128) * 128;
    const double frame = std::min(std::min(px, 128 - px), std::min(py, 128 - py));
    double edge, a, b, piece;
    if (frame < 14) {
        const bool upright = std::min(px, 128 - px) < std::min(py, 128 - py);
        a = upright ? v : u;
        b = upright ? u : v;
        piece = random(static_cast<int>(x / 128) * 2 + (px > 64), static_cast<int>(y / 128) * 2 + (py > 64),
                       upright ? 131 : 132);
        edge = std::min(std::min(frame, 14 - frame), std::abs(std::min(px, 128 - px) - std::min(py, 128 - py)) * 0.7);
    } else {
        const double s = (px + py) / 25, t = (px - py) / 25 + 16;  // the weave lies cornerwise
        const int is = static_cast<int>(std::floor(s)), it = static_cast<int>(std::floor(t));
        const bool over = wrap(is + it, 2) == 0;
        const double fs = fraction(s), ft = fraction(t);
        a = over ? t / 12 : s / 12;
        b = over ? s / 12 : t / 12;
        piece = random(is, it, 133);
        const double side = over ? std::min(fs, 1 - fs) : std::min(ft, 1 - ft),
                     end = over ? std::min(ft, 1 - ft) : std::min(fs, 1 - fs);
        edge = std::min(std::min(side, end) * 17.6, frame - 14);
    }
    Color c = timber_at({rgb(0xb98a52), rgb(0x8a5f36)}, a, b, piece, 134) * (0.93 + 0.13 * piece);
    return {mix(rgb(0x6b482a), c, ramp(0.0, 0.8, edge)), 0.35 * ramp(0.1, 1.1, edge)};
}

// Floor boards with nails at their ends.
Painter boards(const Timber& timber, int seed) {
    return [=](double x, double y, double u, double v) {
        const Block b = block_at(y, x, 256, 256, 2, 8, 0.41, 0.4, seed);  // boards run down the picture
        const double nail = std::sqrt((b.y - 8) * (b.y - 8) + (b.x - 5) * (b.x - 5)),
                     edge = std::min(b.edge, b.width - b.x);
        Color c =
            timber_at(timber, v, u, b.tint, seed + 1) * (0.86 + 0.22 * b.tint + 0.06 * cloud(u, v, 2, 2, 3, seed + 5));
        c = mix(c, rgb(0x2a211b), ramp(2, 1.2, nail));
        return Surface{mix(rgb(0x1d1510), c, ramp(0.2, 1.4, edge)),
                       1.2 * ramp(0.2, 2.2, edge) - 0.6 * ramp(2.5, 1.5, nail)};
    };
}

// A raised field inside a moulded frame: returns its height; `edge` is the distance to the frame's border.
double raised_field(double edge, double border, double depth) {
    return depth * (ramp(border + 5, border + 1, edge) - 0.6 * ramp(2.0, 0.5, std::abs(edge - border - 6)) +
                    0.8 * ramp(border + 8, border + 20, edge));
}

// Oak panelling: two tall fields over one low one.
Surface panelling(double x, double y, double u, double v) {
    const bool low = y > 176;
    const double top = low ? 180 : 4, bottom = low ? 252 : 172;
    const double px = fraction(x / 64) * 64;
    const double edge = std::min(std::min(px, 64 - px), std::min(y - top + 6, bottom + 6 - y));
    const double rail = ramp(6, 4, std::abs(y - 176)) + ramp(5, 3, std::min(y, 256 - y));
    const Color c = timber_at(kOak, v, u, random(static_cast<int>(x / 64), low, 141), 142) * 0.92;
    const double h = raised_field(edge, 8, 2.2);
    return {mix(c, c * 0.8, ramp(1.5, 0, std::abs(edge - 14))), h + 2 * rail};
}

// One leaf of a painted door: three fields with gilded mouldings, a knob.
Surface door(double x, double y, double u, double v) {
    const double bounds[4] = {8, 92, 116, 248};
    const bool low = y > 104;
    const double top = low ? bounds[2] : bounds[0], bottom = low ? bounds[3] : bounds[1];
    const double edge = std::min(std::min(x, 128 - x) - 12, std::min(y - top, bottom - y));
    const double knob = std::sqrt((x - 118) * (x - 118) + (y - 140) * (y - 140)), seam = std::min(x, 128 - x);
    const double tone = cloud(u, v, 4, 6, 4, 151), brush = cloud(u, v, 64, 6, 2, 152);
    Color c = mix(rgb(0xe7e0cf), rgb(0xd3cbb8), 0.5 + 0.5 * tone) * (1 + 0.02 * brush);
    const double moulding = ramp(3.2, 2.2, std::abs(edge - 5));
    c = mix(c, gilding(u, v, 0.7, 153), moulding);
    c = mix(mix(c, gilding(u, v, 1, 154), ramp(5.2, 4.4, knob)), rgb(0x4b4236), ramp(1.2, 0.5, seam));
    return {c, raised_field(edge, 2, 1.6) + 1.5 * moulding + 3 * ramp(5.5, 2, knob)};
}

// Shelves full of books: every one its own width, height, leather and gilt bands.
Surface books(double x, double y, double u, double v) {
    const int shelf = static_cast<int>(y / 51.2);
    const double py = y - shelf * 51.2, board = 6;
    if (py > 51.2 - board || std::min(x, 256 - x) < 5) {
        const double face = std::min(std::max(py - (51.2 - board), std::min(x, 256 - x)), 3.0);
        return {timber_at(kWalnut, u, v, 0.3, 161) * 1.1, 4 + 0.4 * face};
    }
    double left = 5;
    int k = 0;
    double width = 0;
    for (;; ++k) {
        width = 6 + std::floor(9 * random(k, shelf, 162));
        if (x < left + width || left + width > 251) {
            break;
        }
        left += width;
    }
    const double top = 3 + 11 * random(k, shelf, 163), tint = random(k, shelf, 164);
    const double across = (x - left) / width, edge = std::min(x - left, left + width - x);
    if (py < top || (x > left && left + width > 251)) {
        return {rgb(0x150f0b), -3};
    }
    const Color leathers[6] = {rgb(0x7a3326), rgb(0x5b3a22), rgb(0x8a6a3f),
                               rgb(0x2f4436), rgb(0x2d3850), rgb(0xb9a884)};
    Color c = leathers[static_cast<int>(tint * 6)] * (0.8 + 0.35 * random(k, shelf, 165)) *
              (1 + 0.1 * cloud(u, v, 32, 32, 3, 166));
    const double down = (py - top) / (45 - top), band = std::min(std::abs(down - 0.16), std::abs(down - 0.84));
    const double label = ramp(0.09, 0.07, std::abs(down - 0.34)) * ramp(1, 2, edge);
    c = mix(c, fraction(tint * 17) < 0.5 ? rgb(0x5d1b1b) : rgb(0x2a1c14), 0.7 * label);
    c = mix(c, kGold,
            0.7 * std::max(ramp(0.03, 0.018, band), ramp(0.02, 0.01, std::abs(std::abs(down - 0.34) - 0.08))));
    return {c, 3.2 * wave(clamp01(across) / 2) * ramp(0, 2, py - top + 1)};
}

// Heavy beams under a boarded ceiling.
Surface beams(double x, double y, double u, double v) {
    const double px = fraction(x / 64) * 64,
                 edge = std::min(px, 64 - px) - 18;  // positive: the boards between two beams
    const int beam = wrap(static_cast<int>(std::floor(x / 64 + 0.5)), 4);
    if (edge < 0) {
        const Color c = timber_at(kWalnut, v, u, random(beam, 1, 171), 172) * (1.0 + 0.08 * cloud(u, v, 4, 4, 3, 173));
        return {c * (1 + 0.35 * ramp(3, 0, -edge)), 6 * ramp(0, 3, -edge)};
    }
    const Block b = block_at(x, y, 256, 256, 4, 8, 0, 0, 174);
    const Color c = timber_at(kFir, u, v, b.tint, 175) * (0.62 + 0.1 * b.tint);
    return {c * (0.6 + 0.4 * ramp(0, 9, edge)), -1.5 * ramp(1.2, 0.2, std::min(b.y, b.height - b.y))};
}

}  // namespace

void draw_wood(const Album& album) {
    album.add("parquet_herringbone", 256, 256, herringbone);
    album.add("parquet_woven", 256, 256, woven_parquet);
    album.add("boards", 256, 256, boards(kFir, 181));
    album.add("boards_dark", 256, 256, boards(kWalnut, 182));
    album.add("panelling", 128, 256, panelling);
    album.add("door", 128, 256, door);
    album.add("books", 256, 256, books);
    album.add("beams", 256, 256, beams);
}

}  // namespace draw_textures
