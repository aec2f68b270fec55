// Loops in short: rectangles and polygons become corners, and one wall stands for all that say nothing.
#include <algorithm>
#include <array>
#include <cmath>

#include "formats/expand.h"
#include "formats/map_keys.h"
#include "formats/text_parts.h"
#include "math/angle.h"

namespace enfilade {
namespace {

/// Regular polygons: of fewer corners there is none, and a circle of more is no rounder on a screen.
constexpr Range kCorners{3, 256};

/// Radii of polygons [m].
constexpr Range kRadii{kVertexGrid, kWorldLimit};

constexpr std::array kPolygonKeys{
    key<&PolygonRecord::center, &Vec2::x>("x", Dialect::enfilade, Need::required, kPositions),
    key<&PolygonRecord::center, &Vec2::y>("y", Dialect::enfilade, Need::required, kPositions),
    key<&PolygonRecord::radius>("radius", Dialect::enfilade, Need::required, kRadii),
    key<&PolygonRecord::corners>("corners", Dialect::enfilade, Need::required, kCorners),
    key<&PolygonRecord::turn>("turn", Dialect::enfilade, Need::optional, kAngles),
};
constexpr KeyList<PolygonRecord> kPolygonList{"a polygon", kPolygonKeys};

/// Clockwise on the drawing from the corner at the top left.
std::vector<Vec2> corners_of(const RectRecord& rect) {
    const auto [left, right] = std::minmax(rect.a.x, rect.b.x);
    const auto [top, bottom] = std::minmax(rect.a.y, rect.b.y);
    return {{left, top}, {right, top}, {right, bottom}, {left, bottom}};
}

/// Clockwise on the drawing, on the grid of corners.
std::vector<Vec2> corners_of(const PolygonRecord& polygon) {
    constexpr std::uint64_t kFullTurn = std::uint64_t{1} << 32;
    const Angle first = Angle::from_degrees(polygon.turn);
    const auto count = static_cast<std::uint64_t>(polygon.corners);
    std::vector<Vec2> corners;
    for (std::uint64_t i = 0; i < count; ++i) {
        const Angle to_corner{static_cast<std::uint32_t>(i * kFullTurn / count)};
        corners.push_back(snap_to_vertex_grid(polygon.center + direction(first + to_corner) * polygon.radius));
    }
    return corners;
}

bool is_in_the_world(Vec2 point) { return std::max({point.x, -point.x, point.y, -point.y}) <= kWorldLimit; }

bool has_area(const RectRecord& rect) {
    const Vec2 a = snap_to_vertex_grid(rect.a), b = snap_to_vertex_grid(rect.b);
    return a.x != b.x && a.y != b.y;
}

/// The corners of a loop's shape; none where it has no shape, or one that leads out of the world.
std::vector<Vec2> corners_of(Reading& reading, const LoopRecord& loop) {
    if (loop.shorthand->rect) {
        const RectRecord& rect = *loop.shorthand->rect;
        if (has_area(rect)) return corners_of(rect);
        reading.error(key_place(loop, "rect"), "flat-rectangle",
                      "expected two corners of a rectangle that lie across from each other, found " +
                          point_text(rect.a) + " and " + point_text(rect.b) + ", on one line; move one of them");
        return {};
    }
    const PolygonRecord& polygon = *loop.shorthand->polygon;
    if (!polygon.places.is_sound()) return {};
    std::vector<Vec2> corners = corners_of(polygon);
    if (std::ranges::all_of(corners, is_in_the_world)) return corners;
    reading.error(polygon.place, "out-of-range",
                  "expected a polygon within " + number_text(kWorldLimit) + " m of the origin");
    return {};
}

/// A loop has one of `v`, `rect` and `polygon`; true if it has.
bool has_one_shape(Reading& reading, LoopRecord& loop) {
    std::array<TextPlace, 3> given;
    std::size_t count = 0;
    for (const std::string_view key : {"v", "rect", "polygon"})
        if (loop.places.has(key)) given[count++] = key_place(loop, key);
    if (count == 1) return true;
    if (count == 0)
        missing_key(reading, loop.place, "a loop", "v");
    else
        reading.error(*std::max_element(given.begin(), given.begin() + count), "given-twice",
                      "'v', 'rect' and 'polygon' exclude each other; give only one of them");
    loop.places.note_fault();
    return false;
}

/// Walls that are made up for a loop that has too few. An author forgets one or two; a loop of a million vertices
/// and no walls is no slip, and must not take the memory of a million walls.
constexpr std::size_t kMostMissingWalls = 1024;

void give_every_vertex_a_wall(LoopRecord& loop) {
    const std::size_t count = std::min(loop.vertices.size(), loop.walls.size() + kMostMissingWalls);
    loop.vertices.resize(count);
    loop.vertex_places.resize(count);
    loop.walls.resize(count);
}

bool says_nothing(const WallRecord& wall) {
    WallRecord empty;
    empty.place = wall.place;
    return wall == empty && wall.places.is_sound();
}

/// A name and triggers belong to one wall, and not to all that are alike.
bool stands_for_many(Reading& reading, const WallRecord& wall) {
    for (const std::string_view key : {"name", "triggers"})
        if (wall.places.has(key)) {
            reading.error(
                key_place(wall, key), "wall-of-many",
                "'wall' stands for many walls, and " + in_quotes(key) + " belongs to one; give that one in 'walls'");
            return false;
        }
    return true;
}

/// From where the loop begins to each of its corners [m].
std::vector<double> ways_round(const LoopRecord& loop) {
    std::vector<double> ways{0};
    for (std::size_t i = 1; i < loop.vertices.size(); ++i) {
        const Vec2 side = loop.vertices[i] - loop.vertices[i - 1];
        ways.push_back(ways.back() + std::sqrt(dot(side, side)));
    }
    return ways;
}

/// The walls that say nothing become copies of `common`. Round a polygon their pictures go on from one to the next.
void spread(Reading& reading, Expansion& expansion, const WallRecord& common, LoopRecord& loop) {
    const bool are_given = loop.places.has("walls");
    const std::size_t count =
        are_given ? std::size_t(std::ranges::count_if(loop.walls, says_nothing)) : loop.vertices.size();
    if (!stands_for_many(reading, common) || !expansion.take(count * weight_of(common), common.place)) {
        loop.is_whole = false;
        return;
    }
    if (!are_given) loop.walls.resize(count);
    const std::vector<double> ways = loop.places.has("polygon") ? ways_round(loop) : std::vector<double>();
    for (std::size_t i = 0; i < loop.walls.size(); ++i) {
        if (!says_nothing(loop.walls[i])) continue;
        const TextPlace place = are_given ? loop.walls[i].place : common.place;
        loop.walls[i] = common;
        loop.walls[i].place = place;
        if (i < ways.size()) loop.walls[i].move_pictures({-ways[i], 0});
    }
}

/// Whether there are walls for the corners; if not, it is noted, unless that was to be expected.
bool has_enough_walls(Reading& reading, LoopRecord& loop, bool are_common) {
    if (!loop.places.has("walls")) {
        if (are_common) return loop.is_whole;
        const bool is_short = loop.places.has("rect") || loop.places.has("polygon");
        if (!is_short)
            missing_key(reading, loop.place, "a loop", "walls");
        else if (loop.places.is_sound())
            reading.error(loop.place, "missing-key",
                          "expected 'wall', which all walls of the outline are like, or 'walls'; found neither");
        loop.places.note_fault();
        return false;
    }
    if (!loop.is_whole || (loop.walls.empty() && !loop.places.is_sound("walls"))) return false;
    if (loop.walls.size() == loop.vertices.size()) return true;
    reading.error(key_place(loop, "walls"), "walls-vertices-mismatch",
                  "a loop has one wall for each vertex: found " + std::to_string(loop.vertices.size()) +
                      " vertices and " + std::to_string(loop.walls.size()) +
                      " walls; give each wall its place in the list, in the order of the vertices");
    return false;
}

/// Gives a loop that has a shape its corners.
void draw_shape(Reading& reading, Expansion& expansion, LoopRecord& loop, bool is_outline) {
    const bool is_rect = loop.places.has("rect");
    const TextPlace place = key_place(loop, is_rect ? "rect" : "polygon");
    loop.is_whole = loop.places.is_sound("rect");
    if (loop.is_whole && (is_rect || expansion.take(std::size_t(loop.shorthand->polygon->corners), place)))
        loop.vertices = corners_of(reading, loop);
    if (!is_outline) std::ranges::reverse(loop.vertices);
    loop.vertex_places.assign(loop.vertices.size(), place);
    loop.is_whole = !loop.vertices.empty();
}

void write_out(Reading& reading, Expansion& expansion, LoopRecord& loop, bool is_outline, const WallRecord* common) {
    loop.is_whole = has_one_shape(reading, loop) && loop.places.is_sound("v");
    if (loop.is_whole && !loop.places.has("v")) draw_shape(reading, expansion, loop, is_outline);
    if (loop.shorthand && loop.shorthand->wall) common = &*loop.shorthand->wall;
    if (loop.is_whole && common) spread(reading, expansion, *common, loop);
    loop.is_whole = has_enough_walls(reading, loop, common != nullptr);
    give_every_vertex_a_wall(loop);
    loop.shorthand.reset();
}

/// The outline that a sector gives without a loop of its own.
LoopRecord outline_of(SectorRecord& sector) {
    LoopRecord outline;
    outline.place = sector.place;
    if (!sector.places.is_sound()) outline.places.note_fault();  // a key that was not understood may be 'wall'
    for (const std::string_view key : {"rect", "polygon"}) {
        if (!sector.places.has(key)) continue;
        outline.place = key_place(sector, key);
        outline.places.note(key, outline.place, sector.places.is_sound(key));
    }
    outline.shorthand.emplace();
    outline.shorthand->rect = sector.shorthand->rect;
    outline.shorthand->polygon = sector.shorthand->polygon;
    return outline;
}

}  // namespace

template <>
const KeyList<PolygonRecord>& keys_of() {
    return kPolygonList;
}

bool Expansion::take(std::size_t count, TextPlace place) {
    if (count <= left_) {
        left_ -= count;
        return true;
    }
    left_ = 0;
    if (!is_noted_)
        reading_.error(place, "too-large",
                       "the short words make more than " + std::to_string(kMost) +
                           " walls and things; write the rest of them out, or leave some of them out");
    is_noted_ = true;
    return false;
}

std::size_t weight_of(const WallRecord& wall) {
    constexpr std::size_t kUsualBytes = 256;
    std::size_t bytes = wall.name.size() + wall.next.size() + wall.via.size();
    for (const auto* spec : {&wall.texture, &wall.upper, &wall.lower, &wall.middle})
        if (*spec) bytes += (*spec)->name.size();
    return 1 + bytes / kUsualBytes + wall.triggers.size();
}

namespace {

void lacks_outline(Reading& reading, const SectorRecord& sector) {
    if (sector.places.has("loops")) return missing_key(reading, key_place(sector, "loops"), "a sector", "loops");
    if (reading.dialect == Dialect::tutorial)
        return reading.error(sector.place, "missing-key",
                             "a sector needs 'loops', found none; in a file that says `format = 1` on its first line "
                             "it may have a 'rect' or 'polygon' instead");
    if (!sector.places.is_sound()) return;  // it may be the key that was not understood
    reading.error(sector.place, "missing-key", "a sector needs 'rect', 'polygon' or [[sectors.loops]], found none");
}

}  // namespace

void write_out_loops(Reading& reading, Expansion& expansion, SectorRecord& sector) {
    if (sector.places.has("rect") || sector.places.has("polygon"))
        sector.loops.insert(sector.loops.begin(), outline_of(sector));
    if (sector.loops.empty() && (!sector.places.has("loops") || sector.places.is_sound("loops"))) {
        if (!reading.lacks_format) lacks_outline(reading, sector);
        sector.places.note_fault();
    }
    const WallRecord* const common = sector.shorthand && sector.shorthand->wall ? &*sector.shorthand->wall : nullptr;
    for (LoopRecord& loop : sector.loops) write_out(reading, expansion, loop, &loop == &sector.loops.front(), common);
    sector.shorthand.reset();
}

}  // namespace enfilade
