// A converter: example_converter PLAN.txt OUT.toml makes a map of a plan drawn in letters. Every letter that is not a
// blank or '#' is a room of 2 by 2 metres; rooms side by side are open to each other; the player starts at '@'.
#include <cstdio>
#include <sstream>

#include "enfilade.h"

using namespace enfilade;

namespace {

constexpr double kSide = 2;  // [m]

bool is_room(const std::vector<std::string>& plan, std::size_t x, std::size_t y) {
    return y < plan.size() && x < plan[y].size() && plan[y][x] != '#' && plan[y][x] != ' ';
}

std::string name_of_room(std::size_t x, std::size_t y) {
    return std::to_string(x).append("_").append(std::to_string(y));
}

TextureSpec picture(const char* name) { return {name, Vec2{kSide, kSide}, {}, {}}; }

/// What is on one side of a room: an opening into the room at (x, y), or a wall.
WallRecord side(const std::vector<std::string>& plan, std::size_t x, std::size_t y) {
    WallRecord wall;
    if (is_room(plan, x, y))
        wall.next = name_of_room(x, y);
    else
        wall.texture = picture("brick");
    return wall;
}

SectorRecord room(const std::vector<std::string>& plan, std::size_t x, std::size_t y) {
    SectorRecord room;
    room.name = name_of_room(x, y);
    room.floor.texture = picture("boards");
    room.ceiling.z = 3;
    room.ceiling.texture = picture("beams");
    const double left = kSide * double(x), top = kSide * double(y);
    LoopRecord loop;
    loop.vertices = {{left, top}, {left + kSide, top}, {left + kSide, top + kSide}, {left, top + kSide}};
    // Beyond the plan's left and upper edge the numbers wrap around, and no room is there.
    loop.walls = {side(plan, x, y - 1), side(plan, x + 1, y), side(plan, x, y + 1), side(plan, x - 1, y)};
    room.loops.push_back(loop);
    return room;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) return 2;
    const auto bytes = read_file(argv[1]);
    if (!bytes.ok()) return std::puts(bytes.error().text().c_str()), 1;
    std::vector<std::string> plan;
    std::istringstream lines{std::string(as_text(bytes.value()))};
    for (std::string line; std::getline(lines, line);) plan.push_back(line);
    MapFile map;
    map.format = 1;
    for (std::size_t y = 0; y < plan.size(); ++y)
        for (std::size_t x = 0; x < plan[y].size(); ++x) {
            if (is_room(plan, x, y)) map.sectors.push_back(room(plan, x, y));
            if (plan[y][x] == '@')
                map.player = PlayerRecord{
                    name_of_room(x, y), {kSide * (double(x) + 0.5), kSide * (double(y) + 0.5)}, 1.55, 0, {}, {}};
        }
    const Result<void> written = write_file(argv[2], write_map(map));
    if (!written.ok()) std::puts(written.error().text().c_str());
    return written.ok() ? 0 : 1;
}
