// Sounds, and who makes them: names become ids.
#include <algorithm>
#include <string>
#include <vector>

#include "formats/text_parts.h"
#include "map/draft.h"

namespace enfilade {

namespace {

NameIndex sound_names(const MapFile& file) {
    std::vector<ScopedName> names;
    for (std::uint32_t i = 0; i < file.sounds.size(); ++i) names.push_back({0, file.sounds[i].name, i});
    return NameIndex(std::move(names));
}

class SoundPlacer {
public:
    explicit SoundPlacer(Draft& draft) : draft_(draft), map_(draft.map), names_(sound_names(draft.file)) {}

    void add_sounds() {
        for (const SoundRecord& record : draft_.file.sounds) {
            map_.sounds.push_back({record.name, record.file, record.volume, record.reach, record.loops});
            map_.farthest_sound_m = std::max(map_.farthest_sound_m, record.reach);
        }
        for (const auto& [first, again] : names_.duplicates())
            draft_.error(
                draft_.file.sounds[again], "name", "duplicate-sound",
                "expected a name no other sound has, found " + in_quotes(draft_.file.sounds[again].name) + " again");
    }

    void place_on_sectors() {
        for (std::size_t i = 0; i < map_.sectors.size(); ++i) {
            const SectorRecord& record = *draft_.sectors[i].record;
            Sector& sector = map_.sectors[i];
            sector.up_sound = found(record, "move_sound", record.move_sound);
            sector.down_sound =
                record.down_sound.empty() ? sector.up_sound : found(record, "down_sound", record.down_sound);
            sector.stop_sound = found(record, "stop_sound", record.stop_sound);
            place_on_triggers(sector.triggers, record.triggers, [&](Trigger& t) { t.on_sector = SectorId(i); });
        }
    }

    void place_on_walls() {
        for (std::size_t i = 0; i < map_.walls.size(); ++i)
            place_on_triggers(map_.walls[i].triggers, draft_.walls[i].record->triggers,
                              [&](Trigger& t) { t.on_wall = WallId(i); });
    }

    void place_on_panels() {
        for (std::size_t i = 0; i < map_.panels.size(); ++i)
            place_on_triggers(map_.panels[i].triggers, draft_.record_of(PanelId(i)).triggers,
                              [&](Trigger& t) { t.on_panel = PanelId(i); });
    }

    void place_on_things() {
        for (std::size_t i = 0; i < map_.things.size(); ++i) {
            const ThingRecord& record = *draft_.things[i];
            Thing& thing = map_.things[i];
            thing.sound = found(record, "sound", record.sound);
            if (thing.sound) map_.sounding_things.push_back(ThingId(i));
            place_on_triggers(thing.triggers, record.triggers, [&](Trigger& t) { t.on_thing = ThingId(i); });
        }
        std::stable_sort(map_.sounding_things.begin(), map_.sounding_things.end(),
                         [&](ThingId a, ThingId b) { return map_[a].sector < map_[b].sector; });
    }

private:
    /// The sound that the record's key names; none where it names none.
    template <class Record>
    SoundId found(const Record& record, std::string_view key, const std::string& name) {
        if (name.empty()) return {};
        const auto number = names_.find(0, name);
        if (number) return SoundId(*number);
        const bool has_nameless = std::ranges::any_of(draft_.file.sounds, &std::string::empty, &SoundRecord::name);
        if (has_nameless) return {};  // it may be meant for one whose name the reader could not make out
        draft_.error(record, key, "unknown-sound",
                     "expected the name of a sound, found " + in_quotes(name) + names_.suggestion(0, name));
        return {};
    }

    template <class PutOn>
    void place_on_triggers(TriggerRange range, const std::vector<TriggerRecord>& records, PutOn put_on) {
        for (std::uint32_t i = 0; i < range.count; ++i) {
            Trigger& trigger = map_.triggers[range.first + i];
            trigger.sound = found(records[i], "sound", records[i].sound);
            if (trigger.sound) put_on(trigger);
            if (trigger.action == TriggerAction::sound && records[i].sound.empty() && records[i].places.is_sound())
                draft_.error(records[i].place, "needs-sound", "expected 'sound', which says what is heard; found none");
        }
    }

    Draft& draft_;
    Map& map_;
    NameIndex names_;
};

}  // namespace

void place_sounds(Draft& draft) {
    SoundPlacer placer(draft);
    placer.add_sounds();
    placer.place_on_sectors();
    placer.place_on_walls();
    placer.place_on_panels();
    placer.place_on_things();
}

// Suns: from angles to directions, and which sector each shines on.

namespace {

Sun sun_from(const SunRecord& record) {
    const Vec2 climb = direction(Angle::from_degrees(record.elevation_degrees));  // along the ground, and up
    return {direction(Angle::from_degrees(record.yaw_degrees)) * climb.x, climb.y, record.color, record.brightness};
}

NameIndex sun_names(const Draft& draft) {
    std::vector<ScopedName> names;
    for (std::uint32_t i = 0; i < draft.file.suns.size(); ++i)
        if (!draft.file.suns[i].name.empty()) names.push_back({0, draft.file.suns[i].name, i});
    return NameIndex(std::move(names));
}

void check_names(Draft& draft, const NameIndex& names) {
    for (const auto& [first, again] : names.duplicates())
        draft.error(draft.file.suns[again], "name", "duplicate-sun",
                    "expected a name no other sun has, found " + in_quotes(draft.file.suns[again].name) + " again");
}

}  // namespace

void place_suns(Draft& draft) {
    const NameIndex names = sun_names(draft);
    check_names(draft, names);
    for (const SunRecord& record : draft.file.suns) draft.map.suns.push_back(sun_from(record));
    for (std::size_t i = 0; i < draft.map.sectors.size(); ++i) {
        const SectorRecord& record = *draft.sectors[i].record;
        if (record.sun.empty()) continue;
        if (const auto found = names.find(0, record.sun)) {
            draft.map.sectors[i].sun = SunId(*found);
            continue;
        }
        const std::string alike = names.suggestion(0, record.sun);
        draft.error(record, "sun", "unknown-sun",
                    "expected the name of a sun, found " + in_quotes(record.sun) +
                        (alike.empty() ? "; add [[suns]] with that name" : alike));
    }
}

}  // namespace enfilade
