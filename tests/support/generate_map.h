// Large maps made by a rule: the same arguments give the same map on every machine.
#pragma once
#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "base/hash.h"
#include "support/map_builder.h"

namespace enfilade::test {

/// Rooms in a square grid with a door between most neighbours: each room a box of its own floor, height and light,
/// some with a pillar, some doors closed.
class RoomGrid {
public:
    static constexpr double kCell = 8;         ///< from room to room [m]
    static constexpr double kThickness = 0.5;  ///< of the walls between them [m]
    static constexpr double kDoor = 1.5;       ///< width [m]

    /// Exactly `sectors` of them, rooms and doors together; about half are doors.
    RoomGrid(std::size_t sectors, std::uint64_t seed) : random_(seed) {
        side_ = 1;
        while (2 * side_ * side_ - side_ < sectors) ++side_;  // rooms and the doors to the east
        file_ = map_of({});
        file_.name = "grid";
        const std::size_t rooms = std::min(sectors, side_ * side_);
        east_.assign(side_ * side_, false);
        south_.assign(side_ * side_, false);
        choose_doors(rooms, sectors - rooms);
        for (std::size_t i = 0; i < rooms; ++i) add_room(i);
        for (std::size_t i = 0; i < rooms; ++i) add_doors(i);
        test::place_player(file_, name(0), {2, 2}, file_.sectors[0].floor.z + 1);
    }

    MapFile take() && { return std::move(file_); }

private:
    static std::string name(std::size_t room) { return "r" + std::to_string(room); }
    static std::string door_name(std::size_t room, char way) { return "d" + std::to_string(room) + way; }
    double left(std::size_t room) const { return kCell * static_cast<double>(room % side_); }
    double top(std::size_t room) const { return kCell * static_cast<double>(room / side_); }
    double eighths(std::uint64_t count) { return static_cast<double>(random_.below(count)) / 8; }

    /// Doors to the east in all rows, then to the south, as many as there may be.
    void choose_doors(std::size_t rooms, std::size_t doors) {
        for (std::size_t i = 0; i < rooms && doors > 0; ++i)
            if (i % side_ + 1 < side_ && i + 1 < rooms) east_[i] = doors-- > 0;
        for (std::size_t i = 0; i + side_ < rooms && doors > 0; ++i) south_[i] = doors-- > 0;
    }

    bool has_west(std::size_t i) const { return i % side_ > 0 && east_[i - 1]; }
    bool has_north(std::size_t i) const { return i >= side_ && south_[i - side_]; }

    WallRecord solid() const {
        WallRecord wall;
        wall.texture = spec("wall");
        return wall;
    }
    WallRecord portal(std::string next) const {
        WallRecord wall = solid();
        wall.next = std::move(next);
        return wall;
    }

    /// One side of a room, from corner a to b, with a doorway in its middle if `door` names one.
    void add_side(LoopRecord& loop, Vec2 a, Vec2 b, const std::string& door) const {
        loop.vertices.push_back(a);
        loop.walls.push_back(solid());
        if (door.empty()) return;
        const Vec2 middle = (a + b) * 0.5, along = (b - a) * (kDoor / (2 * (kCell - kThickness)));
        loop.vertices.push_back(middle - along);
        loop.walls.push_back(portal(door));
        loop.vertices.push_back(middle + along);
        loop.walls.push_back(solid());
    }

    void add_room(std::size_t i) {
        const double x0 = left(i), y0 = top(i), x1 = x0 + kCell - kThickness, y1 = y0 + kCell - kThickness;
        const double floor = eighths(9);
        SectorRecord room = test::room(name(i), {}, floor, floor + 2.5 + eighths(13));
        room.light = 0.5 + eighths(5);
        LoopRecord& loop = room.loops.front();
        add_side(loop, {x0, y0}, {x1, y0}, has_north(i) ? door_name(i - side_, 's') : "");
        add_side(loop, {x1, y0}, {x1, y1}, east_[i] ? door_name(i, 'e') : "");
        add_side(loop, {x1, y1}, {x0, y1}, south_[i] ? door_name(i, 's') : "");
        add_side(loop, {x0, y1}, {x0, y0}, has_west(i) ? door_name(i - 1, 'e') : "");
        if (random_.below(8) == 0) cut_pillar(room, x0 + 3, y0 + 3, x0 + 3.5 + eighths(5), y0 + 3.5 + eighths(5));
        file_.sectors.push_back(std::move(room));
    }

