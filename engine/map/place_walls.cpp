// Sectors, loops and walls out of their records: coordinates go onto the vertex grid and are checked there.
#include <cmath>

#include "base/result.h"
#include "formats/text_parts.h"
#include "map/draft.h"
#include "map/say.h"
#include "map/shape.h"
#include "math/vec.h"

namespace enfilade {
namespace {

TextPlace place_of_vertex(const SectorRecord& sector, const LoopRecord& loop, std::size_t i) {
    if (i < loop.vertex_places.size() && loop.vertex_places[i].line != 0) return loop.vertex_places[i];
    if (i < loop.walls.size() && loop.walls[i].place.line != 0) return loop.walls[i].place;
    return loop.place.line != 0 ? loop.place : sector.place;
}

bool check_count(Draft& draft, const SectorRecord& sector, const LoopRecord& loop) {
    ENFILADE_CHECK(loop.vertices.size() == loop.walls.size());
    const std::size_t count = loop.vertices.size();
    if (count >= 3) return true;
    if (!loop.is_whole || (count == 0 && !draft.was_sound)) return false;  // the reader could not make it out
    draft.error(known(key_place(loop, "v"), sector.place), "too-few-vertices",
                "expected at least 3 vertices in a loop, found " + std::to_string(count) + " in sector " +
                    quoted(sector.name) + "; use a panel for a wall without thickness");
    return false;
}

/// On the grid. Rounding comes before the check: what rounds to the limit is in range.
Vec2 placed(Vec2 vertex) {
    const Vec2 v = snap_to_vertex_grid(vertex);
    ENFILADE_CHECK(std::abs(v.x) <= kWorldLimit && std::abs(v.y) <= kWorldLimit);
    return v;
}

bool check_length(Draft& draft, const SectorRecord& sector, const LoopRecord& loop, std::size_t i, const Wall& wall) {
    if (wall.a != draft.map[wall.next].a) return true;
    const std::size_t next = (i + 1) % loop.vertices.size();
    const bool was_rounded = loop.vertices[i] != loop.vertices[next];
    draft.error(place_of_vertex(sector, loop, i), "zero-length",
                "two neighbouring vertices of sector " + quoted(sector.name) + " are both at " + point_text(wall.a) +
                    (was_rounded ? " after rounding to the grid of 1/1024 m; drop one or move them apart"
                                 : "; drop one of them (the last wall closes the loop by itself)"));
    return false;
}

/// The loop's walls, closed into a ring.
void add_loop(Draft& draft, const SectorRecord& sector, const LoopRecord& record) {
    const auto first = static_cast<std::uint32_t>(draft.map.walls.size());
    const auto count = static_cast<std::uint32_t>(record.vertices.size());
    draft.loops.push_back({&record, first, count});
    for (std::uint32_t i = 0; i < count; ++i) {
        Wall wall;
        wall.a = placed(record.vertices[i]);
        wall.next = WallId(first + (i + 1) % count);
        draft.walls.push_back({&record.walls[i], place_of_vertex(sector, record, i)});
        draft.map.walls.push_back(wall);
    }
}

/// True where nothing is wrong with any of its loops so far.
bool add_loops(Draft& draft, const SectorRecord& record) {
    bool all = !record.loops.empty();
    for (const LoopRecord& loop : record.loops) {
        if (!check_count(draft, record, loop)) {
            all = false;
            continue;
        }
        add_loop(draft, record, loop);
        const DraftLoop& added = draft.loops.back();
        for (std::uint32_t i = 0; i < added.wall_count; ++i)
            all = check_length(draft, record, loop, i, draft.map.walls[added.first_wall + i]) && all;
        all = all && loop.is_whole;
    }
    return all;
}

void add_sector(Draft& draft, const SectorRecord& record) {
    const SectorId id(draft.map.sectors.size());
    SectorDraft parts{&record};
    Sector sector;
    sector.name = record.name;
    sector.light = record.light;
    sector.unlit = record.unlit;
    if (record.light_effect) sector.light_effect = *record.light_effect;
    sector.damage = record.damage;
    sector.secret = record.secret;
    sector.leader = sector.next_of_group = id;
    sector.floor.z = record.floor.z;
    sector.ceiling.z = record.ceiling.z;
    sector.first_wall = static_cast<std::uint32_t>(draft.map.walls.size());
    parts.first_loop = static_cast<std::uint32_t>(draft.loops.size());
    parts.measurable = add_loops(draft, record);
    parts.loop_count = static_cast<std::uint32_t>(draft.loops.size()) - parts.first_loop;
    sector.wall_count = static_cast<std::uint32_t>(draft.map.walls.size()) - sector.first_wall;
    draft.has_nameless_sectors |= record.name.empty();
    draft.map.sectors.push_back(std::move(sector));
    settle_shape(draft.map, id);
    draft.sectors.push_back(parts);
}

/// Room for all walls at once: moving them while the vector grows would cost more than making them.
void reserve(Draft& draft) {
    std::size_t walls = 0, loops = 0;
    for (const SectorRecord& sector : draft.file.sectors) {
        loops += sector.loops.size();
        for (const LoopRecord& loop : sector.loops) walls += loop.walls.size();
    }
    draft.map.walls.reserve(walls);
    draft.walls.reserve(walls);
    draft.loops.reserve(loops);
    draft.map.sectors.reserve(draft.file.sectors.size());
    draft.sectors.reserve(draft.file.sectors.size());
}

}  // namespace

void place_walls(Draft& draft) {
    if (draft.file.sectors.empty() && draft.was_sound)
        draft.error(kTopOfFile, "no-sectors",
                    "expected at least one [[sectors]], found none; a map needs a room to stand in");
    reserve(draft);
    for (const SectorRecord& record : draft.file.sectors) add_sector(draft, record);
}

}  // namespace enfilade
