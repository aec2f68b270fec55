#include "wadconv/freedoom/firing_range.h"

#include <cstdlib>

#include "math/predicates.h"
#include "world/trigger_actions.h"

namespace enfilade::test {

std::uint32_t doom_sector_of(const Sector& part) {
    return static_cast<std::uint32_t>(std::strtoul(part.name.c_str() + 1, nullptr, 10));
}

FiringRange::FiringRange(const wadconv::DoomMap& doom, const Map& map) : doom_(doom), map_(map) {
    for (const Wall& wall : map.walls) add(wall.a, wall.b, wall.triggers);
    for (const Panel& panel : map.panels) add(panel.a, panel.b, panel.triggers);
}

Fired FiringRange::fire(const wadconv::Linedef& line, History before, std::uint64_t tick) const {
    Fired fired{std::move(before), 0};
    fired.first_change = fired.history.changes().size();
    const TriggerRange range = triggers_of(line);
    for (std::uint32_t i = range.first; i < range.first + range.count; ++i)
        carry_out(map_, fired.history, TriggerId(i), tick);
    return fired;
}

TriggerRange FiringRange::triggers_of(const wadconv::Linedef& line) const {
    const Vec2 a = point(line.start), b = point(line.end);
    for (const Ends& side : {ends(a, b), ends(b, a)})
        if (const auto found = found_.find(side); found != found_.end()) return found->second;
    const auto is_along = [&](Vec2 p) { return corner(a, b, p) == 0 && dot(p - a, p - b) <= 0; };
    for (const Panel& panel : map_.panels)
        if (panel.triggers.count > 0 && is_along(panel.a) && is_along(panel.b)) return panel.triggers;
    return {};
}

Vec2 FiringRange::point(std::uint16_t vertex) const {
    return {doom_.vertices[vertex].x / wadconv::kUnitsPerMetre, 0 - doom_.vertices[vertex].y / wadconv::kUnitsPerMetre};
}

void FiringRange::add(Vec2 a, Vec2 b, TriggerRange triggers) {
    if (triggers.count > 0) found_[ends(a, b)] = triggers;
}

}  // namespace enfilade::test
