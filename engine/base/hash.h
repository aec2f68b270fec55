// A 64-bit hash fed value by value, never with raw structs, whose padding would leak in.
#pragma once
#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <span>
#include <string_view>

namespace enfilade {

/// FNV-1a over 64-bit words with a final avalanche (Fowler, Noll, Vo; finaliser after Stafford's "Mix13").
/// For telling pictures and states apart, not for security. The same values give the same hash on every machine.
class Hash {
public:
    void add(std::uint64_t word) {
        state_ = (state_ ^ word) * 0x100000001B3u;
        state_ ^= state_ >> 29;
    }
    void add(std::uint32_t word) { add(std::uint64_t{word}); }
    void add(std::int32_t word) { add(static_cast<std::uint64_t>(std::int64_t{word})); }
    void add(std::int64_t word) { add(static_cast<std::uint64_t>(word)); }
    void add(bool bit) { add(std::uint64_t{bit}); }
    /// The bits of the number; -0.0 counts as 0.0.
    void add(double number) { add(std::bit_cast<std::uint64_t>(number + 0.0)); }
    /// Its length, too: texts one after the other are not taken for others that make the same together.
    void add(std::string_view text) {
        add(std::uint64_t{text.size()});
        for (char c : text) add(std::uint64_t{static_cast<unsigned char>(c)});
    }

    /// A literal is text too; without this it would be taken for a bool.
    void add(const char* text) { add(std::string_view(text)); }

    std::uint64_t value() const {
        std::uint64_t x = state_;
        x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
        x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
        return x ^ (x >> 31);
    }

private:
    std::uint64_t state_ = 0xCBF29CE484222325u;
};

/// Of a text alone, e.g. to notice that a file was changed.
inline std::uint64_t hash_of_text(std::string_view text) {
    Hash hash;
    hash.add(text);
    return hash.value();
}

/// Of bytes: sixteen times as quick as as a text. For large files. Little-endian words are dealt out to four hashes,
/// whose multiplications a processor does at the same time.
/// Cost: about 0.1 ns a byte.
inline std::uint64_t hash_of_bytes(std::span<const std::byte> bytes) {
    constexpr std::size_t kWord = sizeof(std::uint64_t);
    const auto word_at = [&](std::size_t at) {
        std::uint64_t word = 0;
        const std::size_t count = std::min(kWord, bytes.size() - at);
        if constexpr (std::endian::native == std::endian::little)
            std::memcpy(&word, bytes.data() + at, count);
        else
            for (std::size_t b = 0; b < count; ++b) word |= std::to_integer<std::uint64_t>(bytes[at + b]) << (8 * b);
        return word;
    };
    Hash lanes[4], hash;
    std::size_t at = 0;
    for (; bytes.size() - at >= std::size(lanes) * kWord; at += std::size(lanes) * kWord)
        for (std::size_t lane = 0; lane < std::size(lanes); ++lane) lanes[lane].add(word_at(at + lane * kWord));
    hash.add(std::uint64_t{bytes.size()});
    for (const Hash& lane : lanes) hash.add(lane.value());
    for (; at < bytes.size(); at += kWord) hash.add(word_at(at));
    return hash.value();
}

// One small random generator with a written-down sequence, the same on every machine.

/// SplitMix64 (Steele, Lea, Flood: "Fast splittable pseudorandom number generators", 2014).
class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    /// Uniform over all there are.
    std::uint64_t bits() {
        std::uint64_t z = (state_ += 0x9E3779B97F4A7C15u);
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
        return z ^ (z >> 31);
    }

    /// Uniform in [0, count). count > 0. The bias is below count / 2^64.
    std::uint64_t below(std::uint64_t count) {
        return static_cast<std::uint64_t>((static_cast<unsigned __int128>(bits()) * count) >> 64);
    }

    /// Uniform in [low, high); high itself only where rounding the sum leads there.
    double uniform(double low, double high) {
        return low + (high - low) * (static_cast<double>(bits() >> 11) * 0x1p-53);
    }

private:
    std::uint64_t state_;
};

}  // namespace enfilade
