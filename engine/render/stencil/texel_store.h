// All pictures of a map in one texture of the graphics card, one after another, so that a whole layer is one draw.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "base/result.h"
#include "map/map.h"
#include "map/textures.h"
#include "render/light_grid.h"
#include "render/sprite.h"
#include "render/stencil/gl_object.h"
#include "world/snapshot.h"

namespace enfilade::stencil {

// A long list of whole numbers as a texture, which shaders read exactly: entry n is at (n mod kRow, n / kRow).

class ListTexture {
public:
    static constexpr std::uint32_t kRow = 2048;  ///< entries; OpenGL ES 3.0 promises textures this wide

    /// How many entries this graphics card has room for.
    static std::size_t most() {
        GLint rows = 0;
        glGetIntegerv(GL_MAX_TEXTURE_SIZE, &rows);
        return static_cast<std::size_t>(rows) * kRow;
    }

    /// Holds the list from now on, made up to whole rows; at most most() entries. stored, format, type: as
    /// glTexImage2D calls what an Entry is.
    template <class Entry>
    void hold(std::vector<Entry>& list, GLint stored, GLenum format, GLenum type) {
        const std::size_t rows = (list.size() + kRow - 1) / kRow;
        list.resize(rows * kRow);
        texture_.create();
        glBindTexture(GL_TEXTURE_2D, texture_.id());
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glTexImage2D(GL_TEXTURE_2D, 0, stored, GLsizei(kRow), static_cast<GLsizei>(rows), 0, format, type, list.data());
    }

    GLuint id() const { return texture_.id(); }

private:
    GlTexture texture_;
};

/// Width and height of a picture, each less than 2^16, as one number.
inline std::uint32_t size_of(const Texture& picture) { return picture.width | picture.height << 16; }

/// Texel (x, y) of a picture is number place + x * height + y; whole numbers are read
/// back, so nearest sampling is the same arithmetic as in the other renderers.
class TexelStore {
public:
    /// Loads the pictures. An error where they do not fit.
    Result<void> hold(const TextureSet& textures);

    std::uint32_t place_of(TextureId id) const { return places_[id ? id.index : places_.size() - 1]; }
    GLuint texture() const { return texture_.id(); }

    /// Where the map has a color table: the number in it of each texel of the pictures that go by it, and what the
    /// colours are at each level, level by level.
    GLuint color_numbers() const { return color_numbers_.id(); }
    GLuint color_table() const { return color_table_.id(); }

private:
    void hold_color_table(const TextureSet& textures);

    ListTexture texture_, color_numbers_, color_table_;
    std::vector<std::uint32_t> places_;  ///< by TextureId; the placeholder comes last
};

// What few surfaces need beyond their PaintParams, in one texture of the graphics card: pairs of numbers, found by
// their place.

/// Where layers over flats are found.
struct LayerSource {
    const Map& map;
    const Snapshot& snapshot;
    const TextureSet& textures;
    const TexelStore& store;
};

/// The records of one frame. The first pair is not used, so that 0 is no record.
class Records {
public:
    using Pair = std::array<std::uint32_t, 2>;
    /// Forgets all of the frame before.
    void clear();

    /// Where the pairs are. They keep their order.
    std::uint32_t add(std::span<const Pair> pairs);

    /// The layers over a sky, how many first; 0: it has none. The same sky has the same record.
    std::uint32_t sky(const LayerSource& from, const FlatNow& sky);

    /// Those over a floor or ceiling, how many first, and the record `lamplight` of its point lights, or 0. eye: in its
    /// space [m].
    std::uint32_t level(const LayerSource& from, const FlatNow& flat, Vec2 eye, std::uint32_t lamplight);

    /// Point lights on a surface: their grid, and how its points are counted: scale * what the shader knows + start.
    std::uint32_t lamplight(const LightGrid& grid, Vec2 scale, Vec2 start);

    /// For the graphics card. Costs nothing where there are none. An error where they do not fit.
    Result<void> upload();

    GLuint texture() const { return texture_.id(); }

private:
    ListTexture texture_;
    std::vector<Pair> pairs_;
    std::map<const LightGrid*, std::uint32_t> grids_;  ///< where their points are
    std::vector<std::uint32_t> skies_;                 ///< by first layer; 0: not yet asked for
};

}  // namespace enfilade::stencil
