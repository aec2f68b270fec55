// What has happened in a world: a list of changes in the order they came. Everything that moves or changes its light is
// a function of this list and the time, and of nothing else.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "formats/dials.h"
#include "map/map.h"

namespace enfilade {

// Where a height or a light goes and when: a function of time, which nobody has to tick.

/// A value to go to, and how.
struct Stop {
    double value = 0;
    double per_tick = 0;     ///< how fast one goes there, > 0; infinity: at once
    std::uint32_t wait = 0;  ///< how long one stays there before one goes on [ticks]

    bool operator==(const Stop&) const = default;
};

/// From a value to at most two stops, once or over and over. Before its start it is at `from`, after its end at its
/// last stop. Each way takes a whole number of ticks, rounded up, and stops are reached exactly.
struct Track {
    std::uint64_t start = 0;  ///< [ticks]
    double from = 0;
    std::array<Stop, 2> stops{};
    std::uint8_t count = 0;     ///< of stops; 0: it stays where it is
    bool loops = false;         ///< after the last stop to the first again; count > 0, and both stops' ways and waits
                                ///< together take at least one tick, else it ends
    double first_per_tick = 0;  ///< how fast one goes to the first stop the first time; 0: as the stop says

    bool operator==(const Track&) const = default;
};

/// The value at a moment, which may lie between two ticks. Computed from the track alone: nothing adds up, and any
/// moment costs the same.
double value_at(const Track& track, double tick);

/// The first tick at which it has come to rest for good, its last wait not counted; none where it never does.
std::optional<std::uint64_t> end_of(const Track& track);

/// A time in which a value moves.
struct Move {
    double begin = 0, end = 0;  ///< [ticks]
    bool is_down = false;
};

/// When the track moves, in order: those that end after `since` and begin by `until`. Cost: the laps between the
/// two, however late they are.
std::vector<Move> moves_of(const Track& track, double since, double until);

/// Whether it is on its first way and that has a speed of its own.
bool is_on_first_way(const Track& track, double tick);

/// Which stop it is on its way to, or waits at, 0 or 1; `count` once it has ended. Before its start: 0.
std::uint8_t stop_at(const Track& track, double tick);

/// What of a sector a track is about.
enum class Channel : std::uint8_t { floor, ceiling, light };
inline constexpr std::size_t kChannels = 3;

/// From the start of its track on, a value of a sector follows it instead of the one before.
struct Change {
    SectorId sector;  ///< that leads its group
    Channel channel = Channel::floor;
    Track track;
    TriggerId cause;               ///< none: somebody was in the way of a bob (world/instant.h)
    std::uint64_t lag = 0;         ///< of a bob that was held up: how far it then is behind the clock [ticks]
    std::uint32_t before = kNone;  ///< index of the change of the same value that this one ends, or kNone
    /// The newest before it whose cause gives a floor a picture, or heals on it; so that nobody need ask all of them.
    std::uint32_t before_with_picture = kNone, before_that_heals = kNone;
    static constexpr std::uint32_t kNone = 0xFFFFFFFFu;

    bool holds_up_bob() const { return !cause; }
};

/// A sector of which something ever changed, and the newest change of each of its values.
struct ChangedSector {
    SectorId sector;                              ///< that leads its group
    std::array<std::uint32_t, kChannels> newest;  ///< by channel: index into History::changes, or Change::kNone
};

/// A trigger that went off.
struct Firing {
    TriggerId trigger;
    WallId wall;  ///< whose switch was pressed, or none
    std::uint64_t tick = 0;
};

/// A thing that was picked up.
struct Pickup {
    ThingId thing;
    std::uint64_t tick = 0;
};

/// From a tick on, the one way back that stands open, which whoever passed a one-way portal last left behind; or none.
struct WayBack {
    WallId wall;  ///< a way back of the map, or none
    std::uint64_t tick = 0;
};

/// A plain value: a copy is a state to come back to. It only ever grows, so that what it says of a moment in the past
/// stays true.
class History {
public:
    /// motion: by which the world of these events moves; its ticks are those that it counts in.
    explicit History(const MotionDials& motion) : motion_(motion) {}
    History() = default;

