// What stands in the rooms: a statue, an orange tree in its pot, a candelabrum.
#include "album.h"
#include "figure.h"

namespace draw_textures {
namespace {

constexpr double kSize = 64;  // texels per metre of all of them

// A woman in a robe with folds, one arm raised, on a pedestal. 1.95 m.
Matter statue(Vec3 p) {
    const double grain = 0.04 * cloud(p.y * 2 + 0.31 * p.x, p.z * 2, 4, 4, 3, 701);
    const Color marble = rgb(0xe4ded0) * (1 + grain), stone = rgb(0xa89c88) * (1 + 2 * grain);
    const double around = std::atan2(p.y, p.x), folds = 0.012 * std::sin(9 * around + 3 * p.z);
    const double robe = cone(p, 0.5, 1.2, 0.19 + folds, 0.105 + 0.4 * folds);
    const double torso =
        std::min(stick(p, {0, -0.09, 1.36}, {0, 0.09, 1.36}, 0.085), stick(p, {0, 0, 1.15}, {0.01, 0, 1.36}, 0.1));
    const double raised = std::min(stick(p, {0, -0.16, 1.4}, {0.06, -0.27, 1.55}, 0.045),
                                   stick(p, {0.06, -0.27, 1.55}, {0.1, -0.24, 1.8}, 0.036));
    const double lowered = std::min(stick(p, {0, 0.16, 1.4}, {-0.02, 0.21, 1.18}, 0.045),
                                    stick(p, {-0.02, 0.21, 1.18}, {0.16, 0.16, 1.12}, 0.036));
    const double head = std::min({ball(p, {0.02, 0, 1.62}, 0.085), stick(p, {0, 0, 1.44}, {0.01, 0, 1.6}, 0.045),
                                  ball(p, {0.1, 0, 1.61}, 0.018), ball(p, {-0.07, 0, 1.67}, 0.055)});
    const double bowl = ball(p, {0.1, -0.24, 1.86}, 0.06), book = box(p, {0.19, 0.15, 1.16}, {0.03, 0.09, 0.07});
    const double plinth = std::min({box(p, {0, 0, 0.05}, {0.27, 0.27, 0.05}), box(p, {0, 0, 0.27}, {0.21, 0.21, 0.2}),
                                    box(p, {0, 0, 0.47}, {0.25, 0.25, 0.035})});
    const double figure = std::min({robe, torso, raised, lowered, head, bowl, book});
    return either({figure, marble}, {plinth, stone});
}

// 1.75 m, a clipped ball of leaves with fruit.
Matter orange_tree(Vec3 p) {
    const Vec3 middle{0, 0, 1.3};
    const Vec3 out = p - middle;
    const double turn = std::atan2(out.y, out.x) / 6.2831853, rise = out.z;
    const double leaves = ball(p, middle, 0.4 + 0.035 * cloud(turn, rise, 14, 14, 3, 711));
    const double shade = 0.75 + 0.5 * cloud(turn, rise * 1.3, 24, 24, 3, 712);
    double fruit = 9;
    for (int i = 0; i < 16; ++i) {
        const double a = i * 2.399963, z = 1 - (2 * i + 1) / 16.0, r = std::sqrt(1 - z * z);
        fruit = std::min(fruit, ball(p, middle + Vec3{r * std::cos(a), r * std::sin(a), z} * 0.41, 0.036));
    }
    const double trunk = stick(p, {0, 0, 0.3}, {0.01, 0.01, 1}, 0.028);
    const double pot = std::min(cone(p, 0, 0.34, 0.15, 0.21), cone(p, 0.3, 0.38, 0.235, 0.235));
    const Matter crown =
        either({leaves * 0.7, mix(rgb(0x35552a), rgb(0x6f9045), clamp01(shade))}, {fruit, rgb(0xe58a2b)});
    return either(crown, either({trunk, rgb(0x6b5138)}, {pot, rgb(0xb4643e)}));
}

// 1.6 m, brass, three candles; the flames lean with `wind`.
Body candelabrum(double wind) {
    return [wind](Vec3 p) -> Matter {
        const Color brass = rgb(0xb8913f);
        double metal = std::min(stick(p, {0, 0, 0.1}, {0, 0, 1.3}, 0.016), cone(p, 0, 0.05, 0.17, 0.13));
        for (const double z : {0.16, 0.6, 1.05}) metal = std::min(metal, ball(p, {0, 0, z}, 0.035));
        double wax = 9, flame = 9;
        for (const double side : {-0.2, 0.0, 0.2}) {
            const double foot = side == 0 ? 1.34 : 1.26;
            metal = std::min({metal, stick(p, {0, side * 0.3, 1.1}, {0, side, foot}, 0.012),
                              cone(p - Vec3{0, side, 0}, foot - 0.01, foot + 0.03, 0.02, 0.045)});
            wax = std::min(wax, stick(p, {0, side, foot + 0.03}, {0, side, foot + 0.13}, 0.018));
            const double lean = wind * (side == 0 ? 1 : -0.7);
            flame = std::min({flame, ball(p, {0, side, foot + 0.185}, 0.026),
                              stick(p, {0, side, foot + 0.19}, {0, side + lean, foot + 0.25}, 0.011)});
        }
        const double white = clamp01((p.z - 1.44) * 6);
        return either({metal, brass},
                      either({wax, rgb(0xefe6cf), 0.3}, {flame, mix(rgb(0xfff3b0), rgb(0xffb84a), white), 1}));
    };
}

}  // namespace

void draw_furniture(const Album& album) {
    for (int view = 0; view < 8; ++view)
        album.add_cutout("statue" + std::to_string(view + 1), 64, 132, figure(statue, view, 64, 132, kSize, 4));
    album.add_cutout("orange_tree", 64, 116, figure(orange_tree, 1, 64, 116, kSize, 3));
    int frame = 1;
    for (const double wind : {0.0, 0.012, -0.008})
        album.add_cutout("candelabrum_" + std::to_string(frame++), 48, 112,
                         figure(candelabrum(wind), 0, 48, 112, kSize, 3));
}

}  // namespace draw_textures
