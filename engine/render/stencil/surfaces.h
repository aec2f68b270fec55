// What polygons show, as the graphics card is told: the numbers of each, the texels and records that they refer to, and
// how they follow from surfaces, pegs and light.
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
#include "render/lighting.h"
#include "render/shade.h"
#include "render/sprite.h"
#include "render/stencil/gl_object.h"
#include "render/stencil/plan.h"
#include "world/snapshot.h"

namespace enfilade::stencil {

// What a polygon shows, as the graphics card is told.

/// How a polygon's pixels are painted; numbers known to the shader.
enum class Paint : std::uint32_t { wall, flat, sky, color, picture };

/// Beside the paint: the surface is in classic light; else in smooth. Known to the shader, too.
inline constexpr std::uint32_t kClassicLight = 1u << 31;
/// Beside the paint: the picture goes by the map's color table. Known to the shader, too.
inline constexpr std::uint32_t kByTable = 1u << 30;

/// Beside the paint: layers are laid over the floor or ceiling; its record begins with them.
inline constexpr std::uint32_t kLayered = 1u << 29;

/// Numbers that change evenly over the picture are given as three: at the point `from`, per column and per row.
struct PaintParams {
    float from[2]{}, cross = 0;
    float order = 0;                  ///< the nearer the larger
    float span[3]{};                  ///< depth = cross / span
    float nearest = 0, farthest = 0;  ///< bounds of that depth [m]
    float light = 1, contrast = 1;
    float a[4]{};  ///< by Paint, see shaders.cpp
    float b[4]{};
    float c[4]{};
    std::uint32_t id_and_paint = 0;    ///< id in the low 24 bits; kClassicLight, kByTable
    std::uint32_t texels = 0;          ///< where the picture begins in the texel store; Paint::color: 0xAABBGGRR
    std::uint32_t size = 1 | 1 << 16;  ///< of the picture: size_of()
    std::uint32_t record = 0;          ///< what it needs beyond this: its place in Records; 0: nothing
    float left_edge[3]{1, 0, 0}, right_edge[3]{-1, 0, 0};  ///< tilted: shown where left >= 0 > right; from the corner
};

/// Which program draws a surface: chosen once for each, so that what it does not use is in no pixel's way (graphics
/// cards that draw many pixels in step take all branches of a program). A set of what the program can draw:
using Kind = std::uint8_t;
inline constexpr Kind kFlats = 1, kSkies = 2, kColors = 3;  ///< one of these, or none: walls and pictures
inline constexpr Kind kWithRecords = 4;                     ///< light of lamps, or a sky's layers
inline constexpr Kind kGoingByTable = 8;                    ///< and others
inline constexpr Kind kInSmoothLight = 16, kInClassicLight = 32;
inline constexpr Kind kWithHoles = 64;    ///< pixels that are not there, or hide only a part
inline constexpr Kind kWithLayers = 128;  ///< over floors and ceilings
inline constexpr std::size_t kKinds = 256;

inline Kind paints(Kind kind) { return kind & kColors; }

inline Kind kind_of(const PaintParams& params) {
    constexpr Kind kByPaint[] = {0, kFlats, kSkies, kColors, 0};
    const Kind paint = kByPaint[params.id_and_paint >> 24 & 7];
    Kind kind = paint;
    if (params.record != 0) kind |= kWithRecords;
    if ((params.id_and_paint & kByTable) != 0) kind |= kGoingByTable;
    if ((params.id_and_paint & kLayered) != 0) kind |= kWithLayers;
    const bool is_lit = paint == 0 || paint == kFlats;
    if (is_lit) kind |= (params.id_and_paint & kClassicLight) != 0 ? kInClassicLight : kInSmoothLight;
    return kind;
}

// All pictures of a map in one texture of the graphics card, one after another, so that a whole layer is one draw.

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

// What the parts of walls look like: from surfaces, pegs and light to what the shader is told.

/// What there is to see, and where its pictures are kept.
struct DrawInput {
    const FrameInput& input;
    const TexelStore& store;
    const Screen& screen;  ///< of the picture; of a tilted one: of its panorama
    const RayField& rays;
    Records& records;    ///< grow while PaintParams are made
    LightGrids* lights;  ///< null: the map has no point lights

    const Map& map() const { return input.map; }
};

/// Everything about one wall of a layer that its parts have in common.
struct SeenWall {
    const Pose& pose;
    const WallOnScreen& place;
    WallParts parts;
};

/// A wall or a step.
PaintParams wall_params(const DrawInput& scene, const SeenWall& wall, SurfaceId surface, WallPart part);

/// A picture with holes in a portal, shown once from top to bottom. top: above the eye [m].
PaintParams hanging_params(const DrawInput& scene, const SeenWall& wall, double top);

PaintParams panel_params(const DrawInput& scene, const PanelOnScreen& panel, const Pose& pose);

/// A floor or ceiling, or the sky: above and below a wall everything up to the picture's edge shows it, because there
/// a ray has left the room's heights before it reached the wall. height: of the flat above the eye [m]. grid: of point
/// lights on it; null: none.
PaintParams flat_params(const DrawInput& scene, const SeenWall& wall, const FlatNow& flat, double height,
                        const LightGrid* grid, PixelSurface id);

/// The end of a chain of links.
PaintParams end_params(const DrawInput& scene, const SeenWall& wall);

/// Only where it is: for masks.
PaintParams plain_params(const DrawInput& scene, const WallOnScreen& place);

PaintParams thing_params(const DrawInput& scene, const ThingOnScreen& thing);

}  // namespace enfilade::stencil
