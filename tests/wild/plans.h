// A world under construction: its sectors, and the triangles that they were put together from.
#pragma once
#include <string>
#include <vector>

#include "formats/map_file.h"
#include "wild/choices.h"

namespace enfilade::test {

/// A triangle of a sector's ground, clockwise.
struct Ground {
    std::size_t sector;  ///< index into MapFile::sectors
    Vec2 a, b, c;
};

struct WorldPlan {
    MapFile file;
    std::vector<Ground> ground;
    double size = 1;  ///< of the smallest island: measure for heights and lengths [m]
};

/// A wall of the plan.
struct WallPlace {
    std::size_t sector, loop, wall;
};

std::vector<WallPlace> solid_walls(const WorldPlan& plan);
WallRecord& wall_at(WorldPlan& plan, const WallPlace& place);
Vec2 start_of(const WorldPlan& plan, const WallPlace& place);
Vec2 end_of(const WorldPlan& plan, const WallPlace& place);

/// wild_joints.cpp: doorways between neighbours, most of them open; links, mirrors, and rooms beside walls.
void join_neighbours(WorldPlan& plan, std::size_t first_sector, Choices& choices);
void add_joint(WorldPlan& plan, Choices& choices);

/// wild_furniture.cpp: heights, skies, lights, what moves, panels, things, lamps, sounds, and the player.
void furnish(WorldPlan& plan, Choices& choices);

}  // namespace enfilade::test
