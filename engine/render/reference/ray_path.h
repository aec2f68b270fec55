// The walls a ray meets in the plane, one after the other: through portals, links and mirrors, decided exactly.
#pragma once
#include <cstdint>
#include <vector>

#include "map/map.h"
#include "math/predicates.h"
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
};

/// The course of a ray. A ray straight up or down leans ahead by a hair. Rays that are not tilted keep their bits.
RayCourse ray_course(const Ray& ray);

/// The view from which the ray is followed.
View turned(const View& view, int quarters);

/// The eye and its look, carried through every link passed so far into the space where the ray now is.
struct EyeSpace {
    Vec2 eye;            ///< on the point grid [m]
    double eye_z = 0;    ///< [m]
    Vec2 forward{1, 0};  ///< unit vector
    double flip = 1;     ///< -1: an odd number of mirrors was passed
    int links = 0;       ///< linked portals and mirrors passed

    /// Direction in the plane of the ray with this slope; its length along `forward` is 1.
    Vec2 direction(double slope) const { return forward + right_of(forward) * (flip * slope); }
};

/// One panel met by a ray, and where.
struct PanelHit {
    PanelId panel;
    double along = 0;  ///< 0 at the panel's a, 1 at its b [1]
    double depth = 0;  ///< along `forward`; 0 where the eye is on the panel's line [m]
};

/// One wall met by a ray, and where.
struct RayHit {
    EyeSpace space;
    SectorId sector;               ///< the one the ray was in
    WallId wall;                   ///< of that sector
    double along = 0;              ///< 0 at the wall's a, 1 at its b [1]
    double depth = 0;              ///< along `forward`; 0 where the eye is on the wall's line [m]
    std::uint32_t spent = 0;       ///< on the looks into this sector and those before it (render/openings.h)
    bool is_missed = false;        ///< no wall of the sector was met; this one was missed least
    bool comes_round = false;      ///< it was met before (render/openings.h): the ray ends here
    bool ambiguous = false;        ///< a vertex, another wall or a panel was within kAmbiguous of changing the answer
    std::vector<PanelHit> panels;  ///< with a picture, met on the way through the sector; depths never fall
};

/// A decision that a shift of this much would have changed is called ambiguous [m]. Far above the rounding of any
/// renderer that computes in double (1e-9 at the edge of the world), far below what anyone can see.
inline constexpr double kAmbiguous = 1e-7;

/// The path of the rays of one pixel column. All pixels of a column meet the same walls in the same order; they only
/// differ in how far up or down they are when they get there, so the path is found once and as far as somebody asks.
///
/// The ray's normal is rounded once to a grid of 2^-55. From then on which wall it meets is decided in whole numbers,
/// for an eye at eye + (e, e^2) (math/predicates.h) in every space: no crack, no double cover, no tolerance.
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
    void start_step(const EyeSpace& space);
    void add(RayHit hit, std::uint32_t spent);
    void add_next();
    RayHit next_hit(const EyeSpace& space, SectorId sector) const;
    WallId nearest_covering(const EyeSpace& space, SectorId sector) const;
    WallId least_missed(const EyeSpace& space, SectorId sector) const;
    bool is_ambiguous(const RayHit& hit) const;
    bool ends_near_ray(const DirectedEdge& edge, const RayHit& hit) const;
    bool is_beyond_entry(const DirectedEdge& edge) const;
    void add_panels(RayHit& hit) const;
    void put_in_order(RayHit& hit) const;

    Int128 offset(Vec2 vertex, Vec2 eye) const;
    int side(Vec2 vertex, Vec2 eye) const;
    bool covers(const DirectedEdge& edge, const EyeSpace& space) const;
    double depth_of(const DirectedEdge& edge, const EyeSpace& space) const;

    const Map& map_;
    const Presences* things_;
    double slope_;
    SectorId first_sector_;
    EyeSpace first_space_;
    WallId entry_;                              ///< wall the ray came into the present sector by, or none
    double entry_depth_ = 0;                    ///< [m]
    std::int64_t normal_x_ = 0, normal_y_ = 0;  ///< slope * forward - right [2^-55]
    int side_of_tie_ = 1;                       ///< what side() says of a vertex exactly on the ray
    StrayingLook straying_;
    std::vector<RayHit> hits_;
};

}  // namespace enfilade
