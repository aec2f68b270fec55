#include "hard_cases/scenes.h"

#include <string>

#include "support/map_builder.h"

namespace enfilade::test {

MapFile stepped_rooms() {
    MapFile file = map_of({});
    for (int x = 0; x < 4; ++x)
        for (int y = 0; y < 4; ++y)
            file.sectors.push_back(box_room("room_" + std::to_string(x) + std::to_string(y), x * 4, y * 4, x * 4 + 4,
                                            y * 4 + 4, 0.25 * ((x * 7 + y * 3) % 5), 2.5 + 0.25 * ((x * 5 + y) % 4)));
    file.sectors.push_back(
        room("garden", {{0, 16}, {4, 16}, {8, 16}, {12, 16}, {16, 16}, {20, 20}, {8, 19}, {-3, 25}}));
    join_all(file);
    return file;
}

MapFile wheel() {
    const std::vector<Vec2> rim{{0, -6}, {4, -4}, {6, 0}, {4, 4}, {0, 6}, {-4, 4}, {-6, 0}, {-4, -4}};
    MapFile file = map_of({});
    for (std::size_t i = 0; i < rim.size(); ++i)
        file.sectors.push_back(room("wedge_" + std::to_string(i), {{0, 0}, rim[i], rim[(i + 1) % rim.size()]},
                                    static_cast<double>(i % 3) / 2, 3 - static_cast<double>(i % 2)));
    join_all(file);
    return file;
}

MapFile crooked_rooms() {
    MapFile file = map_of({room("u", {{0, 0}, {8, 0}, {8, 8}, {6, 8}, {6, 4}, {2, 4}, {2, 8}, {0, 8}}),
                           room("beyond", {{0, 8}, {2, 8}, {6, 8}, {8, 8}, {4, 11}}),
                           box_room("niche", 8, 0, 9, 8, 1, 1), box_room("middle", 2, 4, 6, 8, 0.25, 1.75)});
    cut_pillar(file.sectors[0], 3, 1, 4, 2);
    file.sectors[0].loops.push_back(loop_of({{1, 6}, {0.5, 6.5}, {1, 7}, {1.5, 6.5}}));
    join_all(file);
    return file;
}

MapFile open_steps() {
    MapFile file = map_of({box_room("west", 0, 0, 4, 8, 0, 6), box_room("middle", 4, 0, 8, 8, 1, 4),
                           box_room("east", 8, 0, 12, 8, 0.5, 3), box_room("cellar", 12, 0, 16, 8, 2, 2.5)});
    cut_pillar(file.sectors[1], 5, 3, 6, 5);
    file.sectors.push_back(box_room("roof", 5, 3, 6, 5, 1.5, 2.25));
    join_all(file);
    for (const char* name : {"west", "middle", "east"}) sector(file, name).ceiling.parallax = true;
    wall(file, "middle", {8, 0}, {8, 8}).lower = spec("-");
    wall(file, "west", {4, 0}, {4, 8}).lower = spec("-");
    wall(file, "east", {12, 0}, {12, 8}).upper = spec("-");
    wall(file, "east", {12, 0}, {12, 8}).lower = spec("-");
    wall(file, "middle", {5, 3}, {5, 5}).upper = spec("-");
    wall(file, "middle", {6, 5}, {6, 3}).lower = spec("-");
    return file;
}

MapFile slivers() {
    constexpr double kStep = 0x1p-10;  // of the vertex grid
    MapFile file = map_of({box_room("west", 0, 0, 8, 8), box_room("sliver", 8, 0, 8 + kStep, 8, 0.5, 1.5),
                           box_room("east", 8 + kStep, 0, 16, 8),
                           room("wedge", {{0, 8}, {8, 8}, {8, 8 + kStep}, {-16, 8 + kStep}}, 0, 1.75),
                           room("plain", {{-16, 8 + kStep}, {8, 8 + kStep}, {4096, 9}, {4096, 16}, {-16, 16}}, 0, 8)});
    join_all(file);
    return file;
}

MapFile overlapping_rooms() {
    MapFile file = map_of({box_room("house", 0, 0, 4, 4), box_room("hall", 1, 0, 9, 4, 0, 3),
                           box_room("yard", -4, -4, 8, 0, 0, 4), box_room("cupboard", 2, -1, 3, 0, 0.5, 1.5)});
    // The yard's wall towards both has a door into each, and one into a cupboard that stands in the yard itself.
    file.sectors[2] = room("yard", {{-4, -4}, {8, -4}, {8, 0}, {4, 0}, {3, 0}, {2, 0}, {1, 0}, {0, 0}, {-4, 0}}, 0, 4);
    split(file);
    join(file, "yard", "house", {1, 0}, {0, 0});
    join(file, "yard", "hall", {4, 0}, {3, 0});
    join(file, "hall", "cupboard", {2, 0}, {3, 0});
    return file;
}

MapFile pinched_room() {
    MapFile file = map_of({box_room("room", 0, 0, 12, 8)});
    for (const std::vector<Vec2>& hole : {std::vector<Vec2>{{6, 4}, {4, 3}, {4, 5}},
                                          {{6, 4}, {8, 6}, {8, 4.5}},
                                          {{6, 4}, {5, 6}, {7, 6}},
                                          {{6, 4}, {7, 2}, {5, 2}},
                                          {{8, 6}, {8, 7}, {9, 7}}})
        file.sectors[0].loops.push_back(loop_of(hole));
    return file;
}

std::vector<NamedScene> plain_scenes() {
    return {{"PinchedRoom", pinched_room},          {"SteppedRooms", stepped_rooms}, {"Wheel", wheel},
            {"CrookedRooms", crooked_rooms},        {"OpenSteps", open_steps},       {"Slivers", slivers},
            {"OverlappingRooms", overlapping_rooms}};
}

MapFile linked_rooms() {
    // "turned" has a wall along (20, 21) / 29, as long as the door it is linked to.
    MapFile file = map_of({box_room("hub", 0, 0, 29, 29, 0, 4), box_room("moved", 100, 0, 129, 29, 1, 3),
                           box_room("quarter", 200, 200, 229, 229, 2, 5),
                           room("turned", {{300, 300}, {320, 321}, {299, 341}, {279, 320}}, 0, 3)});
    cut_pillar(file.sectors[0], 14, 14, 15, 15);
    link(file, "hub", {29, 0}, {29, 29}, "moved", {100, 29}, {100, 0});
    link(file, "hub", {29, 29}, {0, 29}, "quarter", {229, 200}, {229, 229});
    link(file, "hub", {0, 29}, {0, 0}, "turned", {300, 300}, {320, 321});
    link(file, "moved", {129, 0}, {129, 29}, "quarter", {200, 229}, {200, 200});
    return file;
}

MapFile endless_hall() {
    MapFile file = map_of({box_room("hall", 0, 0, 8, 4, 0, 3)});
    cut_pillar(file.sectors[0], 3, 1, 3.5, 2);
    link(file, "hall", {8, 0}, {8, 4}, "hall", {0, 4}, {0, 0});
    file.render.max_depth = 6;
    return file;
}

MapFile mirrors() {
    MapFile file = map_of(
        {room("hall", {{0, 0}, {8, 0}, {10, 4}, {8, 8}, {0, 8}}, 0, 3), box_room("next", 40, 0, 48, 8, 0.5, 2.5)});
    wall(file, "hall", {8, 0}, {10, 4}).mirror = true;
    wall(file, "hall", {10, 4}, {8, 8}).mirror = true;
    wall(file, "next", {48, 0}, {48, 8}).mirror = true;
    link(file, "hall", {0, 8}, {0, 0}, "next", {40, 8}, {40, 0});
    file.render.max_depth = 6;
    return file;
}

std::vector<NamedScene> linked_scenes() {
    return {{"LinkedRooms", linked_rooms}, {"EndlessHall", endless_hall}, {"Mirrors", mirrors}};
}

}  // namespace enfilade::test
