// What a flythrough looked like when it was recorded, and whether it still does.
#pragma once
#include <string>

#include "app/mismatch_report.h"
#include "base/result.h"
#include "flight/draw_frames.h"

namespace enfilade {

/// The hashes beside a script: "tour.hashes" of "tour.toml".
std::string hashes_path(const std::string& script_path);

/// Draws all frames of the plan and writes their hashes, and beside them the pictures that shall be kept.
Status record_flight(const FlightScene& scene, const DrawPlan& plan, const std::string& script_path,
                     const PictureKeeping& keeping);

/// Draws the frames of the plan and compares each with its recorded hash. An error where frames of another number, size
/// or renderer were recorded, or where some differ; of the last report_folder holds pictures of a few and a page,
/// index.html, that shows them: expected, as it was kept when it was recorded, actual, and the difference. Nothing
/// else is ever shown as expected; where nothing was kept, the page and stderr say so.
Status check_flight(const FlightScene& scene, const DrawPlan& plan, const std::string& script_path,
                    const std::string& report_folder);

/// Draws the frames of the plan with two renderers. An error where more than `tolerance` of a frame's pixels (0..1)
/// differ, with the same report.
Status compare_renderers(const FlightScene& scene, const DrawPlan& plan, RendererKind other, double tolerance,
                         const std::string& report_folder);

}  // namespace enfilade
