// Sectors, loops and walls out of their records: coordinates go onto the vertex grid and are checked there.
#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "map/draft.h"
#include "map/say.h"
#include "math/grid.h"

namespace enfilade {
namespace {

TextPlace place_of_vertex(const SectorRecord& sector, const LoopRecord& loop, std::size_t i) {
    if (i < loop.vertex_places.size() && loop.vertex_places[i].line != 0) return loop.vertex_places[i];
    if (i < loop.walls.size() && loop.walls[i].place.line != 0) return loop.walls[i].place;
    return loop.place.line != 0 ? loop.place : sector.place;
}

/// Rounding comes first, so a number that rounds to the limit is in range. False for numbers that are none.
bool is_in_range(double x) { return std::abs(x) <= kWorldLimit + 1 && std::abs(snap_to_vertex_grid(x)) <= kWorldLimit; }

bool check_range(Draft& draft, const SectorRecord& sector, const LoopRecord& loop) {
    bool all = true;
    for (std::size_t i = 0; i < loop.vertices.size(); ++i) {
        const Vec2 v = loop.vertices[i];
        if (is_in_range(v.x) && is_in_range(v.y)) continue;
        all = false;
        draft.error(place_of_vertex(sector, loop, i), "vertex-out-of-range",
                    "expected coordinates between -32768 and 32768, found " + to_text(v) + " in sector " +
                        quoted(sector.name) + "; move the map nearer to the origin");
    }
    return all;
}

bool check_count(Draft& draft, const SectorRecord& sector, const LoopRecord& loop) {
    // The reader reports the difference and says so in the findings; here it only must do no harm.
    const bool same = loop.vertices.size() == loop.walls.size();
    ENFILADE_CHECK(same || has_errors(draft.findings));
    if (loop.vertices.size() >= 3) return same;
    draft.error(loop.place.line != 0 ? loop.place : sector.place, "too-few-vertices",
                "expected at least 3 vertices in a loop, found " + std::to_string(loop.vertices.size()) +
                    " in sector " + quoted(sector.name) + "; use a panel for a wall without thickness");
    return false;
}

void check_length(Draft& draft, const SectorRecord& sector, const LoopRecord& loop, std::size_t i, const Wall& wall) {
    if (wall.a != wall.b) return;
    const std::size_t next = (i + 1) % loop.vertices.size();
    const bool was_rounded = loop.vertices[i] != loop.vertices[next];
    draft.error(place_of_vertex(sector, loop, i), "zero-length",
                "two neighbouring vertices of sector " + quoted(sector.name) + " are both at " + to_text(wall.a) +
                    (was_rounded ? " after rounding to the grid of 1/1024 m; drop one or move them apart"
                                 : "; drop one of them (the last wall closes the loop by itself)"));
}

/// The loop's walls, closed into a ring.
void add_loop(Draft& draft, SectorId id, const SectorRecord& sector, const LoopRecord& record) {
    const auto first = static_cast<std::uint32_t>(draft.map.walls.size());
    const auto count = static_cast<std::uint32_t>(std::min(record.vertices.size(), record.walls.size()));
    draft.loops.push_back({&record, first, count});
    for (std::uint32_t i = 0; i < count; ++i) {
        Wall wall;
        wall.a = snap_to_vertex_grid(record.vertices[i]);
        wall.b = snap_to_vertex_grid(record.vertices[(i + 1) % count]);
        wall.length = std::sqrt(dot(wall.b - wall.a, wall.b - wall.a));
        wall.sector = id;
        wall.next = WallId(first + (i + 1) % count);
        wall.previous = WallId(first + (i + count - 1) % count);
        draft.walls.push_back({&record.walls[i], place_of_vertex(sector, record, i)});
        draft.map.walls.push_back(wall);
    }
}

void add_bounds(Sector& sector, const std::vector<Wall>& walls) {
    sector.min = {kWorldLimit, kWorldLimit};
    sector.max = {-kWorldLimit, -kWorldLimit};
    for (std::uint32_t i = sector.first_wall; i < sector.first_wall + sector.wall_count; ++i) {
        sector.min = {std::min(sector.min.x, walls[i].a.x), std::min(sector.min.y, walls[i].a.y)};
        sector.max = {std::max(sector.max.x, walls[i].a.x), std::max(sector.max.y, walls[i].a.y)};
    }
}

/// True where all its loops can be measured.
bool add_loops(Draft& draft, SectorId id, const SectorRecord& record) {
    bool all = true;
    for (const LoopRecord& loop : record.loops) {
        const bool counts = check_count(draft, record, loop);
        const bool in_range = check_range(draft, record, loop);
        all = all && counts && in_range;
        if (!counts || !in_range) continue;
        add_loop(draft, id, record, loop);
        const Loop& added = draft.loops.back();
        for (std::uint32_t i = 0; i < added.wall_count; ++i)
            check_length(draft, record, loop, i, draft.map.walls[added.first_wall + i]);
    }
    return all;
}

void add_sector(Draft& draft, const SectorRecord& record) {
    const SectorId id(draft.map.sectors.size());
    SectorDraft parts{&record};
    Sector sector;
    sector.name = record.name;
    sector.light = record.light;
    sector.floor.z = record.floor.z;
    sector.ceiling.z = record.ceiling.z;
    sector.first_wall = static_cast<std::uint32_t>(draft.map.walls.size());
    parts.first_loop = static_cast<std::uint32_t>(draft.loops.size());
    parts.measurable = add_loops(draft, id, record);
    parts.loop_count = static_cast<std::uint32_t>(draft.loops.size()) - parts.first_loop;
    sector.wall_count = static_cast<std::uint32_t>(draft.map.walls.size()) - sector.first_wall;
    add_bounds(sector, draft.map.walls);
    if (record.loops.empty()) {
        parts.measurable = false;
        draft.error(record.place, "no-loops",
                    "expected at least one [[sectors.loops]] in sector " + quoted(record.name) + ", found none");
    }
    draft.map.sectors.push_back(std::move(sector));
    draft.sectors.push_back(parts);
}

}  // namespace

void place_walls(Draft& draft) {
    if (draft.file.sectors.empty())
        draft.error({}, "no-sectors", "expected at least one [[sectors]], found none; a map needs a room to stand in");
    draft.map.sectors.reserve(draft.file.sectors.size());
    draft.sectors.reserve(draft.file.sectors.size());
    for (const SectorRecord& record : draft.file.sectors) add_sector(draft, record);
}

}  // namespace enfilade
