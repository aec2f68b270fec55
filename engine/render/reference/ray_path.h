// The walls a ray meets in the plane, one after the other: through portals, links and mirrors, decided exactly.
#pragma once
#include <cstdint>
#include <vector>

#include "map/map.h"
#include "render/exact_ray.h"
#include "render/openings.h"
#include "render/view.h"
#include "space/reach.h"

namespace enfilade {

// Walls and panels as edges in the plane, and which of two a ray meets first.

/// A directed edge.
struct DirectedEdge {
    Vec2 a, b;  ///< on the vertex grid

    DirectedEdge(Vec2 start, Vec2 end) : a(start), b(end) {}
    DirectedEdge(const Wall& wall) : a(wall.a), b(wall.b) {}  // NOLINT(google-explicit-constructor): a wall is one
};

/// Where e lies as seen from the line of another: 1 on its right, -1 on its left (touching allowed), 0 on both sides or
/// all on the line. Edges of a sector and its panels never cross: where this is 0 one way round, it is not the other,
/// unless both are on one line.
int side_of_edge(const DirectedEdge& line, const DirectedEdge& e);

bool are_on_one_line(const DirectedEdge& e, const DirectedEdge& f);

/// Both face the eye and cover the ray: is e met before f? Not if both are on one line.
bool is_in_front(const DirectedEdge& e, const DirectedEdge& f);

// How a ray of a tilted picture is followed: in the plane of its own, like a ray of a picture that is not tilted and
// looks where the ray goes.

/// A ray in the way it is followed: from a view that is turned by whole quarters, so that the ray goes ahead.
struct RayCourse {
    int quarters = 0;        ///< to the right, 0..3; 0 where the picture is not tilted
    double slope = 0;        ///< to the right, per metre ahead
    double climb = 0;        ///< up, per metre ahead; finite
    double depth_scale = 1;  ///< depth along the line of sight, per metre ahead
    RowClimb tied_climb;     ///< how it climbs by the tie rule for rows: of this is asked which heights it passes
};

/// The course of the ray of a pixel. A ray straight up or down leans ahead by a hair.
RayCourse ray_course(const Projection& projection, int x, int y);

/// The view from which the ray is followed.
View turned(const View& view, int quarters);

/// One panel met by a ray, and where.
struct PanelHit {
    PanelId panel;
    double along = 0;  ///< 0 at the panel's a, 1 at its b [1]
    RayDepth depth;    ///< 0 where the eye is on the panel's line
};

/// One wall met by a ray, and where.
struct RayHit {
    Pose space;                    ///< the eye and its look, carried through every link passed so far
    SectorId sector;               ///< the one the ray was in
    WallId wall;                   ///< of that sector
    double along = 0;              ///< 0 at the wall's a, 1 at its b [1]
    RayDepth depth;                ///< 0 where the eye is on the wall's line
    std::uint32_t spent = 0;       ///< on the looks into this sector and those before it (render/openings.h)
    bool is_missed = false;        ///< no wall of the sector was met; this one was missed least
    bool comes_round = false;      ///< it was met before (render/openings.h): the ray ends here
    std::vector<PanelHit> panels;  ///< with a picture, met on the way through the sector, in order
};

/// The path of the rays of one pixel column. All pixels of a column meet the same walls in the same order; they only
/// differ in how far up or down they are when they get there, so the path is found once and as far as somebody asks.
///
/// Cost: each step looks at all walls of one sector.
class RayPath {
public:
    /// view.sector contains view.eye. The map is kept by reference, and so are the things, which only count for what
    /// the look has spent; null: there are none.
    RayPath(const Map& map, const Presences* things, const View& view, double slope);

    /// The i-th wall met, i counting from 0. All before it must be portals or mirrors, as what is behind a solid wall
    /// is not defined. The reference is valid until the next call.
    const RayHit& operator[](std::size_t i);

private:
    void start_step(const Pose& space);
    void add(RayHit hit, std::uint32_t spent);
    void add_next();
    RayHit next_hit(const Pose& space, SectorId sector) const;
    WallId nearest_covering(const Pose& space, SectorId sector) const;
    bool is_beyond_entry(const DirectedEdge& edge) const;
    void add_panels(RayHit& hit) const;
    void put_in_order(RayHit& hit) const;
    bool covers(const DirectedEdge& edge, const Pose& space) const;
    double along(const DirectedEdge& edge, const Pose& space) const;

    const Map& map_;
    const Presences* things_;
    double slope_;
    SectorId first_sector_;
    Pose first_space_;
    WallId entry_;      ///< wall the ray came into the present sector by, or none
    RayNormal normal_;  ///< in the present space
    StrayingLook straying_;
    std::vector<RayHit> hits_;
};

}  // namespace enfilade
