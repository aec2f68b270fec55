// A sound while it is drawn: values at 22 050 a second, and what is done to them.
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace draw_sounds {

inline constexpr double kRate = 22050;  // enough for what rumbles, hums and hisses, at half the bytes [1/s]
inline constexpr double kTurn = 6.283185307179586;

using Wave = std::vector<double>;

// The function of time [s], sampled.
Wave drawn(double seconds, const std::function<double(double)>& value);

// Even noise within -1..1; the same seed gives the same noise.
Wave noise(double seconds, std::uint32_t seed);

// Keeps what is below, or above, a frequency [Hz]: a filter of first order.
Wave below(Wave wave, double hertz);
Wave above(Wave wave, double hertz);

Wave operator+(Wave a, const Wave& b);
Wave operator*(Wave a, const Wave& b);
Wave operator*(Wave a, double factor);

// The last `seconds` are laid over the first ones and cut off, so that the end goes over into the beginning.
Wave looped(const Wave& wave, double seconds);

// As loud as it may be without clipping, times `peak`.
Wave loud(Wave wave, double peak);

// 16 bits, one channel. Throws where it cannot be written.
void save_wav(const Wave& wave, const std::string& path);

}  // namespace draw_sounds
