// What becomes of the colours of a map's pictures in the dark, where they are not darkened in proportion: a table, as
// Doom's COLORMAP is one. Yellow may turn brown, then green.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/result.h"

namespace enfilade {

struct Texture;

/// Up to 256 colours 0xAABBGGRR, all opaque, each as it is painted and at 32 levels of darkness.
class ColorTable {
public:
    static constexpr std::size_t kMostColors = 256;
    static constexpr std::size_t kLevels = 32;

    /// Reads a picture whose top row has the colours as they are painted, and whose other rows have what becomes of
    /// each at the 32 levels, full light first. Of equal colours in the top row the first counts.
    /// An error without a place says what was expected and found where the picture is no such table.
    static Result<ColorTable> read(const Texture& picture);

    bool is_empty() const { return levels_.empty(); }

    /// The colours at a level, by their numbers, kMostColors of them. level: 0, full light, to kLevels - 1.
    const std::uint32_t* at_level(std::size_t level) const { return &levels_[level * kMostColors]; }

    /// The number of each texel's colour, holes having any; nothing where the table lacks the colour of one of them.
    /// Cost: a search for every texel that differs from the one above it.
    std::vector<std::uint8_t> numbers_in(const Texture& picture) const;

    /// Of all levels, level by level; for graphics cards.
    const std::vector<std::uint32_t>& levels() const { return levels_; }

private:
    struct Painted {
        std::uint32_t color;
        std::uint8_t number;
    };
    std::vector<Painted> painted_;  ///< sorted by color
    std::vector<std::uint32_t> levels_;
};

}  // namespace enfilade
