#include "app/accuracy/motion_parts.h"

#include <algorithm>

#include "app/bench.h"
#include "map/load.h"
#include "platform/clock.h"

namespace enfilade {

SectorRecord plain_room(std::string name, std::vector<Vec2> outline, const std::vector<std::string>& behind) {
    constexpr double kCeiling = 3;
    const TextureSpec picture{"plain", {}, {}, {}};
    SectorRecord room;
    room.name = std::move(name);
    room.ceiling.z = kCeiling;
    room.floor.texture = room.ceiling.texture = picture;
    LoopRecord loop;
    loop.walls.resize(outline.size());
    for (std::size_t i = 0; i < outline.size(); ++i) {
        loop.walls[i].texture = picture;
        if (i < behind.size()) loop.walls[i].next = behind[i];
    }
    loop.vertices = std::move(outline);
    room.loops.push_back(std::move(loop));
    return room;
}

Map plain_map(std::vector<SectorRecord> rooms) {
    MapFile file;
    file.format = 1;
    file.name = "motion";
    file.sectors = std::move(rooms);
    Findings findings;
    const TextureSet textures = load_textures(
        file, {}, [](const std::string& path) { return Error{path, "no picture is looked at"}; }, findings);
    std::optional<Map> map = build_map(file, textures, findings);
    ENFILADE_CHECK(map.has_value());
    return std::move(*map);
}

std::vector<MotionPrice> prices_in_turn(const std::vector<std::function<void()>>& ways, std::uint64_t count,
                                        std::size_t rounds) {
    std::vector<std::vector<std::int64_t>> times(ways.size());
    for (std::size_t round = 0; round < rounds; ++round)
        for (std::size_t i = 0; i < ways.size(); ++i) {
            const std::int64_t began_ns = now_ns();
            ways[i]();
            times[i].push_back(now_ns() - began_ns);
        }
    std::vector<MotionPrice> prices;
    for (std::vector<std::int64_t>& of_way : times) {
        const auto least = static_cast<double>(*std::ranges::min_element(of_way));
        prices.push_back(
            {least / static_cast<double>(count), static_cast<double>(median_of(of_way)) / static_cast<double>(count)});
    }
    return prices;
}

}  // namespace enfilade
