#include "map/load.h"

#include <algorithm>
#include <bit>
#include <concepts>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

#include "base/files.h"
#include "base/hash.h"
#include "base/parallel.h"
#include "formats/words.h"
#include "map/draft.h"
#include "map/map_fields.h"
#include "map/sector_finder.h"

namespace enfilade {

// As in map/map_fields.h; looked up by their arguments, which does not look into a nameless namespace.

constexpr auto fields(Some<TextPlace> auto& whole, auto visit) {
    auto& [line, column] = whole;
    return visit(line, column);
}

constexpr auto fields(Some<Finding> auto& whole, auto visit) {
    auto& [place, severity, code, sentence, file] = whole;
    return visit(place, severity, code, sentence, file);
}

constexpr auto fields(Some<NamedFile> auto& whole, auto visit) {
    auto& [name, place] = whole;
    return visit(name, place);
}

constexpr auto fields(Some<TextureSize> auto& whole, auto visit) {
    auto& [width, height] = whole;
    return visit(width, height);
}

constexpr auto fields(Some<PictureNeed> auto& whole, auto visit) {
    auto& [name, written, place] = whole;
    return visit(name, written, place);
}

constexpr auto fields(Some<PictureNeeds> auto& whole, auto visit) {
    auto& [pictures, color_table, color_table_place] = whole;
    return visit(pictures, color_table, color_table_place);
}

constexpr auto fields(Some<CompiledMap> auto& whole, auto visit) {
    auto& [map, textures, needs, sizes, findings, sounds, next_maps] = whole;
    return visit(map, textures, needs, sizes, findings, sounds, next_maps);
}

namespace {

// Structs as bytes by their fields, and back from bytes nobody trusts.
//
// Numbers are little-endian and as long as in memory; words and flags are one byte; a text, a list and what may be
// absent begin with how many there are.

/// The last value of each kind, the greatest byte that stands for one.
template <Word W>
constexpr W last_of(W) {
    return static_cast<W>(kWords<W>.size() - 1);
}
constexpr WallKind last_of(WallKind) { return WallKind::way_back; }
constexpr Footing last_of(Footing) { return Footing::fixed; }
constexpr Severity last_of(Severity) { return Severity::error; }

/// Has its fields in map/map_fields.h, or above.
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

// The file of a compiled map.

/// Begins a compiled map: "ENFMAP" and the number of this way of writing it.
constexpr std::uint64_t kMagic = 0x0004'50414D'464E45;

/// What stands around the map itself: the magic number and the source before it, the checksum behind it [bytes].
constexpr std::size_t kHead = 2 * sizeof(std::uint64_t), kTail = sizeof(std::uint64_t);

std::uint64_t number_at(std::span<const std::byte> bytes, std::size_t at) {
    std::uint64_t number;
    copy_little_endian<std::uint64_t>(&number, bytes.data() + at);
    return number;
}

/// Each wall is the next one of one other wall of its sector, and the sectors share out all walls.
bool are_rings(const Map& map) {
    std::size_t walls = 0;
    std::vector<bool> is_next(map.walls.size());
    for (const Sector& sector : map.sectors) {
        if (sector.first_wall != walls || sector.wall_count < 3) return false;
        if (sector.wall_count > map.walls.size() - walls) return false;
        for (; walls < sector.first_wall + sector.wall_count; ++walls) {
            const std::uint32_t next = map.walls[walls].next.index;
            if (next < sector.first_wall || next - sector.first_wall >= sector.wall_count || is_next[next])
                return false;
            is_next[next] = true;
        }
    }
    return walls == map.walls.size();
}

void settle_shapes(Map& map) {
    constexpr std::size_t kPart = 4096;  // sectors that one thread takes at once
    const std::size_t sectors = map.sectors.size();
    parallel_for((sectors + kPart - 1) / kPart, hardware_threads(), [&](std::size_t part, std::size_t) {
        for (std::size_t i = part * kPart; i < std::min(sectors, (part + 1) * kPart); ++i)
            settle_shape(map, SectorId(i));
    });
    for (Panel& panel : map.panels) settle_length(panel);
}

/// None where it is no map that can be drawn and walked through.
std::optional<CompiledMap> unpack(std::span<const std::byte> bytes) {
    Unpacker unpacker(bytes);
    CompiledMap compiled;
    unpacker.take(compiled);
    if (unpacker.failed() || !unpacker.is_at_end() || !are_rings(compiled.map)) return {};
    settle_shapes(compiled.map);
    const std::size_t pictures = compiled.needs.pictures.size();
    if (compiled.sizes.size() != pictures || !is_consistent(compiled.map, pictures)) return {};
    for (const Wall& wall : compiled.map.walls) settle_grid_link(compiled.map, wall);
    list_near_things(compiled.map);
    return compiled;
}

}  // namespace

Bytes compile(const CompiledMap& compiled, std::uint64_t source) {
    Packer packer;
    packer.add(kMagic);
    packer.add(source);
    packer.add(compiled);
    packer.add(hash_of_bytes(packer.bytes()));
    return std::move(packer.bytes());
}

bool is_compiled_from(std::span<const std::byte> bytes, std::uint64_t source) {
    return bytes.size() >= kHead + kTail && number_at(bytes, 0) == kMagic && number_at(bytes, sizeof(kMagic)) == source;
}

std::optional<CompiledMap> read_compiled(std::span<const std::byte> bytes, std::uint64_t source) {
    if (!is_compiled_from(bytes, source)) return {};
    const std::span<const std::byte> checked = bytes.first(bytes.size() - kTail);
    bool is_whole = false;
    std::optional<CompiledMap> compiled;
    // Whatever the bytes are, they may be unpacked while their checksum is still being worked out.
    parallel_for(2, hardware_threads(), [&](std::size_t task, std::size_t) {
        if (task == 0)
            is_whole = number_at(bytes, checked.size()) == hash_of_bytes(checked);
        else
            compiled = unpack(checked.subspan(kHead));
    });
    return is_whole ? std::move(compiled) : std::nullopt;
}

}  // namespace enfilade
