// The fields of everything a built map consists of, in order, each kind once: whoever writes or reads a map as bytes
// goes by them. Each takes its struct apart by a structured binding, so that one with a field more does not compile.
// fields(whole, visit) returns visit(field, field, …). Left out is where something was written in its file, which
// nobody asks a built map, and what is quickly worked out again (map/compiled_map.cpp).
#pragma once
#include <type_traits>

#include "map/map.h"

namespace enfilade {

template <class T>
concept Scalar = std::is_arithmetic_v<T> || std::is_enum_v<T>;

/// Whole, also where it is const.
template <class T, class Whole>
concept Some = std::is_same_v<std::remove_const_t<T>, Whole>;

template <class T>
inline constexpr bool kIsId = false;
template <class Tag>
inline constexpr bool kIsId<Id<Tag>> = true;

template <class T>
    requires kIsId<std::remove_const_t<T>>
constexpr auto fields(T& id, auto visit) {
    return visit(id.index);
}

constexpr auto fields(Some<Vec2> auto& whole, auto visit) {
    auto& [x, y] = whole;
    return visit(x, y);
}

constexpr auto fields(Some<Angle> auto& whole, auto visit) {
    auto& [steps] = whole;
    return visit(steps);
}

constexpr auto fields(Some<TriggerRange> auto& whole, auto visit) {
    auto& [first, count] = whole;
    return visit(first, count);
}

constexpr auto fields(Some<TargetRange> auto& whole, auto visit) {
    auto& [first, count] = whole;
    return visit(first, count);
}

constexpr auto fields(Some<Rigid> auto& whole, auto visit) {
    auto& [c, s, flip, shift, rise] = whole;
    return visit(c, s, flip, shift, rise);
}

constexpr auto fields(Some<Surface> auto& whole, auto visit) {
    auto& [texture, tile_m, offset_tiles, peg, scroll] = whole;
    return visit(texture, tile_m, offset_tiles, peg, scroll);
}

constexpr auto fields(Some<Wall> auto& whole, auto visit) {
    auto& [a, b, length, sector, next, previous, kind, behind, exit, blocks, one_way_exit, link, contrast, texture,
           upper, lower, middle, triggers] = whole;
    return visit(a, next, kind, behind, exit, blocks, one_way_exit, link, contrast, texture, upper, lower, middle,
                 triggers);
}

constexpr auto fields(Some<Panel> auto& whole, auto visit) {
    auto& [a, b, length, sector, bottom, top, contrast, surface, one_sided, blocks, triggers] = whole;
    return visit(a, b, sector, bottom, top, contrast, surface, one_sided, blocks, triggers);
}

constexpr auto fields(Some<Flat> auto& whole, auto visit) {
    auto& [z, origin, surface, sky, carries, first_layer, layer_count] = whole;
    return visit(z, origin, surface, sky, carries, first_layer, layer_count);
}

constexpr auto fields(Some<BobRecord> auto& whole, auto visit) {
    auto& [amplitude, period, phase, shape] = whole;
    return visit(amplitude, period, phase, shape);
}

constexpr auto fields(Some<LightEffectRecord> auto& whole, auto visit) {
    auto& [kind, dark, dark_s, bright_s, in_step, lasts, step, clock_hz, place, places] = whole;
    return visit(kind, dark, dark_s, bright_s, in_step, lasts, step, clock_hz);
}

constexpr auto fields(Some<Sector> auto& whole, auto visit) {
    auto& [name, first_wall, wall_count, has_screens, light, unlit, sun, floor, ceiling, floor_bob, ceiling_bob, min,
           max, first_solid, solid_count, first_panel, panel_count, active_panels, first_touchable, touchable_count,
           triggers, light_effect, damage, secret, leader, next_of_group, up_sound, down_sound, stop_sound] = whole;
    return visit(name, first_wall, wall_count, has_screens, light, unlit, sun, floor, ceiling, floor_bob, ceiling_bob,
                 first_solid, solid_count, first_panel, panel_count, active_panels, first_touchable, touchable_count,
                 triggers, light_effect, damage, secret, leader, next_of_group, up_sound, down_sound, stop_sound);
}

constexpr auto fields(Some<SpriteFrame> auto& whole, auto visit) {
    auto& [views, origins_m, until_s] = whole;
    return visit(views, origins_m, until_s);
}

constexpr auto fields(Some<Sprite> auto& whole, auto visit) {
    auto& [frames, texels_per_m, reach_m] = whole;
    return visit(frames, texels_per_m, reach_m);
}

constexpr auto fields(Some<Thing> auto& whole, auto visit) {
    auto& [name, kind, sector, position, yaw, turn, bob, footing, z, radius, height, solid, holds_up, light, sprite,
           triggers, gives_key, gives_health, sound] = whole;
    return visit(name, kind, sector, position, yaw, turn, bob, footing, z, radius, height, solid, holds_up, light,
                 sprite, triggers, gives_key, gives_health, sound);
}

constexpr auto fields(Some<PointLight> auto& whole, auto visit) {
    auto& [sector, position, z, color, brightness, reach, effect] = whole;
    return visit(sector, position, z, color, brightness, reach, effect);
}

constexpr auto fields(Some<Sun> auto& whole, auto visit) {
    auto& [level, up, color, brightness] = whole;
    return visit(level, up, color, brightness);
}

constexpr auto fields(Some<PlayerStart> auto& whole, auto visit) {
    auto& [sector, position, eye_z, yaw] = whole;
    return visit(sector, position, eye_z, yaw);
}

constexpr auto fields(Some<Trigger> auto& whole, auto visit) {
    auto& [on, action, once, one_way, reverses, crushes, heals, key, targets, destination, leads_to, after_s, z, to,
           like, by, speed, wait_s, step, crush_speed, texture, light, light_of, effect, sound, on_sector, on_wall,
           on_panel, on_thing] = whole;
    return visit(on, action, once, one_way, reverses, crushes, heals, key, targets, destination, leads_to, after_s, z,
                 to, like, by, speed, wait_s, step, crush_speed, texture, light, light_of, effect, sound, on_sector,
                 on_wall, on_panel, on_thing);
}

constexpr auto fields(Some<Sound> auto& whole, auto visit) {
    auto& [name, file, volume, reach_m, loops] = whole;
    return visit(name, file, volume, reach_m, loops);
}

constexpr auto fields(Some<Animation> auto& whole, auto visit) {
    auto& [frames, seconds] = whole;
    return visit(frames, seconds);
}

constexpr auto fields(Some<PictureChanges> auto& whole, auto visit) {
    auto& [animations, animation_of, other_face] = whole;
    return visit(animations, animation_of, other_face);
}

constexpr auto fields(Some<RenderRecord> auto& whole, auto visit) {
    auto& [stretch, light, recursion_color, max_depth, fog_color, fog_reach, sky, things, rays, color_table, fog_step,
           place, places] = whole;
    return visit(stretch, light, recursion_color, max_depth, fog_color, fog_reach, sky, things, rays, color_table);
}

constexpr auto fields(Some<Map> auto& whole, auto visit) {
    auto& [name, sectors, walls, surfaces, links, grid_links, flat_layers, panels, things, sprites, lights, suns,
           solid_things, near_things, first_near, touchables, triggers, targets, at_start, sounds, sounding_things,
           has_ways_back, farthest_sound_m, has_bobs, keys, pictures, player, render] = whole;
    return visit(name, sectors, walls, surfaces, links, flat_layers, panels, things, sprites, lights, suns,
                 solid_things, touchables, triggers, targets, at_start, sounds, sounding_things, has_ways_back,
                 farthest_sound_m, has_bobs, keys, pictures, player, render);
}

}  // namespace enfilade
