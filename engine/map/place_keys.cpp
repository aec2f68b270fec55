// Keys: which ones triggers ask for, and which things give them.
#include <algorithm>
#include <string>
#include <utility>

#include "formats/text_parts.h"
#include "map/draft.h"
#include "map/things.h"

namespace enfilade {
namespace {

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
        for (std::uint32_t key = 0; key < map_.keys.size(); ++key)
            if (std::ranges::find(map_.things, key, &Thing::gives_key) == map_.things.end())
                draft_.warning(places_[key], "no-such-key",
                               "this trigger asks for the key " + quoted(map_.keys[key]) +
                                   ", but no thing gives it; give a thing gives_key = " + quoted(map_.keys[key]));
    }

private:
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
                         quoted(name) + "; let doors share keys");
    }

    Draft& draft_;
    Map& map_;
    std::vector<TextPlace> places_;  ///< where each of Map::keys is named first
    bool has_too_many_ = false;
};

}  // namespace

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
