#include "app/bench.h"

#include <algorithm>

namespace enfilade {
namespace {

/// Calls visit(record) for each wall, or each floor and ceiling.
template <class File, class Visit>
void each_wall(File& map, Visit visit) {
    for (auto& sector : map.sectors)
        for (auto& loop : sector.loops)
            for (auto& wall : loop.walls) visit(wall);
}
template <class File, class Visit>
void each_flat(File& map, Visit visit) {
    for (auto& sector : map.sectors) {
        visit(sector.floor);
        visit(sector.ceiling);
    }
}

template <class Test>
std::size_t count_walls(const MapFile& map, Test test) {
    std::size_t count = 0;
    each_wall(map, [&](const WallRecord& wall) { count += test(wall); });
    return count;
}
template <class Test>
std::size_t count_flats(const MapFile& map, Test test) {
    std::size_t count = 0;
    each_flat(map, [&](const FlatRecord& flat) { count += test(flat); });
    return count;
}
template <class Test>
std::size_t count_panels(const MapFile& map, Test test) {
    std::size_t count = 0;
    for (const SectorRecord& sector : map.sectors)
        count += static_cast<std::size_t>(std::ranges::count_if(sector.panels, test));
    return count;
}
template <class Test>
std::size_t count_sectors(const MapFile& map, Test test) {
    return static_cast<std::size_t>(std::ranges::count_if(map.sectors, test));
}

/// Triggers of all bearers whose action passes the test.
template <class Test>
std::size_t count_triggers(const MapFile& map, Test test) {
    std::size_t count = 0;
    const auto add = [&](const std::vector<TriggerRecord>& triggers) {
        count += static_cast<std::size_t>(
            std::ranges::count_if(triggers, [&](const TriggerRecord& trigger) { return test(trigger.action); }));
    };
    for (const SectorRecord& sector : map.sectors) {
        add(sector.triggers);
        for (const PanelRecord& panel : sector.panels) add(panel.triggers);
    }
    each_wall(map, [&](const WallRecord& wall) { add(wall.triggers); });
    for (const ThingRecord& thing : map.things) add(thing.triggers);
    return count;
}

bool has_middle(const WallRecord& wall) { return wall.middle && wall.middle->name != "-"; }
bool is_scrolled_flat(const FlatRecord& flat) { return flat.scroll != Vec2{} && !flat.parallax; }
bool moves(TriggerAction action) {
    return action != TriggerAction::light && action != TriggerAction::teleport && action != TriggerAction::leave_map &&
           action != TriggerAction::stop && action != TriggerAction::sound;
}

Effect sky() {
    return {"sky", "flat", "one direction for each column that shows it",
            [](const MapFile& map) { return count_flats(map, [](const FlatRecord& f) { return f.parallax; }); },
            [](MapFile& map) { each_flat(map, [](FlatRecord& f) { f.parallax = false; }); }};
}
Effect flat_layers() {
    return {"layers", "picture", "a mix of two colours for each pixel of their flat",
            [](const MapFile& map) {
                std::size_t count = 0;
                each_flat(map, [&](const FlatRecord& f) { count += f.layers.size(); });
                return count;
            },
            [](MapFile& map) { each_flat(map, [](FlatRecord& f) { f.layers.clear(); }); }};
}
Effect fog() {
    return {"fog", "map", "a mix of two colours for each pixel",
            [](const MapFile& map) { return std::size_t{map.render.fog_reach > 0}; },
            [](MapFile& map) { map.render.fog_reach = 0; }};
}
Effect color_table() {
    return {"color table", "map", "a look into the table for each pixel, instead of a product",
            [](const MapFile& map) { return std::size_t{!map.render.color_table.empty()}; }, nullptr};
}
Effect links() {
    return {"linked portals", "wall", "the rooms behind, drawn once for each way they are seen",
            [](const MapFile& map) { return count_walls(map, [](const WallRecord& w) { return !w.via.empty(); }); },
            nullptr};
}
Effect mirrors() {
    return {"mirrors", "wall", "the rooms in front, drawn once more while the mirror is in view",
            [](const MapFile& map) { return count_walls(map, [](const WallRecord& w) { return w.mirror; }); },
            [](MapFile& map) { each_wall(map, [](WallRecord& w) { w.mirror = false; }); }};
}
Effect masked_walls() {
    return {"masked walls", "wall", "a second pass over the pixels they cover",
            [](const MapFile& map) { return count_walls(map, has_middle); },
            [](MapFile& map) { each_wall(map, [](WallRecord& w) { w.middle.reset(); }); }};
}
Effect panels() {
    return {"panels", "wall", "a second pass over the pixels they cover",
            [](const MapFile& map) { return count_panels(map, [](const PanelRecord&) { return true; }); },
            [](MapFile& map) {
                for (SectorRecord& sector : map.sectors) sector.panels.clear();
            }};
}
Effect things() {
    return {"things", "thing", "a second pass over the pixels they cover",
            [](const MapFile& map) { return map.things.size(); },
            [](MapFile& map) {
                for (ThingRecord& thing : map.things) thing.frames.clear();
            }};
}
Effect animated_things() {
    return {"animated things", "thing", "one look at the clock while in view",
            [](const MapFile& map) {
                return static_cast<std::size_t>(
                    std::ranges::count_if(map.things, [](const ThingRecord& t) { return t.frames.size() > 1; }));
            },
            [](MapFile& map) {
                for (ThingRecord& thing : map.things)
                    if (thing.frames.size() > 1) thing.frames.resize(1);
            }};
}
Effect moving_things() {
    return {"moving things", "thing", "one function of time while in view",
            [](const MapFile& map) {
                return static_cast<std::size_t>(
                    std::ranges::count_if(map.things, [](const ThingRecord& t) { return t.turn != 0 || t.bob; }));
            },
            [](MapFile& map) {
                for (ThingRecord& thing : map.things) {
                    thing.turn = 0;
                    thing.bob.reset();
                }
            }};
}
Effect animations() {
    return {"animations", "picture", "one look at the clock for each surface in view",
            [](const MapFile& map) { return map.animations.size(); }, [](MapFile& map) { map.animations.clear(); }};
}
Effect scrolling() {
    return {"scrolling", "surface", "a sum for each of them in view",
            [](const MapFile& map) {
                return count_flats(map, is_scrolled_flat) +
                       count_walls(map, [](const WallRecord& w) { return w.scroll != Vec2{}; }) +
                       count_panels(map, [](const PanelRecord& p) { return p.scroll != Vec2{}; });
            },
            [](MapFile& map) {
                each_flat(map, [](FlatRecord& f) { f.scroll = {}; });
                each_wall(map, [](WallRecord& w) { w.scroll = {}; });
                for (SectorRecord& sector : map.sectors)
                    for (PanelRecord& panel : sector.panels) panel.scroll = {};
            }};
}
Effect changing_lights() {
    return {"changing lights", "sector", "one function of time for each of them in view",
            [](const MapFile& map) {
                return count_sectors(map, [](const SectorRecord& s) { return s.light_effect.has_value(); });
            },
            [](MapFile& map) {
                for (SectorRecord& sector : map.sectors) sector.light_effect.reset();
            }};
}
Effect point_lights() {
    return {"point lights", "lamp", "two mixes of light for each pixel of the surfaces they reach",
            [](const MapFile& map) { return map.lights.size(); }, [](MapFile& map) { map.lights.clear(); }};
}
Effect unlit_rooms() {
    return {"unlit rooms", "sector", "nothing: it is decided once for each of their surfaces in view",
            [](const MapFile& map) { return count_sectors(map, [](const SectorRecord& s) { return s.unlit; }); },
            [](MapFile& map) {
                for (SectorRecord& sector : map.sectors) sector.unlit = false;
            }};
}
Effect sunlight() {
    return {"sunlight", "sector", "two mixes of light for each pixel of the surfaces that it falls on",
            [](const MapFile& map) { return count_sectors(map, [](const SectorRecord& s) { return !s.sun.empty(); }); },
            [](MapFile& map) {
                for (SectorRecord& sector : map.sectors) sector.sun.clear();
                map.suns.clear();
            }};
}
Effect bobs() {
    return {"bobs", "flat", "one function of time for each look into the room, and each body in it",
            [](const MapFile& map) { return count_flats(map, [](const FlatRecord& f) { return bool(f.bob); }); },
            [](MapFile& map) { each_flat(map, [](FlatRecord& f) { f.bob.reset(); }); }};
}
Effect movers() {
    return {"doors and movers", "trigger", "nothing until one is set off; then one function of time for each frame",
            [](const MapFile& map) { return count_triggers(map, moves); }, nullptr};
}
Effect other_triggers() {
    return {"other triggers", "trigger", "nothing until one is set off",
            [](const MapFile& map) { return count_triggers(map, [](TriggerAction action) { return !moves(action); }); },
            nullptr};
}
Effect damage() {
    return {"harmful floors", "sector", "one look a second at the floor under the feet",
            [](const MapFile& map) { return count_sectors(map, [](const SectorRecord& s) { return s.damage > 0; }); },
            nullptr};
}

Effect sounds() {
    return {"sounds", "sound",
            "a sound device; while anything sounds, each tick the ways that sound takes to the player",
            [](const MapFile& map) { return map.sounds.size(); }, nullptr};
}

}  // namespace

const std::vector<Effect>& all_effects() {
    static const std::vector<Effect> all{
        sky(),          flat_layers(),     fog(),          color_table(),     links(),         mirrors(),
        masked_walls(), panels(),          things(),       animated_things(), moving_things(), animations(),
        scrolling(),    changing_lights(), point_lights(), unlit_rooms(),     sunlight(),      bobs(),
        movers(),       other_triggers(),  damage(),       sounds()};
    return all;
}

std::vector<EffectUse> effects_in(const MapFile& map) {
    std::vector<EffectUse> uses;
    for (const Effect& effect : all_effects())
        if (const std::size_t count = effect.count(map)) uses.push_back({&effect, count});
    return uses;
}

}  // namespace enfilade
