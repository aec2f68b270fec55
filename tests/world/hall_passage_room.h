// A hall, a passage and a room in a row, and a player before the passage, which is what moves in most tests of
// triggers.
#pragma once
#include "world/body.h"
#include "world/game.h"
#include "world/instant.h"

namespace enfilade::test {

/// A hall, a passage of 1 m and a room behind it, all 4 m wide, along +x. The player stands at (6, 2) and looks at the
/// passage, which begins at x = 8.
inline MapFile hall_passage_room(double passage_floor = 0, double passage_ceiling = 0) {
    MapFile file =
        map_of({box_room("hall", 0, 0, 8, 4, 0, 3), box_room("passage", 8, 0, 9, 4, passage_floor, passage_ceiling),
                box_room("room", 9, 0, 17, 4, 0, 3)});
    join_all(file);
    place_player(file, "hall", {6.5, 2}, kEyeOnFloor);
    return file;
}

inline MapFile with_door(TriggerRecord door) {
    MapFile file = hall_passage_room();
    sector(file, "passage").triggers = {std::move(door)};
    return file;
}

inline Heights passage(const Game& game) { return heights_of(now(game.map, game.world), SectorId(1u)); }

/// Walks along +x into the passage, and comes to a stop in the middle of it.
inline void walk_into_passage(Game& game) {
    for (int i = 0; i < 200 && game.point().x < 8.25; ++i) game.hold(kForward);
    game.hold(kNoKeys, 20);
    ENFILADE_CHECK(game.room() == "passage");
}

/// No part of the body is above a ceiling, below a floor or in a wall.
inline bool is_in_the_open(const Game& game) {
    const Instant at = now(game.map, game.world);
    Body body{game.player().place, game.player().feet_z, game.player().height, kBodyRadius, kWorldLimit};
    body.ceiling_z = squeezed(at, body).ceiling_z;
    EnteredPortals entered;
    const Reach found = around(at, body, &entered);
    return game.is_contained() && fits(at, body, found, entered);
}

}  // namespace enfilade::test
