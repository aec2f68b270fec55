// Structs as bytes by their fields (map/map_fields.h), and back from bytes nobody trusts. Private to map/.
//
// Numbers are little-endian and as long as in memory; words and flags are one byte; a text, a list and what may be
// absent begin with how many there are.
#pragma once
#include <algorithm>
#include <bit>
#include <concepts>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

#include "base/files.h"
#include "base/parallel.h"
#include "formats/words.h"
#include "map/map_fields.h"

namespace enfilade {

/// The last value of each kind, the greatest byte that stands for one.
template <Word W>
constexpr W last_of(W) {
    return static_cast<W>(kWords<W>.size() - 1);
}
constexpr WallKind last_of(WallKind) { return WallKind::way_back; }
constexpr Footing last_of(Footing) { return Footing::fixed; }
constexpr Severity last_of(Severity) { return Severity::error; }

template <class T>
concept Scalar = std::is_arithmetic_v<T> || std::is_enum_v<T>;

/// Has its fields in map/map_fields.h, or beside its own definition.
template <class T>
concept Fielded = requires(T& whole) { fields(whole, [](auto&...) { return 0; }); };

/// How many bytes every value of the type takes; 0: that differs from value to value.
template <class T>
constexpr std::size_t packed_size() {
    if constexpr (Scalar<T>) {
        return sizeof(T);
    } else if constexpr (Fielded<T> && std::is_trivially_copyable_v<T>) {
        using Sum = decltype(fields(std::declval<T&>(), [](auto&... part) {
            constexpr bool all = ((packed_size<std::remove_cvref_t<decltype(part)>>() > 0) && ...);
            constexpr std::size_t sum = (packed_size<std::remove_cvref_t<decltype(part)>>() + ...);
            return std::integral_constant<std::size_t, all ? sum : 0>();
        }));
        return Sum::value;
    } else {
        return 0;
    }
}

/// How many bytes a value takes at least: a list that says it has more than there are bytes for is not begun.
template <class T>
constexpr std::size_t least_size() {
    if constexpr (packed_size<T>() > 0) {
        return packed_size<T>();
    } else if constexpr (Fielded<T>) {
        return decltype(fields(std::declval<T&>(), [](auto&... part) {
            return std::integral_constant<std::size_t, (least_size<std::remove_cvref_t<decltype(part)>>() + ...)>();
        }))::value;
    } else {
        return 1;  // absent; texts and lists begin with eight
    }
}

template <class T>
concept Packed = packed_size<T>() > 0;

/// Copies a number between memory and little-endian bytes.
template <class Number>
void copy_little_endian(void* to, const void* from) {
    std::memcpy(to, from, sizeof(Number));
    if constexpr (std::endian::native == std::endian::big)
        std::reverse(static_cast<std::byte*>(to), static_cast<std::byte*>(to) + sizeof(Number));
}

/// Appends values to bytes.
class Packer {
public:
    template <class T>
    void add(const T& value) {
        if constexpr (Scalar<T>) {
            bytes_.resize(bytes_.size() + sizeof(T));
            copy_little_endian<T>(bytes_.data() + bytes_.size() - sizeof(T), &value);
        } else {
            fields(value, [&](const auto&... part) {
                (add(part), ...);
                return 0;
            });
        }
    }
    void add(const std::string& text) { add_list(text); }
    template <class T>
    void add(const std::vector<T>& list) {
        add_list(list);
    }
    template <class T, std::size_t count>
    void add(const std::array<T, count>& list) {
        for (const T& item : list) add(item);
    }
    template <class T>
    void add(const std::optional<T>& value) {
        add_if_there(value);
    }
    template <class T>
    void add(const Boxed<T>& value) {
        add_if_there(value);
    }

    Bytes& bytes() { return bytes_; }

private:
    void add_list(const auto& list) {
        add(std::uint64_t{list.size()});
        for (const auto& item : list) add(item);
    }
    void add_if_there(const auto& value) {
        add(static_cast<bool>(value));
        if (value) add(*value);
    }

