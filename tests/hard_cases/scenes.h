// Small maps in which things coincide that a renderer likes to keep apart.
#pragma once
#include <vector>

#include "formats/map_file.h"

namespace enfilade::test {

struct NamedScene {
    const char* name;
    MapFile (*file)();
};

/// 16 rooms on a lattice, each of other heights than its neighbours, and a room of many corners beside them.
MapFile stepped_rooms();
/// Eight wedges around one vertex.
MapFile wheel();
/// A room like a U whose arms see each other only through the room between them, with pillars, and a niche of no
/// height.
MapFile crooked_rooms();
/// Pillars that touch each other in vertices only.
MapFile pinched_room();
/// A courtyard under the sky: roofs of other heights with and without a step, floors that are open underneath.
MapFile open_steps();
/// Rooms one grid step wide, a wall a grid step off the line of another, a wall 4 km long.
MapFile slivers();
/// Rooms that overlap in the plane and are joined by doors only: bigger inside.
MapFile overlapping_rooms();

/// All of the above: no links, no mirrors.
std::vector<NamedScene> plain_scenes();

/// Rooms joined by links: moved, turned by quarters and by 20 : 21 : 29, raised; two doors that share a vertex.
MapFile linked_rooms();
/// Two doors of one room that lead into each other, so that the room sees itself for ever.
MapFile endless_hall();
/// Mirrors on two walls and behind a link.
MapFile mirrors();

/// Those with links and mirrors.
std::vector<NamedScene> linked_scenes();

}  // namespace enfilade::test
