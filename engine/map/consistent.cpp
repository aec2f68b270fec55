// Whether a map that was read from bytes holds together: what a built one does by itself.
#include <algorithm>
#include <cmath>
#include <span>

#include "base/parallel.h"
#include "map/draft.h"
#include "map/load.h"
#include "map/map_limits.h"
#include "map/sector_finder.h"
#include "math/vec.h"

namespace enfilade {
namespace {

// Numbers within their limits; what is no number (NaN) is within none.

bool is_within(double number, const Limit& limit) {
    const bool is_in_range = number >= limit.range.low && number <= limit.range.high;
    return is_in_range && (limit.grid == 0 || detail::snap(number, limit.grid) == number);
}
bool is_within(Vec2 numbers, const Limit& limit) { return is_within(numbers.x, limit) && is_within(numbers.y, limit); }
template <class T>
bool is_within(const std::optional<T>& number, const Limit& limit) {
    return !number || is_within(*number, limit);
}
template <class T, std::size_t count>
bool is_within(const std::array<T, count>& numbers, const Limit& limit) {
    return std::ranges::all_of(numbers, [&](const T& number) { return is_within(number, limit); });
}

/// Ends of linked walls meet that well, whose lengths differ by a step of the grid at most [m].
constexpr double kMeeting = kVertexGrid;

bool is_near(Vec2 a, Vec2 b) { return std::fabs(a.x - b.x) <= kMeeting && std::fabs(a.y - b.y) <= kMeeting; }

/// Lays a wall a -> b over another, seen from its other side.
bool leads_onto(const Rigid& passage, const Wall& wall, Vec2 a, Vec2 b) {
    return is_near(passage.apply(wall.a), a) && is_near(passage.apply(wall.b), b);
}

bool is_in_one_tile(Vec2 offset) { return offset.x >= 0 && offset.x < 1 && offset.y >= 0 && offset.y < 1; }

/// Ranges that share out a list, one behind the other: so that looking at all of them takes no longer than the list.
class SharedOut {
public:
    /// The next range. An empty one may begin anywhere.
    bool takes(std::uint32_t first, std::uint32_t count) {
        if (count > 0 && first != taken_) return false;
        taken_ += count;
        return true;
    }
    bool is_all_of(const auto& list) const { return taken_ == list.size(); }

private:
    std::uint64_t taken_ = 0;
};

/// Looks at a value and everything in it. Ids may be none where no rule says more.
class Consistency {
public:
    Consistency(const Map& map, std::size_t pictures) : map_(map), pictures_(pictures) {}

