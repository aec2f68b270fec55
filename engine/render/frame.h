// A picture, and beside it, for those who ask, what each pixel shows.
#pragma once
#include <cstddef>
#include <cstdint>
#include <limits>
#include <new>
#include <optional>
#include <vector>

#include "base/hash.h"
#include "formats/png.h"
#include "map/map.h"

namespace enfilade {

// Numbers for surfaces, equal in all renderers: what an ids picture shows.

/// 24 bits; 0 is "nothing was drawn here".
using PixelSurface = std::uint32_t;

inline constexpr PixelSurface kNothing = 0;

/// Where a chain of links was cut and the map's recursion colour shows.
inline constexpr PixelSurface kRecursionEnd = 0xFFFFFF;

enum class WallPart : std::uint8_t { middle, upper, lower };

inline PixelSurface floor_id(SectorId sector) { return 1 + 2 * sector.index; }
inline PixelSurface ceiling_id(SectorId sector) { return 2 + 2 * sector.index; }
inline PixelSurface wall_id(const Map& map, WallId wall, WallPart part) {
    return static_cast<PixelSurface>(1 + 2 * map.sectors.size() + std::size_t{3} * wall.index +
                                     static_cast<unsigned>(part));
}

inline PixelSurface thing_id(const Map& map, ThingId thing) {
    return static_cast<PixelSurface>(1 + 2 * map.sectors.size() + 3 * map.walls.size() + thing.index);
}

inline PixelSurface panel_id(const Map& map, PanelId panel) {
    return static_cast<PixelSurface>(1 + 2 * map.sectors.size() + 3 * map.walls.size() + map.things.size() +
                                     panel.index);
}

enum class SurfaceKind : std::uint8_t { floor, ceiling, wall, thing, panel };

/// What a surface belongs to.
struct SurfaceOwner {
    SurfaceKind kind = SurfaceKind::floor;
    std::uint32_t index = 0;           ///< of the sector (floor, ceiling), wall, thing or panel
    WallPart part = WallPart::middle;  ///< of a wall
};

/// The other way round: none where nothing was drawn, a chain of links was cut, or the map has no such number.
inline std::optional<SurfaceOwner> owner_of(const Map& map, PixelSurface id) {
    if (id == kNothing || id == kRecursionEnd) return {};
    std::size_t number = id - 1;
    if (number < 2 * map.sectors.size())
        return SurfaceOwner{number % 2 == 0 ? SurfaceKind::floor : SurfaceKind::ceiling, std::uint32_t(number / 2), {}};
    number -= 2 * map.sectors.size();
    if (number < 3 * map.walls.size())
        return SurfaceOwner{SurfaceKind::wall, std::uint32_t(number / 3), static_cast<WallPart>(number % 3)};
    number -= 3 * map.walls.size();
    if (number < map.things.size()) return SurfaceOwner{SurfaceKind::thing, std::uint32_t(number), {}};
    number -= map.things.size();
    if (number < map.panels.size()) return SurfaceOwner{SurfaceKind::panel, std::uint32_t(number), {}};
    return {};
}

/// Texel coordinates in tiles, in [0, 1): position within the picture on that surface.
struct TexelPosition {
    double u = 0;
    double v = 0;
};

/// What each pixel shows; for tests, ids pictures and overlays. All arrays are by row, width * height long.
struct FrameFacts {
    std::vector<PixelSurface> ids;
    std::vector<double> depths;  ///< along `forward` [m]; sky: infinity
    std::vector<TexelPosition> texels;
    std::vector<std::uint8_t> writes;  ///< how often the opaque pass wrote the pixel: 1 everywhere in a sound frame
};

/// As all x86-64 and most others have.
inline constexpr std::size_t kCacheLineBytes = 64;

/// An allocator of memory that begins where a cache line does, wherever the heap has room: what takes whole lines at a
/// time works in the same steps in every run.
template <class T>
struct OnCacheLines {
    using value_type = T;

    OnCacheLines() = default;
    template <class Other>
    OnCacheLines(const OnCacheLines<Other>&) {}

    T* allocate(std::size_t count) {
        return static_cast<T*>(::operator new(count * sizeof(T), std::align_val_t{kCacheLineBytes}));
    }
    void deallocate(T* first, std::size_t) { ::operator delete(first, std::align_val_t{kCacheLineBytes}); }

    bool operator==(const OnCacheLines&) const = default;
};

/// 0xAABBGGRR (bytes R, G, B, A).
using Pixels = std::vector<std::uint32_t, OnCacheLines<std::uint32_t>>;

/// width * height pixels by row, row 0 at the top, no padding.
struct Frame {
    int width = 0;
    int height = 0;
    Pixels pixels;
    bool is_cut_short = false;  ///< somewhere a look ended because its budget was spent (render/openings.h)

    /// Sets the size and makes room. Pixels keep whatever they were: every renderer writes every one.
    void resize(int new_width, int new_height) {
        width = new_width;
        height = new_height;
        pixels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    }
};

/// The same pixels, for write_png(), and the other way round.
inline Image image_of(const Frame& frame) {
    return {std::uint32_t(frame.width), std::uint32_t(frame.height), {frame.pixels.begin(), frame.pixels.end()}};
}
inline Frame frame_of(const Image& image) {
    return {int(image.width), int(image.height), {image.pixels.begin(), image.pixels.end()}};
}

/// For a picture of that size [px]: makes room and sets everything to "nothing drawn, 0 writes, infinitely far".
inline void reset(FrameFacts& facts, int width, int height) {
    const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    facts.ids.assign(count, kNothing);
    facts.depths.assign(count, std::numeric_limits<double>::infinity());
    facts.texels.assign(count, {});
    facts.writes.assign(count, 0);
}

/// Of size and pixels: the number goldens record.
inline std::uint64_t hash_of(const Frame& frame) {
    Hash hash;
    hash.add(std::int32_t{frame.width});
    hash.add(std::int32_t{frame.height});
    for (std::uint32_t pixel : frame.pixels) hash.add(pixel);
    return hash.value();
}

}  // namespace enfilade