    Bytes bytes_;
};

/// Takes values from bytes, in the order in which they were added. What the bytes do not hold is left as it is, and
/// failed() is set; no more memory is taken than a fixed multiple of what there are bytes for.
class Unpacker {
public:
    explicit Unpacker(std::span<const std::byte> bytes) : bytes_(bytes) {}

    template <class T>
    void take(T& value) {
        if constexpr (Packed<T>) {
            if (has(packed_size<T>())) failed_ |= !unpack(at_, value);
        } else {
            fields(value, [&](auto&... part) {
                (take(part), ...);
                return 0;
            });
        }
    }
    void take(std::string& text) {
        const std::size_t count = take_count(1);
        text.assign(reinterpret_cast<const char*>(at_), count);
        advance(count);
    }
    template <class T>
    void take(std::vector<T>& list) {
        list.clear();
        const std::size_t count = take_count(least_size<T>());
        list.reserve(count);
        if constexpr (!std::is_same_v<T, bool>) prefer_large_pages(list.data(), count * sizeof(T));
        if constexpr (Packed<T>) {
            list.resize(count);
            unpack_all(list);
        } else {
            for (std::size_t i = 0; i < count && !failed_; ++i) take(list.emplace_back());
        }
    }
    template <class T, std::size_t count>
    void take(std::array<T, count>& list) {
        for (T& item : list) take(item);
    }
    template <class T>
    void take(std::optional<T>& value) {
        if (take_flag()) take(value.emplace());
    }
    template <class T>
    void take(Boxed<T>& value) {
        if (take_flag()) take(value.emplace());
    }

    bool failed() const { return failed_; }
    bool is_at_end() const { return at_ == bytes_.data() + bytes_.size(); }

private:
    /// Values that one thread takes at once.
    static constexpr std::size_t kPart = std::size_t{1} << 16;

    bool has(std::size_t count) {
        failed_ |= count > left();
        return !failed_;
    }
    std::size_t left() const { return static_cast<std::size_t>(bytes_.data() + bytes_.size() - at_); }
    void advance(std::size_t count) { at_ += count; }

    bool take_flag() {
        bool flag = false;
        take(flag);
        return flag && !failed_;
    }

    /// How many things of at least `least` bytes each follow; 0 where there are no bytes for them.
    std::size_t take_count(std::size_t least) {
        std::uint64_t count = 0;
        take(count);
        failed_ |= count > left() / least;
        return failed_ ? 0 : static_cast<std::size_t>(count);
    }

    /// Every value takes the same room, so that parts of a long list can be taken at once.
    template <class T>
    void unpack_all(std::vector<T>& list) {
        const std::size_t parts = (list.size() + kPart - 1) / kPart;
        std::vector<char> is_sound(parts, 1);
        parallel_for(parts, parts > 1 ? hardware_threads() : 1, [&](std::size_t part, std::size_t) {
            const std::byte* from = at_ + part * kPart * packed_size<T>();
            for (std::size_t i = part * kPart; i < std::min(list.size(), (part + 1) * kPart); ++i)
                if (!unpack(from, list[i])) is_sound[part] = 0;
        });
        for (const char sound : is_sound) failed_ |= !sound;
        advance(list.size() * packed_size<T>());
    }

    /// False where it is no value of its type. There are bytes enough.
    template <class T>
    static bool unpack(const std::byte*& from, T& value) {
        if constexpr (std::is_same_v<T, bool> || std::is_enum_v<T>) {
            static_assert(sizeof(T) == 1);
            const auto byte = std::to_integer<unsigned char>(*from++);
            if constexpr (std::is_same_v<T, bool>) {
                value = byte == 1;
                return byte <= 1;
            } else {
                value = static_cast<T>(std::min(byte, static_cast<unsigned char>(last_of(T()))));
                return byte <= static_cast<unsigned char>(last_of(T()));
            }
        } else if constexpr (Scalar<T>) {
            copy_little_endian<T>(&value, from);
            from += sizeof(T);
            return true;
        } else {
            return fields(value, [&](auto&... part) {
                bool is_sound = true;
                ((is_sound &= unpack(from, part)), ...);
                return is_sound;
            });
        }
    }

    std::span<const std::byte> bytes_;
    const std::byte* at_ = bytes_.data();
    bool failed_ = false;
};

}  // namespace enfilade
