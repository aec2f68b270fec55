// Map records with every field filled at random, sound for the reader though not for geometry.
#pragma once
#include <span>
#include <string>

#include "base/hash.h"
#include "formats/map_file.h"
#include "formats/words.h"

namespace enfilade {

/// Random records from a seed: the same seed gives the same map.
class RandomMap {
public:
    explicit RandomMap(std::uint64_t seed) : random_(seed) {}

    MapFile map() {
        MapFile map;
        map.format = 1;
        map.name = maybe_text();
        map.textures = {file_name(), file_name()};
        map.size = maybe(1, 64);
        map.render = {number(0.125, 8),
                      flip() ? LightModel::classic : LightModel::smooth,
                      static_cast<std::uint32_t>(random_.below(1 << 24)),
                      whole(0, 1024),
                      static_cast<std::uint32_t>(random_.below(1 << 24)),
                      number(0, 99),
                      flip() ? SkyRows::straight : SkyRows::round,
                      flip() ? ThingEdges::whole : ThingEdges::cut,
                      flip() ? RayPoint::corner : RayPoint::middle,
                      flip() ? file_name() : ""};
        for (int i = whole(1, 4); i > 0; --i) map.sectors.push_back(sector());
        if (flip()) map.player = PlayerRecord{text(), point(), number(-100, 100), number(-360, 360), {}};
        for (int i = whole(0, 3); i > 0; --i) map.things.push_back(thing());
        for (int i = whole(0, 2); i > 0; --i)
            map.lights.push_back({maybe_text(),
                                  point(),
                                  number(-9, 9),
                                  static_cast<std::uint32_t>(random_.below(1 << 24)),
                                  number(0, 2),
                                  number(0.1, 60),
                                  light_effect(),
                                  {}});
        for (int i = whole(0, 2); i > 0; --i)
            map.suns.push_back({text(),
                                number(-360, 360),
                                number(0, 90),
                                static_cast<std::uint32_t>(random_.below(1 << 24)),
                                number(0, 2),
                                {}});
        for (int i = whole(0, 2); i > 0; --i)
            map.animations.push_back({{file_name(), file_name()}, number(0.1, 9), {}});
        for (int i = whole(0, 2); i > 0; --i) map.switches.push_back({file_name(), file_name(), {}});
        for (int i = whole(0, 2); i > 0; --i)
            map.sounds.push_back({text(), file_name(), number(0, 1), number(0.1, 99), flip(), {}});
        return map;
    }

private:
    template <Word W>
    W any() {
        return static_cast<W>(random_.below(kWords<W>.size()));
    }
    bool flip() { return random_.below(2) == 1; }
    int whole(int low, int high) {
        return low + static_cast<int>(random_.below(static_cast<std::uint64_t>(high - low) + 1));
    }

    /// Round numbers, and numbers that need all their digits.
    double number(double low, double high) {
        const double x = random_.uniform(low, high);
        const double rounded = static_cast<double>(static_cast<std::int64_t>(x));
        return flip() || rounded < low ? x : rounded;
    }
    Vec2 point() { return {number(-32768, 32768), number(-32768, 32768)}; }

    std::string text() {
        static constexpr std::string_view kParts[] = {"a", "B7", "\"", "\\", "é",  "漢",
                                                      " ", "#",  "'",  "]",  "\t", "\x01"};
        return text_of(kParts);
    }
    /// Of files: without control characters, and in folders.
    std::string file_name() {
        static constexpr std::string_view kParts[] = {"a", "B7", "\"", "\\", "é",  "漢",
                                                      " ", "#",  "'",  "]",  "/n", "..n"};
        return text_of(kParts);
    }
    std::string text_of(std::span<const std::string_view> parts) {
        std::string text = "n";
        for (int i = whole(0, 5); i > 0; --i) text += parts[random_.below(parts.size())];
        return text;
    }
    std::string maybe_text() { return flip() ? text() : ""; }

