// Whether a map that was read from bytes holds together: what a built one does by itself.
#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "map/load.h"
#include "map/map_fields.h"
#include "math/vec.h"

namespace enfilade {
namespace {

/// Looks at a value and everything in it. Ids may be none, unless must() is asked too.
class Consistency {
public:
    Consistency(const Map& map, std::size_t pictures) : map_(map), pictures_(pictures) {}

    template <class T>
    bool holds(const T& value) const {
        if constexpr (std::is_floating_point_v<T>)
            return !std::isnan(value);
        else if constexpr (kIsId<T>)
            return value.is_none() || value.index < count_of(value);
        else if constexpr (Scalar<T>)
            return true;
        else
            return parts_hold(value) && own_rules_hold(value);
    }
    bool holds(const std::string&) const { return true; }
    template <class T>
    bool holds(const std::vector<T>& list) const {
        const std::size_t parts = list.size() / kPart + 1;
        std::vector<char> are_sound(parts);
        parallel_for(parts, parts > 1 ? hardware_threads() : 1, [&](std::size_t part, std::size_t) {
            const auto some = std::span(list).subspan(part * kPart, std::min(kPart, list.size() - part * kPart));
            are_sound[part] = std::ranges::all_of(some, [&](const T& item) { return holds(item); });
        });
        return std::ranges::all_of(are_sound, [](char is_sound) { return is_sound != 0; });
    }
    template <class T, std::size_t count>
    bool holds(const std::array<T, count>& list) const {
        return std::ranges::all_of(list, [&](const T& item) { return holds(item); });
    }
    template <class T>
    bool holds(const std::optional<T>& value) const {
        return !value || holds(*value);
    }
    template <class T>
    bool holds(const Boxed<T>& value) const {
        return !value || holds(*value);
    }

private:
    /// Values that one thread looks at at once.
    static constexpr std::size_t kPart = std::size_t{1} << 16;

    template <class T>
    bool parts_hold(const T& value) const {
        return fields(value, [&](const auto&... part) { return (holds(part) && ...); });
    }

    std::size_t count_of(SectorId) const { return map_.sectors.size(); }
    std::size_t count_of(WallId) const { return map_.walls.size(); }
    std::size_t count_of(SurfaceId) const { return map_.surfaces.size(); }
    std::size_t count_of(TextureId) const { return pictures_; }
    std::size_t count_of(ThingId) const { return map_.things.size(); }
    std::size_t count_of(SpriteId) const { return map_.sprites.size(); }
    std::size_t count_of(PanelId) const { return map_.panels.size(); }
    std::size_t count_of(SoundId) const { return map_.sounds.size(); }
    std::size_t count_of(SunId) const { return map_.suns.size(); }
    std::size_t count_of(TriggerId) const { return map_.triggers.size(); }

    /// What is not told by the kinds of its fields.
    template <class T>
    bool own_rules_hold(const T&) const {
        return true;
    }
    bool own_rules_hold(const TriggerRange& range) const { return are_in(map_.triggers, range.first, range.count); }
    bool own_rules_hold(const TargetRange& range) const { return are_in(map_.targets, range.first, range.count); }
    bool own_rules_hold(const Flat& flat) const { return are_in(map_.flat_layers, flat.first_layer, flat.layer_count); }

    bool own_rules_hold(const Wall& wall) const {
        const bool leads = wall.kind == WallKind::portal || wall.kind == WallKind::way_back;
        if (leads && (wall.behind.is_none() || wall.exit.is_none() || map_[wall.exit].sector != wall.behind))
            return false;
        if (wall.link == Wall::kNoLink && wall.kind == WallKind::mirror) return false;
        if (wall.link != Wall::kNoLink && wall.link >= map_.links.size()) return false;
        return is_on_grid(wall.a) && wall.a != wall.b;
    }
    bool own_rules_hold(const Panel& panel) const {
        return panel.sector && is_on_grid(panel.a) && is_on_grid(panel.b) && panel.a != panel.b;
    }
    bool own_rules_hold(const Sector& sector) const {
        return sector.leader && sector.next_of_group &&
               are_in(map_.solid_things, sector.first_solid, sector.solid_count) &&
               are_in(map_.panels, sector.first_panel, sector.panel_count) &&
               are_in(map_.touchables, sector.first_touchable, sector.touchable_count);
    }
    bool own_rules_hold(const Trigger& trigger) const {
        return trigger.key == Trigger::kNoKey || trigger.key < map_.keys.size();
    }
    bool own_rules_hold(const Thing& thing) const {
        return thing.sector && is_in_world(thing.position) && thing.radius >= 0 && thing.radius <= kWorldLimit &&
               (thing.gives_key == Trigger::kNoKey || thing.gives_key < map_.keys.size());
    }
    bool own_rules_hold(const PointLight& light) const { return light.sector && is_in_world(light.position); }
    bool own_rules_hold(const PlayerStart& player) const { return player.sector && is_in_world(player.position); }
    bool own_rules_hold(const Sprite& sprite) const { return !sprite.frames.empty(); }
    bool own_rules_hold(const Animation& animation) const { return !animation.frames.empty() && animation.seconds > 0; }
    bool own_rules_hold(const PictureChanges& changes) const {
        const auto is_known = [&](std::uint32_t number) {
            return number == PictureChanges::kNone || number < changes.animations.size();
        };
        return is_for_all_or_none(changes.animation_of) && is_for_all_or_none(changes.other_face) &&
               std::ranges::all_of(changes.animation_of, is_known);
    }
    bool own_rules_hold(const Map& map) const {
        return map.grid_links.size() == map.links.size() && map.keys.size() <= kMostKeys && are_groups_rings() &&
               lead_somewhere(map.solid_things) && lead_somewhere(map.touchables) && lead_somewhere(map.targets) &&
               lead_somewhere(map.at_start) && lead_somewhere(map.sounding_things);
    }

    static bool are_in(const auto& list, std::uint32_t first, std::uint32_t count) {
        return count == 0 || (first <= list.size() && count <= list.size() - first);
    }
    static bool lead_somewhere(const auto& ids) {
        return std::ranges::none_of(ids, [](const auto id) { return id.is_none(); });
    }
    bool is_for_all_or_none(const auto& list) const { return list.empty() || list.size() == pictures_; }

    static bool is_in_world(Vec2 p) { return std::fabs(p.x) <= kWorldLimit && std::fabs(p.y) <= kWorldLimit; }
    static bool is_on_grid(Vec2 vertex) { return is_in_world(vertex) && snap_to_vertex_grid(vertex) == vertex; }

    /// Each sector is the next one of exactly one: who goes round comes back.
    bool are_groups_rings() const {
        std::vector<bool> is_next(map_.sectors.size());
        for (const Sector& sector : map_.sectors) {
            if (sector.next_of_group.is_none() || is_next[sector.next_of_group.index]) return false;
            is_next[sector.next_of_group.index] = true;
        }
        return true;
    }

    const Map& map_;
    std::size_t pictures_;
};

}  // namespace

bool is_consistent(const Map& map, std::size_t pictures) { return Consistency(map, pictures).holds(map); }

}  // namespace enfilade
