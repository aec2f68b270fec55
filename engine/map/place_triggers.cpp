// Triggers find their sectors, things and pictures; and what can never go off, or do nothing, is said.
#include <algorithm>
#include <string>

#include "formats/text_parts.h"
#include "formats/words.h"
#include "map/draft.h"

namespace enfilade {
namespace {

/// What has triggers.
enum class Bearer { sector, wall, portal, panel, barrier, thing };

std::string_view name_of(Bearer bearer) {
    switch (bearer) {
        case Bearer::sector: return "a sector";
        case Bearer::wall: return "a solid wall";
        case Bearer::portal: return "a portal";
        case Bearer::panel: return "a panel";
        case Bearer::barrier: return "a panel that blocks";
        case Bearer::thing: return "a thing";
    }
    return "";
}

bool can_be_set_off(Activation on, Bearer bearer) {
    switch (on) {
        case Activation::use: return bearer != Bearer::thing;
        case Activation::cross: return bearer == Bearer::portal || bearer == Bearer::panel;
        case Activation::enter: return bearer == Bearer::sector;
        case Activation::touch: return bearer == Bearer::thing;
        case Activation::start: return true;
    }
    return false;
}

NameIndex thing_names(const Map& map) {
    std::vector<ScopedName> names;
    for (std::uint32_t i = 0; i < map.things.size(); ++i)
        if (!map.things[i].name.empty()) names.push_back({0, map.things[i].name, i});
    return NameIndex(std::move(names));
}

class TriggerPlacer {
public:
    explicit TriggerPlacer(Draft& draft) : draft_(draft), lists_(draft), things_(thing_names(draft.map)) {}

    /// `usual`: the sector meant where the record names none, or none.
    TriggerRange place(const std::vector<TriggerRecord>& records, Bearer bearer, SectorId usual) {
        const auto first = static_cast<std::uint32_t>(draft_.map.triggers.size());
        std::size_t set_off = 0;
        for (const TriggerRecord& record : records) {
            check(record, bearer);
            const bool at_start = record.on == Activation::start;
            if (at_start) draft_.map.at_start.emplace_back(draft_.map.triggers.size());
            draft_.map.triggers.push_back(resolved(record, usual));
            count_targets(record, at_start ? set_off_at_start_ : set_off);
        }
        return {first, static_cast<std::uint32_t>(records.size())};
    }

private:
    /// `set_off`: targets of the triggers that may go off together with the last one.
    void count_targets(const TriggerRecord& record, std::size_t& set_off) {
        const bool was_within = set_off <= kMostSetOff;
        set_off += draft_.map.triggers.back().targets.count;
        if (was_within && set_off > kMostSetOff)
            draft_.error(record, "target", "too-many-targets",
                         "expected triggers that change at most " + std::to_string(kMostSetOff) +
                             " sectors when they go off together, found " + std::to_string(set_off) +
                             " with this one; give them fewer targets, or leave out triggers that do the same");
    }

    void check(const TriggerRecord& record, Bearer bearer) {
        if (!record.places.is_sound()) return;
        if (!can_be_set_off(record.on, bearer))
            draft_.error(record, "on", "trigger-activation",
                         std::string(name_of(bearer)) + " cannot have a trigger on " + in_quotes(to_word(record.on)));
        if (record.action == TriggerAction::light && !record.light && record.light_of == LightLevel::given &&
            !record.effect)
            draft_.error(record, "do", "light-without-level",
                         "expected light, light_of or effect, which say how the light changes; found none of them");
        check_goal(record);
    }

    /// What goes somewhere must be told where; a floor may also just change.
    void check_goal(const TriggerRecord& record) {
        const bool goes = record.action == TriggerAction::floor || record.action == TriggerAction::ceiling;
        const bool has_goal = record.z || record.to != HeightLevel::here || !record.like.empty() || record.by != 0;
        if (goes && !has_goal && record.texture.empty() && !record.heals)
            draft_.error(record, "do", "move-without-goal",
                         "expected z, to, like or by, which say where the " + std::string(to_word(record.action)) +
                             " goes; found none, so it would stay where it is");
        if (record.action == TriggerAction::stairs && record.step == 0)
            draft_.error(record, "step", "move-without-goal",
                         "expected a step that is higher or lower than 0 m, found 0: these stairs would stay level");
    }

    Trigger resolved(const TriggerRecord& record, SectorId usual) {
        Trigger t;
        t.on = record.on;
        t.action = record.action;
        t.once = record.once;
        t.one_way = record.one_way;
        t.reverses = record.reverses;
        t.crushes = record.crushes;
        t.heals = record.heals;
        t.after_s = record.after;
        t.z = record.z;
        t.to = record.to;
        t.by = record.by;
        t.speed = record.speed;
        t.wait_s = record.wait;
        t.step = record.step;
        t.crush_speed = record.crush_speed;
        t.texture = draft_.textures.find(record.texture);
        t.light = record.light;
        t.light_of = record.light_of;
        t.effect = record.effect;
        find_model(record, t);
        find_targets(record, usual, t);
        return t;
    }