    TextureSpec spec(bool may_tile = true) {
        TextureSpec spec;
        spec.name = flip() ? "-" : "WALL" + std::to_string(whole(0, 99));
        if (may_tile && flip()) spec.tile_m = Vec2{number(0.001, 9), -number(0.001, 9)};
        if (flip()) spec.offset_tx = {number(-300, 300), number(-300, 300)};
        return spec;
    }
    std::optional<TextureSpec> maybe_spec(bool may_tile) {
        return flip() ? std::optional(spec(may_tile)) : std::nullopt;
    }
    std::optional<double> maybe(double low, double high) {
        return flip() ? std::optional(number(low, high)) : std::nullopt;
    }
    std::optional<DoomRecord> doom() {
        if (flip()) return {};
        return DoomRecord{whole(0, 300), whole(-5, 700), whole(0, 65535)};
    }
    std::optional<LightEffectRecord> light_effect() {
        if (flip()) return {};
        return LightEffectRecord{any<LightKind>(), number(0, 1),   number(0.1, 9),
                                 number(0.1, 9),   flip(),         flip(),
                                 maybe(0, 1),      number(1, 240), {}};
    }

    Boxed<BobRecord> bob() {
        if (flip()) return {};
        return BobRecord{number(0.1, 9), number(0.2, 99), number(0, 1), flip() ? BobShape::sine : BobShape::triangle};
    }

    TriggerRecord trigger() {
        TriggerRecord trigger;
        trigger.on = any<Activation>();
        trigger.action = any<TriggerAction>();
        for (int i = whole(0, 2); i > 0; --i)
            trigger.targets.push_back(trigger.action == TriggerAction::leave_map ? file_name() : text());
        trigger.once = flip();
        trigger.one_way = flip();
        trigger.key = maybe_text();
        trigger.after = number(0, 99);
        if (flip())
            trigger.z = number(-99, 99);
        else if (flip())
            trigger.to = any<HeightLevel>();
        else
            trigger.like = maybe_text();
        trigger.by = number(-9, 9);
        trigger.speed = number(0.1, 9);
        trigger.wait = number(0, 9);
        trigger.step = number(-9, 9);
        trigger.reverses = flip();
        trigger.crushes = flip();
        trigger.crush_speed = maybe(0.1, 9);
        trigger.texture = flip() ? file_name() : "";
        trigger.heals = flip();
        if (flip())
            trigger.light = number(0, 1);
        else
            trigger.light_of = any<LightLevel>();
        trigger.effect = light_effect();
        trigger.sound = maybe_text();
        return trigger;
    }
    std::vector<TriggerRecord> triggers() {
        std::vector<TriggerRecord> all;
        for (int i = whole(0, 2); i > 0; --i) all.push_back(trigger());
        return all;
    }

    Peg peg() { return any<Peg>(); }

    WallRecord wall() {
        WallRecord wall;
        wall.name = maybe_text();
        wall.size = maybe(1, 64);
        const bool may_tile = !wall.size;
        wall.texture = maybe_spec(may_tile);
        wall.upper = maybe_spec(may_tile);
        wall.lower = maybe_spec(may_tile);
        wall.middle = maybe_spec(may_tile);
        wall.texture_peg = peg();
        wall.upper_peg = peg();
        wall.lower_peg = peg();
        wall.middle_peg = peg();
        wall.next = maybe_text();
        wall.via = maybe_text();
        wall.rise = maybe(-9, 9);
        wall.mirror = flip();
        wall.blocks = flip();
        if (flip()) wall.scroll = {number(-9, 9), number(-9, 9)};
        wall.triggers = triggers();
        wall.doom = doom();
        return wall;
    }

    LoopRecord loop() {
        LoopRecord loop;
        loop.name = maybe_text();
        for (int i = whole(0, 20); i > 0; --i) {
            loop.vertices.push_back(point());
            loop.walls.push_back(wall());
        }
        return loop;
    }

    FlatRecord flat() {
        FlatRecord flat;
        flat.z = number(-9, 9);
        flat.size = maybe(1, 64);
        flat.texture = maybe_spec(!flat.size);
        flat.is_relative = flip();
        flat.parallax = flip();
        if (flip()) flat.scroll = {number(-9, 9), number(-9, 9)};
        flat.carries = flip();
        flat.bob = bob();
        for (int i = whole(0, 2); i > 0; --i) flat.layers.push_back({spec(), flip() ? number(-9, 9) : 0, {}, {}, {}});
        if (!flat.layers.empty() && flip()) flat.layers.back().scroll = {number(-9, 9), number(-9, 9)};
        return flat;
    }

