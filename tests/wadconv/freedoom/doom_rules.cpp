#include "wadconv/freedoom/doom_rules.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace enfilade::test {
namespace {

using wadconv::DoomMap;
using wadconv::DoomSector;
using wadconv::Linedef;

/// The rules themselves, for one line.
class Reader {
public:
    Reader(const DoomMap& map, const DoomSpecial& special, const TextureHeight& height_of)
        : map_(map), special_(special), height_of_(height_of) {}

    std::vector<Motion> read(const Linedef& line) {
        const auto behind = sector_of(line.left);
        if (special_.is_crossed && !behind) return {};  // nobody walks through a wall
        if (special_.is_pushed) {
            if (behind) act(*behind);
            return std::move(motions_);
        }
        // Boom lets no line without a tag act on the sectors without one.
        for (std::uint32_t s = 0; s < map_.sectors.size() && line.tag != 0; ++s)
            if (map_.sectors[s].tag == line.tag) act(s);
        return std::move(motions_);
    }

private:
    std::optional<std::uint32_t> sector_of(std::uint16_t side) const {
        if (side >= map_.sides.size() || map_.sides[side].sector >= map_.sectors.size()) return {};
        return map_.sides[side].sector;
    }

    /// Calls visit(line, its front sector, its back sector) for each two-sided line of the sector, in their order.
    template <class Visit>
    void each_line(std::uint32_t sector, Visit visit) const {
        for (const Linedef& line : map_.lines) {
            const auto front = sector_of(line.right), back = sector_of(line.left);
            if (!front || !back || !(line.flags & wadconv::kTwoSided)) continue;
            if (*front == sector || *back == sector) visit(line, *front, *back);
        }
    }

    template <class Visit>
    void each_around(std::uint32_t sector, Visit visit) const {
        each_line(sector, [&](const Linedef&, std::uint32_t front, std::uint32_t back) {
            if (front != back) visit(map_.sectors[front == sector ? back : front]);
        });
    }

    double floor(std::uint32_t s) const { return map_.sectors[s].floor; }
    double ceiling(std::uint32_t s) const { return map_.sectors[s].ceiling; }

    double lowest_floor(std::uint32_t s) const {
        double z = floor(s);
        each_around(s, [&](const DoomSector& other) { z = std::min<double>(z, other.floor); });
        return z;
    }
    double highest_floor(std::uint32_t s) const {
        double z = -32000;
        each_around(s, [&](const DoomSector& other) { z = std::max<double>(z, other.floor); });
        return z;
    }
    double next_floor(std::uint32_t s) const {
        double z = std::numeric_limits<double>::infinity();
        each_around(s, [&](const DoomSector& other) {
            if (other.floor > floor(s)) z = std::min<double>(z, other.floor);
        });
        return z < std::numeric_limits<double>::infinity() ? z : floor(s);
    }
    double lowest_ceiling(std::uint32_t s) const {
        double z = 32000;
        each_around(s, [&](const DoomSector& other) { z = std::min<double>(z, other.ceiling); });
        return z;
    }
    double highest_ceiling(std::uint32_t s) const {
        double z = -32000;
        each_around(s, [&](const DoomSector& other) { z = std::max<double>(z, other.ceiling); });
        return z;
    }
    double shortest_lower(std::uint32_t s) const {
        double shortest = 32000;
        each_line(s, [&](const Linedef& line, std::uint32_t, std::uint32_t) {
            for (const std::uint16_t side : {line.right, line.left})
                if (const double height = height_of_(map_.sides[side].lower); height > 0)
                    shortest = std::min(shortest, height);
        });
        return shortest;
    }

    bool is_busy(std::uint32_t s, bool is_ceiling) const {
        return std::ranges::any_of(motions_,
                                   [&](const Motion& m) { return m.sector == s && m.is_ceiling == is_ceiling; });
    }

    /// A floor goes up as far as the ceiling lets it, a ceiling down as far as the floor does (T_MovePlane).
    void add(std::uint32_t s, bool is_ceiling, std::vector<MotionLeg> legs, bool loops = false) {
        for (MotionLeg& leg : legs)
            leg.height = is_ceiling ? std::max(leg.height, floor(s)) : std::min(leg.height, ceiling(s));
        motions_.push_back({s, is_ceiling, std::move(legs), loops});
    }
    void add_floor(std::uint32_t s, double z) { add(s, false, {{z, special_.speed}}); }
    void add_ceiling(std::uint32_t s, double z) { add(s, true, {{z, special_.speed}}); }

