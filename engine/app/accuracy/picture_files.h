// Pictures that `enfilade accuracy` writes and reads: what a dial looks like, and what others draw.
#pragma once
#include <string>
#include <vector>

#include "app/accuracy/experiment.h"
#include "app/open_map.h"
#include "base/result.h"
#include "render/view.h"

namespace enfilade {

// Parts of pictures, enlarged, beside maps of how far their texels are off: what a dial looks like.

/// Those that a report shows.
std::vector<AccuracySetting> crop_settings();

/// Writes FOLDER/NAME.png for each setting, NAME by crop_name(): on the left a part of what the player sees
/// at the start, and on the right the same part as error_color() of each pixel.
Result<void> write_crops(const std::string& folder, const OpenMap& map, const std::vector<AccuracySetting>& settings);

/// "span-16" of "--dial span=16".
std::string crop_name(const AccuracySetting& setting);

/// Black up to 1e-6 texel, then blue, red, yellow, and white from 10 on; green where there is none to tell. 0xAABBGGRR.
std::uint32_t error_color(std::optional<double> texel_error);

// The accuracy of others: what is to be drawn, what it should look like, and how near pictures come to it.

/// Pictures of one scene, true or somebody's, in a folder of their own: views.csv, colors/000000.png and, in the same
/// order, ids/000000.png: the numbers of surfaces as colours (ids_image()), 0 where another one would be as right.
struct EntryPlan {
    std::string folder;
    const std::vector<View>& views;
    int width = 0, height = 0;  ///< of the pictures [px]
};

/// Writes the true ones: colours of 64 rays for each pixel, surfaces as the reference sees them.
Result<void> export_truth(const EntryPlan& plan, const OpenMap& map);

/// How near somebody's pictures come.
struct EntryScore {
    double psnr = 0, ssim = 0;     ///< of colours, as AccuracyErrors has them
    std::uint64_t judged_ids = 0;  ///< pixels of pictures of surfaces; none where there are no such pictures
    std::uint64_t wrong_ids = 0;
};

/// Holds the pictures in a folder against the true ones. An error where a picture of colours is missing or has another
/// size; those of surfaces may be missing, all together. Files are hostile until read.
Result<EntryScore> score_entry(const EntryPlan& plan, const OpenMap& map);

}  // namespace enfilade
