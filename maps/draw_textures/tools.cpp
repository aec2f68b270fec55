// What lies and stands in the water-works: key, phial, crate, brazier, the fire on the hearth.
#include "album.h"
#include "figure.h"

namespace draw_textures {
namespace {

constexpr double kSize = 64;  // texels per metre of all of them

// A brass key that hangs upright in the air, turned by some eighths.
Matter key(Vec3 p) {
    const Vec3 ring = p - Vec3{0, 0, 0.52};
    const double bow = std::sqrt(ring.y * ring.y + ring.z * ring.z), loop = bow - 0.08;
    const double hoop = std::sqrt(loop * loop + ring.x * ring.x) - 0.028;
    const double shaft = stick(p, {0, 0, 0.14}, {0, 0, 0.44}, 0.025);
    const double bit =
        std::min(box(p, {0, 0.06, 0.17}, {0.018, 0.05, 0.03}), box(p, {0, 0.055, 0.26}, {0.018, 0.04, 0.022}));
    return {std::min({hoop, shaft, bit}), rgb(0xe3b552) * (1 + 0.1 * cloud(p.y * 3, p.z * 3, 4, 4, 3, 1001)), 0.25};
}

// A round flask with something red in it, and a cork.
Matter phial(Vec3 p) {
    const Vec3 middle{0, 0, 0.15};
    const double belly = ball(p, middle, 0.14), neck = stick(p, {0, 0, 0.25}, {0, 0, 0.36}, 0.04);
    const double cork = stick(p, {0, 0, 0.38}, {0, 0, 0.41}, 0.036);
    const double shine = ball(p, {0.09, 0.06, 0.22}, 0.045);
    const Color red = p.z < 0.19 ? rgb(0xc02a35) : rgb(0x9fc4c4);
    return either({cork, rgb(0x9a7348)}, either({std::min(belly, neck), red, 0.3}, {shine, rgb(0xffd9d4), 0.8}));
}

// Planks in a frame, 0.8 m high.
Matter crate(Vec3 p) {
    const double grain = 0.10 * cloud(p.y * 2, p.z * 9, 4, 8, 3, 1011) + 0.06 * cloud(p.x * 2, p.z * 9, 4, 8, 3, 1012);
    const double planks = box(p, {0, 0, 0.4}, {0.37, 0.37, 0.37});
    double frame = 9;
    for (const double a : {-0.36, 0.36}) {
        for (const double b : {-0.36, 0.36}) {
            frame =
                std::min({frame, box(p, {a, b, 0.4}, {0.045, 0.045, 0.4}), box(p, {a, 0, 0.4 + b}, {0.045, 0.4, 0.045}),
                          box(p, {0, a, 0.4 + b}, {0.4, 0.045, 0.045})});
        }
    }
    const double line = std::abs(fraction(p.z / 0.148) - 0.5) > 0.45 ? 0.6 : 1;
    return either({planks, rgb(0x9a7a4d) * ((1 + grain) * line)}, {frame, rgb(0x7b5a36) * (1 + grain)});
}

// Tongues of fire over a bed of coals; `gust` moves them.
Matter flames(Vec3 p, double wide, double tall, double gust) {
    double fire = 9;
    for (int i = 0; i < 7; ++i) {
        const double at = (i - 3) / 3.5, side = at * wide, lean = 0.35 * wide * wave(gust + 0.31 * i);
        const double top = tall * (1 - 0.55 * at * at) * (0.75 + 0.25 * wave(2 * gust + 0.43 * i));
        fire = std::min({fire, stick(p, {0, side, 0.02}, {0, side + 0.4 * lean, 0.45 * top}, 0.24 * wide),
                         stick(p, {0, side + 0.3 * lean, 0.3 * top}, {0, side + lean, top}, 0.10 * wide)});
    }
    const double up = clamp01(p.z / tall);
    const Color hot =
        up < 0.4 ? mix(rgb(0xfff2b8), rgb(0xffc24a), up / 0.4) : mix(rgb(0xffc24a), rgb(0xe2571c), (up - 0.4) / 0.6);
    return {fire, hot, 1};
}

// A bowl of fire on three legs, 1.35 m.
Body brazier(double gust) {
    return [gust](Vec3 p) -> Matter {
        double metal = cone(p, 0.78, 1.0, 0.12, 0.27);
        for (const Vec3 foot : {Vec3{0.22, 0, 0}, Vec3{-0.12, 0.2, 0}, Vec3{-0.12, -0.2, 0}})
            metal = std::min(metal, stick(p, foot, Vec3{foot.x * 0.35, foot.y * 0.35, 0.8}, 0.022));
        return either({metal, rgb(0x4c4640)}, flames(p - Vec3{0, 0, 1.0}, 0.17, 0.36, gust));
    };
}

// Burning logs, as wide as a hearth.
Body hearth_fire(double gust) {
    return [gust](Vec3 p) -> Matter {
        const double logs = std::min({stick(p, {0.12, -0.5, 0.09}, {0.12, 0.46, 0.09}, 0.085),
                                      stick(p, {-0.1, -0.44, 0.1}, {-0.1, 0.5, 0.1}, 0.09),
                                      stick(p, {0.02, -0.36, 0.24}, {0.04, 0.34, 0.22}, 0.08)});
        const double bark = 0.2 * cloud(p.y * 2, p.z * 3, 4, 4, 3, 1021);
        return either({logs, rgb(0x5a3822) * (1 + bark), 0.25}, flames(p - Vec3{-0.02, 0, 0.16}, 0.34, 0.75, gust));
    };
}

}  // namespace

void draw_tools(const Album& album) {
    for (int frame = 0; frame < 4; ++frame)
        album.add_cutout("key_" + std::to_string(frame + 1), 32, 44, figure(key, frame, 32, 44, kSize, 2));
    album.add_cutout("phial", 28, 32, figure(phial, 0, 28, 32, kSize, 2));
    album.add_cutout("crate", 76, 60, figure(crate, 1, 76, 60, kSize, 4));
    for (int frame = 0; frame < 4; ++frame) {
        album.add_cutout("brazier_" + std::to_string(frame + 1), 48, 96,
                         figure(brazier(0.25 * frame), 0, 48, 96, kSize, 3));
        album.add_cutout("hearth_fire_" + std::to_string(frame + 1), 80, 72,
                         figure(hearth_fire(0.25 * frame), 0, 80, 72, kSize, 3));
    }
}

}  // namespace draw_textures
