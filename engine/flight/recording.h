// What a flythrough looked like when it was recorded: the hashes beside its script, and those of its frames now.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "base/files.h"
#include "base/result.h"
#include "flight/flight.h"
#include "formats/frame_hashes.h"

namespace enfilade {

/// The hashes beside a script: "tour.hashes" of "tour.toml".
std::string hashes_path(const std::string& script_path);

/// What was recorded of the script.
Result<FrameRecording> read_recording(const std::string& script_path, const FileReader& read);

/// An error where the recording can never be equal to what the plan draws: it is of pictures of another size or
/// renderer, or of another number of frames than the flight has.
Result<void> refuse_recording(const FrameRecording& recording, const DrawPlan& plan, int flight_frames,
                              const std::string& script_path);

/// How many frames a plan draws.
inline std::size_t frames_of(const DrawPlan& plan) { return std::size_t(plan.last - plan.first + 1); }

/// The hash of every frame of the plan, in order; `also` sees every frame, too, as draw_frames() hands them over.
Result<std::vector<std::uint64_t>> hash_frames(const FlightScene& scene, const DrawPlan& plan,
                                               const FrameTaker& also = {});

}  // namespace enfilade
