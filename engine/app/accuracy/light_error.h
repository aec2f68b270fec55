// How far the light of lamps in pictures is from the light itself.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "app/open_map.h"
#include "formats/dials.h"
#include "render/view.h"

namespace enfilade {

/// Of pictures that show nothing but what lamps and suns throw: every picture white, rooms dark, no fog. Light that
/// would make white whiter is cut off on both sides.
struct LightErrors {
    std::uint64_t pixels = 0;  ///< judged: both show the same surface, no sky, and the truth is sure of it
    std::uint64_t lit = 0;     ///< of those: where there is any light
    std::uint64_t off = 0;     ///< of those judged: by more than 1/255 in some colour
    double sum = 0;            ///< of each pixel's largest difference of a colour [1/255]
    int largest = 0;           ///< [1/255]

    /// 0..1
    double share_off() const { return pixels > 0 ? static_cast<double>(off) / static_cast<double>(pixels) : 0; }
    /// [1/255]
    double mean() const { return pixels > 0 ? sum / static_cast<double>(pixels) : 0; }
};

/// Draws the views by the column renderer with these dials, and by the reference with its own light
/// (ReferenceOptions::own_light): by sight lines, no grid. The two share the projection, the rounding of light to 256
/// steps, the lamps' colours and effects, and the light of suns.
///
/// views : not tilted
/// width, height : of the pictures [px]
/// dials : of the column renderer; `samples` and `links` are those of the truth, too, and `light` counts for nothing
/// An error where the renderer cannot be made.
Result<LightErrors> measure_light(const OpenMap& map, const std::vector<View>& views, int width, int height,
                                  const Dials& dials);

/// One map by one grid.
struct LightErrorRow {
    std::string scene;
    int points_per_m = 0;  ///< of the dial light_grid
    LightErrors errors;
};

/// The views by grids from 1 to 64 points per metre. Nothing for a map without lamps.
Result<std::vector<LightErrorRow>> measure_light_grids(const std::string& scene, const OpenMap& map,
                                                       const std::vector<View>& views, int width, int height);

/// A section of the report, in Markdown.
std::string light_page(const std::vector<LightErrorRow>& rows);

}  // namespace enfilade
