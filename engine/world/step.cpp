#include "world/step.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "world/body.h"
#include "world/trigger_actions.h"
#include "world/world.h"

namespace enfilade {
namespace {

// What moves under, over and against the player in one tick.

/// How often who is crushed is hurt [ticks], and how much [points]: Doom's 10 points every 4 of its 35 tics a second.
constexpr std::uint64_t ticks_between_crushes(TickRate rate) { return (ticks_per_second(rate) * 4 + 17) / 35; }
constexpr int kCrushDamage = 10;

/// Something that comes nearer to a body in a sector around it.
struct Mover {
    SectorId sector;  ///< that leads its group
    Channel channel;
    const Change* change;  ///< none: it bobs
    bool crushes;
};
using Movers = ShortList<Mover, 8>;

/// The room that is left below a ceiling, also in the portals that the body is in [m]. A portal that closed on it all
/// the same is a wall beside it.
double room_above(const Instant& now, Body body, double ceiling_z, const EnteredPortals& entered) {
    body.ceiling_z = ceiling_z;
    const double in_portals = height_in(now, body, entered);
    return std::min(ceiling_z - body.feet_z, in_portals < kCrushedHeight ? kWorldLimit : in_portals);
}

class Carrier {
public:
    Carrier(const Map& map, World& world) : map_(map), world_(world), placed_(placed_body_of(here(), world.player)) {}

    void run() {
        const double floor_before = placed_.free.floor_z;
        make_room();
        const Clearance next = clearance(then(), body_, around_.sectors);
        stand_on(floor_before, std::max(next.floor_z, lowest_feet_in(then(), entered_)));
        Player& player = world_.player;
        Body there = body_;
        there.feet_z = player.feet_z;
        // Who sinks may come to be below a thing that was beside him.
        const bool is_same = there.feet_z == body_.feet_z;
        const double ceiling_z = (is_same ? next : clearance(then(), there, around_.sectors)).ceiling_z;
        player.height = std::clamp(room_above(then(), there, ceiling_z, entered_), 0.0, player.height);
        player.eye_z = eye_z_of(player, ceiling_z);
    }

private:
    Instant here() const { return now(map_, world_); }
    Instant then() const { return {map_, world_.history, static_cast<double>(world_.tick + 1)}; }

    /// How much room the body would have at the next tick, also in the portals that it is in [m].
    double room() const {
        const Clearance next = clearance(then(), body_, around_.sectors);
        Body there = body_;
        there.feet_z = std::max(next.floor_z, body_.feet_z);
        there.ceiling_z = next.ceiling_z;
        return std::min(next.ceiling_z - there.feet_z, height_in(then(), there, entered_));
    }

    /// The changes that narrow the sectors around the body in this tick.
    Movers movers() const {
        Movers found;
        for (const ReachedSector& reached : around_.sectors) add_changes_of(reached.sector, found);
        for (const EnteredPortal& entered : entered_) add_changes_of(map_[entered.portal].behind, found);
        return found;
    }

    void add_changes_of(SectorId sector, Movers& found) const {
        const Heights before = heights_of(here(), sector), after = heights_of(then(), sector);
        if (after.floor_z > before.floor_z) add(sector, Channel::floor, found);
        // A floor that carried the ceiling lets it down.
        const Channel above = before.ceiling_z > before.floor_z ? Channel::ceiling : Channel::floor;
        if (after.ceiling_z < before.ceiling_z) add(sector, above, found);
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
        ShortList<Answer, 8> answers;
        for (const Mover& mover : found)
            if (!mover.change)
                continue;
            else if (!mover.crushes || is_crushed_to_the_last)
                answers.push_back(answer_to(here(), *mover.change, world_.tick));
            else if (const std::optional<Change> slow = slowed(here(), *mover.change, world_.tick))
                answers.push_back({*slow, {}});
        for (const auto& [at_once, later] : answers) {
            world_.history.add(map_, at_once);
            if (later) world_.history.add(map_, *later);
        }
        for (const Mover& mover : found)
            if (!mover.change) hold_up_bob(map_, world_.history, mover.sector, mover.channel, world_.tick);
    }

