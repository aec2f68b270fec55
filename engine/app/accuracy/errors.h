// How far what is drawn is from the truth: surfaces, texels, colours, and how they flicker when the eye moves; the
// light of lamps; and portals that are left to the graphics card.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/accuracy/experiment.h"
#include "app/open_map.h"
#include "base/result.h"
#include "formats/dials.h"
#include "render/view.h"

namespace enfilade {

/// Of the pictures of one setting. Texels are judged on walls, floors and ceilings with the right id. Colours are held
/// against pictures of 64 rays for each pixel.
struct AccuracyErrors {
    std::uint64_t pixels = 0;
    std::uint64_t wrong_ids = 0;     ///< show another surface than the reference
    std::uint64_t unwritten = 0;     ///< by the opaque pass
    std::uint64_t written_more = 0;  ///< than once
    std::uint64_t judged = 0;
    std::uint64_t wrong_texels = 0;                  ///< of those judged: another texel than the true one
    std::uint64_t broken = 0;                        ///< off by more than is promised, where exact is not
    std::uint64_t beyond = 0;                        ///< off by more than is promised, where exact is, too
    double mean = 0, per_mille = 0, largest = 0;     ///< of texel errors; of all but one in a thousand [texels]
    double psnr = 0;                                 ///< peak signal to noise [dB]; kNoNoise where nothing differs
    double ssim = 1;                                 ///< mean structural similarity, up to 1
    double shimmer_turned = 1, shimmer_stepped = 1;  ///< change from picture to picture, in parts of the true change,
                                                     ///< when the eye turns by 1/64 pixel and goes 2 cm
};
inline constexpr double kNoNoise = 999;

/// Draws every view by every setting and holds it against the truth. Views are not tilted. Shows on a terminal how far
/// it is. By setting; an error where a renderer cannot be made.
Result<std::vector<AccuracyErrors>> measure_errors(const OpenMap& map, const std::vector<View>& views,
                                                   const std::vector<AccuracySetting>& settings, int width, int height);

/// A picture, and how far the texel of each pixel is off.
struct JudgedPicture {
    Frame frame;
    std::vector<std::optional<double>> errors;  ///< by pixel; none where it is not judged [texels]
};

/// One view by every setting.
Result<std::vector<JudgedPicture>> judge_pictures(const OpenMap& map, const View& view,
                                                  const std::vector<AccuracySetting>& settings, int width, int height);

/// From one picture to another of the same size: the squares of what changes, summed over pixels and channels.
double squared_change(const Frame& from, const Frame& to);

/// Peak signal to noise of so many pixels [dB]; kNoNoise where nothing changes.
double signal_to_noise(double squared_change, std::uint64_t pixels);

/// How alike two pictures of a size look, up to 1: the mean over squares of 8 x 8 pixels of their brightness (Zhou Wang
/// et al., "Image Quality Assessment: From Error Visibility to Structural Similarity", 2004). Sides >= 8.
double structural_similarity(const Frame& a, const Frame& b);

// How far the light of lamps in pictures is from the light itself.

/// Of pictures that show nothing but what lamps and suns throw: every picture white, rooms dark, no fog. Light that
/// would make white whiter is cut off on both sides.
struct LightErrors {
    std::uint64_t pixels = 0;  ///< judged: both show the same surface, no sky
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

// What it costs to leave portals to the graphics card's depths and planes, as most engines do that draw them by it.

/// How near an eye is to the linked portal that it looks through [m].
inline constexpr std::array kPortalDistances{1.0, 0.1, 0.01, 0.001, 0.0};

/// Of pictures by one method of the stencil renderer, from one distance.
struct PortalErrors {
    std::uint64_t pixels = 0;     ///< judged
    std::uint64_t at_edges = 0;   ///< of those: another surface than the true one, which is there within a pixel
    std::uint64_t elsewhere = 0;  ///< another one that is not
    std::uint64_t unwritten = 0;  ///< nothing at all
};

struct PortalErrorRow {
    PortalMethod method = PortalMethod::exact;
    double distance_m = 0;  ///< one of kPortalDistances
    PortalErrors errors;
    double time_ratio = 1;  ///< of all pictures from there: the least times, by those of the exact method
};

/// How much is tried.
struct PortalPlan {
    std::size_t views = 24;  ///< from each distance, over all maps, >= 1
    int width = 320, height = 200;
    int rounds = 3;  ///< of timing, >= 1
};

/// Looks through links from random places before them, up to 60 degrees aslant. By method, then by distance; nothing
/// where no map has a link. An error where there is no OpenGL that can do it.
Result<std::vector<PortalErrorRow>> measure_portals(const std::vector<OpenMap>& maps, const PortalPlan& plan);

/// A section of the report, in Markdown.
std::string portal_page(const Result<std::vector<PortalErrorRow>>& rows);

/// An error where the exact method shows what is nowhere near.
Result<void> check_portals(const std::vector<PortalErrorRow>& rows);

}  // namespace enfilade
