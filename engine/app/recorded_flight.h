// What a flythrough looked like when it was recorded, and whether it still does.
#pragma once
#include <string>

#include "base/result.h"
#include "flight/draw_frames.h"

namespace enfilade {

/// The hashes beside a script: "tour.hashes" of "tour.toml".
std::string hashes_path(const std::string& script_path);

/// The folder of pictures that were kept for the human eye: "tour.frames".
std::string kept_pictures_folder(const std::string& script_path);

/// Draws all frames of the plan and writes their hashes. keep_every > 0: also keeps each so-many-th frame as a picture,
/// instead of those kept before; 0: pictures that were kept are drawn anew.
Status record_flight(const FlightScene& scene, const DrawPlan& plan, const std::string& script_path, int keep_every);

/// Draws the frames of the plan and compares each with its recorded hash. An error where frames of another number, size
/// or renderer were recorded, or where some differ; of the last report_folder holds expected, actual and difference
/// pictures of the first few and a page, index.html, that shows them. Expected is the kept picture, else what the
/// reference draws.
Status check_flight(const FlightScene& scene, const DrawPlan& plan, const std::string& script_path,
                    const std::string& report_folder);

/// Draws the frames of the plan with two renderers. An error where more than `tolerance` of a frame's pixels (0..1)
/// differ, with the same report.
Status compare_renderers(const FlightScene& scene, const DrawPlan& plan, RendererKind other, double tolerance,
                         const std::string& report_folder);

}  // namespace enfilade
