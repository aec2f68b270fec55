#include "flight/flight.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "formats/text_parts.h"
#include "map/sector_finder.h"
#include "math/vec.h"
#include "space/trace.h"
#include "world/input.h"
#include "world/world.h"

namespace enfilade {

namespace {

constexpr double kStepsPerDegree = 4294967296.0 / 360;

Finding error_at(TextPlace place, std::string code, std::string sentence) {
    return {place, Severity::error, std::move(code), std::move(sentence)};
}

std::string numbered(std::size_t leg) { return "leg " + std::to_string(leg + 1); }

std::string rounded_text(Vec2 p) {
    const auto metres = [](double x) {
        std::string text = std::to_string(std::round(x * 1000) / 1000);
        text.erase(text.find_last_not_of('0') + 1);
        if (text.ends_with('.')) text.pop_back();
        return text;
    };
    return "(" + metres(p.x) + ", " + metres(p.y) + ")";
}

std::int64_t rounded(double x) { return static_cast<std::int64_t>(std::floor(x + 0.5)); }

/// The turn from one yaw to another, the shorter way round, right where both are as long.
std::int64_t shorter_turn(Angle from, Angle to) {
    const std::int64_t right = (to - from).steps;
    return right <= std::int64_t{1} << 31 ? right : right - (std::int64_t{1} << 32);
}

/// The yaw that looks along v, which is not (0, 0).
Angle yaw_along(Vec2 v) { return {static_cast<std::uint32_t>(rounded(turn_of(v) * 4294967296.0))}; }

/// What a way through links does to a yaw.
Angle turned_by(const Rigid& passage, Angle yaw) { return yaw + yaw_along({passage.c, passage.s}); }

double eased(Ease ease, double fraction) {
    return ease == Ease::linear ? fraction : fraction * fraction * (3 - 2 * fraction);
}

double between(double from, double to, double fraction) { return from + (to - from) * fraction; }

/// The pose after a part of the leg, in the space it is then in.
CameraPose pose_within(const Map& map, const CameraLeg& leg, double fraction) {
    const Vec2 at = leg.from.place.point + (leg.to - leg.from.place.point) * fraction;
    const Trace way = trace(map, leg.from.place, snap_to_point_grid(at));
    const auto turn = static_cast<std::uint32_t>(rounded(static_cast<double>(leg.turn_steps) * fraction));
    return {way.end, way.passage.apply_height(between(leg.from.eye_z, leg.to_z, fraction)),
            turned_by(way.passage, leg.from.yaw + Angle{turn}),
            between(leg.from.pitch_degrees, leg.to_pitch_degrees, fraction)};
}

/// From records to poses, one leg after the other.
class LegPlanner {
public:
    LegPlanner(const ScriptFile& script, const Map& map, Findings& findings)
        : script_(script), map_(map), findings_(findings) {}

    std::optional<CameraPose> start() {
        const StartRecord& record = script_.start;
        CameraPose pose;
        if (map_.player)
            pose = {{map_.player->sector, map_.player->position}, map_.player->eye_z, map_.player->yaw, 0};
        else if (!record.x || !record.z)
            return fail(record.place, "no-start", "the map has no player to start from; give start x, y and z");
        if (record.x) pose.place.point = snap_to_point_grid(Vec2{*record.x, *record.y});
        pose.eye_z = record.z.value_or(pose.eye_z);
        if (record.yaw_degrees) pose.yaw = Angle::from_degrees(*record.yaw_degrees);
        pose.pitch_degrees = record.pitch_degrees.value_or(0);
        return in_sector(pose);
    }

    struct Planned {
        CameraLeg leg;
        CameraPose end;
    };

    /// The leg with that number, which starts at `from`.
    std::optional<Planned> leg(std::size_t number, std::int64_t begin_us, const CameraPose& from) {
        const LegRecord& record = script_.legs[number];
        CameraLeg leg{begin_us, begin_us + rounded(record.seconds * 1e6), from, from.place.point};
        if (record.to) leg.to = snap_to_point_grid(*record.to);
        leg.to_z = record.to_z.value_or(from.eye_z);
        leg.to_pitch_degrees = record.pitch_degrees.value_or(from.pitch_degrees);
        leg.ease = record.ease;
        if (record.look_at && snap_to_point_grid(*record.look_at) == leg.to) {
            fail(record.place, "look-at-self", numbered(number) + " looks at the very point where it ends");
            return {};
        }
        leg.turn_steps = turn_of_leg(record, from.yaw, leg.to);
        const auto arrived = leg.begin_us == leg.end_us ? cut(number, leg) : glide(number, leg);
        if (!arrived) return {};
        return Planned{leg, *arrived};
    }

private:
    std::optional<CameraPose> fail(TextPlace place, std::string code, std::string sentence) {
        findings_.push_back(error_at(place, std::move(code), std::move(sentence)));
        return {};
    }

    std::optional<CameraPose> in_sector(CameraPose pose) {
        const StartRecord& record = script_.start;
        if (!record.sector.empty()) {
            pose.place.sector = sector_named(map_, record.sector);
            if (!pose.place.sector)
                return fail(record.place, "unknown-sector", "the map has no sector named " + in_quotes(record.sector));
        } else if (record.x) {
            pose.place.sector = locate(map_, pose.place.point);
        }
        if (pose.place.sector && contains(map_, pose.place.sector, pose.place.point)) return pose;
        return fail(record.place, "start-outside",
                    "expected a start inside " + (record.sector.empty() ? "the map" : in_quotes(record.sector)) +
                        "; found " + rounded_text(pose.place.point));
    }

