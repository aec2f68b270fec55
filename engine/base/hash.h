// A 64-bit hash fed value by value, never with raw structs, whose padding would leak in.
#pragma once
#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
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

/// Of bytes, as little-endian words: eight times as quick as as a text. For large files.
inline std::uint64_t hash_of_bytes(std::span<const std::byte> bytes) {
    Hash hash;
    hash.add(std::uint64_t{bytes.size()});
    for (std::size_t i = 0; i < bytes.size(); i += sizeof(std::uint64_t)) {
        std::uint64_t word = 0;
        const std::size_t count = std::min(sizeof(word), bytes.size() - i);
        if constexpr (std::endian::native == std::endian::little)
            std::memcpy(&word, bytes.data() + i, count);
        else
            for (std::size_t b = 0; b < count; ++b) word |= std::to_integer<std::uint64_t>(bytes[i + b]) << (8 * b);
        hash.add(word);
    }
    return hash.value();
}

}  // namespace enfilade