    void hurt() {
        if (world_.tick % ticks_between_crushes(world_.history.rate()) != 0) return;
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
    PlacedBody placed_;
    const Body& body_ = placed_.body;
    const Reach& around_ = placed_.around;
    const EnteredPortals& entered_ = placed_.entered;
};

/// Lets floors and ceilings around the player go from this tick to the next: what would leave too little room turns
/// round, waits, or crushes, by its own rules; who stands on a floor goes with it. Afterwards the player has room at
/// tick + 1, and its feet and height are those of then.
/// Cost: the sectors that the body overlaps, however many move elsewhere; none in a map where nothing ever changed or
/// bobs.
void move_flats(const Map& map, World& world) {
    if (world.history.changes().empty() && !map.has_bobs) return;
    Carrier(map, world).run();
}

/// What a tick does to what dies away with time.
struct Pace {
    double seconds;  ///< that a tick lasts
    /// Share of the difference between the speed one has and the speed one wants that a tick makes up for [1]. On the
    /// ground: 90 % within a sixth of a second, both getting going and coming to rest. In the air: hardly any.
    double grip_on_ground, grip_in_air;
    /// Share of the eye's lag that is left [1]: nine tenths of a step are made up for in a fifth of a second.
    double lag_left;
};

/// At 60 ticks a second by choice; at others what makes a second the same: 0.8, 0.98 and 0.82 to the power of 60 /
/// rate, worked out beforehand, because no two machines need agree on powers.
constexpr Pace pace_at(TickRate rate) {
    switch (rate) {
        case TickRate::hz60: break;
        case TickRate::hz35: return {tick_seconds(rate), 0.31786780270917064, 0.03404034682775573, 0.7116268377526048};
        case TickRate::hz140:
            return {tick_seconds(rate), 0.09120247152184588, 0.008620927975755803, 0.9184659904270328};
    }
    return {tick_seconds(TickRate::hz60), 0.2, 0.02, 0.82};
}

/// Below this, who does not want to go anywhere stands [m/s]: a quarter of a millimetre a tick. Without it the speed
/// would halve for ever, down to denormal numbers, which some machines flush to zero and some do not.
constexpr double kStandstill = 0x1p-6;

/// [m/s^2]. More than on Earth, less than Doom's 38: falls look right at the pace people run at here.
constexpr double kGravity = 16;
constexpr double kMaxFallSpeed = 40;  ///< [m/s]

/// How fast one stands up and crouches [m/s]: 0.15 s from one to the other.
constexpr double kStanceSpeed = 5;

constexpr double kLeastLag = 0x1p-10;  ///< less than this is none [m]

constexpr double kFullPace = 127;  ///< InputRecord's

void look(Player& player, const TickInput& input) {
    player.yaw.steps += static_cast<std::uint32_t>(input.yaw_steps);
    const std::int64_t pitch = std::int64_t{player.pitch_steps} + input.pitch_steps;
    player.pitch_steps = static_cast<std::int32_t>(std::clamp<std::int64_t>(pitch, -kMaxPitchSteps, kMaxPitchSteps));
}

/// Whether a wall holds the body; the exit of a one-way portal holds nobody who stands in it.
bool is_held(const Instant& now, const Body& body) {
    const Reach found = around(now, body);
    return std::ranges::any_of(found.walls, [&](const ReachedWall& wall) { return !is_one_way_exit(now.map, wall); });
}

/// Grows or shrinks towards the height asked for, as far as the ceiling and the portals that the body is in let it.
void stand_or_crouch(const Instant& now, Player& player, bool crouch, double seconds) {
    const PlacedBody placed = placed_body_of(now, player);
    const Body& body = placed.body;
    const double wanted = crouch ? kCrouchedHeight : kStandingHeight, change = kStanceSpeed * seconds;
    double grown = std::clamp(wanted, player.height - change, player.height + change);
    if (grown > player.height) {
        grown = std::clamp(height_in(now, body, placed.entered), player.height, grown);
    } else if (grown < player.height) {
        // Who is low enough for the way back of the exit one stands in has to fit behind it, too.
        Body lower = body;
        lower.height = grown;
        if (is_held(now, lower) && !is_held(now, body)) grown = player.height;
    }
    player.height = std::clamp(body.ceiling_z - player.feet_z, 0.0, grown);
}

/// The velocity asked for, in the space of the player.
Vec2 wish(const Player& player, const TickInput& input) {
    const Vec2 ahead = direction(player.yaw);
    Vec2 way = ahead * (input.forward / kFullPace) + right_of(ahead) * (input.strafe / kFullPace);
    const double pace = std::sqrt(dot(way, way));
    if (pace > 1) way = way * (1 / pace);
    if (input.buttons & kButtonCrouch) return way * kCrouchSpeed;
    return way * (input.buttons & kButtonRun ? kRunSpeed : kWalkSpeed);
}

void speed_up(Player& player, Vec2 wish, const Pace& pace) {
    const double grip = player.on_ground ? pace.grip_on_ground : pace.grip_in_air;
    player.velocity = player.velocity + (wish - player.velocity) * grip;
    const bool is_slow = dot(player.velocity, player.velocity) < kStandstill * kStandstill;
    if (is_slow && wish == Vec2{}) player.velocity = {};
}

void turn_by(Player& player, std::uint64_t fine_turn) {
    const std::uint64_t yaw = (std::uint64_t{player.yaw.steps} << 32 | player.yaw_rest) + fine_turn;
    player.yaw.steps = static_cast<std::uint32_t>(yaw >> 32);
    player.yaw_rest = static_cast<std::uint32_t>(yaw);
}

/// Everything the player has is carried into the space where the walk ended.
void arrive(Player& player, const Walk& walk) {
    player.place = walk.end;
    player.velocity = walk.velocity;
    player.feet_z += walk.passage.rise;
    turn_by(player, fine_turn_of({walk.passage.c, walk.passage.s}));
}

/// Up a step at once, down a step at once, deeper under gravity; the eye follows. floor_z: what the feet stop at.
void step_or_fall(Player& player, double floor_z, double seconds) {
    const double above = player.feet_z - floor_z;
    const bool takes_step = above <= 0 || (player.on_ground && is_at_most(above, kMaxStep));
    if (takes_step) {
        player.eye_lag += above;
        player.feet_z = floor_z;
    } else {
        player.fall_speed = std::min(player.fall_speed + kGravity * seconds, kMaxFallSpeed);
        player.feet_z = std::max(floor_z, player.feet_z - player.fall_speed * seconds);
    }
    player.on_ground = player.feet_z <= floor_z;
    if (player.on_ground) player.fall_speed = 0;
}

/// One tick of walking, and what it sets off. Who stands still crosses nothing.
void go(const Map& map, World& world, Vec2 velocity, bool keeps_velocity) {
    if (velocity == Vec2{}) return;
    const Walk walked =
        walk(now(map, world), body_of(now(map, world), world.player), velocity, tick_seconds(world.history.rate()));
    const Vec2 own = walked.passage.turn(world.player.velocity);
    arrive(world.player, walked);
    if (!keeps_velocity) world.player.velocity = own;
    world.passage = then(world.passage, walked.passage);
    pass(map, world, walked.crossings);
}

/// A floor whose picture moves takes along who stands on it.
void ride(const Map& map, World& world) {
    const Flat& floor = map[world.player.place.sector].floor;
    if (floor.carries && world.player.on_ground) go(map, world, map[floor.surface].scroll, false);
}

void settle_eye(Player& player, double ceiling_z, const Pace& pace) {
    player.eye_lag = std::clamp(player.eye_lag * pace.lag_left, -kMaxStep, kMaxStep);
    if (std::fabs(player.eye_lag) < kLeastLag) player.eye_lag = 0;
    player.eye_z = eye_z_of(player, ceiling_z);
}

/// What the floor under the feet does to the player: it hurts, or it is a secret.
void feel_the_floor(const Map& map, World& world) {
    const SectorId here = world.player.place.sector, found = map[here].leader;
    if (!world.player.on_ground) return;
    if (map[here].secret && !std::binary_search(world.secrets.begin(), world.secrets.end(), found)) {
        world.secrets.insert(std::lower_bound(world.secrets.begin(), world.secrets.end(), found), found);
        world.message = PlayerMessage{PlayerMessageKind::secret, here.index, world.tick};
    }
    const bool is_time = world.tick % ticks_per_second(world.history.rate()) == 0;
    const int damage = map[here].damage > 0 && is_time ? damage_of(now(map, world), here) : 0;
    if (damage == 0 || world.health == 0) return;
    world.health = std::max(0, world.health - damage);
    world.message = PlayerMessage{world.health > 0 ? PlayerMessageKind::hurt : PlayerMessageKind::died, 0, world.tick};
}

}  // namespace

void step(const Map& map, World& world, const TickInput& played) {
    const TickInput input = world.health > 0 ? played : TickInput{};
    world.before = world.player;
    world.passage = {};
    Player& player = world.player;
    const Pace pace = pace_at(world.history.rate());
    look(player, input);
    if (input.buttons & ~world.held & kButtonUse) use_what_is_ahead(map, world);
    world.held = input.buttons;
    move_flats(map, world);
    ++world.tick;

    stand_or_crouch(now(map, world), player, input.buttons & kButtonCrouch, pace.seconds);
    speed_up(player, wish(player, input), pace);
    ride(map, world);
    go(map, world, player.velocity, true);

    const Instant next = now(map, world);
    const PlacedBody placed = placed_body_of(next, player);
    Clearance free = placed.free;
    const double feet_z = player.feet_z;
    step_or_fall(player, std::max(free.floor_z, lowest_feet_in(next, placed.entered)), pace.seconds);
    if (placed.body.radius < kBodyRadius || player.feet_z != feet_z) free = come_to_rest(next, player);
    settle_eye(player, free.ceiling_z, pace);
    touch_what_is_near(map, world);
    feel_the_floor(map, world);
}

Timeline::Timeline(World start) : world_(std::move(start)) { keep(); }

void Timeline::keep() {
    History history = std::exchange(world_.history, {});
    kept_.push_back({world_, history.length()});
    world_.history = std::move(history);
}

void Timeline::play(const Map& map, const TickInput& input) {
    step(map, world_, input);
    inputs_.push_back(input);
    if (inputs_.size() % kBetweenKept == 0) keep();
}

World Timeline::after(const Map& map, std::size_t ticks) const {
    const Kept& kept = kept_[ticks / kBetweenKept];
    World world = kept.world;
    world.history = world_.history.beginning(kept.length);
    for (std::size_t tick = ticks - ticks % kBetweenKept; tick < ticks; ++tick) step(map, world, inputs_[tick]);
    return world;
}

void Timeline::go_back(const Map& map, std::size_t ticks) {
    world_ = after(map, ticks);
    inputs_.resize(ticks);
    kept_.resize(ticks / kBetweenKept + 1);
}

}  // namespace enfilade