    static std::int64_t turn_of_leg(const LegRecord& record, Angle yaw, Vec2 end) {
        if (record.turn_degrees) return rounded(*record.turn_degrees * kStepsPerDegree);
        if (record.look_degrees) return shorter_turn(yaw, Angle::from_degrees(*record.look_degrees));
        if (record.look_at) return shorter_turn(yaw, yaw_along(snap_to_point_grid(*record.look_at) - end));
        return 0;
    }

    std::optional<CameraPose> glide(std::size_t number, const CameraLeg& leg) {
        const Trace way = trace(map_, leg.from.place, leg.to);
        if (way.stopped)
            return fail(script_.legs[number].place, "leg-blocked",
                        numbered(number) + " runs into a wall of " + in_quotes(map_[map_[way.stopped].sector].name) +
                            " near " + rounded_text(way.end.point) + " on its way to " + rounded_text(leg.to));
        return pose_within(map_, leg, 1);
    }

    /// A jump: the end is looked for where it is, first in the sector the camera is in.
    std::optional<CameraPose> cut(std::size_t number, const CameraLeg& leg) {
        const SectorId stay = leg.from.place.sector;
        const SectorId sector = contains(map_, stay, leg.to) ? stay : locate(map_, leg.to);
        if (!sector)
            return fail(script_.legs[number].place, "cut-outside",
                        numbered(number) + " jumps to " + rounded_text(leg.to) + ", which is in no sector");
        const Angle yaw = leg.from.yaw + Angle{static_cast<std::uint32_t>(leg.turn_steps)};
        return CameraPose{{sector, leg.to}, leg.to_z, yaw, leg.to_pitch_degrees};
    }

    const ScriptFile& script_;
    const Map& map_;
    Findings& findings_;
};

}  // namespace

std::optional<CameraPath> CameraPath::plan(const ScriptFile& script, const Map& map, Findings& findings) {
    LegPlanner planner(script, map, findings);
    const auto start = planner.start();
    if (!start) return {};
    CameraPath path;
    path.end_ = *start;
    for (std::size_t i = 0; i < script.legs.size(); ++i) {
        const auto planned = planner.leg(i, path.length_us(), path.end_);
        if (!planned) return {};
        path.legs_.push_back(planned->leg);
        path.end_ = planned->end;
    }
    return path;
}

std::optional<std::size_t> CameraPath::leg_at(FrameTime time) const {
    const auto started = [&](const CameraLeg& leg) { return leg.begin_us * time.rate <= time.frame * 1'000'000; };
    const auto later = std::ranges::partition_point(legs_, started);
    if (later == legs_.begin()) return {};
    return static_cast<std::size_t>(later - legs_.begin()) - 1;
}

CameraPose CameraPath::pose_at(const Map& map, FrameTime time) const {
    const auto number = leg_at(time);
    if (!number) return end_;
    const CameraLeg& leg = legs_[*number];
    const std::int64_t passed = time.frame * 1'000'000 - leg.begin_us * time.rate;  // [us / rate]
    const std::int64_t whole = (leg.end_us - leg.begin_us) * time.rate;
    if (passed >= whole) return *number + 1 < legs_.size() ? legs_[*number + 1].from : end_;
    return pose_within(map, leg, eased(leg.ease, static_cast<double>(passed) / static_cast<double>(whole)));
}

namespace {

/// Of a tape that can be played.
Result<MotionDials> motion_of_played(const Tape& tape) {
    const auto motion = motion_of(tape);
    if (!motion)
        return Error{"", "expected a tape of 60, 35 or 140 ticks a second; found " + std::to_string(tape.rate)};
    if (tape.ticks.size() > kMaxTapeSeconds * tape.rate) return Error{"", "the tape is longer than a day"};
    return *motion;
}

}  // namespace

Result<TapePath> TapePath::plan(const Map& map, Tape tape) {
    const Result<MotionDials> motion = motion_of_played(tape);
    if (!motion.ok()) return motion.error();
    auto world = start_of(map, motion.value());
    if (!world) return Error{"", "the map has no player to walk"};
    Timeline timeline(std::move(*world));
    for (const TickInput& input : tape.ticks) timeline.play(map, input);
    if (!tape.final_hash || hash(timeline.world()) == *tape.final_hash) return TapePath(std::move(timeline));
    return Error{"", "the walk ends elsewhere than when it was recorded; the map, or how things move, has changed"};
}

CameraPose TapePath::pose_at(const Map& map, FrameTime time) const {
    const std::int64_t scaled = time.frame * rate();
    const auto before = static_cast<std::size_t>(scaled / time.rate);
    const double part = static_cast<double>(scaled % time.rate) / time.rate;
    const std::size_t ticks = timeline_.inputs().size();
    const World world = timeline_.after(map, std::min(before + 1, ticks));
    const Eye eye = eye_between_ticks(map, world, before < ticks ? part : 1);
    return {eye.place, eye.z, eye.yaw, eye.pitch_steps * (360 / 4294967296.0)};
}

std::int64_t TapePath::length_us() const {
    return static_cast<std::int64_t>(timeline_.inputs().size()) * 1'000'000 / rate();
}

}  // namespace enfilade
