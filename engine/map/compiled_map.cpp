#include "map/compiled_map.h"

#include "base/hash.h"
#include "base/parallel.h"
#include "map/draft.h"
#include "map/packing.h"
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

/// Begins a compiled map: "ENFMAP" and the number of this way of writing it.
constexpr std::uint64_t kMagic = 0x0003'50414D'464E45;

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
