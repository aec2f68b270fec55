// The walls and ceilings of a palace. A salon wall is one whole wall from cornice to skirting: give it the room's
// height.
#include "album.h"
#include "stone.h"

namespace draw_textures {
namespace {

constexpr int kWallWidth = 192, kWallHeight = 384;
constexpr double kCornice = 44, kRail = 268, kDado = 284,
                 kSkirting = 362;  // rows where the parts of a salon wall begin

// How far (x, y) is inside a leaf from its base to its tip; negative outside.
double leaf(double x, double y, double bx, double by, double tx, double ty, double plump) {
    const double dx = tx - bx, dy = ty - by, length = std::sqrt(dx * dx + dy * dy);
    const double t = ((x - bx) * dx + (y - by) * dy) / (length * length), s = ((x - bx) * dy - (y - by) * dx) / length;
    return t < 0 || t > 1 ? -1 : plump * wave(t / 2) * (1.25 - 0.6 * t) - std::abs(s);
}

// The damask's figure: palmettes in a net of ogees. x and y in half repeats; how far inside the figure.
double damask(double x, double y) {
    double ax = std::abs(fraction((x + 1) / 2) * 2 - 1), ay = fraction((y + 1) / 2) * 2 - 1;
    const auto cosine = [](double t) { return wave(t / 2 + 0.25); };
    const double net = cosine(ax) + cosine(ay) + 0.34 * cosine(3 * ay) * (1 - 0.5 * ax);
    double inside = 0.05 - 0.28 * std::abs(std::abs(net) - 0.13);
    if (net < 0) {  // the staggered palmette
        ax = 1 - ax;
        ay = ay > 0 ? ay - 1 : ay + 1;
    }
    const double leaves[8] = {
        leaf(ax, ay, 0, 0.1, 0, -0.66, 0.13),         leaf(ax, ay, 0.05, 0.08, 0.30, -0.45, 0.085),
        leaf(ax, ay, 0.08, 0.12, 0.47, -0.20, 0.075), leaf(ax, ay, 0.08, 0.18, 0.52, 0.10, 0.06),
        leaf(ax, ay, 0.05, 0.22, 0.36, 0.40, 0.06),   leaf(ax, ay, 0.02, 0.26, 0.15, 0.58, 0.05),
        leaf(ax, ay, 0, 0.30, 0, 0.72, 0.05),         0.10 - std::sqrt(ax * ax + (ay - 0.18) * (ay - 0.18))};
    for (const double l : leaves) {
        inside = std::max(inside, l);
    }
    return inside;
}

// Mouldings seen from the front are a profile over the rows: this one rises and falls like cyma, fillet and bead.
double cornice_profile(double y) {
    return 9 * ramp(kCornice, 4, y) + 1.4 * wave(y / 11) * ramp(kCornice, kCornice - 4, y) +
           2 * ramp(3, 0, std::abs(y - 17));
}

// The band under the ceiling: white mouldings, two of them gilded, and a row of dentils.
Surface cornice_band(double x, double y, double u, double v, double tone) {
    const double dentil = ramp(0.18, 0.28, std::abs(fraction(x / 12) - 0.5)) * ramp(12, 10, std::abs(y - 30) * 2.2);
    const bool gilt = std::abs(y - 17) < 3.5 || y > 39;
    const Color c = gilt ? gilding(u, v, 0.8, 222) : mix(rgb(0xeee7d6), rgb(0xd8cfba), y / kCornice) * tone;
    return {c * (1 - 0.25 * dentil), cornice_profile(y) - 3 * dentil};
}

// Silk for the field of the wall: two tones of one colour, the figure a little raised.
Surface silk(double x, double y, double u, double v, Color ground, Color figure) {
    const double inside = damask(x / 48, y / 66), weave = cloud(u, v, 96, 24, 1, 201), fold = cloud(u, v, 3, 2, 3, 202);
    const double t = ramp(-0.012, 0.016, inside), satin = ramp(0.02, 0.10, inside);
    Color c = mix(ground, figure, t * (0.8 + 0.2 * satin)) * (1 + 0.05 * weave + 0.05 * fold);
    return {c, 0.5 * t + 0.12 * weave};
}

// White boards for the field: a tall panel in a gilded moulding with a palmette at its head.
Surface white_panel(double x, double y, double u, double v) {
    const double px = fraction(x / 96) * 96,
                 edge = std::min(std::min(px, 96 - px) - 9, std::min(y - 10, kRail - kCornice - 9 - y));
    const double gold = ramp(3.4, 2.6, std::abs(edge - 4)), line = ramp(1.1, 0.4, std::abs(edge - 12));
    const double head = leaf(std::abs(px - 48), y - 40, 0, 14, 0, -16, 5),
                 side = leaf(std::abs(px - 48), y - 40, 1, 12, 14, -9, 4);
    const double foot = leaf(std::abs(px - 48), y - 40, 2, 14, 18, 8, 3),
                 palmette = ramp(-0.4, 0.5, std::max(std::max(head, side), foot));
    const double tone = cloud(u, v, 3, 6, 4, 211);
    Color c = mix(rgb(0xece6d8), rgb(0xdad2c0), 0.5 + 0.5 * tone);
    c = mix(c, rgb(0xcfd5d2), 0.6 * ramp(9, 11, edge));
    c = mix(c, gilding(u, v, 0.75, 212), std::max(std::max(gold, palmette), 0.8 * line));
    return {c, 1.8 * gold + 1.4 * palmette + 0.5 * line - 0.8 * ramp(6, 9, edge)};
}

using Field = std::function<Surface(double, double, double, double)>;

Painter salon_wall(const Field& field, Color paint, Color dado) {
    return [=](double x, double y, double u, double v) {
        const double tone = 1 + 0.03 * cloud(u, v, 4, 8, 4, 221);
        if (y < kCornice) {
            return cornice_band(x, y, u, v, tone);
        }
        if (y < kRail) {
            Surface s = field(x, y - kCornice, u, v);
            s.color = s.color * (0.78 + 0.22 * ramp(kCornice, kCornice + 26, y));  // the cornice's shadow
            return s;
        }
        if (y < kDado) {
            const bool gilt = y > kRail + 4 && y < kRail + 9;
            const double h =
                4 * wave(clamp01((y - kRail) / (kDado - kRail)) / 2) + 1.5 * ramp(3, 1, std::abs(y - kRail - 6.5));
            return Surface{gilt ? gilding(u, v, 0.8, 223) : paint * tone, h};
        }
        if (y < kSkirting) {
            const double px = fraction(x / 96) * 96;
            const double edge = std::min(std::min(px, 96 - px) - 8, std::min(y - kDado - 6, kSkirting - 7 - y));
            const double gold = ramp(2.6, 1.8, std::abs(edge - 3)), inner = ramp(7, 9, edge);
            const Color c = mix(mix(paint, dado, inner) * tone, gilding(u, v, 0.7, 224), gold);
            return Surface{c * (0.86 + 0.14 * ramp(kDado, kDado + 9, y)), 1.6 * gold + 1.1 * inner};
        }
        const double h = 3 * ramp(kSkirting, kSkirting + 5, y) + 1.2 * ramp(2.5, 0.5, std::abs(y - kSkirting - 7));
        return Surface{paint * (0.72 * tone) * (1 - 0.25 * ramp(376, 384, y)), h};
    };
}

// A stucco ceiling: round coffers with rosettes, a gilded fret between.
Painter rosettes(Color ground, Color hollow, bool gilt) {
    return [=](double x, double y, double u, double v) {
        const double px = fraction(x / 128) * 128 - 64, py = fraction(y / 128) * 128 - 64;
        const double r = std::sqrt(px * px + py * py), edge = 64 - std::max(std::abs(px), std::abs(py));
        const double ring = ramp(4, 2.5, std::abs(r - 47)), rib = ramp(7, 5, edge), tone = cloud(u, v, 4, 4, 4, 231);
        double petals = 0;  // eight leaves: four straight, four diagonal
        const double ax = std::abs(px), ay = std::abs(py), dx = std::abs(px + py) * 0.707,
                     dy = std::abs(px - py) * 0.707;
        for (const double l : {leaf(ax, ay, 3, 0, 34, 0, 8), leaf(ax, ay, 0, 3, 0, 34, 8), leaf(dx, dy, 3, 0, 29, 0, 6),
                               leaf(dx, dy, 0, 3, 0, 29, 6)}) {
            petals = std::max(petals, ramp(-0.5, 3, l));
        }
        const double boss = ramp(8, 5, r), deep = ramp(44, 40, r),
                     corner = ramp(14, 12, 90.5 - r) * ramp(0, 1, 90.5 - r);
        Color c = mix(ground, hollow, deep) * (1 + 0.04 * tone);
        const double gold =
            std::max(std::max(0.85 * petals, boss), std::max(ring * 0.9, 0.8 * ramp(1.4, 0.6, std::abs(edge - 9))));
        c = mix(c, gilt ? gilding(u, v, 0.6 + 0.4 * petals, 232) : ground * 1.03, std::max(gold, 0.7 * corner));
        return Surface{c, 3 * rib + 2.5 * ring - 4 * deep + 4 * petals + 3 * boss + 1.5 * corner};
    };
}

// Deep square coffers of walnut, one inside the other, gilded at the lips.
Surface coffers(double x, double y, double u, double v) {
    const double px = fraction(x / 128) * 128, py = fraction(y / 128) * 128;
    const double edge = std::min(std::min(px, 128 - px), std::min(py, 128 - py));
    const bool upright = std::min(px, 128 - px) < std::min(py, 128 - py);
    const double grain = cloud(upright ? v : u, upright ? u : v, 3, 48, 2, 241), tone = cloud(u, v, 4, 4, 3, 242);
    const double r = std::sqrt((px - 64) * (px - 64) + (py - 64) * (py - 64));
    const double two = ((px - 64) * (px - 64) - (py - 64) * (py - 64)) / (r * r + 0.01),
                 four = 2 * two * two - 1;  // cosines
    Color c = mix(rgb(0x6d4930), rgb(0x4b301f), 0.5 + 0.5 * grain) * (1 + 0.08 * tone);
    c = c * (edge < 20 ? 1.12 : edge < 38 ? 0.9 : 0.7);
    const double flower = ramp(0.2, 1.6, 13 + 2.5 * (2 * four * four - 1) - r);
    c = mix(c, rgb(0x31405a), 0.55 * ramp(38, 40, edge));
    c = mix(c, gilding(u, v, 0.6, 243),
            std::max(std::max(ramp(1.8, 1, std::abs(edge - 21)), ramp(1.6, 0.9, std::abs(edge - 39))), flower));
    return {c, 3 * ramp(0, 3, edge) - 6 * ramp(18, 24, edge) - 6 * ramp(36, 42, edge) + 5 * flower * ramp(15, 4, r) +
                   2 * ramp(4, 3, r)};
}

// A painted sky in a gilded frame, for a ceiling that wants to be higher than it is.
Surface fresco(double x, double y, double u, double v) {
    const double edge = std::min(std::min(x, 256 - x), std::min(y, 256 - y));
    const double du = u - 0.5, dv = v - 0.5, r = std::sqrt(du * du + dv * dv);
    const double swirl =
        cloud(u + 0.15 * cloud(u, v, 2, 2, 3, 251), v + 0.15 * cloud(u, v, 2, 2, 3, 252), 3, 3, 5, 253);
    const double shade = cloud(u + 0.1 * swirl, v + 0.03, 4, 4, 5, 254),
                 cover = ramp(-0.10, 0.22, swirl + 1.7 * r - 0.52);
    Color c = mix(rgb(0xf2dca6), rgb(0x7fa4c9), ramp(0.0, 0.26, r + 0.12 * swirl));
    c = mix(c, mix(rgb(0xf6e3c0), rgb(0xa08488), clamp01(0.45 + 0.9 * shade)), cover);
    c = c * (0.8 + 0.2 * ramp(20, 46, edge));
    const double frame = ramp(24, 22, edge),
                 bead = ramp(4.5, 2, std::abs(edge - 18)) * (0.6 + 0.4 * wave((x + y) / 10));
    c = mix(c, edge > 12 || edge < 3 ? gilding(u, v, 0.5 + 0.5 * bead, 256) : rgb(0xe2d8c2), frame);
    return {c, frame * (2 + 4 * wave(clamp01(edge / 24) / 2) + 1.5 * bead)};
}

// A far landscape at evening: ranges of hills, each nearer one lower, darker and rougher.
Color landscape(double u, double v, double t) {
    const double haze = ramp(0, 0.6, t), billow = cloud(u, v, 6, 3, 5, 523);
    Color c = mix(rgb(0x7d9fbe), rgb(0xf0d9a8), haze);
    c = mix(c, mix(rgb(0xf2e2c4), rgb(0xb99a8c), haze), ramp(0.05, 0.4, billow));
    const Color hills[4] = {rgb(0x8fa3a6), rgb(0x7d9380), rgb(0x6d8152), rgb(0x4f6238)};
    for (int k = 0; k < 4; ++k) {
        const double top = 0.5 + 0.12 * k - 0.14 * value_noise(u * (4 + 2 * k), 0.5, 4 + 2 * k, 1, 524 + k) -
                           0.03 * k * cloud(u, v, 12, 5, 3, 528 + k);
        c = mix(c, hills[k] * (1 + 0.12 * cloud(u, v, 24, 12, 3, 532 + k)), ramp(-0.01, 0.01, t - top));
    }
    return c;
}

// What stands over a door, up to the ceiling: the cornice, and under it a painting between two white panels.
constexpr int kOverdoorWidth = 336, kOverdoorHeight = 105;

Surface overdoor(double x, double y, double u, double v) {
    const double tone = 1 + 0.03 * cloud(u, v, 4, 2, 4, 221), ax = std::abs(x - kOverdoorWidth / 2.0);
    if (y < kCornice) {
        return cornice_band(x, y, u, v, tone);
    }
    const double high = std::min(y - kCornice - 3, kOverdoorHeight - 2 - y), painting = std::min(112 - ax, high);
    const double panel = std::min(std::min(ax - 118, 164 - ax), high), line = ramp(2.6, 1.8, std::abs(panel - 3));
    if (painting > 6) {
        return {landscape(u, v, (y - kCornice - 9) / (kOverdoorHeight - kCornice - 17)) *
                    (0.8 + 0.2 * ramp(6, 14, painting)),
                -2};
    }
    if (painting > 0) {
        return {gilding(u, v, 0.6 + 0.3 * wave((x + y) / 9), 521), 3 * wave(clamp01(painting / 6) / 2)};
    }
    const Color board = mix(rgb(0xe3dccb), rgb(0xcfd5d2), ramp(7, 9, panel)) * tone;
    return {mix(board, gilding(u, v, 0.7, 224), line) * (0.85 + 0.15 * ramp(kCornice, kCornice + 20, y)), 1.6 * line};
}

}  // namespace

void draw_salon(const Album& album) {
    const auto damask_of = [](Color ground, Color figure) {
        return [=](double x, double y, double u, double v) { return silk(x, y, u, v, ground, figure); };
    };
    const Color white = rgb(0xe3dccb);
    album.add("salon_red", kWallWidth, kWallHeight,
              salon_wall(damask_of(rgb(0x7a1f26), rgb(0xa4383a)), white, rgb(0xd2c6ae)));
    album.add("salon_green", kWallWidth, kWallHeight,
              salon_wall(damask_of(rgb(0x4c6a4e), rgb(0x7d9a70)), white, rgb(0xb9c3a4)));
    album.add("salon_blue", kWallWidth, kWallHeight,
              salon_wall(damask_of(rgb(0x31507a), rgb(0x6486ae)), white, rgb(0xb4c0cc)));
    album.add("salon_yellow", kWallWidth, kWallHeight,
              salon_wall(damask_of(rgb(0xc2923f), rgb(0xe0bb6c)), white, rgb(0xdcc894)));
    album.add("salon_white", kWallWidth, kWallHeight, salon_wall(white_panel, white, rgb(0xcfd5d2)));
    album.add("overdoor", kOverdoorWidth, kOverdoorHeight, overdoor);
    album.add("ceiling_rosettes", 256, 256, rosettes(rgb(0xe6dfcf), rgb(0xd4ccb9), true));
    album.add("ceiling_stucco", 256, 256, rosettes(rgb(0xe2ddd2), rgb(0xcfc9bb), false));
    album.add("ceiling_coffers", 256, 256, coffers);
    album.add("ceiling_fresco", 256, 256, fresco);
}

}  // namespace draw_textures
