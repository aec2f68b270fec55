// What stands and moves in a wild world.
#include <algorithm>
#include <cmath>

#include "math/predicates.h"
#include "support/furnish.h"
#include "support/map_builder.h"
#include "wild/plans.h"

namespace enfilade::test {
namespace {

/// Heights of a room of that size; the lowest choice is a room like any other.
void set_heights(SectorRecord& sector, double size, Choices& choices) {
    const double step = std::clamp(size / 16, 0x1p-10, 0.5);
    sector.floor.z = step * static_cast<double>(choices.below(5));
    const double headroom = choices.one_in(8) ? 0 : choices.one_in(8) ? step / 4 : 2 * std::clamp(size, 0x1p-8, 1000.0);
    sector.ceiling.z = sector.floor.z + headroom + step * static_cast<double>(choices.below(4));
}

void set_looks(SectorRecord& sector, Choices& choices) {
    sector.light = 1 - choices.between(0, 1);
    sector.unlit = choices.one_in(8);
    sector.ceiling.parallax = choices.one_in(6);
    sector.floor.parallax = choices.one_in(16);
    sector.floor.is_relative = choices.one_in(4);
    if (choices.one_in(6)) sector.floor.scroll = {choices.between(-3, 3), choices.between(-3, 3)};
    sector.floor.carries = choices.one_in(8);
    if (choices.one_in(8)) sector.light_effect = LightEffectRecord{};
    if (choices.one_in(10)) sector.floor.bob = BobRecord{choices.between(0.01, 0.5), choices.between(0.5, 4)};
    if (choices.one_in(12)) sector.ceiling.bob = BobRecord{0.25, 3, choices.between(0, 1), BobShape::triangle};
    if (choices.one_in(4)) sector.move_sound = "hum";
}

TriggerRecord any_trigger(const WorldPlan& plan, Activation on, Choices& choices) {
    static const std::vector<TriggerAction> kActions{
        TriggerAction::door,  TriggerAction::lift,   TriggerAction::shuttle, TriggerAction::crush,
        TriggerAction::floor, TriggerAction::stairs, TriggerAction::open,    TriggerAction::close_then_open,
        TriggerAction::stop,  TriggerAction::light,  TriggerAction::ceiling, TriggerAction::teleport};
    TriggerRecord trigger;
    trigger.on = on;
    trigger.action = choices.any(kActions);
    trigger.targets = {choices.any(plan.file.sectors).name};
    if (trigger.action == TriggerAction::teleport) trigger.targets = {"thing"};
    if (trigger.action == TriggerAction::light) trigger.light = choices.between(0, 1);
    trigger.to = static_cast<HeightLevel>(choices.below(9));
    trigger.by = choices.between(-1, 1);
    trigger.speed = choices.between(0.5, 12);
    trigger.wait = choices.between(0, 2);
    trigger.step = choices.between(-0.5, 1);
    if (trigger.step == 0) trigger.step = 1;  // no rule allows level stairs
    trigger.crushes = choices.one_in(3);
    trigger.once = choices.one_in(4);
    if (choices.one_in(4)) trigger.sound = "hum";
    return trigger;
}

void add_movers(WorldPlan& plan, Choices& choices) {
    for (std::uint64_t count = choices.below(8); count > 0; --count) {
        std::vector<SectorRecord>& sectors = plan.file.sectors;
        SectorRecord& sector = sectors[choices.below(sectors.size())];
        LoopRecord& loop = sector.loops[choices.below(sector.loops.size())];
        WallRecord& wall = loop.walls[choices.below(loop.walls.size())];
        switch (choices.below(4)) {
            case 0: sector.triggers.push_back(any_trigger(plan, Activation::enter, choices)); break;
            case 1: sector.triggers.push_back(any_trigger(plan, Activation::start, choices)); break;
            case 2: wall.triggers.push_back(any_trigger(plan, Activation::use, choices)); break;
            default: sector.triggers.push_back(any_trigger(plan, Activation::use, choices));
        }
    }
}

/// Along an edge of the ground, wall or not, so that it passes through nothing; on it, or on a part of it.
void add_panel(WorldPlan& plan, Choices& choices) {
    const Ground& ground = choices.any(plan.ground);
    SectorRecord& sector = plan.file.sectors[ground.sector];
    const std::vector<Vec2> corners{ground.a, ground.b, ground.c, ground.a};
    const std::size_t edge = choices.below(3);
    const double bottom = sector.floor.z - choices.between(0, 0.5);
    PanelRecord record = panel(corners[edge], corners[edge + 1], bottom, bottom + choices.between(0.01, 3));
    record.one_sided = choices.one_in(3);
    record.blocks = choices.one_in(4);
    if (choices.one_in(4))
        record.triggers.push_back(any_trigger(plan, record.blocks ? Activation::use : Activation::cross, choices));
    sector.panels.push_back(record);
}

/// A point of the ground that the tie rule puts inside: a corner, a middle, or anywhere; none where that is not.
std::optional<Vec2> point_on(const Ground& ground, Choices& choices) {
    const double u = choices.between(0, 1), v = choices.between(0, 1) * (1 - u);
    const Vec2 anywhere = ground.a + (ground.b - ground.a) * u + (ground.c - ground.a) * v;
    const std::vector<Vec2> points{anywhere, (ground.a + ground.b + ground.c) * (1.0 / 3), ground.a,
                                   (ground.b + ground.c) * 0.5};
    const Vec2 p = snap_to_point_grid(choices.any(points));
    const bool is_inside = side_of_line(ground.a, ground.b, p) > 0 && side_of_line(ground.b, ground.c, p) > 0 &&
                           side_of_line(ground.c, ground.a, p) > 0;
    return is_inside ? std::optional(p) : std::nullopt;
}

void add_thing(WorldPlan& plan, const std::string& name, Choices& choices) {
    const Ground& ground = choices.any(plan.ground);
    const auto point = point_on(ground, choices);
    if (!point) return;
    ThingRecord thing;
    thing.name = name;
    thing.sector = plan.file.sectors[ground.sector].name;
    thing.position = *point;
    thing.radius = choices.between(0.01, 1);
    thing.solid = choices.one_in(2);
    thing.hanging = choices.one_in(4);
    thing.frames = {{"lattice", 0, Vec2{31.3, 60}}};
    thing.size = 64 / std::clamp(plan.size / 4, 0.01, 4.0);
    if (choices.one_in(3)) thing.sound = "hum";
    plan.file.things.push_back(thing);
}

void add_lamp(WorldPlan& plan, Choices& choices) {
    const Ground& ground = choices.any(plan.ground);
    const auto point = point_on(ground, choices);
    if (!point) return;
    const SectorRecord& sector = plan.file.sectors[ground.sector];
    PointLightRecord lamp;
    lamp.sector = sector.name;
    lamp.position = *point;
    lamp.z = choices.between(sector.floor.z, sector.ceiling.z);
    lamp.color = 0xFFC080;
    lamp.reach = choices.between(0.0625, 6);
    plan.file.lights.push_back(lamp);
}

/// In the largest piece of ground, where there is a place for sure; or anywhere.
void place_player(WorldPlan& plan, Choices& choices) {
    const auto area = [](const Ground& g) { return cross(g.b - g.a, g.c - g.a); };
    const Ground& largest = *std::ranges::max_element(plan.ground, {}, area);
    const Ground& chosen = choices.any(plan.ground);
    const auto point = point_on(chosen, choices);
    const SectorRecord& sector = plan.file.sectors[(point ? chosen : largest).sector];
    const Vec2 middle = snap_to_point_grid((largest.a + largest.b + largest.c) * (1.0 / 3));
    test::place_player(plan.file, sector.name, point.value_or(middle), sector.floor.z + 1.55,
                       choices.between(-180, 180));
}

}  // namespace

void furnish(WorldPlan& plan, Choices& choices) {
    plan.file.sounds = {{"hum", "hum.wav", 1, 32, true, {}, {}}};
    plan.file.render.max_depth = 1 + static_cast<int>(choices.below(8));
    for (SectorRecord& sector : plan.file.sectors) {
        set_heights(sector, plan.size, choices);
        set_looks(sector, choices);
    }
    place_player(plan, choices);
    add_thing(plan, "thing", choices);
    for (std::uint64_t count = choices.below(5); count > 0; --count) add_thing(plan, "", choices);
    if (plan.file.things.empty() || plan.file.things.front().name.empty()) return;  // nowhere to be sent
    for (std::uint64_t count = choices.below(4); count > 0; --count) add_panel(plan, choices);
    if (choices.one_in(3)) add_lamp(plan, choices);
    add_movers(plan, choices);
}

}  // namespace enfilade::test
