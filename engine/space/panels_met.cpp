#include "space/panels_met.h"

#include <algorithm>
#include <optional>

#include "math/predicates.h"

namespace enfilade {
namespace {

struct Found {
    MetPanel met;
    PathFraction at;
};
using AllFound = ShortList<Found, 8>;

PathFraction fraction_at(const Leg& leg, Vec2 a, Vec2 b) { return fraction_along_path(leg.from, leg.to, a, b); }

/// The part of a leg's path that is in its sector.
class Inside {
public:
    Inside(const Map& map, const Leg& leg, WallId exit) : leg_(leg) {
        if (leg.entry) begin_ = fraction_at(leg, map[leg.entry].a, map[leg.entry].b);
        if (exit) end_ = fraction_at(leg, map[exit].a, map[exit].b);
    }

    void add(const Map& map, PanelId id, AllFound& found) const {
        const Panel& panel = map[id];
        if (!panel.is_active() || !boxes_touch(leg_, panel.a, panel.b)) return;
        const bool from_behind = side_of_line(panel.a, panel.b, leg_.from) < 0;
        const Vec2 a = from_behind ? panel.b : panel.a, b = from_behind ? panel.a : panel.b;
        if (!path_leaves_through(leg_.from, leg_.to, a, b)) return;
        const PathFraction at = fraction_at(leg_, a, b);
        if ((begin_ && compare(at, *begin_) < 0) || (end_ && compare(at, *end_) > 0)) return;
        found.push_back({{id, from_behind}, at});
        const auto is_before = [](const Found& f, const Found& g) { return compare(f.at, g.at) < 0; };
        std::rotate(std::upper_bound(found.begin(), found.end() - 1, found.back(), is_before), found.end() - 1,
                    found.end());
    }

private:
    const Leg& leg_;
    std::optional<PathFraction> begin_, end_;
};

void add_in_order(const Map& map, const Leg& leg, WallId exit, MetPanels& met) {
    if (leg.from == leg.to) return;
    const Sector& sector = map[leg.sector];
    const Inside inside(map, leg, exit);
    AllFound found;
    for (std::uint32_t i = sector.first_panel; i < sector.first_panel + sector.panel_count; ++i)
        inside.add(map, PanelId(i), found);
    for (const Found& f : found) met.push_back(f.met);
}

}  // namespace

void add_panels_met(const Map& map, const Leg& leg, WallId exit, MetPanels& met) {
    if (map[leg.sector].active_panels == 0) return;
    if (leg.hop) add_in_order(map, {leg.sector, leg.hop->from, leg.from, leg.hop->through}, {}, met);
    add_in_order(map, leg, exit, met);
}

MetPanel first_barrier(const Map& map, const Leg& leg, WallId exit, const MayCross& may_cross) {
    if (!may_cross || map[leg.sector].active_panels == 0) return {};
    MetPanels met;
    add_panels_met(map, leg, exit, met);
    for (const MetPanel& panel : met)
        if (!may_cross(panel)) return panel;
    return {};
}

}  // namespace enfilade
