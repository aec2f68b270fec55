#include "app/play/pacing.h"

#include <algorithm>

namespace enfilade {

std::int64_t Pacing::begin() const {
    const std::int64_t slowest = *std::ranges::max_element(took_);
    return due_ - std::min(slowest + kSpare, period_);
}

void Pacing::drew(std::int64_t took) { took_[count_++ % kKept] = took; }

void Pacing::go_on(std::int64_t now) {
    due_ += period_;
    if (due_ < now || due_ > now + 2 * period_) due_ = now + period_;
}

namespace {

bool is_lively(const Map& map, const Surface& surface) {
    if (surface.scroll != Vec2{}) return true;
    const auto& animation_of = map.pictures.animation_of;
    return surface.texture && surface.texture.index < animation_of.size() &&
           animation_of[surface.texture.index] != PictureChanges::kNone;
}

bool is_lively(const Map& map, const Flat& flat) {
    if (is_lively(map, map[flat.surface])) return true;
    const auto first = map.flat_layers.begin() + flat.first_layer;
    return std::any_of(first, first + flat.layer_count, [&](const Surface& layer) { return is_lively(map, layer); });
}

bool is_lively(const Map& map, const Wall& wall) {
    for (const SurfaceId surface : {wall.texture, wall.upper, wall.lower, wall.middle})
        if (is_lively(map, map[surface])) return true;
    return false;
}

bool is_lively(const Thing& thing) { return thing.sprite && (thing.turn != 0 || thing.bob); }

bool is_lively(const Map& map, const Sector& sector) {
    if (sector.light_effect || sector.floor_bob || sector.ceiling_bob) return true;
    if (is_lively(map, sector.floor) || is_lively(map, sector.ceiling)) return true;
    for (std::uint32_t i = 0; i < sector.wall_count; ++i)
        if (is_lively(map, map.walls[sector.first_wall + i])) return true;
    for (std::uint32_t i = 0; i < sector.panel_count; ++i)
        if (is_lively(map, map.panels[sector.first_panel + i].surface)) return true;
    return false;
}

}  // namespace

bool is_same_look(const View& a, const View& b) {
    const bool is_same_tilt = a.tilt.has_value() == b.tilt.has_value() &&
                              (!a.tilt || (a.tilt->pitch == b.tilt->pitch && a.tilt->roll == b.tilt->roll));
    return is_same_tilt && a.sector == b.sector && a.eye == b.eye && a.eye_z == b.eye_z && a.forward == b.forward &&
           a.pitch_tangent == b.pitch_tangent && a.fov_degrees == b.fov_degrees && a.stretch == b.stretch &&
           a.ray_offset == b.ray_offset;
}

Stillness::Stillness(const Map& map) : map_(map), is_lively_(map.sectors.size()) {
    if (std::ranges::any_of(map.lights, [](const PointLight& light) { return light.effect.has_value(); }))
        lamps_ = LightImages(map);
    for (std::size_t i = 0; i < map.sectors.size(); ++i) is_lively_[i] = is_lively(map, map.sectors[i]);
}

std::vector<Stillness::Moved> Stillness::moved_in(const Snapshot& snapshot) {
    std::vector<Moved> moved;
    for (const SectorId id : snapshot.changed) {
        const SectorSnapshot& sector = snapshot[id];
        moved.push_back({id, sector.floor_z, sector.ceiling_z, sector.light, sector.floor_picture});
    }
    return moved;
}

std::size_t Stillness::frame_of(ThingId thing, const Snapshot& snapshot) const {
    return frame_at(map_[map_[thing].sprite], snapshot.time_s);
}

bool Stillness::changes_by_itself(SectorId sector, const Snapshot& snapshot) const {
    const SectorSnapshot& now = snapshot[sector];
    return is_lively_[sector.index] || now.effect || now.bobbing ||
           std::ranges::any_of(snapshot.things.in(sector),
                               [&](const Presence& presence) { return is_lively(map_[presence.thing]); });
}

void Stillness::remember_changing(SectorId sector, const Snapshot& snapshot) {
    for (const LightImage& image : lamps_.in(sector))
        if (map_.lights[image.light].effect) lit_.push_back({image.light, lamp_color(map_, snapshot, image.light)});
    for (const Presence& presence : snapshot.things.in(sector)) {
        const SpriteId sprite = map_[presence.thing].sprite;
        if (sprite && map_[sprite].frames.size() > 1)
            shown_.push_back({presence.thing, frame_of(presence.thing, snapshot)});
    }
}

bool Stillness::is_as_lit_and_shown(const Snapshot& snapshot) const {
    return std::ranges::all_of(
               lit_, [&](const Lamp& lamp) { return lamp_color(map_, snapshot, lamp.light) == lamp.color; }) &&
           std::ranges::all_of(shown_,
                               [&](const ShownThing& shown) { return frame_of(shown.thing, snapshot) == shown.frame; });
}

void Stillness::drew(const View& view, const Snapshot& snapshot, const std::vector<SectorId>& seen) {
    forget();
    const auto changes = [&](SectorId sector) { return changes_by_itself(sector, snapshot); };
    if (seen.empty() || std::ranges::any_of(seen, changes)) return;
    view_ = view;
    moved_ = moved_in(snapshot);
    lit_.clear();
    shown_.clear();
    for (const SectorId sector : seen) remember_changing(sector, snapshot);
    taken_ = snapshot.taken;
    pressed_ = snapshot.pressed;
    way_back_ = snapshot.way_back;
}

bool Stillness::is_same(const View& view, const Snapshot& snapshot) const {
    return view_ && is_same_look(*view_, view) && taken_ == snapshot.taken && pressed_ == snapshot.pressed &&
           way_back_ == snapshot.way_back && moved_ == moved_in(snapshot) && is_as_lit_and_shown(snapshot);
}

}  // namespace enfilade
