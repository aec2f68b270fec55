// Tiny maps in code, one call a room: for tests that need a Map and no file.
//
//   MapFile file = map_of({box_room("hall", 0, 0, 8, 6), box_room("niche", 8, 2, 10, 4)});
//   split_and_join(file);                     // neighbours get each other's vertices, and doors where they touch
//   const Map map = built(file);
//
// y runs down, outlines run clockwise on the drawing, heights are 0 to 2 m unless said otherwise.
#pragma once
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "map/load.h"
#include "math/predicates.h"

namespace enfilade::test {

inline TextureSpec spec(std::string name) { return {std::move(name), {}, {}, {}}; }

/// A closed loop of solid walls. Clockwise on the drawing: an outline; the other way: a hole.
inline LoopRecord loop_of(std::vector<Vec2> vertices) {
    LoopRecord loop;
    loop.walls.resize(vertices.size());
    for (WallRecord& wall : loop.walls) wall.texture = spec("wall");
    loop.vertices = std::move(vertices);
    return loop;
}

/// A room with any outline; further loops are holes, or outlines of further parts.
inline SectorRecord room(std::string name, std::vector<Vec2> outline, double floor_z = 0, double ceiling_z = 2) {
    SectorRecord sector;
    sector.name = std::move(name);
    sector.floor.z = floor_z;
    sector.floor.texture = spec("floor");
    sector.ceiling.z = ceiling_z;
    sector.ceiling.texture = spec("ceiling");
    sector.loops.push_back(loop_of(std::move(outline)));
    return sector;
}

/// A room along the axes. Its walls, in order: north (y0), east (x1), south (y1), west (x0).
inline SectorRecord box_room(std::string name, double x0, double y0, double x1, double y1, double floor_z = 0,
                             double ceiling_z = 2) {
    return room(std::move(name), {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, floor_z, ceiling_z);
}

/// Cuts a rectangular pillar out of a room.
inline void cut_pillar(SectorRecord& sector, double x0, double y0, double x1, double y1) {
    sector.loops.push_back(loop_of({{x0, y0}, {x0, y1}, {x1, y1}, {x1, y0}}));
}

/// An enfilade-dialect map of these rooms, without a player.
inline MapFile map_of(std::vector<SectorRecord> sectors) {
    MapFile file;
    file.format = 1;
    file.name = "test";
    file.sectors = std::move(sectors);
    return file;
}

inline SectorRecord& sector(MapFile& file, const std::string& name) {
    for (SectorRecord& s : file.sectors)
        if (s.name == name) return s;
    std::fprintf(stderr, "no sector %s\n", name.c_str());
    std::abort();
}

/// The wall a -> b of a sector.
inline WallRecord& wall(MapFile& file, const std::string& name, Vec2 a, Vec2 b) {
    for (LoopRecord& loop : sector(file, name).loops)
        for (std::size_t i = 0; i < loop.walls.size(); ++i)
            if (loop.vertices[i] == a && loop.vertices[(i + 1) % loop.walls.size()] == b) return loop.walls[i];
    std::fprintf(stderr, "no such wall in sector %s\n", name.c_str());
    std::abort();
}

/// Makes the walls a -> b of one sector and b -> a of another portals into each other.
inline void join(MapFile& file, const std::string& from, const std::string& to, Vec2 a, Vec2 b) {
    wall(file, from, a, b).next = to;
    wall(file, to, b, a).next = from;
}

/// Joins every two sectors wherever an edge of one is an edge of the other, reversed.
inline void join_all(MapFile& file) {
    struct Edge {
        Vec2 a, b;
        WallRecord* wall;
        const std::string* sector;
    };
    std::vector<Edge> edges;
    for (SectorRecord& s : file.sectors)
        for (LoopRecord& loop : s.loops)
            for (std::size_t i = 0; i < loop.walls.size(); ++i)
                edges.push_back(
                    {loop.vertices[i], loop.vertices[(i + 1) % loop.walls.size()], &loop.walls[i], &s.name});
    for (Edge& e : edges)
        for (const Edge& f : edges)
            if (e.a == f.b && e.b == f.a && e.sector != f.sector && e.wall->via.empty()) e.wall->next = *f.sector;
}

/// Gives every edge the vertices of other sectors that lie on it, so that rooms of different size can be joined.
/// Each part of an edge keeps what the edge was.
inline void split(MapFile& file) {
    std::vector<Vec2> vertices;
    for (const SectorRecord& s : file.sectors)
        for (const LoopRecord& loop : s.loops)
            vertices.insert(vertices.end(), loop.vertices.begin(), loop.vertices.end());
    const auto on_edge = [](Vec2 a, Vec2 b, Vec2 v) {
        return v != a && v != b && corner(a, b, v) == 0 && dot(v - a, v - b) < 0;
    };
    for (SectorRecord& s : file.sectors)
        for (LoopRecord& loop : s.loops)
            for (std::size_t i = 0; i < loop.walls.size();) {
                const Vec2 a = loop.vertices[i], b = loop.vertices[(i + 1) % loop.walls.size()];
                const auto found =
                    std::find_if(vertices.begin(), vertices.end(), [&](Vec2 v) { return on_edge(a, b, v); });
                if (found == vertices.end()) {
                    ++i;
                    continue;
                }
                loop.vertices.insert(loop.vertices.begin() + static_cast<std::ptrdiff_t>(i) + 1, *found);
                const WallRecord copy = loop.walls[i];
                loop.walls.insert(loop.walls.begin() + static_cast<std::ptrdiff_t>(i), copy);
            }
}

inline void split_and_join(MapFile& file) {
    split(file);
    join_all(file);
}

/// Links two walls both ways, wherever they are: midpoint onto midpoint.
inline void link(MapFile& file, const std::string& from, Vec2 from_a, Vec2 from_b, const std::string& to, Vec2 to_a,
                 Vec2 to_b) {
    WallRecord &there = wall(file, from, from_a, from_b), &back = wall(file, to, to_a, to_b);
    if (there.name.empty()) there.name = "link_" + to + "_" + std::to_string(to_a.x) + "_" + std::to_string(to_a.y);
    if (back.name.empty()) back.name = "link_" + from + "_" + std::to_string(from_a.x) + "_" + std::to_string(from_a.y);
    there.next = to;
    there.via = back.name;
    back.next = from;
    back.via = there.name;
}

inline void place_player(MapFile& file, const std::string& name, Vec2 position, double eye_z = 1,
                         double yaw_degrees = 0) {
    file.player = PlayerRecord{name, position, eye_z, yaw_degrees, {}};
}

/// A picture for every name the file uses: the placeholder, 64 x 64, not marked as missing.
inline TextureSet textures_for(const MapFile& file) {
    Findings ignored;
    TextureSet set =
        load_textures(file, {}, [](const std::string& path) { return Error{path, "not read in tests"}; }, ignored);
    for (Texture& texture : set.textures) texture.missing = false;
    return set;
}

/// The findings, one a line.
inline std::string text_of(const Findings& findings) {
    std::string text;
    for (const Finding& finding : findings) text += to_text("map", finding) + "\n";
    return text;
}

/// What the builder says about the file.
inline Findings findings_of(const MapFile& file) {
    Findings findings;
    build_map(file, textures_for(file), findings);
    sort_by_place(findings);
    return findings;
}

/// The Map; a file with errors prints them and stops the test program.
inline Map built(const MapFile& file) {
    Findings findings;
    std::optional<Map> map = build_map(file, textures_for(file), findings);
    if (map) return std::move(*map);
    std::fputs(text_of(findings).c_str(), stderr);
    std::abort();
}

}  // namespace enfilade::test
