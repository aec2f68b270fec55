#include "map/draft.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "formats/text_parts.h"
#include "math/vec.h"

namespace enfilade {
namespace {

/// How far a frame's pictures reach to either side of the thing [m].
double reach_of(const SpriteFrame& frame, const TextureSet& textures, double texels_per_m) {
    double reach = 0;
    for (std::size_t view = 0; view < frame.views.size(); ++view) {
        const TextureId picture = frame.views[view];
        const double left = frame.origins_m[view].x;
        if (picture) reach = std::max({reach, left, textures[picture].width / texels_per_m - left});
    }
    return reach;
}

/// Who gives no origin lets the picture stand.
Vec2 origin_of(const SpriteFrameRecord& record, const Texture& picture) {
    return record.origin_tx.value_or(Vec2{picture.width * 0.5, double(picture.height)});
}

Sprite sprite_from(const ThingRecord& thing, const TextureSet& textures) {
    Sprite sprite;
    sprite.texels_per_m = thing.size;
    double time_s = 0;
    for (const SpriteFrameRecord& record : thing.frames) {
        SpriteFrame frame;
        for (int view = 0; view < 8; ++view) {
            if (record.texture != "-") frame.views[view] = textures.find(sprite_picture_name(thing, record, view));
            frame.origins_m[view] = origin_of(record, textures[frame.views[view]]) * (1 / thing.size);
        }
        time_s = record.seconds > 0 ? time_s + record.seconds : std::numeric_limits<double>::infinity();
        frame.until_s = time_s;
        sprite.reach_m = std::max(sprite.reach_m, reach_of(frame, textures, thing.size));
        sprite.frames.push_back(frame);
        if (record.seconds == 0) break;  // it stays
    }
    return sprite;
}

void check_frames(Draft& draft, const ThingRecord& thing) {
    const auto stays = [](const SpriteFrameRecord& frame) { return frame.seconds == 0; };
    const auto last = std::find_if(thing.frames.begin(), thing.frames.end(), stays);
    if (last == thing.frames.end() || last + 1 == thing.frames.end()) return;
    draft.warning(*(last + 1), "texture", "unseen-frame",
                  "the frame " + in_quotes(last->texture) + " of this thing is shown for ever, so " +
                      in_quotes((last + 1)->texture) + " after it never is; give it seconds");
}

void check_height(Draft& draft, const Thing& thing, const ThingRecord& record) {
    const Sector& sector = draft.map[thing.sector];
    const bool is_open = sector.floor.z < sector.ceiling.z;
    if (!is_open || (thing.z < sector.ceiling.z && thing.z + thing.height > sector.floor.z)) return;
    draft.warning(record, "z", "thing-hidden",
                  "expected the thing between the floor at " + number_text(sector.floor.z) + " m and the ceiling at " +
                      number_text(sector.ceiling.z) + " m of sector " + in_quotes(sector.name) + ", found it from " +
                      number_text(thing.z) + " m to " + number_text(thing.z + thing.height) + " m; nobody will see it");
}

/// How far the lowest edge of a frame's pictures lies below the thing's foot [m], and whether that is more than a
/// quarter of the picture.
std::optional<double> sunk_depth(const SpriteFrame& frame, const TextureSet& textures, double texels_per_m) {
    constexpr double kMostSunkPart = 0.25;
    std::optional<double> deepest;
    for (std::size_t view = 0; view < frame.views.size(); ++view) {
        const double height = textures[frame.views[view]].height / texels_per_m;
        const double depth = height - frame.origins_m[view].y;
        if (frame.views[view] && depth > height * kMostSunkPart) deepest = std::max(depth, deepest.value_or(depth));
    }
    return deepest;
}

/// A picture that hangs into the floor, because its origin is not at its foot. Doom's corpses and pools lie a few
/// texels deep: up to 0.25 m, and then less than a quarter of them.
void check_footing(Draft& draft, const Thing& thing, const ThingRecord& record) {
    constexpr double kMostSunk = 0.25;  // [m]
    const Sector& sector = draft.map[thing.sector];
    if (!thing.sprite || thing.footing == Footing::ceiling || sector.floor.z >= sector.ceiling.z) return;
    const Sprite& sprite = draft.map[thing.sprite];
    for (std::size_t i = 0; i < sprite.frames.size(); ++i) {
        const auto depth = sunk_depth(sprite.frames[i], draft.textures, sprite.texels_per_m);
        const double below = depth.value_or(0) - (thing.z - sector.floor.z);
        if (depth && below > kMostSunk)
            return draft.warning(record.frames[i], "origin", "thing-sunk",
                                 "expected an origin at the foot of the picture " +
                                     in_quotes(record.frames[i].texture) + ", found one that lets it hang " +
                                     number_text(below) +
                                     " m into the floor; leave origin out, and the picture stands on its bottom");
    }
}

// Keys: which ones triggers ask for, and which things give them.

class KeyPlacer {
public:
    explicit KeyPlacer(Draft& draft) : draft_(draft), map_(draft.map) {}

    void place_on(TriggerRange range, const std::vector<TriggerRecord>& records) {
        for (std::uint32_t i = 0; i < range.count; ++i)
            map_.triggers[range.first + i].key = key_of(records[i].key, key_place(records[i], "key"));
    }

    void place_on(Thing& thing, const ThingRecord& record) {
        place_on(thing.triggers, record.triggers);
        thing.gives_key = key_of(record.gives_key, key_place(record, "gives_key"));
    }

