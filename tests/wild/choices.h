// Decisions out of bytes, a fuzzer's or random ones, so that whatever is made of them can be made of fewer as well.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/hash.h"

namespace enfilade::test {

/// Answers questions, byte by byte. Who has no bytes left answers every question with the first answer: no, 0, low.
class Choices {
public:
    explicit Choices(std::span<const std::byte> bytes) : bytes_(bytes) {}

    bool is_at_end() const { return bytes_.empty(); }

    /// In [0, count). count > 0.
    std::uint64_t below(std::uint64_t count) {
        std::uint64_t value = 0;
        for (std::uint64_t reach = 1; reach<count; reach = reach> count >> 8 ? count : reach << 8)
            value = value << 8 | next();
        return value % count;
    }

    /// In [low, high], in 65536 steps.
    double between(double low, double high) { return low + (high - low) * (static_cast<double>(below(65536)) / 65535); }

    bool one_in(std::uint64_t count) { return below(count) == count - 1; }

    template <class Value>
    const Value& any(const std::vector<Value>& values) {
        return values[below(values.size())];
    }

    /// A generator for what nobody needs to make smaller.
    Random random() { return Random(below(256)); }

private:
    std::uint64_t next() {
        if (bytes_.empty()) return 0;
        const auto byte = std::to_integer<std::uint64_t>(bytes_.front());
        bytes_ = bytes_.subspan(1);
        return byte;
    }

    std::span<const std::byte> bytes_;
};

/// As many as a world takes.
inline std::vector<std::byte> random_bytes(std::uint64_t seed, std::size_t count = 4096) {
    Random random(seed);
    std::vector<std::byte> bytes;
    for (std::size_t i = 0; i < count; ++i) bytes.push_back(static_cast<std::byte>(random.bits() >> 24));
    return bytes;
}

}  // namespace enfilade::test