    template <class T>
    bool holds(const T& value) const {
        if constexpr (kIsId<T>)
            return value.is_none() || value.index < count_of(value);
        else if constexpr (Scalar<T>)
            return true;  // a word or a flag, as which it was read
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
        static_assert(kLimits<T>.size() == count_of_numbers<T>(), "each number needs a limit (map/map_limits.h)");
        std::size_t number = 0;
        return fields(value, [&](const auto&... part) { return (part_holds<T>(part, number) && ...); });
    }
    template <class Whole, class T>
    bool part_holds(const T& part, std::size_t& number) const {
        if constexpr (kIsNumber<T>)
            return is_within(part, kLimits<Whole>[number++]);
        else
            return holds(part);
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
    bool own_rules_hold(const Rigid& link) const {
        constexpr double kRounding = 0x1p-40;
        return std::fabs(link.flip) == 1 && std::fabs(link.c * link.c + link.s * link.s - 1) <= kRounding;
    }
    bool own_rules_hold(const Surface& surface) const {
        return std::min(std::fabs(surface.tile_m.x), std::fabs(surface.tile_m.y)) >= kMinTile;
    }
    bool own_rules_hold(const Wall& wall) const {
        if (wall.a == wall.b || (wall.link != Wall::kNoLink && wall.link >= map_.links.size())) return false;
        if (wall.is_screen() && !map_[wall.sector].has_screens) return false;
        return leads_where_its_kind_does(wall) && repeats(wall.texture) && repeats(wall.upper) && repeats(wall.lower);
    }
    bool leads_where_its_kind_does(const Wall& wall) const {
        const bool is_linked = wall.link != Wall::kNoLink;
        switch (wall.kind) {
            case WallKind::solid: return !is_linked;
            case WallKind::mirror:
                return is_linked && map_.links[wall.link].flip < 0 &&
                       leads_onto(map_.links[wall.link], wall, wall.a, wall.b);
            case WallKind::way_back: return map_.has_ways_back && leads_out(wall);
            case WallKind::portal: return leads_out(wall);
        }
        return false;
    }
    bool leads_out(const Wall& wall) const {
        if (wall.behind.is_none() || wall.exit.is_none()) return false;
        const Wall& exit = map_[wall.exit];
        if (exit.sector != wall.behind) return false;
        if (wall.link == Wall::kNoLink) return exit.a == wall.b && exit.b == wall.a;
        const Rigid& link = map_.links[wall.link];
        return link.flip > 0 && leads_onto(link, wall, exit.b, exit.a);
    }
    bool repeats(SurfaceId surface) const { return is_in_one_tile(map_[surface].offset_tiles); }

    bool own_rules_hold(const Panel& panel) const {
        return panel.sector && panel.a != panel.b && panel.bottom <= panel.top &&
               is_in_one_tile(panel.surface.offset_tiles);
    }
    bool own_rules_hold(const Flat& flat) const {
        return are_in(map_.flat_layers, flat.first_layer, flat.layer_count) && repeats(flat.surface);
    }
    bool own_rules_hold(const Sector& sector) const {
        const bool bobs = sector.floor_bob || sector.ceiling_bob;
        return sector.leader && sector.next_of_group && (map_.has_bobs || !bobs);
    }
    bool own_rules_hold(const Trigger& trigger) const {
        const bool has_key = trigger.key == Trigger::kNoKey || trigger.key < map_.keys.size();
        return has_key && (trigger.action != TriggerAction::teleport || trigger.destination);
    }
    bool own_rules_hold(const Thing& thing) const {
        return thing.sector && (thing.gives_key == Trigger::kNoKey || thing.gives_key < map_.keys.size());
    }
    bool own_rules_hold(const PointLight& light) const { return bool(light.sector); }
    bool own_rules_hold(const PlayerStart& player) const {
        return player.sector && is_inside(map_, player.sector, player.position);
    }
    bool own_rules_hold(const Sound& sound) const { return sound.reach_m <= map_.farthest_sound_m; }
    /// Frames follow one another, each for its time; only the last one may stay for ever.
    bool own_rules_hold(const Sprite& sprite) const {
        double before_s = 0;
        for (const SpriteFrame& frame : sprite.frames) {
            const bool stays = &frame == &sprite.frames.back() && std::isinf(frame.until_s);
            if (!stays && !(frame.until_s >= before_s && frame.until_s <= before_s + kSeconds.high)) return false;
            before_s = frame.until_s;
        }
        return before_s > 0;
    }
    bool own_rules_hold(const Animation& animation) const { return !animation.frames.empty(); }
    bool own_rules_hold(const PictureChanges& changes) const {
        const auto is_known = [&](std::uint32_t number) {
            return number == PictureChanges::kNone || number < changes.animations.size();
        };
        return is_for_all_or_none(changes.animation_of) && is_for_all_or_none(changes.other_face) &&
               std::ranges::all_of(changes.animation_of, is_known);
    }
    bool own_rules_hold(const Map& map) const {
        return map.keys.size() <= kMostKeys && are_groups_rings() && are_links_of_one_wall_each() &&
               are_shared_out(map.panels, &Sector::first_panel, &Sector::panel_count) &&
               are_shared_out(map.solid_things, &Sector::first_solid, &Sector::solid_count) &&
               are_shared_out(map.touchables, &Sector::first_touchable, &Sector::touchable_count) &&
               are_triggers_shared_out() && is_lit_area_small() && lead_somewhere(map.targets) &&
               lead_somewhere(map.at_start) && sets_off_few(map.at_start) && lead_somewhere(map.sounding_things);
    }

    static bool are_in(const auto& list, std::uint32_t first, std::uint32_t count) {
        return count == 0 || (first <= list.size() && count <= list.size() - first);
    }
    static bool lead_somewhere(const auto& ids) {
        return std::ranges::none_of(ids, [](const auto id) { return id.is_none(); });
    }
    bool is_for_all_or_none(const auto& list) const { return list.empty() || list.size() == pictures_; }

    /// Each sector is the next one of exactly one: who goes round comes back.
    bool are_groups_rings() const {
        std::vector<bool> is_next(map_.sectors.size());
        for (const Sector& sector : map_.sectors) {
            if (sector.next_of_group.is_none() || is_next[sector.next_of_group.index]) return false;
            is_next[sector.next_of_group.index] = true;
        }
        return true;
    }

    bool are_links_of_one_wall_each() const {
        std::vector<bool> is_taken(map_.links.size());
        for (const Wall& wall : map_.walls) {
            if (wall.link == Wall::kNoLink) continue;
            if (is_taken[wall.link]) return false;
            is_taken[wall.link] = true;
        }
        return true;
    }

    // Lists by sector, each sector's in one piece.

    SectorId sector_of(const Panel& panel) const { return panel.sector; }
    SectorId sector_of(ThingId thing) const { return map_[thing].sector; }

    template <class T>
    bool are_shared_out(const std::vector<T>& list, std::uint32_t Sector::* first,
                        std::uint32_t Sector::* count) const {
        SharedOut shared;
        for (std::size_t i = 0; i < map_.sectors.size(); ++i) {
            const Sector& sector = map_.sectors[i];
            if (!shared.takes(sector.*first, sector.*count) || !are_in(list, sector.*first, sector.*count))
                return false;
            for (std::uint32_t k = sector.*first; k < sector.*first + sector.*count; ++k)
                if (is_none(list[k]) || sector_of(list[k]) != SectorId(i)) return false;
        }
        return shared.is_all_of(list);
    }
    static bool is_none(const Panel&) { return false; }
    static bool is_none(ThingId thing) { return thing.is_none(); }

    bool are_triggers_shared_out() const {
        SharedOut shared;
        const auto takes = [&](const auto& bearer) {
            const auto [first, count] = bearer.triggers;
            return shared.takes(first, count) && are_in(map_.triggers, first, count) &&
                   sets_off_few(std::span(map_.triggers).subspan(count > 0 ? first : 0, count));
        };
        return std::ranges::all_of(map_.sectors, takes) && std::ranges::all_of(map_.walls, takes) &&
               std::ranges::all_of(map_.panels, takes) && std::ranges::all_of(map_.things, takes) &&
               shared.is_all_of(map_.triggers);
    }
    bool sets_off_few(std::span<const Trigger> triggers) const {
        std::uint64_t set_off = 0;
        for (const Trigger& trigger : triggers) set_off += trigger.targets.count;
        return set_off <= kMostSetOff;
    }
    bool sets_off_few(std::span<const TriggerId> triggers) const {
        std::uint64_t set_off = 0;
        for (const TriggerId trigger : triggers) set_off += map_[trigger].targets.count;
        return set_off <= kMostSetOff;
    }

    bool is_lit_area_small() const {
        double area = 0;
        for (const PointLight& light : map_.lights) area += lit_area(light.reach);
        return area <= kMostLitArea;
    }

    const Map& map_;
    std::size_t pictures_;
};

}  // namespace

bool is_consistent(const Map& map, std::size_t pictures) { return Consistency(map, pictures).holds(map); }

}  // namespace enfilade
