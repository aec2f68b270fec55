// Prefabs: map files that are put into another one, moved, raised, turned, and each room called after the place.
#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "formats/expand.h"
#include "formats/map_keys.h"
#include "formats/text_parts.h"
#include "math/angle.h"

namespace enfilade {
namespace {

/// How deep prefabs may stand in one another.
constexpr std::size_t kMostNested = 8;

/// All prefab files of a map together [bytes]: each is read whole before the next is looked for.
constexpr std::size_t kMostPrefabBytes = std::size_t{16} << 20;

/// Angles and speeds beyond which turning would lead out of their ranges (formats/map_keys.h).
double within(double number, Range range) { return std::clamp(number, range.low, range.high); }

/// Where a prefab comes to lie.
class Placing {
public:
    explicit Placing(const PrefabRecord& prefab)
        : at_(snap_to_vertex_grid(prefab.at)),
          forward_(direction(Angle::from_degrees(prefab.turn))),
          z_(prefab.z),
          turn_(prefab.turn) {}

    /// False where something would lie out of the world.
    bool put(SectorRecord& sector) {
        put(sector.floor);
        put(sector.ceiling);
        put(sector.triggers);
        for (LoopRecord& loop : sector.loops) {
            for (Vec2& vertex : loop.vertices) vertex = corner(vertex);
            for (WallRecord& wall : loop.walls) put(wall.triggers);
        }
        for (PanelRecord& panel : sector.panels) {
            panel.a = corner(panel.a);
            panel.b = corner(panel.b);
            panel.bottom = height(panel.bottom);
            panel.top = height(panel.top);
            put(panel.triggers);
        }
        return is_in_world_;
    }

    bool put(ThingRecord& thing) {
        thing.position = point(thing.position);
        if (thing.z) thing.z = height(*thing.z);
        thing.yaw_degrees = within(thing.yaw_degrees + turn_, kAngles);
        put(thing.triggers);
        return is_in_world_;
    }

    bool put(PointLightRecord& light) {
        light.position = point(light.position);
        light.z = height(light.z);
        return is_in_world_;
    }

private:
    Vec2 turned(Vec2 v) const { return {forward_.x * v.x - forward_.y * v.y, forward_.y * v.x + forward_.x * v.y}; }

    Vec2 point(Vec2 v) {
        const Vec2 placed = turned(v) + at_;
        is_in_world_ = is_in_world_ && std::max({placed.x, -placed.x, placed.y, -placed.y}) <= kWorldLimit;
        return placed;
    }
    Vec2 corner(Vec2 v) { return snap_to_vertex_grid(point(snap_to_vertex_grid(v))); }

    double height(double z) {
        is_in_world_ = is_in_world_ && std::max(z + z_, -z - z_) <= kHeights.high;
        return z + z_;
    }

    void put(FlatRecord& flat) {
        flat.z = height(flat.z);
        const auto turn_speed = [&](Vec2& speed) {
            const Vec2 after = turned(speed);
            speed = {within(after.x, kScrollSpeeds), within(after.y, kScrollSpeeds)};
        };
        if (flat.parallax) return;  // a sky turns by itself
        turn_speed(flat.scroll);
        for (FlatLayerRecord& layer : flat.layers) turn_speed(layer.scroll);
    }

    void put(std::vector<TriggerRecord>& triggers) {
        for (TriggerRecord& trigger : triggers)
            if (trigger.z) trigger.z = height(*trigger.z);
    }

    Vec2 at_, forward_;
    double z_, turn_;
    bool is_in_world_ = true;
};

/// Names that are given in a prefab, and are called after its place where it is put.
class Renaming {
public:
    Renaming(const MapFile& prefab, const std::string& place) : place_(place) {
        for (const SectorRecord& sector : prefab.sectors) {
            own_.insert(sector.name);
            own_.insert(sector.group);
            own_.insert(sector.tags.begin(), sector.tags.end());
        }
        for (const ThingRecord& thing : prefab.things) own_.insert(thing.name);
        own_.erase("");
    }

