// Which rooms a picture shows and how far into each it looks, unfolded into the space of the eye: what lies behind a
// link or in a mirror is where it appears to be.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "map/map.h"
#include "render/view.h"
#include "space/trace.h"
#include "world/snapshot.h"

namespace enfilade {

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

}  // namespace enfilade
