// A picture of the world from outside, above the eye or behind it: what the eye sees, where it sees it, and through
// which portals. Rooms behind links and in mirrors are where they appear to be.
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "map/map.h"
#include "map/textures.h"
#include "math/vec.h"
#include "render/frame.h"
#include "render/outside/outside_camera.h"
#include "render/shade.h"
#include "render/view.h"
#include "space/trace.h"
#include "space/triangulate.h"
#include "world/snapshot.h"

namespace enfilade {

// Which rooms a picture shows and how far into each it looks, unfolded into the space of the eye: what lies behind a
// link or in a mirror is where it appears to be.

/// A room as it lies around the eye.
struct UnfoldedRoom {
    SectorId sector;
    Rigid to_eye;  ///< from the sector's space into that of the eye
};

/// The rooms of one picture. Every column of the picture is one look along the ground, exact as all of space/ is, that
/// passes what is open between the picture's first and last row.
///
/// A picture that is turned instead of sheared (View::tilt) is taken for the sheared one with the same yaw, pitch and
/// field of view, as far up or down as a sheared one can look.
class SeenRooms {
public:
    /// Forgets what was before, and looks. width, height: of the picture, 1..kMaxPictureSide [px].
    /// Cost: for each column the walls of the rooms it looks into, at most kLookBudget and one room more.
    void look(const Map& map, const Snapshot& snapshot, const View& view, int width, int height);

    /// Adds a room, and the rooms that one can walk to from it and from the eye's room by plain doorways, those nearer
    /// to `middle` than `reach` [m]: nothing of them is seen where looks did not get to them. Cost: their walls.
    void add_surroundings(const Map& map, SectorId room, Vec2 middle, double reach);

    /// The eye's own room first, each room once for each way in which it lies around the eye; kMostRooms at most, and
    /// but for the first with no more than kMostWalls together.
    const std::vector<UnfoldedRoom>& rooms() const { return rooms_; }

    /// Whether the picture shows this point of a room's ground or air, or of one of its walls: `wall`.
    /// room: index into rooms(). p, z: in the space of the eye [m]. Cost: the doorways before it.
    bool shows(std::size_t room, WallId wall, Vec2 p, double z) const;

    /// Whether looks pass through a wall of a room, or one walks through it into the surroundings.
    bool passes(const Map& map, std::size_t room, WallId wall) const {
        return behind_[first_behind_[room] + wall.index - map[rooms_[room].sector].first_wall] != kNone;
    }

    double half_fov_tangent() const { return half_fov_tangent_; }

    /// Where the look through the first or the last column ends, in the space of the eye [m].
    Vec2 end_of_first() const { return end_of(0); }
    Vec2 end_of_last() const { return end_of(first_.size() - 2); }

    /// More cannot be told apart in a picture; looks end where another would be needed.
    static constexpr std::size_t kMostRooms = 1024;

    /// Several times what a large level of Doom has as a whole; what is drawn of so many takes some 50 megabytes.
    static constexpr std::size_t kMostWalls = std::size_t{1} << 17;

private:
    static constexpr std::uint32_t kNone = 0xFFFFFFFFu;

    /// What a look sees of one room.
    struct SeenPart {
        std::uint32_t room = 0;
        WallId exit;               ///< the wall that it meets there, or none: it ends in the air
        double exit_depth = 0;     ///< along the view's forward [m]
        double low = 0, high = 0;  ///< between which climbs it is open [1]
    };

    void follow(const Map& map, const Snapshot& snapshot, int column);
    /// The look beyond the wall that it meets, or none: it ends there.
    std::optional<PathSegment> go_on(const Map& map, const Snapshot& snapshot, const PathSegment& segment,
                                     SeenPart& part);
    /// The room that `room` has behind one of its walls, or kNone: there are too many.
    std::uint32_t room_behind(const Map& map, std::uint32_t room, WallId wall);
    std::uint32_t find_or_add(const Map& map, const UnfoldedRoom& room);
    Vec2 end_of(std::size_t column) const;

    View view_;  ///< upright
    std::vector<double> slopes_;
    double half_fov_tangent_ = 1, middle_column_ = 0;  ///< the latter as in Projection
    double lowest_ = 0, highest_ = 0;                  ///< climbs of the picture's last and first row [1]
    std::vector<UnfoldedRoom> rooms_;
    std::vector<std::uint32_t> first_behind_, behind_;  ///< rooms behind a room's walls: behind_[first_behind_[room]…]
    std::vector<SeenPart> parts_;
    std::vector<std::size_t> first_;  ///< those of column x are parts_[first_[x]] to parts_[first_[x + 1]]
};

// Flat pieces of the world as an outside camera sees them: put into a picture pixel by pixel, the nearest one wins.
//
// Rims are lines in homogeneous coordinates, so nothing is clipped before the camera (Marc Olano, Trey Greer: "Triangle
// Scan Conversion using 2D Homogeneous Coordinates", 1997). Two facets that share a rim compute it from the same two
// points and get exactly opposite lines: between them no pixel is left out and none is in both.

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

// What is drawn into a picture from outside to explain it: the eye, the edges of what it sees, and the portals that it
// looks through.

/// Colours of the automap, so that one learns them once [0xAABBGGRR].
inline constexpr std::uint32_t kLinkMark = 0xFFFF80C0, kMirrorMark = 0xFFFFE080, kDoorwayMark = 0xFF909090,
                               kEyeMark = 0xFF40FF40;

/// Adds the frames of all portals that looks pass: links and mirrors whole, plain doorways by their sills.
/// Only right after rooms.look().
void add_portal_marks(const OutsideScene& scene, const SeenRooms& rooms, std::vector<Facet>& facets);

/// Adds the eye, a pyramid that opens the way it looks, and the two edges of its field of view.
void add_eye_marks(const OutsideScene& scene, const SeenRooms& rooms, std::vector<Facet>& facets);

// The renderer.

/// What to draw.
struct OutsideLook {
    OutsideFrom from = OutsideFrom::above;
    double reach_m = kUsualReach;              ///< kLeastReach..kMostReach [m]
    int seen_width = 1280, seen_height = 800;  ///< of the picture whose view is shown, 1..kMaxPictureSide [px]
    const View* camera = nullptr;              ///< not null: from there instead, with what is around its sector
};

/// Draws pictures of one map from outside, one at a time. What is seen is bright, the rest of the rooms dim; where
/// rooms lie on one another, what is seen comes before what is not. Roofs and walls that face away are left out.
class OutsideRenderer {
public:
    /// map, textures: outlive it.
    OutsideRenderer(const Map& map, const TextureSet& textures);

    /// Sets every pixel of the frame, whose size is the picture's. `view` is what the eye sees.
    /// workers: threads, >= 1; the picture does not depend on them.
    /// Cost: SeenRooms::look(), the walls of the rooms around, and the pixels that they cover.
    void render(Frame& frame, const Snapshot& snapshot, const View& view, const OutsideLook& look, std::size_t workers);

private:
    const Map& map_;
    const TextureSet& textures_;
    MapPieces pieces_;
    SeenRooms rooms_;
    std::vector<Facet> facets_;
};

}  // namespace enfilade