    void in(SectorRecord& sector) const {
        rename(sector.name);
        rename(sector.group);
        for (std::string& tag : sector.tags) rename(tag);
        in(sector.triggers);
        for (LoopRecord& loop : sector.loops)
            for (WallRecord& wall : loop.walls) {
                rename(wall.next);
                in(wall.triggers);
            }
        for (PanelRecord& panel : sector.panels) in(panel.triggers);
    }
    void in(ThingRecord& thing) const {
        rename(thing.name);
        rename(thing.sector);
        in(thing.triggers);
    }
    void in(PointLightRecord& light) const { rename(light.sector); }

private:
    void rename(std::string& name) const {
        if (own_.contains(name)) name = place_ + "." + name;
    }
    void in(std::vector<TriggerRecord>& triggers) const {
        for (TriggerRecord& trigger : triggers) {
            rename(trigger.like);
            if (trigger.action != TriggerAction::leave_map)
                for (std::string& target : trigger.targets) rename(target);
        }
    }

    const std::string& place_;
    std::set<std::string> own_;
};

/// What a copy of a map takes, counted in usual walls.
std::size_t weight_of(const MapFile& map, std::size_t bytes) {
    constexpr std::size_t kUsualBytes = 256;
    std::size_t weight = bytes / kUsualBytes + map.things.size() + map.lights.size() + map.suns.size() +
                         map.sounds.size() + map.animations.size() + map.switches.size();
    const auto add = [&](const std::vector<TriggerRecord>& triggers) { weight += triggers.size(); };
    for (const ThingRecord& thing : map.things) add(thing.triggers);
    for (const SectorRecord& sector : map.sectors) {
        weight += 2 + sector.panels.size() + sector.tags.size();
        add(sector.triggers);
        for (const PanelRecord& panel : sector.panels) add(panel.triggers);
        for (const LoopRecord& loop : sector.loops)
            for (const WallRecord& wall : loop.walls) weight += weight_of(wall);
    }
    return weight;
}

std::string name_of(const SoundRecord& sound) { return sound.name; }
std::string name_of(const SunRecord& sun) { return sun.name; }
std::string name_of(const SwitchRecord& faces) { return faces.off; }
std::string name_of(const AnimationRecord& animation) {
    std::string name;
    for (const std::string& frame : animation.frames) name += frame + "\n";
    return name;
}

/// Adds what a map has not yet: what is called alike must be alike.
template <class Record>
void merge(Reading& reading, const PrefabRecord& prefab, std::vector<Record>& into, const std::vector<Record>& from) {
    std::map<std::string, Record> known;
    for (const Record& record : into) known.try_emplace(name_of(record), record);
    for (const Record& record : from) {
        const auto [there, is_new] = known.try_emplace(name_of(record), record);
        if (is_new) into.push_back(record);
        Record same = record;
        same.place = there->second.place;
        if (same != there->second)
            reading.error(key_place(prefab, "file"), "prefab-differs",
                          "the prefab and the map call two things " + in_quotes(name_of(record)) +
                              ", which are not alike; give one of the two sounds, suns, animations or switches "
                              "another name");
    }
}

}  // namespace

void PrefabFiles::read_into(const PrefabRecord& prefab, std::string_view text, File& file) {
    const std::uint32_t first_line = next_line_;
    sources_.push_back({prefab.file, first_line});
    next_line_ += static_cast<std::uint32_t>(std::ranges::count(text, '\n')) + 2;
    const std::size_t before = reading_.findings.size();
    auto document = TomlDocument::parse(text, {}, reading_.findings);
    if (!document) {
        if (TextPlace& place = reading_.findings.back().place; place.line > 0) place.line += first_line - 1;
        return;
    }
    document->move_lines(first_line - 1);
    if (document->root().find("format").kind() == TomlKind::absent)
        return reading_.error({first_line, 1}, "needs-format-1",
                              "a prefab must be in the enfilade dialect; put 'format = 1' at its top");
    read_document(reading_, document->root(), *this, file.map);
    file.weight = weight_of(file.map, text.size());
    const auto is_error = [](const Finding& finding) { return finding.severity == Severity::error; };
    file.is_sound = std::none_of(reading_.findings.begin() + std::ptrdiff_t(before), reading_.findings.end(), is_error);
}

PrefabFiles::File* PrefabFiles::find(const PrefabRecord& prefab) {
    const TextPlace place = key_place(prefab, "file");
    if (std::ranges::find(open_, prefab.file) != open_.end() || open_.size() == kMostNested) {
        reading_.error(place, "prefab-in-itself",
                       open_.size() == kMostNested
                           ? "prefabs stand in one another more than " + std::to_string(kMostNested) + " deep"
                           : "the prefab " + in_quotes(prefab.file) + " would stand in itself; leave it out here");
        return nullptr;
    }
    const auto [found, is_new] = files_.try_emplace(prefab.file);
    File& file = found->second;
    if (!is_new) return file.is_sound ? &file : nullptr;
    const Result<Bytes> bytes = read_ ? read_(prefab.file) : Error{"", "a map that is not a file has no prefabs"};
    if (!bytes.ok() || (bytes_ += bytes.value().size()) > kMostPrefabBytes) {
        reading_.error(
            place, "no-prefab",
            "expected a map file in the map's folder: " +
                (bytes.ok() ? "all prefabs together have more than " + std::to_string(kMostPrefabBytes >> 20) + " MiB"
                            : bytes.error().text() +
                                  "; those that come with Enfilade are in its maps/prefabs, copy one to there"));
        return nullptr;
    }
    open_.push_back(prefab.file);
    read_into(prefab, as_text(bytes.value()), file);
    open_.pop_back();
    return file.is_sound ? &file : nullptr;
}

void PrefabFiles::place(const PrefabRecord& prefab, MapFile& map) {
    File* const file = find(prefab);
    if (!file) return;
    constexpr std::size_t kUsualName = 64;
    if (!expansion_.take(file->weight * (1 + prefab.name.size() / kUsualName), prefab.place)) return;
    if (file->map.size && file->map.size != map.size)
        return reading_.error(key_place(prefab, "file"), "prefab-differs",
                              "the prefab has another 'size' than the map; give both the same");
    MapFile placed = file->map;
    Placing placing(prefab);
    const Renaming renaming(file->map, prefab.name);
    bool is_in_world = true;
    const auto put = [&](auto& records) {
        for (auto& record : records) {
            is_in_world = placing.put(record) && is_in_world;
            renaming.in(record);
        }
    };
    put(placed.sectors);
    put(placed.things);
    put(placed.lights);
    if (!is_in_world)
        return reading_.error(
            prefab.place, "out-of-range",
            "expected a prefab within " + number_text(kWorldLimit) + " m of the origin; put it nearer");
    std::ranges::move(placed.sectors, std::back_inserter(map.sectors));
    std::ranges::move(placed.things, std::back_inserter(map.things));
    std::ranges::move(placed.lights, std::back_inserter(map.lights));
    if (std::exchange(file->is_merged, true)) return;
    merge(reading_, prefab, map.sounds, placed.sounds);
    merge(reading_, prefab, map.suns, placed.suns);
    merge(reading_, prefab, map.animations, placed.animations);
    merge(reading_, prefab, map.switches, placed.switches);
}

void PrefabFiles::place_all(MapFile& map) {
    const std::vector<PrefabRecord> prefabs = std::move(map.prefabs);
    map.prefabs.clear();
    for (const PrefabRecord& prefab : prefabs) {
        const std::size_t before = map.sectors.size();
        if (prefab.places.is_sound() && !reading_.is_full()) place(prefab, map);
        // In the place of what could not be put in: whoever names what is not there may have meant that.
        if (map.sectors.size() == before && has_errors(reading_.findings))
            map.sectors.emplace_back().place = prefab.place;
    }
}

}  // namespace enfilade
