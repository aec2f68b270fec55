// Two programs that take turns: what each says of one pass over all frames, and how they compare.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace enfilade {

/// One frame of one pass.
struct PassFrame {
    std::string subject;
    int number = 0;
    std::int64_t ns = 0;
    std::optional<std::string> hash;  ///< of the picture; none where the program is too old to tell
    bool is_same_frame(const PassFrame& other) const { return subject == other.subject && number == other.number; }
};

/// The rows of bench_csv() in what a program said, which may hold other lines: words for people. An error where there
/// is no such row. program : for the message. Any bytes are safe.
Result<std::vector<PassFrame>> read_pass(const std::string& program, std::string_view said);

/// What two programs said in turn; all passes are of the same frames.
using Passes = std::vector<std::vector<PassFrame>>;

/// An error where the programs, or two passes of one, did not draw the same frames.
Status compare_frames(const std::array<std::string, 2>& programs, const std::array<Passes, 2>& passes);

/// A line for each subject: the means over its frames of each program's minimum and median, the ratios of the first
/// program's to the second's, and how many pictures differ; last, the means over the subjects.
/// passes : as compare_frames() wants them, each with at least one.
std::string comparison_table(const std::array<Passes, 2>& passes);

}  // namespace enfilade
