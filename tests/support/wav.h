// WAV files in code: 16 bits, as recorders write them.
#pragma once
#include <cmath>
#include <vector>

#include "base/files.h"

namespace enfilade::test {

struct WavShape {
    std::uint32_t rate = 48000;
    std::uint16_t channels = 1;
};

/// Values within -1..1, channel by channel.
inline Bytes wav_of(const std::vector<double>& values, WavShape shape = {}) {
    ByteWriter out;
    const auto bytes = static_cast<std::uint32_t>(2 * values.size());
    out.text("RIFF");
    out.u32(36 + bytes);
    out.text("WAVEfmt ");
    out.u32(16);
    out.u16(1);  // PCM
    out.u16(shape.channels);
    out.u32(shape.rate);
    out.u32(shape.rate * shape.channels * 2);
    out.u16(static_cast<std::uint16_t>(shape.channels * 2));
    out.u16(16);
    out.text("data");
    out.u32(bytes);
    for (const double value : values)
        out.u16(static_cast<std::uint16_t>(static_cast<std::int16_t>(std::lround(value * 32767))));
    return {out.bytes().begin(), out.bytes().end()};
}

/// A tone of half the full size.
inline std::vector<double> tone(std::size_t count, double hertz, double rate = 48000) {
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i)
        values.push_back(0.5 * std::sin(2 * 3.14159265358979 * hertz * static_cast<double>(i) / rate));
    return values;
}

}  // namespace enfilade::test
