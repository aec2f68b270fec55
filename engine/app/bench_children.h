// What `enfilade bench` lets other processes measure: another program beside this one, and instructions.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace enfilade {

// Two programs that take turns: what each says of one pass over all frames, and how they compare.

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

/// What the children are told to measure.
struct ChildBench {
    std::vector<std::string> subjects;  ///< at least one
    std::vector<std::string> options;   ///< of `bench`, but for --rounds and --csv
    std::size_t rounds = 1;             ///< >= 1
    std::size_t pixels = 1;             ///< of one picture
};

/// This program and the other one measure the same in turn, pass by pass, each as a process of its own, this one
/// first in every other pass. The comparison as a table, or an error where the other one cannot: too old, perhaps.
Result<std::string> compare_with(const std::string& other, const ChildBench& bench);

/// The function whose instructions count_instructions() counts; see bench_command.cpp.
inline constexpr const char* kMeasuredFunction = "*draw_measured*";

/// Instructions that the renderer takes for a pixel of each subject, counted by valgrind on one thread, as a table: the
/// difference of two runs, one of which draws every frame once more. Takes about fifty times as long as drawing.
/// An error where valgrind is not installed.
Result<std::string> count_instructions(const ChildBench& bench);

}  // namespace enfilade
