// What one sees of a room and through its portals, by height and by row: shared by all renderers.
#pragma once
#include <bit>
#include <cstdint>

#include "map/map.h"
#include "render/built_in.h"

namespace enfilade {

/// Heights of a room, or of a part of a wall, above the eye [m].
struct RelativeHeights {
    double floor = 0;
    double ceiling = 0;

    bool is_empty() const { return floor >= ceiling; }
};

/// The rows [top, bottom) of one column that are still open: nothing has been drawn there yet.
struct OpenRows {
    int top = 0;
    int bottom = 0;  ///< top >= bottom: closed

    bool is_closed() const { return top >= bottom; }
};

/// A step without a texture is open: one sees past it. So is the upper step between two rooms under the sky, behind
/// which there would be nothing but sky.
inline bool has_upper_step(const Map& map, const Wall& portal) {
    const bool from_sky_to_sky = built_in::kSky && map[portal.sector].ceiling.sky && map[portal.behind].ceiling.sky;
    return map[portal.upper].texture && !from_sky_to_sky;
}

inline bool has_lower_step(const Map& map, const Wall& portal) { return static_cast<bool>(map[portal.lower].texture); }

// How far one look goes through doorways. What it may cost depends only on the rooms on its way, so that all renderers
// end it at the same doorway, whatever the size of the picture and however its work is divided among threads.

/// What looking into a room costs beside its walls, panels and things, each of which is looked at [walls].
inline constexpr std::uint32_t kRoomCost = 32;

/// A look that has cost this much goes through no further doorway; there the map's recursion colour is drawn [walls].
/// Enough for 1024 links, the most that max_depth allows, through rooms of 32 walls, and to look out of a room of
/// 65 000 walls. Each column of a picture costs at most this and one more room, about 2 ms: without it a room whose
/// 8000 walls all lead back into it took 10 s for 640 columns.
inline constexpr std::uint32_t kLookBudget = 1u << 16;

/// things: that are in the room; of the eye's own room 0, so that one can look out of it however many there are.
inline std::uint32_t cost_of_look_into(const Sector& sector, std::size_t things) {
    return sector.wall_count + sector.panel_count + static_cast<std::uint32_t>(things) + kRoomCost;
}

/// A look that strays: where the eye was rounded past the end of a link, a look along that end may miss every wall of a
/// room and goes on through the one it misses least. Such a look may come round to the wall it went through before, and
/// on for ever; there it ends, as one does that has cost too much. What it meets next depends on the wall it comes
/// through alone, so a ring is found as in a sequence of numbers, by remembering the first, second, fourth, eighth, …
/// wall (Richard Brent, "An improved Monte Carlo factorization algorithm", 1980): after at most four times as many
/// walls as there are.
class StrayingLook {
public:
    /// The look goes through the wall, having missed it (but least) or not; true where it comes round to it. Behind a
    /// link a look is a new one.
    bool comes_round_to(WallId wall, bool has_missed) {
        if (walls_ == 0 && !has_missed) return false;
        if (walls_ > 0 && wall == remembered_) return true;
        if (std::has_single_bit(++walls_)) remembered_ = wall;
        return false;
    }

private:
    std::uint32_t walls_ = 0;  ///< gone through since it missed one
    WallId remembered_;
};

/// Pictures with holes that are seen one behind the other: things, panels and fences that a look along one column of
/// the picture passes, whether they are in its way or above or below it. Those behind are left out: no honest map
/// stacks so many, and one that stacks more takes no more time and memory for it. Not of a tilted picture, whose
/// columns are no planes.
inline constexpr std::size_t kMostPictures = 512;

}  // namespace enfilade
