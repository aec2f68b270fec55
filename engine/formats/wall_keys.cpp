// The keys of walls and loops.
#include <algorithm>
#include <array>

#include "formats/map_keys.h"

namespace enfilade {
namespace {

constexpr auto kBoth = Dialect::tutorial;
constexpr auto kNew = Dialect::enfilade;

constexpr std::array kWallKeys{
    key<&WallRecord::name>("name", kNew),
    key<&WallRecord::texture>("texture", kBoth),
    key<&WallRecord::next>("next", kBoth),
    key<&WallRecord::via>("via", kNew),
    key<&WallRecord::rise>("rise", kNew, Need::optional, kHeights),
    key<&WallRecord::mirror>("mirror", kNew),
    key<&WallRecord::blocks>("blocks", kNew),
    key<&WallRecord::way_back>("way_back", kNew),
    key<&WallRecord::upper>("upper", kBoth),
    key<&WallRecord::lower>("lower", kBoth),
    key<&WallRecord::middle>("middle", kNew),
    key<&WallRecord::texture_peg>("peg", kNew),
    key<&WallRecord::upper_peg>("upper_peg", kNew),
    key<&WallRecord::lower_peg>("lower_peg", kNew),
    key<&WallRecord::middle_peg>("middle_peg", kNew),
    key<&WallRecord::size>("size", kNew, Need::optional, kTexelsPerMetre),
    key<&WallRecord::scroll>("scroll", kNew, Need::optional, kScrollSpeeds),
    key<&WallRecord::triggers>("triggers", kNew),
    key<&WallRecord::doom>("doom", kNew),
    header_key<&WallRecord::upper>("up", kBoth),
    header_key<&WallRecord::lower>("down", kBoth),
};

/// "v = [x0, y0, x1, y1, …]".
void read_vertices(Reading& reading, const NamedValue& value, Range range, LoopRecord& loop) {
    if (!expect(reading, value, TomlKind::array)) return;
    const std::size_t count = value.node.size();
    if (count % 2 != 0)
        reading.error(value.node.place(), "odd-vertices",
                      "'v' must have an x and a y for each vertex, found " + std::to_string(count) + " numbers");
    loop.vertices.resize(count / 2);
    loop.vertex_places.resize(count / 2);
    for (std::size_t i = 0; i < count / 2 && !reading.is_full(); ++i) {
        loop.vertex_places[i] = value.node.at(2 * i).place();
        read_value(reading, {value.name, value.node.at(2 * i)}, range, loop.vertices[i].x);
        read_value(reading, {value.name, value.node.at(2 * i + 1)}, range, loop.vertices[i].y);
    }
}

void write_vertices(TableText& table, const Key<LoopRecord>& key, const LoopRecord& loop, const LoopRecord&) {
    table.add(key.name, vertices_text(loop.vertices));
}

constexpr std::array kLoopKeys{
    key<&LoopRecord::name>("name", kBoth),
    Key<LoopRecord>{"v", kBoth, Need::required, kVertices, read_vertices, write_vertices},
    key<&LoopRecord::walls>("walls", kBoth, Need::required),
};

/// Walls that are made up for a loop that has too few. An author forgets one or two; a loop of a million vertices
/// and no walls is no slip, and must not take the memory of a million walls.
constexpr std::size_t kMostMissingWalls = 1024;

void give_every_vertex_a_wall(LoopRecord& loop) {
    const std::size_t count = std::min(loop.vertices.size(), loop.walls.size() + kMostMissingWalls);
    loop.vertices.resize(count);
    loop.vertex_places.resize(count);
    loop.walls.resize(count);
}

constexpr KeyList<WallRecord> kWallList{"a wall", kWallKeys};
constexpr KeyList<LoopRecord> kLoopList{"a loop", kLoopKeys};

}  // namespace

template <>
const KeyList<WallRecord>& keys_of() {
    return kWallList;
}

template <>
const KeyList<LoopRecord>& keys_of() {
    return kLoopList;
}

template <>
void check_record(Reading& reading, TomlNode, std::span<const TomlEntry> entries, WallRecord& wall) {
    refuse_both(reading, entries, "upper", "up", "given-twice");
    refuse_both(reading, entries, "lower", "down", "given-twice");
    for (const auto* spec : {&wall.texture, &wall.upper, &wall.lower, &wall.middle})
        if (*spec && wall.size) refuse_tile_and_size(reading, **spec);
}

template <>
void check_record(Reading& reading, TomlNode, std::span<const TomlEntry> entries, LoopRecord& loop) {
    const TomlEntry* walls = find_entry(entries, "walls");
    loop.is_whole =
        walls && walls->value.kind() == TomlKind::array && loop.places.has("v") && loop.places.is_sound("v");
    if (loop.is_whole && loop.walls.size() != loop.vertices.size()) {
        reading.error(walls->value.place(), "walls-vertices-mismatch",
                      "a loop has one wall for each vertex: found " + std::to_string(loop.vertices.size()) +
                          " vertices and " + std::to_string(loop.walls.size()) +
                          " walls; give each wall its place in "
                          "the list, in the order of the vertices");
        loop.is_whole = false;
    }
    give_every_vertex_a_wall(loop);
}

}  // namespace enfilade
