// Little-endian numbers out of bytes nobody trusts, and back into bytes.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace enfilade {

/// Reads forward through bytes. A read past the end gives zeros and sets failed(); nothing is ever read outside.
class ByteReader {
public:
    explicit ByteReader(std::span<const std::byte> bytes) : bytes_(bytes) {}

    std::uint8_t u8() { return static_cast<std::uint8_t>(little_endian(1)); }
    std::uint16_t u16() { return static_cast<std::uint16_t>(little_endian(2)); }
    std::uint32_t u32() { return static_cast<std::uint32_t>(little_endian(4)); }
    std::uint64_t u64() { return little_endian(8); }
    std::int16_t i16() { return static_cast<std::int16_t>(u16()); }
    std::int32_t i32() { return static_cast<std::int32_t>(u32()); }

    /// The next count bytes, or an empty span (and failed()) if there are fewer.
    std::span<const std::byte> take(std::size_t count) {
        if (count > remaining()) {
            failed_ = true;
            at_ = bytes_.size();
            return {};
        }
        auto part = bytes_.subspan(at_, count);
        at_ += count;
        return part;
    }

    std::size_t remaining() const { return bytes_.size() - at_; }
    std::size_t position() const { return at_; }
    bool failed() const { return failed_; }

private:
    std::uint64_t little_endian(std::size_t count) {
        std::uint64_t value = 0;
        const auto part = take(count);
        for (std::size_t i = 0; i < part.size(); ++i) value |= std::uint64_t(part[i]) << (8 * i);
        return value;
    }

    std::span<const std::byte> bytes_;
    std::size_t at_ = 0;
    bool failed_ = false;
};

/// Appends little-endian numbers to bytes.
class ByteWriter {
public:
    void u8(std::uint8_t v) { little_endian(v, 1); }
    void u16(std::uint16_t v) { little_endian(v, 2); }
    void u32(std::uint32_t v) { little_endian(v, 4); }
    void u64(std::uint64_t v) { little_endian(v, 8); }
    void text(std::string_view s) {
        for (char c : s) bytes_.push_back(static_cast<std::byte>(c));
    }

    std::span<const std::byte> bytes() const { return bytes_; }

private:
    void little_endian(std::uint64_t v, int count) {
        for (int i = 0; i < count; ++i) bytes_.push_back(static_cast<std::byte>(v >> (8 * i)));
    }

    std::vector<std::byte> bytes_;
};

}  // namespace enfilade
