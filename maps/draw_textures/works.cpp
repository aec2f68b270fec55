// The water-works: machines, gates, switches, and water that moves.
#include <array>

#include "album.h"
#include "layout.h"
#include "stone.h"

namespace draw_textures {
namespace {

constexpr int kFrames = 4;  // of moving water and slime

struct Turn {
    double c, s;
};

// Round the circle in as many steps as there are frames, so that the last frame leads into the first.
constexpr std::array<Turn, kFrames> kTurns = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

double distance(double x, double y, double cx, double cy) {
    return std::sqrt((x - cx) * (x - cx) + (y - cy) * (y - cy));
}

// How far from the straight line between two points.
double from_line(double x, double y, double ax, double ay, double bx, double by) {
    const double dx = bx - ax, dy = by - ay, t = clamp01(((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy));
    return distance(x, y, ax + t * dx, ay + t * dy);
}

Color iron(double u, double v, int seed) {
    const double grain = cloud(u, v, 24, 24, 4, seed), rust = cloud(u, v, 5, 5, 4, seed + 1);
    return mix(rgb(0x4a4d52), rgb(0x6b4a35), 0.7 * ramp(0.05, 0.6, rust)) * (1 + 0.10 * grain);
}

// Riveted plates of iron, `across` x `down` of them.
Painter plates(int width, int height, int across, int down, int seed) {
    return [=](double x, double y, double u, double v) {
        const Block b = block_at(x, y, width, height, across, down, 0, 0, seed);
        const double inset = 9, px = std::min(b.x, b.width - b.x), py = std::min(b.y, b.height - b.y);
        const double pitch = 22, along_x = std::abs(fraction(b.x / pitch) - 0.5) * pitch,
                     along_y = std::abs(fraction(b.y / pitch) - 0.5) * pitch;
        const double to_rivet = std::min(std::max(std::abs(py - inset), 0.0) + along_x + (px < 5 ? 9 : 0),
                                         std::max(std::abs(px - inset), 0.0) + along_y + (py < 5 ? 9 : 0));
        const double rivet = ramp(4, 1.5, to_rivet), seam = ramp(0.2, 1.6, b.edge);
        const double streak = ramp(0.1, 0.6, cloud(u, v, 18, 2, 3, seed + 5));
        Color c = iron(u, v, seed) * (0.9 + 0.16 * b.tint);
        c = mix(c, rgb(0x5f4030), 0.35 * streak);
        return Surface{mix(rgb(0x17181a), c, seam) + Color{1, 1, 1} * (0.06 * rivet), 2 * seam + 2.6 * rivet};
    };
}

// Yellow and black, worn.
Surface hazard(double x, double y, double u, double v) {
    const double stripe = fraction((x + y) / 32), edge = std::min(std::abs(stripe - 0.5), std::min(stripe, 1 - stripe));
    const double worn = ramp(0.15, 0.55, cloud(u, v, 10, 4, 4, 905));
    const Color paint = mix(stripe < 0.5 ? rgb(0xd7a62b) : rgb(0x25231f), rgb(0x5a5148), 0.7 * worn);
    return {paint * (1 + 0.06 * cloud(u, v, 32, 8, 2, 906)) * (1 - 0.25 * ramp(2, 0, std::min(y, 32 - y))),
            0.4 * (1 - worn) + 0.3 * edge};
}

// The block of a press: plates with a warning along its lower edge, 2 m x 4.25 m.
Surface press_face(double x, double y, double u, double v) {
    static const Painter upper = plates(256, 512, 2, 4, 907);
    return y < 512 ? upper(x, y, u, v) : hazard(fraction(x / 128) * 128, y - 512, fraction(2 * u), (y - 512) / 32);
}

// The front of a lift between its guides: a warning along its upper edge, braces below, 2 m x 3 m.
Surface lift_front(double x, double y, double u, double v) {
    static const Painter panel = plates(256, 352, 1, 2, 915);
    if (y < 32) return hazard(fraction(x / 128) * 128, y, fraction(2 * u), y / 32);
    const double py = fraction((y - 32) / 176) * 176, side = std::min(x, 256 - x);
    const double brace = std::min(from_line(x, py, 24, 12, 232, 164), from_line(x, py, 232, 12, 24, 164));
    const double bar = std::max(ramp(8, 7, brace) * ramp(16, 18, side), ramp(20, 19, side));
    Surface s = panel(x, y - 32, u, (y - 32) / 352);
    s.color = mix(s.color * (1 - 0.3 * ramp(14, 8, brace)), iron(u, v, 917) * 1.35, bar);
    s.height = mix({s.height, 0, 0}, {5 * ramp(8.5, 4, brace) + 4 * ramp(20, 17, side), 0, 0}, bar).r;
    return s;
}

// A tall window of many small panes with a lamp behind it, 1.5 m x 2.25 m.
Surface window_lit(double x, double y, double u, double v) {
    const double frame = std::min(std::min(x, 128 - x), std::min(y, 192 - y));
    const double px = fraction((x - 8) / 28) * 28, py = fraction((y - 8) / 35.2) * 35.2;
    const double bar = std::min(std::min(px, 28 - px), std::min(py, 35.2 - py));
    if (frame < 8) return {rgb(0x5c5346) * (1 + 0.1 * cloud(u, v, 16, 16, 3, 919)), 4 * ramp(0, 3, frame)};
    const double pane = random(static_cast<int>((x - 8) / 28), static_cast<int>((y - 8) / 35.2), 920);
    const double near_lamp = ramp(120, 10, distance(x, y, 64, 118)), waves = cloud(u, v, 6, 9, 3, 918);
    const Color glass = mix(rgb(0x8a5420), rgb(0xffd98a), near_lamp) * (0.88 + 0.2 * pane + 0.08 * waves);
    return {mix(rgb(0x2c2a28), glass, ramp(1.2, 2.2, bar)), 2 * ramp(2.4, 1, bar)};
}

// A round lamp of thick amber glass behind bars.
Surface lamp(double x, double y, double u, double v) {
    const double r = distance(x, y, 32, 32), edge = std::min(std::min(x, 64 - x), std::min(y, 64 - y));
    const double glass = ramp(24, 22.5, r), hot = ramp(20, 2, distance(x, y, 29, 28));
    const double bars = ramp(2.2, 1.2, std::min(std::abs(x - 32), std::abs(y - 32))) * glass,
                 ring = ramp(4, 2.5, std::abs(r - 25));
    Color c = mix(iron(u, v, 909), mix(rgb(0xd0641c), rgb(0xffe29a), hot), glass);
    c = mix(c, rgb(0x3a3630), bars);
    return {mix(c, rgb(0x8a7038), ring) * (1 - 0.4 * ramp(2, 0.5, edge)),
            3 * ring + 2.5 * glass * (1 - r * r / 900) + 2 * bars};
}

// Chequer plate: short raised bars, every other one across.
Surface chequer_plate(double x, double y, double u, double v) {
    const int ix = static_cast<int>(std::floor(x / 16)), iy = static_cast<int>(std::floor(y / 16));
    const double px = fraction(x / 16) * 16 - 8, py = fraction(y / 16) * 16 - 8;
    const double a = (px + py) * 0.7071, b = (px - py) * 0.7071;
    const bool odd = wrap(ix + iy, 2) == 1;
    const double bar = 1 - std::sqrt((odd ? a * a : b * b) / 42 + (odd ? b * b : a * a) / 4.5);
    const double rim = std::min(std::min(x, 128 - x), std::min(y, 128 - y));
    const double raised = ramp(0, 0.35, bar) * ramp(5, 7, rim), frame = ramp(7, 5, rim);
    const Color c = iron(u, v, 911) * (0.95 + 0.3 * raised + 0.1 * frame);
    return {c * (1 - 0.5 * ramp(1.2, 0.3, rim)), 1.6 * raised + 1.8 * frame};
}

// A gate's leaf of upright planks with two iron bands, 2 m x 2.25 m; `lock` adds a brass plate with a keyhole.
Painter gate_leaf(bool lock) {
    return [=](double x, double y, double u, double v) {
        const int plank = static_cast<int>(x / 32);
        const double px = fraction(x / 32) * 32, seam = std::min(px, 32 - px), tint = random(plank, 3, 921);
        const double rings = cloud(u + 0.13 * plank, v * 0.5 + tint, 16, 2, 4, 922), pores = cloud(u, v, 96, 6, 2, 923);
        Color c =
            mix(rgb(0x6f7f4f), rgb(0x46573a), clamp01(0.5 + 0.5 * rings + 0.4 * (tint - 0.5))) * (1 + 0.06 * pores);
        c = mix(c, rgb(0x8a6a45), 0.55 * ramp(0.25, 0.6, rings + 0.3 * pores));  // paint has worn off to the wood
        c = c * (1 - 0.55 * ramp(1.8, 0.6, seam)) * (1 - 0.3 * ramp(3, 0, std::min(y, 288 - y)));
        double h = 1.4 * ramp(0.5, 3, seam);
        const double band = std::min(std::abs(y - 58), std::abs(y - 230)), iron_band = ramp(12.5, 11.5, band);
        const double rivet = ramp(4.6, 2.5, distance(px, band, 16, 0));
        c = mix(c, iron(u, v, 924), iron_band) + Color{1, 1, 1} * (0.07 * rivet);
        h = std::max(h, 3 * iron_band) + 2.2 * rivet;
        if (lock) {
            const double plate = std::max(std::abs(x - 128) - 22, std::abs(y - 146) - 30);
            const double hole =
                std::min(distance(x, y, 128, 140) - 6, std::max(std::abs(x - 128) - 2.6, std::abs(y - 150) - 12));
            c = mix(c, rgb(0xd0a548) * (1 + 0.10 * cloud(u, v, 20, 20, 3, 925)), ramp(0.7, -0.7, plate));
            c = mix(c, rgb(0x120d08), ramp(0.8, -0.6, hole));
            h = plate < 0 ? 4.2 * ramp(0, 4, -plate) - 3 * ramp(0.8, -0.6, hole) : h;
        }
        return Surface{c, h};
    };
}

// A cast plate with a lever in a slot and a small lamp; off: lever down, lamp red; on: lever up, lamp green.
Painter lever_switch(bool on) {
    return [=](double x, double y, double u, double v) {
        const double edge = std::min(std::min(x, 96 - x), std::min(y, 96 - y));
        const double corner = distance(std::min(x, 96 - x), std::min(y, 96 - y), 11, 11);
        const double screw = ramp(4.5, 3, corner), slot = std::max(std::abs(x - 42) - 5, std::abs(y - 50) - 26);
        Color c = iron(u, v, 931) * 1.15 * (1 - 0.4 * ramp(2, 0.5, edge));
        double h = 3 * ramp(0.5, 5, edge) + 1.5 * screw;
        c = mix(c, rgb(0x0e0e10), ramp(0.6, -0.6, slot));
        h -= 3 * ramp(1, -1, slot);
        const double tip = on ? 24 : 76, arm = from_line(x, y, 42, 50, 42, tip), knob = distance(x, y, 42, tip);
        c = mix(c, rgb(0xb9b4a6), ramp(4.4, 3.4, arm));
        c = mix(c, mix(rgb(0x7d1f18), rgb(0xd2513c), ramp(9, 1, distance(x, y, 39, tip - 3))), ramp(10, 9, knob));
        h = std::max({h, 6 * ramp(4.6, 2, arm), 9 * ramp(10.5, 4, knob)});
        const double lamp = distance(x, y, 74, 48), glow = ramp(16, 6, lamp);
        const Color shine = on ? rgb(0x6bf08a) : rgb(0xf0583c);
        c = mix(c, rgb(0xb48a3c), ramp(11, 10, lamp));
        c = mix(c, shine * (0.7 + 0.5 * ramp(8, 1, distance(x, y, 72, 45))), ramp(8.2, 7, lamp)) +
            shine * (0.12 * glow);
        return Surface{c, std::max(h, 4 * ramp(11, 6, lamp))};
    };
}

// A valve's wheel on a flange; turned by an eighth once it was used, and its mark gone from red to green.
Painter valve(bool on) {
    return [=](double x, double y, double u, double v) {
        const double edge = std::min(std::min(x, 96 - x), std::min(y, 96 - y));
        const double dx = x - 48, dy = y - 48, r = std::sqrt(dx * dx + dy * dy);
        const double a = on ? (dx + dy) * 0.7071 : dx, b = on ? (dx - dy) * 0.7071 : dy;
        Color c = mix(rgb(0x3f6f63), iron(u, v, 941), 0.45) * (1 - 0.4 * ramp(2, 0.5, edge));
        double h = 2.5 * ramp(0.5, 5, edge);
        const double bolt = ramp(4.5, 3, distance(std::abs(dx), std::abs(dy), 38, 38));
        const double spoke = std::min(std::abs(a), std::abs(b)), rim = std::abs(r - 31);
        const double wheel = std::max({ramp(5, 4, rim), r < 31 ? ramp(3.6, 2.6, spoke) : 0.0, ramp(9, 8, r)});
        const Color paint = on ? rgb(0x4f9a55) : rgb(0xb8402c);
        c = mix(c * (1 - 0.35 * ramp(6, 0, std::abs(r - 34) - 3)), paint * (1 + 0.1 * cloud(u, v, 16, 16, 3, 943)),
                wheel);
        c = mix(c, rgb(0xd0a548), ramp(5, 4, r));
        h = std::max(h + 1.5 * bolt, wheel * (7 - 0.12 * rim * rim) * ramp(5.4, 2, std::min({rim, spoke, r})));
        return Surface{c, h};
    };
}

// Running water: a net of light that shivers.
Painter water(Turn t) {
    return [=](double, double, double u, double v) {
        const double cu = u + 0.05 * t.c, cv = v + 0.05 * t.s;
        const double du = 0.05 * cloud(cu, cv, 4, 4, 3, 951), dv = 0.05 * cloud(cv, cu, 4, 4, 3, 952);
        const Cell a = cell_at(u + du, v + dv, 5, 5, 0.9, 953), b = cell_at(u - dv, v + du, 8, 8, 0.9, 954);
        const double light = 0.6 * ramp(0.13, 0, a.edge) + 0.4 * ramp(0.14, 0, b.edge),
                     deep = cloud(u, v, 2, 2, 4, 955);
        Color c = mix(rgb(0x3d8288), rgb(0x245a68), 0.5 + 0.5 * deep);
        c = mix(c, rgb(0xbfe6dc), 0.5 * light * (0.7 + 0.3 * deep));
        return Surface{c, 0.9 * cloud(u + du, v + dv, 5, 5, 3, 956)};
    };
}

// Something green that works: bubbles that grow and burst, each in its own time.
Painter slime(int frame) {
    return [=](double, double, double u, double v) {
        const Turn t = kTurns[static_cast<std::size_t>(frame)];
        const double du = 0.06 * cloud(u + 0.04 * t.c, v + 0.04 * t.s, 3, 3, 3, 961);
        const double flow = cloud(u + du, v - du, 3, 3, 5, 962), fine = cloud(u - du, v + du, 12, 12, 3, 963);
        Color c = mix(rgb(0x6fb52c), rgb(0x2f5c17), clamp01(0.5 + 0.9 * flow)) * (1 + 0.10 * fine);
        c = mix(c, rgb(0xc9f06a), 0.6 * ramp(0.07, 0, std::abs(flow)));
        const Cell cell = cell_at(u, v, 9, 9, 0.7, 964);
        const double age = fraction(cell.tint * 5 + frame / static_cast<double>(kFrames)), radius = 0.06 + 0.26 * age;
        const double rim = fraction(cell.tint * 17) < 0.45 ? ramp(0.05, 0, std::abs(cell.nearest - radius)) : 0;
        return Surface{mix(c, rgb(0xe2ff9c), 0.7 * rim * (1 - 0.6 * age)), 2 * flow + 2.2 * rim};
    };
}

// Falling water in strands; `thin`: through its gaps one sees what is behind.
Painter waterfall(bool thin) {
    return [=](double, double, double u, double v) {
        const double bend = 0.02 * cloud(u, v, 3, 3, 3, 971);
        const double strands = cloud(u + bend, v, 22, 2, 3, 972), threads = cloud(u + bend, v, 40, 3, 3, 973);
        const double foam = ramp(-0.45, 0.8, strands + 0.8 * threads);
        const Color c = mix(rgb(0x2f6c78), rgb(0xd9f2f0), foam) * (1 + 0.05 * cloud(u, v, 32, 32, 2, 974));
        return Surface{c, 2 * strands + threads, thin ? clamp01(0.35 + 0.75 * foam) : 1.0};
    };
}

// A belt of rubber slats with a paler line, so that one sees it run.
Surface belt(double x, double y, double u, double v) {
    const double px = fraction(x / 32) * 32, seam = std::min(px, 32 - px), side = std::min(y, 128 - y);
    const double worn = cloud(u, v, 8, 8, 4, 981);
    Color c = mix(rgb(0x3b3834), rgb(0x57524a), 0.5 + 0.5 * worn);
    c = mix(c, rgb(0x9a7f3c), 0.8 * ramp(3, 2, std::abs(px - 16)) * ramp(-0.4, 0.1, worn));
    const double edge = ramp(9, 7, side);
    c = mix(c * (1 - 0.6 * ramp(2, 0.6, seam)), iron(u, v, 982) * 1.1, edge);
    return {c, 1.8 * ramp(0.5, 3.5, seam) + 2 * edge};
}

// A disc with rings and signs, on dark stone.
Surface pad(double x, double y, double u, double v) {
    const double dx = x - 64, dy = y - 64, r = std::sqrt(dx * dx + dy * dy);
    const Color stone = mix(rgb(0x3a3647), rgb(0x2a2836), 0.5 + 0.5 * cloud(u, v, 6, 6, 4, 991));
    const double rings = std::max(
        {ramp(2.4, 1.4, std::abs(r - 58)), ramp(1.8, 0.8, std::abs(r - 42)), ramp(1.8, 0.8, std::abs(r - 20))});
    const double three = std::min(
        {from_line(x, y, 64, 24, 98.6, 84), from_line(x, y, 98.6, 84, 29.4, 84), from_line(x, y, 29.4, 84, 64, 24)});
    const double gold = std::max({rings, ramp(2.2, 1.2, three), ramp(8, 7, r)});
    return {mix(stone * (1 + 0.25 * ramp(60, 0, r)), mix(rgb(0x7fe0e8), rgb(0xd8fbff), ramp(50, 0, r)), gold),
            1.6 * gold};
}

}  // namespace

void draw_works(const Album& album) {
    album.add("iron_plates", 256, 256, plates(256, 256, 2, 2, 901));
    album.add("iron_shutter", 256, 288, plates(256, 288, 1, 4, 903));
    album.add("press_face", 256, 544, press_face);
    album.add("lift_front", 256, 384, lift_front);
    album.add("window_lit", 128, 192, window_lit);
    album.add("lamp", 64, 64, lamp);
    album.add("hazard", 128, 32, hazard);
    album.add("chequer_plate", 128, 128, chequer_plate);
    album.add("gate_leaf", 256, 288, gate_leaf(false));
    album.add("gate_leaf_lock", 256, 288, gate_leaf(true));
    album.add("lever_off", 96, 96, lever_switch(false));
    album.add("lever_on", 96, 96, lever_switch(true));
    album.add("valve_off", 96, 96, valve(false));
    album.add("valve_on", 96, 96, valve(true));
    for (int frame = 0; frame < kFrames; ++frame) {
        album.add("stream_" + std::to_string(frame + 1), 256, 256, water(kTurns[static_cast<std::size_t>(frame)]));
        album.add("slime_" + std::to_string(frame + 1), 256, 256, slime(frame));
    }
    album.add("waterfall", 256, 256, waterfall(false));
    album.add_with_alpha("waterfall_veil", 256, 256, waterfall(true));
    album.add("belt", 128, 128, belt);
    album.add("pad", 128, 128, pad);
}

}  // namespace draw_textures
