// The report of `enfilade accuracy`: a table for programs, a page for people and a picture.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/accuracy/experiment.h"
#include "base/result.h"

namespace enfilade {

/// What a setting costs in one scene.
struct AccuracyPrice {
    double minimum_ns = 0, median_ns = 0;  ///< per pixel
    double low_ratio = 1, high_ratio = 1;  ///< to exact in the same round: between them lie half of the rounds
    std::optional<double> instructions;    ///< per pixel; none: not counted
};

/// One setting in one scene.
struct AccuracyRow {
    std::string scene;
    PoseKind poses = PoseKind::random;
    AccuracySetting setting;
    AccuracyErrors errors;
    AccuracyPrice price;
};

/// Pictures that the price is measured by.
struct PricePlan {
    std::size_t rounds = 1;                ///< >= 1
    int width = 1, height = 1;             ///< [px]
    bool counts_instructions = false;      ///< by valgrind: fifty times as long
    std::vector<std::string> map_options;  ///< of `bench`, for the scene: its file, and folders of pictures
};

/// Draws the views by one setting after the other, over and over, on one thread. By setting.
Result<std::vector<AccuracyPrice>> measure_prices(const OpenMap& map, const std::vector<View>& views,
                                                  const std::vector<AccuracySetting>& settings, const PricePlan& plan);

/// A line for each row, with a line of names above.
std::string accuracy_csv(std::vector<AccuracyRow>& rows);

/// Nothing where the errors in `csv`, of accuracy_csv(), are those of these rows, whatever the prices; else which are
/// others.
Status compare_errors(const std::string& path, std::string_view csv, std::vector<AccuracyRow>& rows);

/// The page, in Markdown. command: that made it.
std::string accuracy_page(std::vector<AccuracyRow>& rows, const std::string& command);

/// What gnuplot is to be told, with the data: error over price, a picture in SVG. output: where it goes.
std::string accuracy_plot(std::vector<AccuracyRow>& rows, const std::string& output);

/// Nothing where every promise is kept and exact pictures have no fault; else the first that is not.
Status check_promises(const std::vector<AccuracyRow>& rows);

}  // namespace enfilade
