// Skies: the whole turn across, the horizon at the bottom, the top row the colour of the zenith.
#include "album.h"

namespace draw_textures {
namespace {

struct Sky {
    Color zenith, middle, horizon;   // clear air
    Color cloud_light, cloud_shade;  // the lit and the dark side of the clouds
    Color hills;                     // the farthest land
    Color glow;                      // around the sun's bearing
    double glow_strength, cover;
    int seed;
};

constexpr double kRise = 1.2;  // the top of the picture as the tangent of its elevation

// A flat layer of clouds, seen in perspective: far ones are low and narrow.
double layer(double cosine, double sine, double rise, double scale, int octaves, int seed) {
    const double far = scale / (rise + 0.13);
    return cloud((cosine * far + 40) / 80, (sine * far + 40) / 80, 80, 80, octaves, seed);
}

Painter sky(const Sky& sky) {
    return [=](double, double, double u, double v) {
        const double rise = kRise * (1 - v), cosine = wave(u + 0.25), sine = wave(u);
        const double toward_sun = 0.5 + 0.5 * wave(u - 0.375 + 0.25), low = 1 / (1 + 6 * rise);
        Color c = mix(sky.middle, sky.zenith, ramp(0.05, 1.1, rise));
        c = mix(c, sky.horizon, ramp(0.45, 0.0, rise));
        c = mix(c, sky.glow, sky.glow_strength * toward_sun * toward_sun * low);

        const double high =
            layer(cosine, sine, rise, 2.6, 5, sky.seed) * 0.8 + 0.35 * layer(cosine, sine, rise, 9, 3, sky.seed + 9);
        const double veil = ramp(0.0, 0.7, high + 0.25) * 0.35 * ramp(1.2, 0.8, rise);
        c = mix(c, sky.cloud_light, veil);

        const double thick = layer(cosine, sine, rise, 1.5, 6, sky.seed + 20);
        const double sunward = layer(cosine - 0.030, sine - 0.030, rise + 0.02, 1.5, 5, sky.seed + 20);
        const double body = ramp(-sky.cover, -sky.cover + 0.30, thick) * ramp(1.2, 0.75, rise) * ramp(0.01, 0.12, rise);
        const double lit = clamp01(0.62 + 2.4 * (thick - sunward) - 0.55 * ramp(0.05, 0.55, thick) + 0.25 * toward_sun);
        Color puff = mix(sky.cloud_shade, sky.cloud_light, lit);
        puff = mix(puff, sky.horizon, 0.55 * ramp(0.30, 0.02, rise));
        puff = mix(puff, sky.glow, 0.5 * sky.glow_strength * toward_sun * low);
        c = mix(c, puff, body);

        for (int range = 0; range < 3; ++range) {  // hills, the nearest last
            const double crest =
                0.050 - 0.013 * range + 0.030 * cloud(u, 0.37, 7 + 6 * range, 1, 5, sky.seed + 40 + range);
            const Color hill = mix(sky.horizon, sky.hills, 0.35 + 0.25 * range);
            c = mix(c, mix(hill, sky.horizon, 0.35 * ramp(crest, 0, rise)), ramp(0.004, 0.0, rise - crest));
        }
        return Surface{c, 0};
    };
}

struct Clouds {
    Color light, shade, low;  // where the sun reaches, where it does not, and near the horizon
    double cover;
    int seed;
};

// Nothing but clouds, clear at the foot and at the top: to be laid over a sky and turned.
Painter clouds(const Clouds& clouds) {
    return [=](double, double, double u, double v) {
        const double rise = kRise * (1 - v), cosine = wave(u + 0.25), sine = wave(u);
        const double thick = layer(cosine, sine, rise, 2.1, 6, clouds.seed);
        const double sunward = layer(cosine - 0.03, sine - 0.03, rise + 0.02, 2.1, 5, clouds.seed);
        const double body = ramp(-clouds.cover, -clouds.cover + 0.34, thick);
        const double lit = clamp01(0.6 + 2.6 * (thick - sunward) - 0.5 * ramp(0.05, 0.5, thick));
        const Color c = mix(mix(clouds.shade, clouds.light, lit), clouds.low, 0.6 * ramp(0.35, 0.05, rise));
        return Surface{c, 0, 0.85 * body * ramp(0.06, 0.22, rise) * ramp(1.15, 0.6, rise)};
    };
}

}  // namespace

void draw_sky(const Album& album) {
    album.add("sky_day", 2048, 384,
              sky({rgb(0x2f66b0), rgb(0x5f97d2), rgb(0xd3e2ea), rgb(0xfbf8ee), rgb(0x93a5ba), rgb(0x58748a),
                   rgb(0xfff1cf), 0.5, 0.02, 501}));
    album.add("sky_dusk", 2048, 384,
              sky({rgb(0x232a52), rgb(0x5d4a78), rgb(0xe89a62), rgb(0xf3a67c), rgb(0x57436a), rgb(0x3a2f4e),
                   rgb(0xffc46b), 0.9, 0.06, 541}));
    album.add_with_alpha("clouds_dusk", 1024, 192, clouds({rgb(0xf7b48a), rgb(0x4d3d62), rgb(0xd98a63), 0.04, 561}));
}

}  // namespace draw_textures