    const MotionDials& motion() const { return motion_; }
    TickRate rate() const { return motion_.rate; }

    /// The newest change of a value that has begun by `tick`, or null: it is as in the map. A change that begins later
    /// counts only then, and not at all if a newer one came before. Cost: log of the sectors that ever changed, and the
    /// newer changes of this value.
    const Change* change_of(SectorId sector, Channel channel, double tick) const;

    /// The newest change, whether it has begun or not, or null.
    const Change* newest_of(SectorId sector, Channel channel) const;

    /// The sector's record, or null: nothing of it ever changed. Cost: log of the sectors that ever changed.
    const ChangedSector* changed(SectorId sector) const;

    /// change_of, of a record that was found before. Cost: the newer changes of this value.
    const Change* change_of(const ChangedSector& sector, Channel channel, double tick) const;

    /// Sets what was before the change.
    void add(const Map& map, Change change);
    void add(const Firing& firing);
    void add(const Pickup& pickup);
    /// It counts from the tick of the one before, where that is later.
    void add(WayBack way_back);

    /// Whether the trigger has gone off before. Cost: log of the triggers that have.
    bool has_fired(TriggerId trigger) const;

    /// Calls see(Firing) with the first firing of every trigger that ever went off, in the order of their numbers.
    template <class See>
    void each_first_firing(See see) const {
        for (const std::uint32_t i : by_trigger_) see(firings_[i]);
    }

    /// Calls see(Firing) with the last firing by `tick` of every wall whose switch was pressed, in the order of their
    /// numbers. Cost: those walls, each the log of all firings, and the newer firings.
    template <class See>
    void each_last_press(double tick, See see) const {
        for (auto it = by_wall_.begin(); it != by_wall_.end();) {
            const WallId wall = firings_[*it].wall;
            it = end_of_presses(wall);
            if (const Firing* firing = pressed(wall, tick)) see(*firing);
        }
    }

    /// Calls see(ThingId) with what is taken by `tick`, in the order of their numbers.
    template <class See>
    void each_taken(double tick, See see) const {
        for (const std::uint32_t i : by_thing_)
            if (static_cast<double>(pickups_[i].tick) <= tick) see(pickups_[i].thing);
    }

    /// The last time a wall's switch was pressed by `tick`, or null. Cost: as has_fired.
    const Firing* pressed(WallId wall, double tick) const;
    bool is_taken(ThingId thing, double tick) const;

    /// The way back that stands open, or none. Cost: log of the ways back that ever opened and shut.
    WallId way_back(double tick) const;

    /// Sectors of which something ever changed, of a group its leader, in the order of their numbers, each once.
    const std::vector<ChangedSector>& changed_sectors() const { return changed_sectors_; }
    const std::vector<Change>& changes() const { return changes_; }
    const std::vector<Firing>& firings() const { return firings_; }
    const std::vector<Pickup>& pickups() const { return pickups_; }

    /// Of all that was ever added, each kind in its order.
    std::uint64_t digest() const;

    /// How much had happened at some moment, to come back to it.
    struct Length {
        std::size_t changes = 0, firings = 0, pickups = 0, ways_back = 0;
    };
    Length length() const { return {changes_.size(), firings_.size(), pickups_.size(), ways_back_.size()}; }

    /// What had happened when it was that long. Equal, digest and all, to the history of then.
    History beginning(const Length& length) const;

private:
    void append(const Change& change);
    std::vector<std::uint32_t>::const_iterator end_of_presses(WallId wall) const;

    MotionDials motion_;
    std::vector<Change> changes_;
    std::vector<ChangedSector> changed_sectors_;
    std::vector<Firing> firings_;            ///< in the order they came
    std::vector<std::uint32_t> by_trigger_;  ///< the first of each trigger, by trigger
    std::vector<std::uint32_t> by_wall_;     ///< those with a wall, by wall, then by time
    std::vector<Pickup> pickups_;            ///< in the order they came
    std::vector<std::uint32_t> by_thing_;    ///< pickups, by thing
    std::vector<WayBack> ways_back_;         ///< in the order they came
    std::uint64_t changes_digest_ = 0, firings_digest_ = 0, pickups_digest_ = 0, ways_back_digest_ = 0;
};

}  // namespace enfilade
