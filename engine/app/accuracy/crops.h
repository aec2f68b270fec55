// Parts of pictures, enlarged, beside maps of how far their texels are off: what a dial looks like.
#pragma once
#include <string>
#include <vector>

#include "app/accuracy/experiment.h"
#include "app/open_map.h"
#include "base/result.h"

namespace enfilade {

/// Those that a report shows.
std::vector<AccuracySetting> crop_settings();

/// Writes FOLDER/NAME.png for each setting, NAME by crop_name(): on the left a part of what the player sees
/// at the start, and on the right the same part as error_color() of each pixel.
Result<void> write_crops(const std::string& folder, const OpenMap& map, const std::vector<AccuracySetting>& settings);

/// "span-16" of "--dial span=16".
std::string crop_name(const AccuracySetting& setting);

/// Black up to 1e-6 texel, then blue, red, yellow, and white from 10 on; green where there is none to tell. 0xAABBGGRR.
std::uint32_t error_color(std::optional<double> texel_error);

}  // namespace enfilade
