// draw_sounds OUTDIR: draws every sound of the maps into OUTDIR. Running it again gives the same bytes.
#include <cmath>
#include <cstdio>
#include <exception>

#include "wave.h"

namespace draw_sounds {
namespace {

double tone(double t, double hertz) { return std::sin(kTurn * hertz * t); }

// Stone on stone: low noise that comes and goes in shudders.
Wave door() {
    const Wave rumble = below(below(noise(1.4, 1), 180), 180);
    const Wave shudder = drawn(1.4, [](double t) {
        return (0.6 + 0.4 * tone(t, 11)) * (1 - std::exp(-t * 30)) * (1 - std::exp((t - 1.4) * 12));
    });
    return loud(rumble * shudder, 0.9);
}

// What comes to rest.
Wave thud() {
    const Wave body = drawn(0.5, [](double t) { return tone(t, 55 + 40 * std::exp(-t * 30)) * std::exp(-t * 14); });
    const Wave dust = below(noise(0.5, 2), 900) * drawn(0.5, [](double t) { return std::exp(-t * 35); });
    return loud(body + dust * 2, 0.9);
}

// A motor: whole periods in a second, so that it loops by itself.
Wave lift() {
    return loud(drawn(1,
                      [](double t) {
                          return tone(t, 60) + 0.5 * tone(t, 120) + 0.35 * tone(t, 181) * (1 + 0.5 * tone(t, 7)) +
                                 0.15 * tone(t, 422);
                      }),
                0.7);
}

// A lever and its latch.
Wave click() {
    const auto knock = [](double t, double at, double hertz) {
        return t < at ? 0 : tone(t - at, hertz) * std::exp((at - t) * 180);
    };
    return loud(drawn(0.18, [&](double t) { return knock(t, 0, 1900) + 0.7 * knock(t, 0.06, 1200); }), 0.8);
}

// A flame's breath, and sparks at random.
Wave torch() {
    const Wave breath = below(noise(3.3, 3), 300) * 0.8;
    Wave sparks = above(noise(3.3, 4), 2500);
    const Wave chances = noise(3.3, 5);
    double spark = 0;
    for (std::size_t i = 0; i < sparks.size(); ++i) {
        if (chances[i] > 0.9993) spark = 0.4 + 0.6 * (sparks[i] + 1) / 2;
        sparks[i] *= spark;
        spark *= 0.992;
    }
    return loud(looped(breath + sparks, 0.3), 0.7);
}

// Noise through a pass that opens and closes with the gusts.
Wave wind() {
    const Wave gusts = drawn(5, [](double t) { return 0.55 + 0.3 * tone(t, 0.25) + 0.15 * tone(t, 0.75); });
    const Wave low = below(below(noise(5, 6), 350), 350), high = below(above(noise(5, 7), 400), 900);
    return loud(looped(low * gusts + high * gusts * gusts * 0.3, 1), 0.7);
}

// Much of a hiss and little of a roar, and bubbles that nobody can tell apart.
Wave water() {
    const Wave roar = below(noise(4, 8), 500) * 1.2, hiss = below(above(noise(4, 9), 900), 4000) * 0.35;
    const Wave bubbles =
        drawn(4, [](double t) { return 0.85 + 0.1 * tone(t, 3.5) * tone(t, 1.25) + 0.05 * tone(t, 9); });
    return loud(looped((roar + hiss) * bubbles, 0.5), 0.6);
}

}  // namespace
}  // namespace draw_sounds

int main(int count, char** arguments) {
    using namespace draw_sounds;
    if (count != 2) {
        std::fprintf(stderr, "usage: draw_sounds OUTDIR\n");
        return 2;
    }
    const std::string folder = std::string(arguments[1]) + "/";
    try {
        save_wav(door(), folder + "door.wav");
        save_wav(thud(), folder + "thud.wav");
        save_wav(lift(), folder + "lift.wav");
        save_wav(click(), folder + "click.wav");
        save_wav(torch(), folder + "torch.wav");
        save_wav(wind(), folder + "wind.wav");
        save_wav(water(), folder + "water.wav");
    } catch (const std::exception& problem) {
        std::fprintf(stderr, "draw_sounds: %s\n", problem.what());
        return 1;
    }
}