    void act(std::uint32_t s) {
        const double v = special_.speed, top = lowest_ceiling(s) - 4;
        switch (special_.rule) {
            case Rule::door: return add(s, true, {{top, v, special_.wait}, {floor(s), v}});
            case Rule::open: return add_ceiling(s, top);
            case Rule::close:
            case Rule::ceiling_to_floor: return add_ceiling(s, floor(s));
            case Rule::close_then_open: return add(s, true, {{floor(s), v, special_.wait}, {ceiling(s), v}});
            case Rule::ceiling_to_highest: return add_ceiling(s, highest_ceiling(s));
            case Rule::ceiling_to_8_above_floor: return add_ceiling(s, floor(s) + 8);
            case Rule::crusher: return add(s, true, {{floor(s) + 8, v}, {ceiling(s), v}}, true);
            default: return act_on_floor(s);
        }
    }

    void act_on_floor(std::uint32_t s) {
        const double v = special_.speed, z = floor(s);
        switch (special_.rule) {
            case Rule::lift: return add(s, false, {{lowest_floor(s), v, special_.wait}, {z, v}});
            case Rule::perpetual: {
                const double high = std::max(z, highest_floor(s));
                return add(s, false, {{lowest_floor(s), v, special_.wait}, {high, v, special_.wait}}, true);
            }
            case Rule::raise_by: return add_floor(s, z + special_.amount);
            case Rule::raise_to_next: return add_floor(s, next_floor(s));
            case Rule::to_highest: return add_floor(s, highest_floor(s));
            case Rule::to_highest_and_up: return add_floor(s, highest_floor(s) + (highest_floor(s) == z ? 0 : 8));
            case Rule::to_lowest: return add_floor(s, lowest_floor(s));
            case Rule::to_ceiling: return add_floor(s, std::min(lowest_ceiling(s), ceiling(s)));
            case Rule::to_8_below_ceiling: return add_floor(s, std::min(lowest_ceiling(s), ceiling(s)) - 8);
            case Rule::by_texture: return add_floor(s, z + shortest_lower(s));
            case Rule::donut: return add_donut(s);
            case Rule::stairs: return add_stairs(s);
            default: return;
        }
    }

    /// The ring is beyond the pillar's first line, the model beyond the ring's first line that leads elsewhere.
    void add_donut(std::uint32_t pillar) {
        std::optional<std::uint32_t> ring, model;
        each_line(pillar, [&](const Linedef&, std::uint32_t front, std::uint32_t back) {
            if (!ring) ring = front == pillar ? back : front;
        });
        if (!ring) return;
        each_line(*ring, [&](const Linedef&, std::uint32_t, std::uint32_t back) {
            if (!model && back != pillar) model = back;
        });
        if (!model) return;
        add_floor(*ring, floor(*model));
        add_floor(pillar, floor(*model));
    }

    /// From each stair through its first line that it is in front of to a sector with the first one's floor picture
    /// that does not move yet.
    void add_stairs(std::uint32_t first) {
        std::vector<std::uint32_t> stairs{first};
        for (std::size_t i = 0; i < stairs.size(); ++i) {
            const std::uint32_t from = stairs[i];
            add_floor(from, floor(first) + special_.amount * static_cast<double>(i + 1));
            each_line(from, [&](const Linedef&, std::uint32_t front, std::uint32_t back) {
                if (stairs.size() > i + 1 || front != from || is_busy(back, false)) return;
                if (map_.sectors[back].floor_flat == map_.sectors[first].floor_flat) stairs.push_back(back);
            });
        }
    }

    const DoomMap& map_;
    const DoomSpecial& special_;
    const TextureHeight& height_of_;
    std::vector<Motion> motions_;
};

}  // namespace

std::vector<Motion> motions_of(const DoomMap& map, const Linedef& line, const DoomSpecial& special,
                               const TextureHeight& height_of) {
    return Reader(map, special, height_of).read(line);
}

}  // namespace enfilade::test
