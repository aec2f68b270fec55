// Polished stone, used by floors, columns and trim alike.
#pragma once

#include "picture.h"

namespace draw_textures {

struct Marble {
    Color base, cloud, vein;
};

inline constexpr Marble kWhiteMarble{rgb(0xe4dfd4), rgb(0xcac4b8), rgb(0x8f8b86)};
inline constexpr Marble kBlackMarble{rgb(0x33302f), rgb(0x232124), rgb(0xa39b8c)};
inline constexpr Marble kRoseMarble{rgb(0xb9796a), rgb(0x985a50), rgb(0xe3c4b1)};
inline constexpr Marble kGreenMarble{rgb(0x48685a), rgb(0x2f4b42), rgb(0xa9bfa8)};
inline constexpr Marble kYellowMarble{rgb(0xd8b674), rgb(0xbd9453), rgb(0xf0dfb6)};

inline constexpr Color kGold = rgb(0xd0a24a);
inline constexpr Color kGoldShade = rgb(0x7d551f);

// The stone's colour; `shift` picks another piece of the same quarry.
inline Color marble_at(const Marble& m, double u, double v, double shift, int seed) {
    const double su = u + shift * 7.3, sv = v + shift * 3.1;
    const double broad = cloud(su, sv, 3, 3, 5, seed);
    const double bend = 0.55 * cloud(su, sv, 2, 2, 5, seed + 10), ripple = 0.5 * cloud(su, sv, 3, 3, 5, seed + 20);
    const double wide = ramp(0.5, 0.0, std::abs(wave(su + sv + bend))),
                 fine = ramp(0.10, 0.0, std::abs(wave(su - 2 * sv + ripple)));
    const double strength = 0.5 + 0.5 * cloud(su, sv, 2, 2, 3, seed + 30);
    Color c = mix(m.base, m.cloud, clamp01(0.5 + 0.9 * broad));
    c = mix(c, m.vein, 0.45 * fine * strength);
    return mix(c, m.vein, 0.30 * wide * wide * strength);
}

// Gilding: bright where it stands out, brown where the leaf is rubbed.
inline Color gilding(double u, double v, double shine, int seed) {
    const double rubbed = cloud(u, v, 12, 12, 3, seed);
    return mix(kGoldShade, kGold, clamp01(0.55 + 0.45 * shine + 0.25 * rubbed)) +
           Color{1, 0.9, 0.6} * (0.18 * ramp(0.6, 1, shine));
}

}  // namespace draw_textures
