#include "wave.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <stdexcept>

namespace draw_sounds {
namespace {

std::size_t samples_of(double seconds) { return static_cast<std::size_t>(seconds * kRate); }

void put(std::ofstream& out, std::uint32_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) out.put(static_cast<char>(value >> (8 * i) & 255));
}

}  // namespace

Wave drawn(double seconds, const std::function<double(double)>& value) {
    Wave wave(samples_of(seconds));
    for (std::size_t i = 0; i < wave.size(); ++i) wave[i] = value(static_cast<double>(i) / kRate);
    return wave;
}

Wave noise(double seconds, std::uint32_t seed) {
    Wave wave(samples_of(seconds));
    for (double& value : wave) {
        seed = seed * 1664525u + 1013904223u;
        value = static_cast<double>(seed >> 8) / 8388608.0 - 1;
    }
    return wave;
}

Wave below(Wave wave, double hertz) {
    const double part = 1 - std::exp(-kTurn * hertz / kRate);
    double level = 0;
    for (double& value : wave) value = level += (value - level) * part;
    return wave;
}

Wave above(Wave wave, double hertz) { return wave + below(wave, hertz) * -1; }

Wave operator+(Wave a, const Wave& b) {
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) a[i] += b[i];
    return a;
}

Wave operator*(Wave a, const Wave& b) {
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) a[i] *= b[i];
    return a;
}

Wave operator*(Wave a, double factor) {
    for (double& value : a) value *= factor;
    return a;
}

Wave looped(const Wave& wave, double seconds) {
    const std::size_t over = samples_of(seconds), length = wave.size() - over;
    Wave loop(wave.begin(), wave.begin() + static_cast<std::ptrdiff_t>(length));
    for (std::size_t i = 0; i < over; ++i) {
        const double part = static_cast<double>(i) / static_cast<double>(over);
        loop[i] = wave[i] * std::sqrt(part) + wave[length + i] * std::sqrt(1 - part);
    }
    return loop;
}

Wave loud(Wave wave, double peak) {
    double largest = 0;
    for (const double value : wave) largest = std::max(largest, std::abs(value));
    return wave * (largest > 0 ? peak / largest : 0);
}

void save_wav(const Wave& wave, const std::string& path) {
    std::ofstream out(path, std::ios::binary);
    const auto bytes = static_cast<std::uint32_t>(2 * wave.size()), rate = static_cast<std::uint32_t>(kRate);
    out << "RIFF";
    put(out, 36 + bytes, 4);
    out << "WAVEfmt ";
    put(out, 16, 4);
    put(out, 1, 2);  // plain samples
    put(out, 1, 2);  // one channel
    put(out, rate, 4);
    put(out, rate * 2, 4);
    put(out, 2, 2);
    put(out, 16, 2);
    out << "data";
    put(out, bytes, 4);
    for (const double value : wave)
        put(out, static_cast<std::uint32_t>(static_cast<std::int32_t>(std::lround(value * 32767))), 2);
    if (!out.flush()) throw std::runtime_error(path + " cannot be written");
}

}  // namespace draw_sounds
