#include "world/move_flats.h"

#include <algorithm>

#include "world/trigger_actions.h"

namespace enfilade {
namespace {

/// How often who is crushed is hurt, and how much: Doom's 10 points every 4 of its 35 tics a second.
constexpr std::uint64_t kTicksBetweenCrushes = 7;
constexpr int kCrushDamage = 10;

/// Something that comes nearer to a body in a sector around it.
struct Mover {
    SectorId sector;  ///< that leads its group
    Channel channel;
    const Change* change;  ///< none: it bobs
    bool crushes;
};
using Movers = ShortList<Mover, 8>;

class Carrier {
public:
    Carrier(const Map& map, World& world)
        : map_(map), world_(world), body_(body_of(here(), world.player)), around_(around(here(), body_)) {}

    void run() {
        const double floor_before = clearance(here(), body_, around_.sectors).floor_z;
        make_room();
        const Clearance next = clearance(then(), body_, around_.sectors);
        stand_on(floor_before, next.floor_z);
        Player& player = world_.player;
        player.height = std::clamp(next.ceiling_z - player.feet_z, 0.0, player.height);
        player.eye_z = eye_z_of(player, next.ceiling_z);
    }

private:
    Instant here() const { return now(map_, world_); }
    Instant then() const { return {map_, world_.history, static_cast<double>(world_.tick + 1)}; }

    /// How much room the body would have at the next tick [m].
    double room() const {
        const Clearance next = clearance(then(), body_, around_.sectors);
        return next.ceiling_z - std::max(next.floor_z, body_.feet_z);
    }

    /// The changes that narrow the sectors around the body in this tick.
    Movers movers() const {
        Movers found;
        for (const ReachedSector& reached : around_.sectors) {
            const Heights before = heights_of(here(), reached.sector), after = heights_of(then(), reached.sector);
            if (after.floor_z > before.floor_z) add(reached.sector, Channel::floor, found);
            if (after.ceiling_z < before.ceiling_z) add(reached.sector, Channel::ceiling, found);
        }
        return found;
    }

    void add(SectorId sector, Channel channel, Movers& found) const {
        const Change* change = change_of(then(), sector, channel);
        if (change && change->holds_up_bob()) change = nullptr;
        const SectorId leader = map_[sector].leader;
        const auto is_it = [&](const Mover& m) { return m.sector == leader && m.channel == channel; };
        if (std::none_of(found.begin(), found.end(), is_it))
            found.push_back({leader, channel, change, change && crushes(map_, *change)});
    }

    /// What crushes may go on while there is room for who is crushed; then everything answers.
    void make_room() {
        if (is_at_most(body_.height, room())) return;
        const Movers found = movers();
        const bool some_crush = std::any_of(found.begin(), found.end(), [](const Mover& m) { return m.crushes; });
        if (some_crush) hurt();
        const bool is_crushed_to_the_last = !is_at_most(kCrushedHeight, room());
        ShortList<Change, 8> answers;
        for (const Mover& mover : found)
            if (!mover.change)
                continue;
            else if (!mover.crushes || is_crushed_to_the_last)
                answers.push_back(answer_to(here(), *mover.change, world_.tick));
            else if (const std::optional<Change> slow = slowed(here(), *mover.change, world_.tick))
                answers.push_back(*slow);
        for (const Change& answer : answers) world_.history.add(map_, answer);
        for (const Mover& mover : found)
            if (!mover.change) hold_up_bob(map_, world_.history, mover.sector, mover.channel, world_.tick);
    }

    void hurt() {
        if (world_.tick % kTicksBetweenCrushes != 0) return;
        world_.health = std::max(0, world_.health - kCrushDamage);
        world_.message =
            PlayerMessage{world_.health > 0 ? PlayerMessageKind::hurt : PlayerMessageKind::died, 0, world_.tick};
    }

    /// On a floor that sinks no faster than one walks down a step, and on any that rises.
    void stand_on(double before, double after) {
        Player& player = world_.player;
        const bool stands = player.on_ground && player.feet_z <= before;
        if (after > player.feet_z || (stands && is_at_most(before - after, kMaxStep))) player.feet_z = after;
    }

    const Map& map_;
    World& world_;
    Body body_;
    Reach around_;
};

}  // namespace

void move_flats(const Map& map, World& world) {
    if (world.history.changes().empty() && !map.has_bobs) return;
    Carrier(map, world).run();
}

}  // namespace enfilade