    /// A key that triggers ask for and no thing gives opens nothing.
    void check() {
        std::vector<std::string_view> given;
        for (std::uint32_t key = 0; key < map_.keys.size(); ++key)
            if (is_given(key)) given.push_back(map_.keys[key]);
        for (std::uint32_t key = 0; key < map_.keys.size(); ++key)
            if (!is_given(key))
                draft_.warning(places_[key], "no-such-key",
                               "this trigger asks for the key " + in_quotes(map_.keys[key]) +
                                   ", but no thing gives it; give a thing gives_key = " + in_quotes(map_.keys[key]) +
                                   nearest_suggestion(map_.keys[key], given));
    }

private:
    bool is_given(std::uint32_t key) const {
        return std::ranges::find(map_.things, key, &Thing::gives_key) != map_.things.end();
    }

    /// `place`: of who names it.
    std::uint32_t key_of(const std::string& name, TextPlace place) {
        if (name.empty()) return Trigger::kNoKey;
        std::vector<std::string>& keys = map_.keys;
        const auto found = std::ranges::find(keys, name);
        const auto index = static_cast<std::uint32_t>(found - keys.begin());
        if (found != keys.end()) return index;
        if (index == kMostKeys) {
            refuse(name, place);
            return Trigger::kNoKey;
        }
        keys.push_back(name);
        places_.push_back(place);
        return index;
    }

    void refuse(const std::string& name, TextPlace place) {
        if (std::exchange(has_too_many_, true)) return;
        draft_.error(place, "too-many-keys",
                     "expected at most " + std::to_string(kMostKeys) + " keys in a map, found one more, " +
                         in_quotes(name) + "; let doors share keys");
    }

    Draft& draft_;
    Map& map_;
    std::vector<TextPlace> places_;  ///< where each of Map::keys is named first
    bool has_too_many_ = false;
};

}  // namespace

SpriteId SpriteShelf::sprite_of(const ThingRecord& thing) {
    if (thing.frames.empty()) return {};
    std::vector<FrameKey> frames;
    for (const SpriteFrameRecord& frame : thing.frames)
        frames.emplace_back(frame.texture, frame.seconds,
                            frame.origin_tx ? OriginKey({frame.origin_tx->x, frame.origin_tx->y}) : OriginKey());
    std::vector<Sprite>& sprites = draft_.map.sprites;
    const auto [it, is_new] = known_.try_emplace({thing.rotations, thing.size, std::move(frames)}, sprites.size());
    if (is_new) sprites.push_back(sprite_from(thing, draft_.textures));
    return it->second;
}

void add_thing(Draft& draft, const ThingRecord& record, SectorId sector, SpriteShelf& sprites) {
    Thing thing;
    thing.name = record.name;
    thing.kind = record.kind;
    thing.sector = sector;
    thing.position = snap_to_point_grid(record.position);
    thing.yaw = Angle::from_degrees(record.yaw_degrees);
    thing.turn = record.turn;
    if (record.bob) thing.bob = *record.bob;
    thing.radius = snap_to_point_grid(record.radius);
    thing.height = record.height;
    thing.solid = record.solid;
    thing.holds_up = record.holds_up;
    thing.light = record.light;
    thing.footing = record.z ? Footing::fixed : record.hanging ? Footing::ceiling : Footing::floor;
    const Sector& home = draft.map[sector];
    thing.z = record.z ? *record.z : record.hanging ? home.ceiling.z - record.height : home.floor.z;
    thing.sprite = sprites.sprite_of(record);
    thing.gives_health = record.gives_health;
    check_frames(draft, record);
    if (thing.footing == Footing::fixed) check_height(draft, thing, record);
    check_footing(draft, thing, record);
    draft.map.things.push_back(std::move(thing));
    draft.things.push_back(&record);
}

void list_solid_things(Map& map) {
    for (std::size_t i = 0; i < map.things.size(); ++i) {
        const Thing& thing = map.things[i];
        if (!thing.solid || thing.radius <= 0 || thing.height <= 0) continue;
        map.solid_things.push_back(ThingId(i));
        ++map.sectors[thing.sector.index].solid_count;
    }
    std::stable_sort(map.solid_things.begin(), map.solid_things.end(),
                     [&](ThingId a, ThingId b) { return map[a].sector < map[b].sector; });
    std::uint32_t first = 0;
    for (Sector& sector : map.sectors) {
        sector.first_solid = first;
        first += sector.solid_count;
    }
}

void list_touchables(Map& map) {
    for (std::size_t i = 0; i < map.things.size(); ++i)
        if (map.things[i].is_pickup() || map.things[i].triggers.count > 0) map.touchables.emplace_back(i);
    std::stable_sort(map.touchables.begin(), map.touchables.end(),
                     [&](ThingId a, ThingId b) { return map[a].sector < map[b].sector; });
    for (const ThingId thing : map.touchables) ++map.sectors[map[thing].sector.index].touchable_count;
    std::uint32_t first = 0;
    for (Sector& sector : map.sectors) {
        sector.first_touchable = first;
        first += sector.touchable_count;
    }
}

void place_keys(Draft& draft) {
    KeyPlacer placer(draft);
    Map& map = draft.map;
    for (std::size_t i = 0; i < map.sectors.size(); ++i)
        placer.place_on(map.sectors[i].triggers, draft.sectors[i].record->triggers);
    for (std::size_t i = 0; i < map.walls.size(); ++i)
        placer.place_on(map.walls[i].triggers, draft.walls[i].record->triggers);
    for (std::size_t i = 0; i < map.panels.size(); ++i)
        placer.place_on(map.panels[i].triggers, draft.record_of(PanelId(i)).triggers);
    for (std::size_t i = 0; i < map.things.size(); ++i) placer.place_on(map.things[i], *draft.things[i]);
    placer.check();
    list_touchables(map);
}

}  // namespace enfilade
