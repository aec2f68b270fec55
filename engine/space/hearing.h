// How sound comes to a listener: along the shortest way through open portals, linked ones too, and around corners.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "space/tiling.h"
#include "space/trace.h"

namespace enfilade {

/// The way a sound takes.
struct SoundWay {
    double length_m = 0;  ///< on the drawing, whatever the heights [m]
    Vec2 from;  ///< the direction from which it arrives, in the space of the listener: towards its last bend, or its
                ///< source; length 1, or (0, 0) where it has no length
};

/// All ways to one listener. Listen once, then ask for any number of sources.
///
/// A way is straight but for bends at corners of walls, and passes portals only. Everything is found from the listener
/// outward: cones of sight cross the triangles of the floors in the order of their distance; where a cone's edge is a
/// corner, what lies in its shadow is searched from the corner. Side tests are exact, lengths are rounded; where two
/// ways have the same length, the one found first counts, the same on every machine.
/// Source: M. Cui, D. Harabor, A. Grastien, "Compromise-free Pathfinding on a Navigation Mesh", IJCAI 2017, here from
/// one place to all others, and through links.
class Hearing {
public:
    /// The map must outlive it. Cost: that of a Tiling.
    explicit Hearing(const Map& map)
        : map_(map), tiling_(map), roots_(map.walls.size()), latest_(tiling_.tile_count()) {}

    /// Forgets what was heard before and listens at a place.
    /// reach_m  : longest way that counts [m]
    /// may_pass : asked for portals within reach, linked or not; what it refuses is a wall. Empty: all are open
    /// Cost: the triangles within reach, once for each way in which they are seen; at most kMostGlances.
    void listen(const Place& listener, double reach_m, const MayPass& may_pass = {});

    /// The sectors that sound gets to, and those behind closed portals that it gets to, by number.
    std::span<const SectorId> sectors() const { return sectors_; }

    /// The shortest way from a place, or none: too far, or cut off. The point may also lie on a wall of the sector.
    std::optional<SoundWay> from(const Place& source) const;

    /// The shortest way from a whole sector: from where it is nearest, even where that is a closed portal. None as
    /// above.
    std::optional<SoundWay> from(SectorId sector) const;

    /// The nearest are found first, so what is missed beyond is the faintest. Less than 8 ms; a map may fold as much
    /// space as it likes into a metre, and pillared halls of Doom have several times as many within 32 m.
    static constexpr std::size_t kMostGlances = 1u << 13;

private:
    static constexpr std::uint32_t kNone = 0xFFFFFFFFu;

    /// Where the root of a glance is an end of the edge it enters by: it sees all of the tile, and turns on around
    /// that end for as long as it turns away from the way it came.
    enum class Fan : std::uint8_t { none, left, right };

    /// A look into a tile from a root, the last corner of the way or the listener, through one of its edges.
    struct Glance {
        Vec2 root;
        Vec2 left, right;               ///< between these one looks; a fan's other one is straight on
        double length = 0;              ///< of the way to the root [m]
        std::uint32_t edge = kNone;     ///< through which it enters; the tile is on its right
        std::uint32_t earlier = kNone;  ///< glance into the same tile
        WallId corner;                  ///< begins at the root; none: the root is the listener
        Fan fan = Fan::none;
        Rigid passage;    ///< from the space of the listener into that of the tile
        Vec2 first_bend;  ///< in the space of the listener; only where there is a corner
    };
    /// A glance that has not gone on yet, and what a way through it is at least [m].
    struct Waiting {
        double least;
        std::uint32_t glance;
    };
    struct Touched {
        SectorId sector;
        SoundWay way;
    };
    /// The shortest way to a corner, or the latest glance into a tile; of an earlier listening where that is not the
    /// present one.
    struct Root {
        std::uint32_t listening = 0;
        double length = 0;
    };
    struct Latest {
        std::uint32_t listening = 0, glance = kNone;
    };

    void look_around();
    void go_on(const Glance& glance);
    void fan_out(const Glance& glance);
    void turn_left(const Glance& glance);
    void turn_right(const Glance& glance);
    void look_through(Glance glance, std::uint32_t edge, Vec2 left, Vec2 right);
    void fan_through(Glance glance, std::uint32_t edge, Fan fan, Vec2 straight_on);
    void pass(Glance glance, std::uint32_t edge, Vec2 nearest);
    void carry(Glance& glance, const Wall& link) const;
    void keep(Glance glance, double least);
    void sort_out();

    bool is_open(WallId wall, const Rigid& passage) const;
    bool is_corner(WallId corner, const Rigid& passage) const;
    bool is_outdone(const Glance& glance) const;
    bool take_corner(const Glance& bent);
    Glance bent(const Glance& glance, std::uint32_t corner_edge) const;
    SoundWay way_over(const Glance& glance, Vec2 point) const;
    std::optional<SoundWay> way_into(const Glance& glance, Vec2 point) const;
    Vec2 start_of(std::uint32_t edge) const { return map_[tiling_.corner(edge)].a; }
    Vec2 end_of(std::uint32_t edge) const { return start_of(next_edge(edge)); }

    const Map& map_;
    Tiling tiling_;
    Place listener_;
    std::uint32_t own_tile_ = kNone;
    double reach_m_ = 0;
    MayPass may_pass_;
    std::uint32_t listening_ = 0;  ///< its number, so that nothing as large as the map need be cleared
    std::vector<Root> roots_;      ///< by the wall that begins at the corner
    std::vector<Latest> latest_;   ///< by tile
    std::vector<Glance> glances_;
    std::vector<Waiting> waiting_;  ///< a heap
    std::vector<Touched> touched_;  ///< by sector
    std::vector<SectorId> sectors_;
};

}  // namespace enfilade
