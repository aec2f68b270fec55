#include "wild/saved_fault.h"

#include <cstdio>
#include <filesystem>

#include "base/files.h"
#include "formats/map_toml.h"
#include "space/trace.h"
#include "support/looks.h"
#include "support/map_builder.h"
#include "wild/shrink.h"

namespace enfilade::test {
namespace {

constexpr const char *kMap = "/map.toml", *kPose = "/pose.txt", *kTape = "/input.tape", *kSeed = "/seed.txt";

/// The numbers in hexadecimal, so that every bit comes back; then the sector.
std::string text_of(const HardPose& pose, const std::string& sector) {
    const View& v = pose.view;
    char text[400];
    std::snprintf(text, sizeof text, "%d %d %a %a %a %a %a %a %a %a %a %a\n", pose.size.width, pose.size.height,
                  v.eye.x, v.eye.y, v.eye_z, v.forward.x, v.forward.y, v.fov_degrees, v.pitch_tangent, v.stretch,
                  v.ray_offset.x, v.ray_offset.y);
    return text + sector;
}

Result<HardPose> pose_of(const std::string& text, std::string& sector) {
    HardPose pose;
    View& v = pose.view;
    const std::string numbers = text.substr(0, text.find('\n'));
    const int read = std::sscanf(numbers.c_str(), "%d %d %la %la %la %la %la %la %la %la %la %la", &pose.size.width,
                                 &pose.size.height, &v.eye.x, &v.eye.y, &v.eye_z, &v.forward.x, &v.forward.y,
                                 &v.fov_degrees, &v.pitch_tangent, &v.stretch, &v.ray_offset.x, &v.ray_offset.y);
    if (read < 10) return Error{kPose, "expected ten or twelve numbers, found " + std::to_string(read)};
    sector = text.substr(text.find('\n') + 1);
    return pose;
}

std::string fault_in_pose(const TrialMap& on, const HardPose& pose, const std::string& sector) {
    HardPose here = pose;
    for (std::size_t i = 0; i < on.map.sectors.size(); ++i) {
        here.view.sector = SectorId(i);
        if (on.map.sectors[i].name == sector && contains(on.map, here.view.sector, here.view.eye))
            return picture_fault(on, here);
    }
    return "";
}

/// What is wrong now; empty: nothing.
std::string fault_now(const FaultyWorld& world) {
    const TextureSet textures = textures_for(world.file);
    Findings findings;
    const std::optional<Map> map = build_map(world.file, textures, findings);
    if (!map) return "";
    const TrialMap on{*map, textures};
    std::vector<TickInput> inputs = world.fault.inputs;
    if (world.fault.pose) return fault_in_pose(on, *world.fault.pose, world.sector);
    return inputs.empty() ? ground_fault(on, world.plan.seed) : walk_fault(on, world.fault.motion, inputs);
}

}  // namespace

bool is_faulty(const FaultyWorld& world) { return !fault_now(world).empty(); }

FaultyWorld shrunk(FaultyWorld world) {
    FaultyWorld candidate = world;
    world.file = shrunk(std::move(world.file), [&](const MapFile& file) {
        candidate.file = file;
        return is_faulty(candidate);
    });
    world.fault.what = fault_now(world);
    return world;
}

Result<void> save(const FaultyWorld& world, const std::string& folder) {
    std::error_code failed;
    std::filesystem::create_directories(folder, failed);
    if (failed) return Error{folder, failed.message()};
    if (const Result<void> done = write_file(folder + kMap, write_map(world.file)); !done.ok()) return done.error();
    if (const Result<void> done = write_file(folder + kSeed, std::to_string(world.plan.seed)); !done.ok())
        return done.error();
    if (world.fault.pose) return write_file(folder + kPose, text_of(*world.fault.pose, world.sector));
    if (world.fault.inputs.empty()) return {};
    const Bytes tape = write_tape({.map = "map.toml",
                                   .map_hash = 0,
                                   .rate = ticks_per_second(world.fault.motion.rate),
                                   .is_naive = world.fault.motion.crossing == CrossingMethod::naive,
                                   .ticks = world.fault.inputs,
                                   .final_hash = {}});
    return write_file(folder + kTape, std::span<const std::byte>(tape));
}

Result<FaultyWorld> load_fault(const std::string& folder) {
    const auto map = read_file(folder + kMap), seed = read_file(folder + kSeed), pose = read_file(folder + kPose),
               tape = read_file(folder + kTape);
    if (!map.ok()) return map.error();
    FaultyWorld world;
    world.file = read_map(as_text(map.value())).map;
    if (seed.ok()) world.plan.seed = std::stoull(std::string(as_text(seed.value())));
    if (pose.ok()) {
        const auto read = pose_of(std::string(as_text(pose.value())), world.sector);
        if (!read.ok()) return read.error();
        world.fault.pose = read.value();
    }
    if (tape.ok()) {
        const auto read = read_tape(tape.value());
        if (!read.ok()) return read.error();
        world.fault.inputs = read.value().ticks;
        world.fault.motion = motion_of(read.value()).value_or(MotionDials());
    }
    world.fault.what = fault_now(world);
    return world;
}

}  // namespace enfilade::test
