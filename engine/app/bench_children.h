// What `enfilade bench` lets other processes measure: another program beside this one, and instructions.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "base/result.h"

namespace enfilade {

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
