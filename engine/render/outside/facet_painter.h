// Flat pieces of the world as an outside camera sees them: put into a picture pixel by pixel, the nearest one wins.
//
// Rims are lines in homogeneous coordinates, so nothing is clipped before the camera (Marc Olano, Trey Greer: "Triangle
// Scan Conversion using 2D Homogeneous Coordinates", 1997). Two facets that share a rim compute it from the same two
// points and get exactly opposite lines: between them no pixel is left out and none is in both.
#pragma once
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "map/textures.h"
#include "math/vec.h"
#include "render/frame.h"
#include "render/outside/outside_camera.h"
#include "render/outside/seen_rooms.h"
#include "render/shade.h"
#include "space/triangulate.h"

namespace enfilade {

// Pictures made smaller, so that one seen from far away does not glitter.

/// A texture and its halves, quarters and so on to a single texel (Lance Williams: "Pyramidal Parametrics", 1983).
class TexturePyramid {
public:
    /// Cost: the texture's pixels.
    explicit TexturePyramid(const Texture& texture);

    /// The texel at a place, of the level in which a texel of the texture is at least half a pixel wide.
    /// u, v: on the tile. texels_per_px: of the texture itself, > 0
    std::uint32_t at(TilePlace u, TilePlace v, double texels_per_px) const;

private:
    struct MipLevel {
        std::uint32_t width = 1, height = 1;
        std::vector<std::uint32_t> pixels;  ///< by column, as in Texture
    };
    static MipLevel halved(const MipLevel& from);

    std::vector<MipLevel> levels_;  ///< the largest first
};

/// What hides what, whatever the depth: the first hides all others.
enum class FacetLayer : std::uint8_t { mark, seen, around, unfolded };

/// A point of a facet.
struct FacetCorner {
    Vec2 p;        ///< in the space of the eye [m]
    double z = 0;  ///< [m]
    Vec2 uv{};     ///< where on the picture [tiles]
};

/// How a facet looks.
struct FacetLook {
    const TexturePyramid* texture = nullptr;  ///< null: a mark, in `color` and in front of everything
    std::uint32_t color = 0;                  ///< 0xAABBGGRR
    Shade shade = 256;                        ///< where it is seen
    double texels_per_m = 1;
    FacetLayer unseen_layer = FacetLayer::around;
    std::size_t room = 0;  ///< index into SeenRooms::rooms()
    WallId wall{};         ///< of the map, where the facet is a part of one
};

/// Whether a facet that is seen from behind is left out.
enum class FacetSides : std::uint8_t { front, both };

/// A triangle or an upright rectangle, ready to be painted. Its front is where its corners run clockwise.
class Facet {
public:
    /// None where nothing of it is to be seen from this side.
    static std::optional<Facet> triangle(const OutsideCamera& camera, const std::array<FacetCorner, 3>& corners,
                                         const FacetLook& look, FacetSides sides);
    /// From the upper left corner and the lower right one, as seen from the front.
    static std::optional<Facet> upright(const OutsideCamera& camera, const FacetCorner& upper_left,
                                        const FacetCorner& lower_right, const FacetLook& look, FacetSides sides);

    /// The pixels [begin, end) of a row whose centres it covers, of a picture `width` wide; none where begin >= end.
    struct Span {
        int begin = 0, end = 0;
    };
    Span span(int row, int width) const;

    /// What is at the centre of a covered pixel.
    FacetCorner at(int x, int row) const;

    const FacetLook& look() const { return look_; }
    /// Rows in which it may have a span; [0, kMaxPictureSide) where it reaches behind the camera.
    int first_row() const { return first_row_; }
    int end_row() const { return end_row_; }

private:
    using Line = PicturePoint;  ///< x px + y py + w: positive inside

    Facet(const std::array<FacetCorner, 3>& corners, const FacetLook& look) : corners_(corners), look_(look) {}
    void bound_rows(std::span<const PicturePoint> points);

    std::array<FacetCorner, 3> corners_;
    FacetLook look_;
    std::array<Line, 3> opposite_{};  ///< by corner: 0 on the line through the other two
    std::array<Line, 4> rims_{};
    std::size_t rim_count_ = 0;
    int first_row_ = 0, end_row_ = 0;
};

/// Paints all facets over the frame. Of two in one layer at the same depth the one listed first is seen.
/// Cost: the pixels that they cover. workers: threads, >= 1; the picture does not depend on them.
void paint_facets(Frame& frame, std::span<const Facet> facets, const SeenRooms& rooms, const OutsideCamera& camera,
                  std::size_t workers);

// What an outside camera sees of rooms: floors, ceilings, walls, panels and things, each from its front only, so that
// one looks through roofs and near walls as into a doll's house.

/// What is worked out once for a map: floors as triangles, pictures made smaller.
class MapPieces {
public:
    /// map, textures: outlive it.
    MapPieces(const Map& map, const TextureSet& textures);

    /// Cost: that of triangulate(), the first time.
    const std::vector<Triangle>& triangles(SectorId sector);
    /// Cost: that of a TexturePyramid, the first time. id: none: the placeholder
    const TexturePyramid& pyramid(TextureId id);

private:
    const Map& map_;
    const TextureSet& textures_;
    std::vector<std::vector<Triangle>> triangles_;           ///< by sector; empty: not asked for yet
    std::vector<std::unique_ptr<TexturePyramid>> pyramids_;  ///< by texture, the placeholder last
};

/// What facets are made from.
struct OutsideScene {
    const Map& map;
    const TextureSet& textures;
    const Snapshot& snapshot;
    const View& view;
    const OutsideCamera& camera;
    MapPieces& pieces;
};

/// Adds all of a room. room: index into rooms.rooms(). Cost: its walls.
void add_room_facets(const OutsideScene& scene, const SeenRooms& rooms, std::size_t room, std::vector<Facet>& facets);

}  // namespace enfilade
