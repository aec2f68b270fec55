#include "wadconv/workbench.h"

#include <algorithm>
#include <array>

#include "wadconv/wad.h"

namespace enfilade::wadconv {
namespace {

/// Tics between two pains on a floor that hurts.
constexpr double kTicsOfDamage = 32;

Activation activation_of(How how) { return how == How::cross ? Activation::cross : Activation::use; }

std::string key_name(DoorKey key) {
    constexpr std::array<std::string_view, 4> kKeyNames = {"", "blue", "yellow", "red"};
    return std::string(kKeyNames[static_cast<std::size_t>(key)]);
}

/// What the action's own measures say, in metres and seconds. Actions that do not move keep the usual ones.
TriggerRecord measured(const LineAction& line_action) {
    TriggerRecord trigger;
    trigger.on = activation_of(line_action.how);
    trigger.action = line_action.action;
    trigger.once = line_action.times == Times::once;
    trigger.key = key_name(line_action.key);
    // Only who stands at the door itself turns it round.
    trigger.reverses =
        line_action.action != TriggerAction::door || line_action.how == How::push || line_action.how == How::cross;
    trigger.crushes = line_action.crushes;
    if (line_action.crush_speed > 0) trigger.crush_speed = metres(line_action.crush_speed * kTicsPerSecond);
    trigger.to = line_action.to;
    if (line_action.action == TriggerAction::stairs)
        trigger.step = metres(line_action.by);
    else
        trigger.by = metres(line_action.by);
    if (line_action.speed > 0) trigger.speed = metres(line_action.speed * kTicsPerSecond);
    if (line_action.wait > 0) trigger.wait = line_action.wait / kTicsPerSecond;
    if (line_action.light >= 0) trigger.light = line_action.light / kLightLevels;
    trigger.light_of = line_action.light_of;
    return trigger;
}

/// Whether it is made for each sector of the tag, because what it needs differs from one to the other.
bool differs_by_sector(const LineAction& line_action) {
    return line_action.action == TriggerAction::stairs || line_action.special_case == SpecialCase::donut ||
           line_action.special_case == SpecialCase::shortest_lower || line_action.change == FloorChange::as_beside;
}

}  // namespace

std::string tag_name(int tag) { return "tag " + std::to_string(tag); }
std::string exit_name(std::uint32_t sector) { return "exit of s" + std::to_string(sector); }

int damage_of(int special) {
    switch (special) {
        case 7: return 5;
        case 5: return 10;
        case 4:
        case 11:
        case 16: return 20;
        default: return 0;
    }
}

int damage_a_second(int damage) { return static_cast<int>(damage * kTicsPerSecond / kTicsOfDamage + 0.5); }

TriggerMaker::TriggerMaker(const DoomMap& doom, const Parts& parts, const Pictures& pictures,
                           const Neighbours& neighbours, const Exits& exits, Report& report)
    : doom_(doom),
      parts_(parts),
      pictures_(pictures),
      neighbours_(neighbours),
      exits_(exits),
      report_(report),
      names_(doom.sectors.size()) {
    for (const Part& part : parts_.parts) {
        if (part.number != 0) continue;
        by_tag_[sector(part.sector).tag].push_back(part.sector);
        names_[part.sector] = part_name(part);
    }
}

std::vector<TriggerRecord> TriggerMaker::triggers_of(std::uint32_t line, bool is_open) const {
    const Linedef& doom = doom_.lines[line];
    const std::optional<LineAction> line_action = line_action_of(doom.special);
    if (!line_action) return {};
    if (!is_open && (line_action->how == How::cross || line_action->how == How::push)) {
        report_.note(Kind::closed_trigger, line);
        return {};
    }
    if (line_action->how == How::shoot) report_.note(Kind::shot_trigger, line);
    LineJob job{line, *line_action, measured(*line_action), {}};
    if (line_action->action == TriggerAction::leave_map) return {leave_map(job)};
    if (line_action->how == How::push) return {job.base};
    return remote(job);
}

/// Acts on the sectors of the line's tag.
std::vector<TriggerRecord> TriggerMaker::remote(LineJob& job) const {
    const int tag = doom_.lines[job.line].tag;
    const auto found = by_tag_.find(tag);
    if (tag == 0 || found == by_tag_.end()) {
        report_.note(Kind::aimless_trigger, job.line);
        return {};
    }
    job.sectors = found->second;
    if (job.line_action.action == TriggerAction::teleport) return teleport(job);
    if (differs_by_sector(job.line_action)) return one_by_one(job);
    TriggerRecord trigger = job.base;
    trigger.targets = {tag_name(tag)};
    if (job.line_action.change != FloorChange::none)
        change_as(front_of(job.line), job.line_action.change == FloorChange::as_in_front, trigger);
    if (job.line_action.change == FloorChange::harmless) trigger.heals = true;
    if (trigger.action == TriggerAction::light && !trigger.light && trigger.light_of == LightLevel::given)
        strobe(job, trigger);
    return {trigger};
}

/// To the first sector of the tag that has an exit; only from the front.
std::vector<TriggerRecord> TriggerMaker::teleport(const LineJob& job) const {
    for (const std::uint32_t sector : job.sectors)
        if (exits_[sector]) {
            TriggerRecord trigger = job.base;
            trigger.targets = {exit_name(sector)};
            trigger.one_way = true;
            return {trigger};
        }
    report_.note(Kind::aimless_trigger, job.line);
    return {};
}

TriggerRecord TriggerMaker::leave_map(const LineJob& job) const {
    TriggerRecord trigger = job.base;
    std::string next = next_map(doom_.name, job.line_action.special_case == SpecialCase::secret_exit);
    for (char& c : next)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');  // as its file is called
    if (!next.empty()) trigger.targets = {next};
    return trigger;
}

std::vector<TriggerRecord> TriggerMaker::one_by_one(const LineJob& job) const {
    std::vector<TriggerRecord> all;
    const auto append = [&](std::vector<TriggerRecord> more) {
        for (TriggerRecord& trigger : more) all.push_back(std::move(trigger));
    };
    for (const std::uint32_t s : job.sectors) {
        if (job.line_action.action == TriggerAction::stairs) {
            append(staircase(job, s));
        } else if (job.line_action.special_case == SpecialCase::donut) {
            append(donut(job, s));
        } else {
            TriggerRecord trigger = job.base;
            trigger.targets = targets_of(s);
            if (job.line_action.special_case == SpecialCase::shortest_lower) trigger.by = metres(shortest_lower(s));
            if (job.line_action.change == FloorChange::as_beside)
                if (const std::uint32_t model = beside_of_height(s, neighbours_.lowest_floor(s)); model != kNone)
                    change_as(model, true, trigger);
            all.push_back(std::move(trigger));
        }
    }
    return all;
}

/// Every stair goes to its height above the first, whatever its own was.
std::vector<TriggerRecord> TriggerMaker::staircase(const LineJob& job, std::uint32_t first) const {
    const std::vector<std::uint32_t> stairs = stairs_from(first);
    const auto is_even = [&](std::uint32_t s) { return sector(s).floor == sector(first).floor && !names_[s].empty(); };
    TriggerRecord trigger = job.base;
    if (std::ranges::all_of(stairs, is_even)) {
        for (const std::uint32_t s : stairs) trigger.targets.push_back(names_[s]);
        return {trigger};
    }
    trigger.action = TriggerAction::floor;
    trigger.step = TriggerRecord{}.step;
    std::vector<TriggerRecord> all;
    for (std::size_t i = 0; i < stairs.size(); ++i) {
        trigger.targets = targets_of(stairs[i]);
        trigger.z = metres(sector(first).floor + static_cast<double>(i + 1) * job.line_action.by);
        if (!trigger.targets.empty()) all.push_back(trigger);
    }
    return all;
}

/// On from each stair through the first line that it is in front of to a sector with the same floor picture.
std::vector<std::uint32_t> TriggerMaker::stairs_from(std::uint32_t first) const {
    std::vector<std::uint32_t> stairs{first};
    for (bool goes_on = true; goes_on;) {
        goes_on = false;
        for (const Neighbour& n : neighbours_.of(stairs.back())) {
            if (!n.is_front || sector(n.sector).floor_flat != sector(first).floor_flat) continue;
            if (std::ranges::find(stairs, n.sector) != stairs.end()) continue;
            stairs.push_back(n.sector);
            goes_on = true;
            break;
        }
    }
    return stairs;
}

/// The ring is behind the pillar's first line, the model beyond the ring.
std::vector<TriggerRecord> TriggerMaker::donut(const LineJob& job, std::uint32_t pillar) const {
    if (neighbours_.of(pillar).empty()) return {};
    const std::uint32_t ring = neighbours_.of(pillar).front().sector;
    if (names_[ring].empty()) return {};
    for (const Neighbour& n : neighbours_.of(ring)) {
        if (n.sector == pillar || n.sector == ring || names_[n.sector].empty()) continue;
        TriggerRecord down = job.base, up = job.base;
        down.targets = targets_of(pillar);
        up.targets = targets_of(ring);
        down.like = up.like = names_[n.sector];
        change_as(n.sector, false, up);
        up.heals = true;
        return {down, up};
    }
    return {};
}

/// A sector around with that floor, or kNone.
std::uint32_t TriggerMaker::beside_of_height(std::uint32_t number, std::int16_t floor) const {
    for (const Neighbour& n : neighbours_.of(number))
        if (n.sector != number && sector(n.sector).floor == floor) return n.sector;
    return kNone;
}

void TriggerMaker::change_as(std::uint32_t model, bool takes_nature, TriggerRecord& trigger) const {
    if (model == kNone) return;
    if (const PictureFile* file = pictures_.flat(sector(model).floor_flat)) trigger.texture = file->name;
    if (takes_nature) trigger.heals = damage_of(sector(model).special) == 0;
}

/// Flashes between each sector's own light and the darkest around any of them.
void TriggerMaker::strobe(const LineJob& job, TriggerRecord& trigger) const {
    std::int16_t dark = 255;
    for (const std::uint32_t s : job.sectors) dark = std::min(dark, neighbours_.darkest(s));
    trigger.effect = slow_strobe(dark);
}

double TriggerMaker::shortest_lower(std::uint32_t number) const {
    std::uint32_t shortest = 0;
    for (const Neighbour& n : neighbours_.of(number))
        for (const std::uint16_t side : {doom_.lines[n.line].right, doom_.lines[n.line].left})
            if (const PictureFile* file = pictures_.wall(doom_.sides[side].lower))
                if (shortest == 0 || file->height < shortest) shortest = file->height;
    return shortest;
}

std::uint32_t TriggerMaker::front_of(std::uint32_t line) const {
    const Sidedef* side = doom_.side_of(doom_.lines[line].right);
    return side ? std::uint32_t{side->sector} : kNone;
}

/// The first part, which stands for all of them: they are a group.
std::vector<std::string> TriggerMaker::targets_of(std::uint32_t number) const {
    if (names_[number].empty()) return {};
    return {names_[number]};
}

}  // namespace enfilade::wadconv