    void find_model(const TriggerRecord& record, Trigger& trigger) {
        if (record.like.empty()) return;
        trigger.like = lists_.first_of(record.like);
        if (!trigger.like) unknown(record, "like", "sector", record.like, lists_.suggestion(record.like));
    }

    void find_targets(const TriggerRecord& record, SectorId usual, Trigger& trigger) {
        if (record.action == TriggerAction::sound) return;
        if (record.action == TriggerAction::leave_map) {
            if (!record.targets.empty()) trigger.leads_to = record.targets.front();
        } else if (record.action == TriggerAction::teleport) {
            find_destination(record, trigger);
        } else if (!record.targets.empty()) {
            trigger.targets = lists_.list_of(record);
            for (const std::string& name : record.targets)
                if (!lists_.first_of(name)) unknown(record, "target", "sector", name, lists_.suggestion(name));
        } else if (usual) {
            trigger.targets = lists_.list_of(usual);
        } else {
            needs_target(record, "the name or tag of a sector: here is none behind");
        }
    }

    void find_destination(const TriggerRecord& record, Trigger& trigger) {
        if (record.targets.size() != 1) return needs_target(record, "the name of a thing, to stand where it is");
        const std::string& name = record.targets.front();
        const auto found = things_.find(0, name);
        if (!found) return unknown(record, "target", "thing", name, things_.suggestion(0, name));
        trigger.destination = ThingId(*found);
    }

    void unknown(const TriggerRecord& record, const char* key, const char* kind, const std::string& name,
                 const std::string& suggestion) {
        const bool is_sector = kind == std::string_view("sector");
        if (is_sector && draft_.has_nameless_sectors) return;
        draft_.error(record, key, "unknown-target",
                     "expected the name " + std::string(is_sector ? "or tag " : "") + "of a " + kind + ", found " +
                         in_quotes(name) + suggestion);
    }

    void needs_target(const TriggerRecord& record, const char* what) {
        if (!record.places.is_sound()) return;
        draft_.error(record, "do", "needs-target",
                     in_quotes(to_word(record.action)) + " needs a target, " + std::string(what));
    }

    Draft& draft_;
    TargetLists lists_;
    NameIndex things_;
    std::size_t set_off_at_start_ = 0;
};

bool has_triggers(const MapFile& file) {
    for (const SectorRecord& sector : file.sectors) {
        if (!sector.triggers.empty()) return true;
        for (const LoopRecord& loop : sector.loops)
            for (const WallRecord& wall : loop.walls)
                if (!wall.triggers.empty()) return true;
        for (const PanelRecord& panel : sector.panels)
            if (!panel.triggers.empty()) return true;
    }
    return std::any_of(file.things.begin(), file.things.end(),
                       [](const ThingRecord& thing) { return !thing.triggers.empty(); });
}

}  // namespace

void place_triggers(Draft& draft) {
    if (!has_triggers(draft.file)) return;
    TriggerPlacer placer(draft);
    for (std::size_t i = 0; i < draft.map.sectors.size(); ++i)
        draft.map.sectors[i].triggers = placer.place(draft.sectors[i].record->triggers, Bearer::sector, SectorId(i));
    for (std::size_t i = 0; i < draft.map.walls.size(); ++i) {
        Wall& wall = draft.map.walls[i];
        const WallRecord& record = *draft.walls[i].record;
        // What is meant as a portal and could not be made one is refused for that, and not for its triggers.
        const bool is_lost = wall.kind == WallKind::solid && !record.next.empty();
        const bool is_passed = wall.kind == WallKind::portal || wall.kind == WallKind::way_back;
        const Bearer bearer = is_passed || is_lost ? Bearer::portal : Bearer::wall;
        const SectorId usual = is_lost ? wall.sector : wall.behind;
        if (!record.triggers.empty()) wall.triggers = placer.place(record.triggers, bearer, usual);
    }
    for (std::size_t i = 0; i < draft.map.panels.size(); ++i) {
        Panel& panel = draft.map.panels[i];
        const PanelRecord& record = draft.record_of(PanelId(i));
        const Bearer bearer = panel.blocks ? Bearer::barrier : Bearer::panel;
        if (!record.triggers.empty()) panel.triggers = placer.place(record.triggers, bearer, panel.sector);
    }
    for (std::size_t i = 0; i < draft.map.things.size(); ++i) {
        Thing& thing = draft.map.things[i];
        thing.triggers = placer.place(draft.things[i]->triggers, Bearer::thing, thing.sector);
    }
}

}  // namespace enfilade
