// Everything that runs on a map, run on one map, and what is wrong first.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "map/textures.h"
#include "wild/hard_poses.h"
#include "world/input.h"

namespace enfilade::test {

/// How much is tried.
struct TrialPlan {
    std::uint64_t seed = 0;
    int poses = 4;
    PictureSize largest{48, 32};  ///< of a picture
    int ticks = 120;              ///< walked
};

/// What was wrong, and where. What is neither seen from a pose nor met on a walk is wrong with the map alone.
struct Fault {
    std::string what;
    std::optional<HardPose> pose;
    std::vector<TickInput> inputs;  ///< from the player's start; the last is the one after which it is wrong
    MotionDials motion = {};
};

/// A map that was built, and all its pictures.
struct TrialMap {
    const Map& map;
    const TextureSet& textures;
};

/// What the work finds wrong; empty: nothing. A contract that it breaks is as wrong as anything.
std::string what_is_wrong(const std::function<std::string()>& work);

/// Pictures by column and reference, triangles, ways of sound, the automap, a walk with everything moving, and back.
std::optional<Fault> first_fault(const TrialMap& on, const TrialPlan& plan);

/// Runs, turns, crouches and uses what there is, and changes its mind every now and then.
std::vector<TickInput> random_inputs(int ticks, Random& random);

/// Each rate by exact crossings, and by naive ones every eighth time.
MotionDials random_motion(Random& random);

/// What is wrong with the picture; empty: nothing. Column against reference: each pixel once, surfaces and colours.
std::string picture_fault(const TrialMap& on, const HardPose& pose);

/// What is wrong after one of the ticks; empty: nothing. The fault's inputs end with that tick.
std::string walk_fault(const TrialMap& on, const MotionDials& motion, std::vector<TickInput>& inputs);

/// What is wrong with the map by itself: triangles, sound, bodies, the automap; empty: nothing.
std::string ground_fault(const TrialMap& on, std::uint64_t seed);

}  // namespace enfilade::test
