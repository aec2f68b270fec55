// Lines of a Doom map, fired in the converted one.
#pragma once
#include <map>
#include <utility>

#include "map/map.h"
#include "wadconv/wad.h"
#include "world/history.h"

namespace enfilade::test {

/// The number of the Doom sector that a part belongs to: 12 of "s12b".
std::uint32_t doom_sector_of(const Sector& part);

/// What has happened in a map, and by which of its changes the last firing began.
struct Fired {
    History history;
    std::size_t first_change = 0;
};

/// Where one fires the lines of a map, which are found by where they lie on the drawing.
class FiringRange {
public:
    FiringRange(const wadconv::DoomMap& doom, const Map& map);

    /// What happens at once where the line is set off at a tick, after what has happened before. Whether it still may
    /// be set off is not asked.
    Fired fire(const wadconv::Linedef& line, History before = {}, std::uint64_t tick = 0) const;

    /// They are on the right side's wall where it has one, else on the left side's, or on each panel of a line in the
    /// middle of a room: on the first.
    TriggerRange triggers_of(const wadconv::Linedef& line) const;

private:
    using Ends = std::pair<std::pair<double, double>, std::pair<double, double>>;

    static Ends ends(Vec2 a, Vec2 b) { return {{a.x, a.y}, {b.x, b.y}}; }
    Vec2 point(std::uint16_t vertex) const;
    void add(Vec2 a, Vec2 b, TriggerRange triggers);

    const wadconv::DoomMap& doom_;
    const Map& map_;
    std::map<Ends, TriggerRange> found_;
};

}  // namespace enfilade::test
