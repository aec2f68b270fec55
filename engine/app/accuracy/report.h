// The report of `enfilade accuracy`: a table for programs, a page for people and a picture.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/accuracy/errors.h"
#include "app/accuracy/experiment.h"
#include "base/result.h"

namespace enfilade {

/// One setting in one scene.
struct AccuracyRow {
    PoseKind poses = PoseKind::random;
    AccuracySetting setting;
    AccuracyErrors errors;
    AccuracyPrice price;
};

/// One map with all settings.
struct AccuracyScene {
    std::string name;            ///< of the file, without folder and ending
    std::uint64_t map_hash = 0;  ///< hash_of_bytes() of the file
    std::vector<AccuracyRow> rows;
};

/// A line for each row, with a line of names above.
std::string accuracy_csv(const std::vector<AccuracyScene>& scenes);

/// The page, in Markdown. command: that made it.
std::string accuracy_page(const std::vector<AccuracyScene>& scenes, const std::string& command);

/// What gnuplot is to be told, with the data: error over price, of all scenes and of each; pictures in SVG. folder:
/// where they go: accuracy.svg and scenes.svg.
std::string accuracy_plot(const std::vector<AccuracyScene>& scenes, const std::string& folder);

/// Nothing where every promise is kept and exact pictures have no fault; else the first that is not.
Result<void> check_promises(const std::vector<AccuracyScene>& scenes);

// The report for programs.

/// How a report came about.
struct AccuracyRun {
    std::string command;
    bool is_quick = false;
    std::uint64_t program_hash = 0;  ///< of the program's file
};

/// maps/accuracy.schema.json: machine, compiler and flags, and each row with the command that repeats its price.
std::string accuracy_json(const AccuracyRun& run, const std::vector<AccuracyScene>& scenes);

/// What accuracy_json() wrote. path: for messages. Any bytes are safe.
struct ReadAccuracy {
    AccuracyRun run;
    std::vector<AccuracyScene> scenes;
};
Result<ReadAccuracy> read_accuracy_json(const std::string& path, std::string_view text);

/// Nothing where these scenes are in the report with the same errors, whatever the prices; else the first that is not.
Result<void> compare_errors(const std::string& path, const std::vector<AccuracyScene>& report,
                            const std::vector<AccuracyScene>& scenes);

}  // namespace enfilade
