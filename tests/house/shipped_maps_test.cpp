// The maps that ship: along a line of walls a picture goes on, whatever rooms and doors cut the line.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "base/files.h"
#include "map/load.h"
#include "support/shipped_maps.h"

namespace enfilade {
namespace {

/// Authors round offsets to whole texels: where a picture is off by less than one, it goes on [texels].
constexpr double kOneTexel = 1;

/// What a wall shows below the ceiling; a portal into a room that is as high shows nothing.
const Surface& uppermost(const Map& map, const Wall& wall) {
    if (wall.kind != WallKind::portal) return map[wall.texture];
    return map[wall.behind].ceiling.z < map[wall.sector].ceiling.z ? map[wall.upper] : kNoSurface;
}

/// All around a loop a picture has one seam: where the first wall of the loop begins.
bool is_straight_on(const Wall& wall, const Wall& next) {
    const Vec2 along = wall.b - wall.a, on = next.b - next.a;
    const bool is_seam = wall.sector == next.sector && &next < &wall;
    return !is_seam && cross(along, on) == 0 && dot(along, on) > 0;
}

/// How far the picture of the next wall is from where that of the first ends [tiles].
double gap(const Surface& picture, double length, const Surface& next) {
    const double missing = length / picture.tile_m.x - picture.offset_tiles.x + next.offset_tiles.x;
    return std::fabs(missing - std::round(missing));
}

/// Where pictures begin anew along straight walls.
struct Breaks {
    int tried = 0;                   ///< pairs of walls that show one picture
    std::vector<std::string> found;  ///< "map: sector -> sector"
};

void look_along(const Map& map, const TextureSet& textures, const std::string& name, Breaks& breaks) {
    std::multimap<std::pair<double, double>, const Wall*> from;
    for (const Wall& wall : map.walls) from.emplace(std::pair{wall.a.x, wall.a.y}, &wall);
    for (const Wall& wall : map.walls) {
        const auto [first, last] = from.equal_range({wall.b.x, wall.b.y});
        for (auto next = first; next != last; ++next) {
            const Surface &here = uppermost(map, wall), &there = uppermost(map, *next->second);
            if (!here.texture || here.texture != there.texture || here.tile_m != there.tile_m) continue;
            if (!is_straight_on(wall, *next->second)) continue;
            ++breaks.tried;
            if (gap(here, wall.length, there) * textures[here.texture].width > kOneTexel)
                breaks.found.push_back(name + ": " + map[wall.sector].name + " -> " + map[next->second->sector].name);
        }
    }
}

TEST(ShippedMaps, LetPicturesGoOnAlongStraightWalls) {
    Breaks breaks;
    for (const std::string& path : test::shipped_maps()) {
        const LoadedMap loaded = load_map(path, {}, read_file);
        ASSERT_TRUE(loaded.map) << path;
        if (path.ends_with("/tutorial.toml")) continue;  // looks as the tutorial's own program draws it
        look_along(*loaded.map, loaded.textures, std::filesystem::path(path).stem().string(), breaks);
    }
    std::string list;
    for (const std::string& line : breaks.found) list += line + "\n";
    EXPECT_TRUE(breaks.found.empty()) << list;
    EXPECT_GT(breaks.tried, 1000);
}

}  // namespace
}  // namespace enfilade
