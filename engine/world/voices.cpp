#include "world/voices.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "world/input.h"

namespace enfilade {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// Things of one kind would all sound in step: each begins this much earlier than the one before, counted round
/// [ticks].
constexpr std::uint32_t kApart = 977, kRound = 4096;

class Listening {
public:
    Listening(const Instant& now, Hearing& hearing, const Listener& listener, std::span<const double> lengths_s)
        : now_(now),
          map_(now.map),
          hearing_(hearing),
          right_(right_of(direction(listener.yaw))),
          lengths_s_(lengths_s) {
        for (const double length_s : lengths_s) longest_ = std::max(longest_, length_s * kTickRate);
        hearing.listen(listener.place, map_.farthest_sound_m,
                       [this](WallId wall, const Rigid&) { return is_open(now_, map_[wall]); });
    }

    std::vector<Voice> run() {
        for (const SectorId sector : hearing_.sectors()) {
            hear_things(sector);
            hear_movers(sector, Channel::floor);
            hear_movers(sector, Channel::ceiling);
        }
        if (now_.history) hear_triggers();
        keep_loudest();
        return std::move(voices_);
    }

private:
    double length_of(SoundId sound) const { return lengths_s_[sound.index] * kTickRate; }

    /// Adds the voice, as it comes over the way.
    void add(Voice voice, const std::optional<SoundWay>& way) {
        if (!way) return;
        const Sound& sound = map_[voice.sound];
        voice.level = sound.volume * loudness(way->length_m, sound.reach_m);
        voice.side = dot(way->from, right_) * std::min(way->length_m / kAroundHead, 1.0);
        voice.side = std::clamp(voice.side, -1.0, 1.0);
        if (voice.level > 0) voices_.push_back(voice);
    }

    /// The same, of one that plays once; not where it is over, or silent.
    void add_once(SoundId sound, Maker maker, std::uint32_t number, double since, const std::optional<SoundWay>& way) {
        if (sound && since <= now_.tick && now_.tick < since + length_of(sound))
            add({sound, maker, number, since, false}, way);
    }

    void hear_things(SectorId sector) {
        const auto is_before = [this](ThingId thing, SectorId id) { return map_[thing].sector < id; };
        const std::vector<ThingId>& all = map_.sounding_things;
        for (auto it = std::lower_bound(all.begin(), all.end(), sector, is_before);
             it != all.end() && map_[*it].sector == sector; ++it) {
            if (now_.history && now_.history->is_taken(*it, now_.tick)) continue;
            const double since = -static_cast<double>(it->index * kApart % kRound);
            add({map_[*it].sound, Maker::thing, it->index, since, true}, hearing_.from(place_of(*it)));
        }
    }

    Place place_of(ThingId thing) const { return {map_[thing].sector, map_[thing].position}; }

    /// From the present change of a value back through those whose sounds may still be heard.
    void hear_movers(SectorId id, Channel channel) {
        const Sector& sector = map_[id];
        if (!now_.history || (!sector.up_sound && !sector.down_sound && !sector.stop_sound)) return;
        const auto way_here = hearing_.from(id);
        const std::uint32_t number = 2 * id.index + (channel == Channel::ceiling);
        double cut = kNever, next_begin = kNever;
        const Change* change = now_.history->change_of(id, channel, now_.tick);
        while (change && cut > now_.tick - longest_) {
            std::vector<Move> moves = moves_of(change->course, now_.tick - longest_, std::min(now_.tick, cut));
            for (auto move = moves.rbegin(); move != moves.rend(); ++move) {
                if (move->begin >= cut) continue;
                const double end = std::min(move->end, cut);
                hear_start(move->is_down ? sector.down_sound : sector.up_sound, number, move->begin, end, way_here);
                if (end != next_begin) add_once(sector.stop_sound, Maker::stop, number, end, way_here);
                next_begin = move->begin;
            }
            cut = std::min(cut, static_cast<double>(change->course.start));
            change = change->before == Change::kNone ? nullptr : &now_.history->changes()[change->before];
        }
    }

    void hear_start(SoundId sound, std::uint32_t number, double begin, double end, const std::optional<SoundWay>& way) {
        if (!sound) return;
        if (!map_[sound].loops) return add_once(sound, Maker::start, number, begin, way);
        if (now_.tick < end) add({sound, Maker::start, number, begin, true}, way);
    }

    void hear_triggers() {
        const std::vector<Firing>& all = now_.history->firings();
        const auto is_before = [](const Firing& firing, double tick) {
            return static_cast<double>(firing.tick) < tick;
        };
        for (auto it = std::lower_bound(all.begin(), all.end(), now_.tick - longest_, is_before); it != all.end();
             ++it) {
            const Trigger& trigger = map_[it->trigger];
            const auto number = static_cast<std::uint32_t>(it - all.begin());
            if (trigger.sound)
                add_once(trigger.sound, Maker::trigger, number, static_cast<double>(it->tick), way_to(*it));
        }
    }

    /// From the wall that was used or passed, or else from what the trigger is on; from the middle of walls and panels.
    std::optional<SoundWay> way_to(const Firing& firing) const {
        const Trigger& trigger = map_[firing.trigger];
        const WallId wall = firing.wall ? firing.wall : trigger.on_wall;
        if (wall) return hearing_.from({map_[wall].sector, (map_[wall].a + map_[wall].b) * 0.5});
        if (trigger.on_panel) {
            const Panel& panel = map_[trigger.on_panel];
            return hearing_.from({panel.sector, (panel.a + panel.b) * 0.5});
        }
        return trigger.on_thing ? hearing_.from(place_of(trigger.on_thing)) : hearing_.from(trigger.on_sector);
    }

    void keep_loudest() {
        std::stable_sort(voices_.begin(), voices_.end(),
                         [](const Voice& v, const Voice& w) { return v.level > w.level; });
        voices_.resize(std::min(voices_.size(), kMostVoices));
    }

    const Instant& now_;
    const Map& map_;
    Hearing& hearing_;
    Vec2 right_;
    std::span<const double> lengths_s_;
    double longest_ = 0;  ///< [ticks]
    std::vector<Voice> voices_;
};

}  // namespace

double loudness(double way_m, double reach_m) {
    const double left = std::max(0.0, 1 - way_m / reach_m);
    return left * left;
}

std::vector<Voice> voices_at(const Instant& now, Hearing& hearing, const Listener& listener,
                             std::span<const double> lengths_s) {
    if (now.map.sounds.empty()) return {};
    return Listening(now, hearing, listener, lengths_s).run();
}

}  // namespace enfilade
