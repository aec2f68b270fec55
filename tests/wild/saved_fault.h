// A fault as files, so that it can be looked at again: the world, and the pose or the input that shows it.
#pragma once
#include <string>

#include "base/result.h"
#include "formats/map_file.h"
#include "wild/trial.h"

namespace enfilade::test {

/// A world with a fault in it.
struct FaultyWorld {
    MapFile file;
    Fault fault;
    std::string sector;  ///< where the fault's pose is
    TrialPlan plan;
};

/// Whether the world is legal and still has it: in the same pose, by the same input, or by itself.
bool is_faulty(const FaultyWorld& world);

/// The same fault in a smaller world.
FaultyWorld shrunk(FaultyWorld world);

/// Writes map.toml, and pose.txt or input.tape, into the folder, which is made if need be.
Result<void> save(const FaultyWorld& world, const std::string& folder);

/// What save() wrote; `what` of its fault is found anew.
Result<FaultyWorld> load_fault(const std::string& folder);

}  // namespace enfilade::test
