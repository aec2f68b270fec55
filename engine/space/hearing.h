// How sound comes to a listener: along the shortest way through open portals, linked ones too, and around corners.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "space/trace.h"
#include "space/triangulate.h"

namespace enfilade {

/// The way a sound takes.
struct SoundWay {
    double length_m = 0;  ///< on the drawing, whatever the heights [m]
    Vec2 from;  ///< the direction from which it arrives, in the space of the listener: towards its last bend, or its
                ///< source; length 1, or (0, 0) where it has no length
};

/// What a listener may hear.
struct SoundSource {
    SectorId sector;
    std::optional<Vec2> point;  ///< none: all of the sector, and of those that move with it
    double reach_m = 0;         ///< nobody hears it at the end of a longer way [m]
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
    explicit Hearing(const Map& map);

    /// Listens at a place.
    /// reach_m  : longest way that counts [m]
    /// may_pass : asked for portals within reach, linked or not; what it refuses is a wall. Empty: all are open
    /// slice    : how many beams are followed now. A listening that is not at its end by then goes on in the next
    ///            call, instead of that one's own; until it ends, what is told below is that of the one before
    /// Cost: the triangles within reach, once for each way in which they are seen; at most kMostBeams, some 0.25 us
    /// each.
    void listen(const Place& listener, double reach_m, const MayPass& may_pass = {}, std::size_t slice = kMostBeams);

    /// The same, but only for these sources: from() finds the same ways to them; those to others may be longer or
    /// missing.
    /// Cost: what lies within reach of both listener and source is searched, until the shortest ways to all are known,
    /// and nothing for sources that are too far away in a straight line; in a map with links only the search ends
    /// earlier.
    void listen(const Place& listener, std::span<const SoundSource> sources, const MayPass& may_pass = {},
                std::size_t slice = kMostBeams);

    /// Nothing is heard any more, and no listening is under way: for one who was elsewhere when it was last asked.
    void forget();

    /// The sectors that sound gets to, and those behind closed portals that it gets to, by number.
    std::span<const SectorId> sectors() const { return heard_.sectors; }

    /// The shortest way from a place, or none: too far, or cut off. The point may also lie on a wall of the sector.
    std::optional<SoundWay> from(const Place& source) const;

    /// The shortest way from a whole sector and all that move with it: from where they are nearest, even where that is
    /// a closed portal. None as above.
    std::optional<SoundWay> from(SectorId sector) const;

    /// The nearest are found first, so what is missed beyond is the faintest. Less than 8 ms; a map may fold as much
    /// space as it likes into a metre, and pillared halls of Doom have several times as many within 32 m.
    static constexpr std::size_t kMostBeams = 1u << 13;

    /// A slice of some 0.04 ms, for who listens in every tick. Where there are many ways, a listening then takes
    /// several ticks, up to a second.
    static constexpr std::size_t kBeamsATick = 160;

private:
    static constexpr std::uint32_t kNone = 0xFFFFFFFFu;

    /// Where the root of a beam is an end of the edge it enters by: it sees all of the tile, and turns on around
    /// that end for as long as it turns away from the way it came.
    enum class Fan : std::uint8_t { none, left, right };

    /// What is seen of a tile from a root, the last corner of the way or the listener, through one of its edges.
    struct Beam {
        Vec2 root;
        Vec2 left, right;               ///< between these one looks; a fan's other one is straight on
        double length = 0;              ///< of the way to the root [m]
        std::uint32_t edge = kNone;     ///< through which it enters; the tile is on its right
        std::uint32_t earlier = kNone;  ///< beam into the same tile
        WallId corner;                  ///< begins at the root; none: the root is the listener
        Fan fan = Fan::none;
        Rigid passage;    ///< from the space of the listener into that of the tile
        Vec2 first_bend;  ///< in the space of the listener; only where there is a corner
    };
    /// A beam that has not gone on yet, and what a way through it is at least [m].
    struct Waiting {
        double least;
        std::uint32_t beam;
    };
    struct Touched {
        SectorId sector;
        SoundWay way;
    };
    /// The shortest way to a corner, of an earlier listening where that is not the present one.
    struct Root {
        std::uint32_t listening = 0;
        double length = 0;
    };
    /// Of something as large as the map, that need not be cleared: a number in a list of the listening.
    struct StampedNumber {
        std::uint32_t listening = 0, number = kNone;
    };
    /// What a listening found.
    struct SoundField {
        Place listener;
        std::uint32_t listening = 0;
        std::uint32_t own_tile = kNone;
        double reach_m = 0;
        std::vector<StampedNumber> latest;   ///< by tile: of the beams into it
        std::vector<StampedNumber> touched;  ///< by sector: of its way
        std::vector<Beam> beams;
        std::vector<Touched> ways;
        std::vector<SectorId> sectors;

        /// kNone where the entry is an earlier listening's.
        std::uint32_t number(const StampedNumber& entry) const {
            return entry.listening == listening ? entry.number : kNone;
        }
    };
    /// A source that is listened for, and the shortest way found so far [m].
    struct Sought {
        SoundSource source;
        Vec2 min, max;               ///< bounding box
        std::uint32_t tile = kNone;  ///< of its point
        double nearest = 0;
    };

    void begin(const Place& listener, double reach_m, const MayPass& may_pass);
    double seek(std::span<const SoundSource> sources, const Place& listener);
    Sought sought_as(const SoundSource& source) const;
    bool may_lead_to_sought(const Beam& beam, std::uint32_t edge, double least) const;
    bool is_all_found(double least) const;
    void follow(const MayPass& may_pass, std::size_t slice);
    void end();

    double follow_nearest();
    void look_around();
    void go_on(const Beam& beam);
    void fan_out(const Beam& beam);
    void turn_left(const Beam& beam);
    void turn_right(const Beam& beam);
    void look_through(Beam beam, std::uint32_t edge, Vec2 left, Vec2 right);
    void fan_through(Beam beam, std::uint32_t edge, Fan fan, Vec2 straight_on);
    void pass(Beam beam, std::uint32_t edge, Vec2 nearest);
    void touch(SectorId sector, const SoundWay& way);
    void pass_link(Beam& beam, const Wall& link) const;
    void keep(Beam beam, double least);

    bool is_open(WallId wall, const Rigid& passage) const;
    bool is_corner(WallId corner, const Rigid& passage) const;
    bool is_outdone(const Beam& beam) const;
    bool take_corner(const Beam& bent);
    Beam bent(const Beam& beam, std::uint32_t corner_edge) const;
    SoundWay way_over(const SoundField& field, const Beam& beam, Vec2 point) const;
    std::optional<SoundWay> way_into(const SoundField& field, const Beam& beam, Vec2 point) const;
    static SoundWay straight_way(Vec2 listener, Vec2 source);
    std::optional<SoundWay> from_part(SectorId sector) const;
    Vec2 start_of(std::uint32_t edge) const { return map_[tiling_.corner(edge)].a; }
    Vec2 end_of(std::uint32_t edge) const { return start_of(next_edge(edge)); }

    const Map& map_;
    Tiling tiling_;
    SoundField heard_;              ///< of the listening that ended last
    SoundField field_;              ///< of the one under way
    std::vector<Root> roots_;       ///< by the wall that begins at the corner
    std::vector<Waiting> waiting_;  ///< a heap
    MayPass may_pass_;
    std::uint32_t listening_ = 0;  ///< how many have begun
    bool is_under_way_ = false;
    bool is_seeking_ = false;  ///< only what is in sought_
    std::vector<Sought> sought_;
};

}  // namespace enfilade
