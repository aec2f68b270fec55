#include "wild/shrink.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace enfilade::test {
namespace {

template <class See>
void each_wall(MapFile& file, See see) {
    for (SectorRecord& sector : file.sectors)
        for (LoopRecord& loop : sector.loops)
            for (WallRecord& wall : loop.walls) see(wall);
}

WallRecord plain(const WallRecord& wall) {
    WallRecord solid;
    solid.texture = wall.texture;
    return solid;
}

/// Closes the doorways into the room and forgets who is in it.
void remove_sector(MapFile& file, std::size_t number) {
    const std::string name = file.sectors[number].name;
    file.sectors.erase(file.sectors.begin() + static_cast<std::ptrdiff_t>(number));
    each_wall(file, [&](WallRecord& wall) {
        if (wall.next == name) wall = plain(wall);
    });
    std::erase_if(file.things, [&](const ThingRecord& thing) { return thing.sector == name; });
    std::erase_if(file.lights, [&](const PointLightRecord& light) { return light.sector == name; });
    if (file.player && file.player->sector == name) file.player.reset();
}

/// In every loop, the corner and the wall that begins in it.
void remove_corner(MapFile& file, Vec2 corner) {
    for (SectorRecord& sector : file.sectors) {
        for (LoopRecord& loop : sector.loops)
            for (std::size_t i = loop.vertices.size(); i-- > 0;) {
                if (loop.vertices[i] != corner) continue;
                loop.vertices.erase(loop.vertices.begin() + static_cast<std::ptrdiff_t>(i));
                loop.walls.erase(loop.walls.begin() + static_cast<std::ptrdiff_t>(i));
            }
        std::erase_if(sector.loops, [](const LoopRecord& loop) { return loop.vertices.size() < 3; });
    }
}

std::vector<Vec2> corners_of(const MapFile& file) {
    std::vector<Vec2> corners;
    for (const SectorRecord& sector : file.sectors)
        for (const LoopRecord& loop : sector.loops)
            corners.insert(corners.end(), loop.vertices.begin(), loop.vertices.end());
    const auto key = [](Vec2 v) { return std::pair(v.x, v.y); };
    std::ranges::sort(corners, {}, key);
    corners.erase(std::ranges::unique(corners).begin(), corners.end());
    return corners;
}

class Shrinking {
public:
    Shrinking(MapFile file, const IsFaulty& is_faulty, int most_questions)
        : file_(std::move(file)), is_faulty_(is_faulty), questions_left_(most_questions) {}

    MapFile run() {
        bool is_smaller = true;
        while (is_smaller && questions_left_ > 0) {
            is_smaller = false;
            for (const bool shrunk : {shrink_list(&MapFile::things), shrink_list(&MapFile::lights), shrink_sectors(),
                                      shrink_loops(), shrink_corners(), shrink_runs(), shrink_walls()})
                is_smaller |= shrunk;
        }
        return std::move(file_);
    }

private:
    /// Takes the change where the fault survives it.
    template <class Change>
    bool take(Change change) {
        if (questions_left_-- <= 0) return false;
        MapFile changed = file_;
        change(changed);
        if (changed == file_ || !is_faulty_(changed)) return false;
        file_ = std::move(changed);
        return true;
    }

    template <class Record>
    bool shrink_list(std::vector<Record> MapFile::* list) {
        bool is_smaller = take([&](MapFile& file) { (file.*list).clear(); });
        for (std::size_t i = (file_.*list).size(); i-- > 0;)
            is_smaller |=
                take([&](MapFile& file) { (file.*list).erase((file.*list).begin() + static_cast<std::ptrdiff_t>(i)); });
        return is_smaller;
    }

    bool shrink_sectors() {
        bool is_smaller = false;
        for (std::size_t i = file_.sectors.size(); i-- > 0;) {
            if (take([&](MapFile& file) { remove_sector(file, i); })) {
                is_smaller = true;
                continue;
            }
            is_smaller |= take([&](MapFile& file) { file.sectors[i].panels.clear(); });
            is_smaller |= take([&](MapFile& file) { file.sectors[i].triggers.clear(); });
            is_smaller |= take([&](MapFile& file) { make_plain(file.sectors[i]); });
        }
        return is_smaller;
    }

    /// As the room would be if nobody had said anything but its shape, heights and doorways.
    static void make_plain(SectorRecord& sector) {
        SectorRecord plain_one;
        plain_one.name = sector.name;
        plain_one.loops = sector.loops;
        plain_one.panels = sector.panels;
        plain_one.triggers = sector.triggers;
        plain_one.floor.z = sector.floor.z;
        plain_one.floor.texture = sector.floor.texture;
        plain_one.ceiling.z = sector.ceiling.z;
        plain_one.ceiling.texture = sector.ceiling.texture;
        sector = std::move(plain_one);
    }

    bool shrink_corners() {
        bool is_smaller = false;
        for (const Vec2 corner : corners_of(file_))
            is_smaller |= take([&](MapFile& file) { remove_corner(file, corner); });
        return is_smaller;
    }

    bool shrink_loops() {
        bool is_smaller = false;
        for (std::size_t s = 0; s < file_.sectors.size(); ++s)
            for (std::size_t l = file_.sectors[s].loops.size(); l-- > 0;)
                is_smaller |= take([&](MapFile& file) {
                    auto& loops = file.sectors[s].loops;
                    loops.erase(loops.begin() + static_cast<std::ptrdiff_t>(l));
                });
        return is_smaller;
    }

    /// A loop that comes to one corner several times may go without what lies between.
    bool shrink_runs() {
        bool is_smaller = false;
        for (std::size_t s = 0; s < file_.sectors.size(); ++s)
            for (std::size_t l = 0; l < file_.sectors[s].loops.size(); ++l)
                for (std::size_t i = 0; i < file_.sectors[s].loops[l].vertices.size(); ++i)
                    is_smaller |= shrink_runs_from(s, l, i);
        return is_smaller;
    }

    bool shrink_runs_from(std::size_t s, std::size_t l, std::size_t first) {
        const std::vector<Vec2> vertices = file_.sectors[s].loops[l].vertices;
        for (std::size_t end = vertices.size(); --end > first;) {
            if (vertices[end] != vertices[first]) continue;
            const auto cut = [&](MapFile& file) {
                LoopRecord& loop = file.sectors[s].loops[l];
                const auto from = static_cast<std::ptrdiff_t>(first), to = static_cast<std::ptrdiff_t>(end);
                loop.vertices.erase(loop.vertices.begin() + from, loop.vertices.begin() + to);
                loop.walls.erase(loop.walls.begin() + from, loop.walls.begin() + to);
            };
            if (take(cut)) return true;
        }
        return false;
    }

    bool shrink_walls() {
        bool is_smaller = false;
        for (std::size_t s = 0; s < file_.sectors.size(); ++s)
            for (std::size_t l = 0; l < file_.sectors[s].loops.size(); ++l)
                for (std::size_t w = 0; w < file_.sectors[s].loops[l].walls.size(); ++w)
                    is_smaller |= take([&](MapFile& file) {
                        WallRecord& wall = file.sectors[s].loops[l].walls[w];
                        wall = plain(wall);
                    });
        return is_smaller;
    }

    MapFile file_;
    const IsFaulty& is_faulty_;
    int questions_left_;
};

}  // namespace

MapFile shrunk(MapFile file, const IsFaulty& is_faulty, int most_questions) {
    return Shrinking(std::move(file), is_faulty, most_questions).run();
}

}  // namespace enfilade::test
