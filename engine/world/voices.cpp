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

/// edge: a wall or a panel.
template <class Edge>
Place middle_of(const Edge& edge) {
    return {edge.sector, (edge.a + edge.b) * 0.5};
}

class Listening {
public:
    Listening(const Instant& now, Hearing& hearing, Angle yaw, std::span<const double> lengths_s)
        : now_(now), map_(now.map), hearing_(hearing), right_(right_of(direction(yaw))), lengths_s_(lengths_s) {
        for (const double length_s : lengths_s) longest_ = std::max(longest_, length_s * rate_);
        if (now.history) note_events(*now.history);
    }

    std::vector<Voice> run(const Place& ear, std::size_t slice) {
        const auto may_pass = [this](WallId wall, const Rigid&) { return is_open(now_, wall); };
        if (!map_.sounding_things.empty()) {
            hearing_.listen(ear, map_.farthest_sound_m, may_pass, slice);
            for (const SectorId sector : hearing_.sectors()) hear_things(sector);
        } else if (!noted_.empty()) {
            hearing_.listen(ear, sources_noted(), may_pass, slice);
        } else {
            hearing_.forget();  // the ear may be elsewhere when something sounds again
        }
        for (const Noted& noted : noted_)
            hear(noted.voice, noted.place ? hearing_.from(*noted.place) : hearing_.from(noted.sector));
        keep_loudest();
        return std::move(voices_);
    }

private:
    /// Something that sounds, wherever the listener is: from a whole sector, or from a place.
    struct Noted {
        Voice voice;
        SectorId sector;
        std::optional<Place> place;
    };

    double length_of(SoundId sound) const { return lengths_s_[sound.index] * rate_; }

    std::vector<SoundSource> sources_noted() const {
        std::vector<SoundSource> sources;
        for (const Noted& noted : noted_)
            sources.push_back({noted.place ? noted.place->sector : noted.sector,
                               noted.place ? std::optional(noted.place->point) : std::nullopt,
                               map_[noted.voice.sound].reach_m});
        return sources;
    }

    /// Adds the voice, as it comes over the way.
    void hear(Voice voice, const std::optional<SoundWay>& way) {
        if (!way) return;
        const Sound& sound = map_[voice.sound];
        voice.level = sound.volume * loudness(way->length_m, sound.reach_m);
        voice.side = dot(way->from, right_) * std::min(way->length_m / kAroundHead, 1.0);
        voice.side = std::clamp(voice.side, -1.0, 1.0);
        if (voice.level > 0) voices_.push_back(voice);
    }

    void note(const Voice& voice, SectorId sector, const std::optional<Place>& place = {}) {
        noted_.push_back({voice, sector, place});
    }

    /// The same, of one that plays once; not where it is over.
    void note_once(const Voice& voice, SectorId sector, const std::optional<Place>& place = {}) {
        if (voice.sound && voice.since <= now_.tick && now_.tick < voice.since + length_of(voice.sound))
            note(voice, sector, place);
    }

    void note_events(const History& history) {
        for (const ChangedSector& changed : history.changed_sectors()) {
            note_mover(history, changed.sector, Channel::floor);
            note_mover(history, changed.sector, Channel::ceiling);
        }
        note_triggers(history);
    }

    void hear_things(SectorId sector) {
        const auto is_before = [this](ThingId thing, SectorId id) { return map_[thing].sector < id; };
        const std::vector<ThingId>& all = map_.sounding_things;
        for (auto it = std::lower_bound(all.begin(), all.end(), sector, is_before);
             it != all.end() && map_[*it].sector == sector; ++it) {
            if (now_.history && now_.history->is_taken(*it, now_.tick)) continue;
            const double since = -static_cast<double>(it->index * kApart % kRound);
            hear({map_[*it].sound, Maker::thing, it->index, since, true}, hearing_.from(place_of(*it)));
        }
    }

    Place place_of(ThingId thing) const { return {map_[thing].sector, map_[thing].position}; }

    /// From the present change of a value back through those whose sounds may still be heard.
    void note_mover(const History& history, SectorId id, Channel channel) {
        const Sector& sector = map_[id];
        if (!sector.up_sound && !sector.down_sound && !sector.stop_sound) return;
        const std::uint32_t number = 2 * id.index + (channel == Channel::ceiling);
        double cut = kNever, next_begin = kNever;
        const Change* change = history.change_of(id, channel, now_.tick);
        while (change && cut > now_.tick - longest_) {
            std::vector<Move> moves = moves_of(change->track, now_.tick - longest_, std::min(now_.tick, cut));
            for (auto move = moves.rbegin(); move != moves.rend(); ++move) {
                if (move->begin >= cut) continue;
                const double end = std::min(move->end, cut);
                note_start(move->is_down ? sector.down_sound : sector.up_sound, number, move->begin, end, id);
                if (end != next_begin) note_once({sector.stop_sound, Maker::stop, number, end}, id);
                next_begin = move->begin;
            }
            cut = std::min(cut, static_cast<double>(change->track.start));
            change = change->before == Change::kNone ? nullptr : &history.changes()[change->before];
        }
    }

    void note_start(SoundId sound, std::uint32_t number, double begin, double end, SectorId sector) {
        if (!sound) return;
        if (!map_[sound].loops) return note_once({sound, Maker::start, number, begin}, sector);
        if (now_.tick < end) note({sound, Maker::start, number, begin, true}, sector);
    }

    void note_triggers(const History& history) {
        const std::vector<Firing>& all = history.firings();
        const auto is_before = [](const Firing& firing, double tick) {
            return static_cast<double>(firing.tick) < tick;
        };
        for (auto it = std::lower_bound(all.begin(), all.end(), now_.tick - longest_, is_before); it != all.end();
             ++it) {
            const auto number = static_cast<std::uint32_t>(it - all.begin());
            note_once({map_[it->trigger].sound, Maker::trigger, number, static_cast<double>(it->tick)},
                      map_[it->trigger].on_sector, place_of(*it));
        }
    }

    /// The middle of the wall that was used or passed, or else of what the trigger is on; none: a whole sector.
    std::optional<Place> place_of(const Firing& firing) const {
        const Trigger& trigger = map_[firing.trigger];
        const WallId wall = firing.wall ? firing.wall : trigger.on_wall;
        if (wall) return middle_of(map_[wall]);
        if (trigger.on_panel) return middle_of(map_[trigger.on_panel]);
        if (trigger.on_thing) return place_of(trigger.on_thing);
        return {};
    }

    void keep_loudest() {
        std::stable_sort(voices_.begin(), voices_.end(),
                         [](const Voice& v, const Voice& w) { return v.level > w.level; });
        voices_.resize(std::min(voices_.size(), kMostVoices));
    }

    const Instant& now_;
    const Map& map_;
    const double rate_ = ticks_per_second(rate_of(now_));
    Hearing& hearing_;
    Vec2 right_;
    std::span<const double> lengths_s_;
    double longest_ = 0;  ///< [ticks]
    std::vector<Noted> noted_;
    std::vector<Voice> voices_;
};

}  // namespace

double loudness(double way_m, double reach_m) {
    const double left = std::max(0.0, 1 - way_m / reach_m);
    return left * left;
}

std::vector<Voice> voices_at(const Instant& now, Hearing& hearing, const Listener& listener,
                             std::span<const double> lengths_s, std::size_t slice) {
    if (now.map.sounds.empty()) return {};
    return Listening(now, hearing, listener.yaw, lengths_s).run(listener.place, slice);
}

}  // namespace enfilade