    SectorRecord sector() {
        SectorRecord sector;
        sector.name = text();
        sector.light = number(0, 1);
        sector.unlit = flip();
        sector.sun = maybe_text();
        if (flip()) sector.floor = flat();
        if (flip()) sector.ceiling = flat();
        for (int i = whole(1, 3); i > 0; --i) sector.loops.push_back(loop());
        for (int i = whole(0, 2); i > 0; --i)
            sector.panels.push_back({point(),
                                     point(),
                                     number(-9, 9),
                                     number(-9, 9),
                                     spec(),
                                     {},
                                     flip(),
                                     flip(),
                                     flip() ? Vec2{number(-9, 9), number(-9, 9)} : Vec2{},
                                     triggers(),
                                     doom(),
                                     {},
                                     {}});
        if (flip()) sector.tags = {text(), text()};
        sector.group = maybe_text();
        sector.triggers = triggers();
        sector.light_effect = light_effect();
        sector.damage = whole(0, 99);
        sector.secret = flip();
        sector.move_sound = maybe_text();
        sector.down_sound = maybe_text();
        sector.stop_sound = maybe_text();
        sector.doom = doom();
        return sector;
    }

    ThingRecord thing() {
        ThingRecord thing;
        thing.name = maybe_text();
        thing.kind = maybe_text();
        thing.sector = maybe_text();
        thing.position = point();
        thing.z = maybe(-9, 9);
        thing.yaw_degrees = number(-720, 720);
        thing.turn = number(-720, 720);
        thing.bob = bob();
        thing.radius = number(0, 9);
        thing.height = number(0, 9);
        thing.solid = flip();
        thing.holds_up = any<HoldsUp>();
        thing.hanging = flip();
        thing.rotations = flip() ? 8 : 1;
        for (int i = whole(0, 3); i > 0; --i)
            thing.frames.push_back({file_name(), number(0, 3), Vec2{number(-64, 64), number(-64, 64)}, {}, {}});
        thing.size = number(1, 64);
        thing.light = maybe(0, 1);
        thing.triggers = triggers();
        thing.gives_key = maybe_text();
        thing.gives_health = whole(0, 99);
        thing.skills = static_cast<std::uint8_t>(flip() ? kAllSkills : whole(0, kAllSkills));
        thing.multiplayer = flip();
        thing.sound = maybe_text();
        thing.doom = doom();
        return thing;
    }

    Random random_;
};

/// The map without the places its records were read from.
inline MapFile without_places(MapFile map) {
    const auto forget = [](auto& spec) {
        if (spec) spec->place = {};
    };
    const auto forget_triggers = [](std::vector<TriggerRecord>& triggers) {
        for (TriggerRecord& trigger : triggers) {
            trigger.place = {};
            if (trigger.effect) trigger.effect->place = {};
        }
    };
    map.render.place = {};
    for (SectorRecord& sector : map.sectors) {
        forget_triggers(sector.triggers);
        if (sector.light_effect) sector.light_effect->place = {};
        sector.place = sector.floor.place = sector.ceiling.place = {};
        for (FlatRecord* flat : {&sector.floor, &sector.ceiling})
            for (FlatLayerRecord& layer : flat->layers) layer.place = layer.texture.place = {};
        forget(sector.floor.texture);
        forget(sector.ceiling.texture);
        for (PanelRecord& panel : sector.panels) {
            forget_triggers(panel.triggers);
            panel.place = panel.texture.place = {};
        }
        for (LoopRecord& loop : sector.loops) {
            loop.place = {};
            loop.vertex_places.clear();
            for (WallRecord& wall : loop.walls) {
                forget_triggers(wall.triggers);
                wall.place = {};
                for (auto* spec : {&wall.texture, &wall.upper, &wall.lower, &wall.middle}) forget(*spec);
            }
        }
    }
    for (ThingRecord& thing : map.things) {
        thing.place = {};
        for (SpriteFrameRecord& frame : thing.frames) frame.place = {};
        forget_triggers(thing.triggers);
    }
    for (SunRecord& sun : map.suns) sun.place = {};
    for (PointLightRecord& light : map.lights) {
        light.place = {};
        if (light.effect) light.effect->place = {};
    }
    for (AnimationRecord& animation : map.animations) animation.place = {};
    for (SwitchRecord& faces : map.switches) faces.place = {};
    for (SoundRecord& sound : map.sounds) sound.place = {};
    if (map.player) map.player->place = {};
    return map;
}

}  // namespace enfilade
