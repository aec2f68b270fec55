// How far what is drawn is from the truth: surfaces, texels, colours, and how they flicker when the eye moves.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "app/accuracy/experiment.h"
#include "app/open_map.h"
#include "base/result.h"

namespace enfilade {

/// Of the pictures of one setting. Texels are judged on walls, floors and ceilings with the right id. Colours are held
/// against pictures of 64 rays for each pixel.
struct AccuracyErrors {
    std::uint64_t pixels = 0;
    std::uint64_t wrong_ids = 0;     ///< show another surface than the reference, which is sure of its own
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

}  // namespace enfilade