    void add_doors(std::size_t i) {
        const double middle = (kCell - kThickness) / 2, x = left(i), y = top(i), far = kCell - kThickness;
        const double low = middle - kDoor / 2, high = middle + kDoor / 2;
        if (east_[i]) add_door(door_name(i, 'e'), {x + far, y + low}, {x + kCell, y + high}, i, i + 1, true);
        if (south_[i]) add_door(door_name(i, 's'), {x + low, y + far}, {x + high, y + kCell}, i, i + side_, false);
    }

    void add_door(std::string door, Vec2 min, Vec2 max, std::size_t from, std::size_t to, bool eastward) {
        const double floor = std::max(file_.sectors[from].floor.z, file_.sectors[to].floor.z);
        const bool is_closed = random_.below(4) == 0;
        SectorRecord sector = box_room(std::move(door), min.x, min.y, max.x, max.y, floor, floor + (is_closed ? 0 : 2));
        auto& walls = sector.loops.front().walls;  // north, east, south, west
        walls[eastward ? 3 : 0] = portal(name(from));
        walls[eastward ? 1 : 2] = portal(name(to));
        file_.sectors.push_back(std::move(sector));
    }

    Random random_;
    std::size_t side_;  ///< rooms in a row
    std::vector<bool> east_, south_;
    MapFile file_;
};

inline MapFile grid_of_rooms(std::size_t sectors, std::uint64_t seed = 1) { return RoomGrid(sectors, seed).take(); }

/// `count` triangles around the origin, each a sector open to its two neighbours. count >= 8, a multiple of 4.
inline MapFile fan_of_sectors(std::size_t count) {
    constexpr double kRadius = 16000;  // a square's: 1.28 m of it for each of 100 000 sectors
    const double step = 8 * kRadius / static_cast<double>(count);
    const auto rim = [&](std::size_t i) {
        double along = step * static_cast<double>(i % count);
        Vec2 from{-kRadius, -kRadius}, way{1, 0};
        for (; along >= 2 * kRadius; along -= 2 * kRadius) {
            from = from + way * (2 * kRadius);
            way = right_of(way);
        }
        return from + way * along;
    };
    MapFile file = map_of({});
    for (std::size_t i = 0; i < count; ++i) {
        SectorRecord s = room("s" + std::to_string(i), {{0, 0}, rim(i), rim(i + 1)});
        s.loops.front().walls[0].next = "s" + std::to_string((i + count - 1) % count);
        s.loops.front().walls[2].next = "s" + std::to_string((i + 1) % count);
        file.sectors.push_back(std::move(s));
    }
    return file;
}

/// The same fan, each sector made of every `sectors`-th of the parts; parts is a multiple of sectors, sectors >= 2.
inline MapFile fan_of_scattered_sectors(std::size_t parts, std::size_t sectors) {
    const auto label = [&](const std::string& name) {
        return "s" + std::to_string(std::stoul(name.substr(1)) % sectors);
    };
    MapFile fan = fan_of_sectors(parts), file = map_of({});
    for (std::size_t i = 0; i < parts; ++i) {
        LoopRecord& part = fan.sectors[i].loops.front();
        for (WallRecord& wall : part.walls)
            if (!wall.next.empty()) wall.next = label(wall.next);
        if (i < sectors)
            file.sectors.push_back(std::move(fan.sectors[i]));
        else
            file.sectors[i % sectors].loops.push_back(std::move(part));
    }
    return file;
}

/// One sector whose outline is a comb of thin teeth: 4 walls a tooth, every tooth as long as the comb.
inline MapFile comb(std::size_t teeth) {
    std::vector<Vec2> outline;
    const double length = static_cast<double>(teeth);
    for (std::size_t i = 0; i < teeth; ++i) {
        const double x = static_cast<double>(i);
        outline.insert(outline.end(), {{x, 0}, {x + 0.5, 0}, {x + 0.5, length}, {x + 1, length}});
    }
    outline.insert(outline.end(), {{length, length + 1}, {-1, length + 1}, {-1, 0}});
    return map_of({room("comb", std::move(outline))});
}

}  // namespace enfilade::test
