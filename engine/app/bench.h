// How long pictures take to draw: many of them, over and over and in turn, so that what else the machine does troubles
// all of them alike.
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "base/result.h"

namespace enfilade {

/// One picture of a map or script.
struct BenchFrame {
    std::size_t subject = 0;  ///< which of those that are measured
    int number = 0;           ///< of the frame; a map has one
    std::int64_t minimum_ns = 0, median_ns = 0;
};

/// Draws one frame of a subject and says how long that alone took [ns].
using TimedDrawing = std::function<Result<std::int64_t>(std::size_t subject, int number)>;

/// The frames of subjects that have so many, in the order in which they are drawn: one of each in turn.
std::vector<BenchFrame> frames_in_turn(const std::vector<int>& counts);

/// Draws all frames `rounds` times, >= 1, and once before, uncounted, so that no frame pays for memory that grows.
/// Shows on a terminal how far it is. The first error ends it.
Status measure(std::vector<BenchFrame>& frames, std::size_t rounds, const TimedDrawing& draw);

/// `subject,frame,minimum_ns,median_ns`, a line for each frame. Subjects with a comma, quote or line end are quoted.
std::string bench_csv(const std::vector<std::string>& subjects, const std::vector<BenchFrame>& frames);

/// A line for each subject: how many frames, the means of their minimum and median, and the slowest.
std::string bench_table(const std::vector<std::string>& subjects, const std::vector<BenchFrame>& frames);

}  // namespace enfilade
