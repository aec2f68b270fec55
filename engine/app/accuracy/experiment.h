// The experiment of `enfilade accuracy`: settings of the dials, places to look from, and what each setting costs.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/open_map.h"
#include "base/result.h"
#include "map/map.h"
#include "render/choice/renderer.h"
#include "render/view.h"

namespace enfilade {

/// One row of the report: options as `render` takes them.
struct AccuracySetting {
    std::vector<std::string> options;
    Dials dials;
    double promise = 0;  ///< largest texel error [texels]; 0: nothing is promised
};

/// Exact first, then promises from the narrowest to the widest, then single dials.
/// is_quick : fewer of them
std::vector<AccuracySetting> accuracy_settings(bool is_quick);

/// By a promise [texels].
AccuracySetting promise_of(double texels);

/// By one dial, as set_dial() takes it.
AccuracySetting dial_of(const std::string& text);

/// The column renderer on one thread.
RendererChoice one_thread(const Dials& dials);

/// The setting's options as one text; "exact" where there are none.
std::string name_of(const AccuracySetting& setting);

enum class PoseKind : std::uint8_t {
    random,   ///< anywhere in a room, any look
    lattice,  ///< on half metres, along an axis or a diagonal, level: where ties happen
};
inline constexpr std::array kPoseKinds{PoseKind::random, PoseKind::lattice};
std::string_view name_of(PoseKind kind);

/// The same for the same seed.
std::vector<View> poses_in(const Map& map, PoseKind kind, std::size_t count, std::uint64_t seed);

/// A list of views as `bench` and `render` read it (maps/FORMAT.md).
std::string views_csv(const std::vector<View>& views);

// What each setting costs: time, in turn with all others, and instructions, which repeat.

/// What a setting costs in one scene.
struct AccuracyPrice {
    double minimum_ns = 0, median_ns = 0;  ///< per pixel
    double low_ratio = 1, high_ratio = 1;  ///< to exact in the same round: between them lie half of the rounds
    std::optional<double> instructions;    ///< per pixel; none: not counted
};

/// Pictures that the price is measured by.
struct PricePlan {
    std::size_t rounds = 1;                ///< >= 1
    int width = 1, height = 1;             ///< [px]
    std::string views_file;                ///< with the views, for `bench`, where instructions are counted, too: that
                                           ///< takes fifty times as long. Empty: they are not
    std::vector<std::string> map_options;  ///< of `bench`, for the scene: its file, and folders of pictures
};

/// Draws the views by one setting after the other, over and over, on one thread. By setting.
Result<std::vector<AccuracyPrice>> measure_prices(const OpenMap& map, const std::vector<View>& views,
                                                  const std::vector<AccuracySetting>& settings, const PricePlan& plan);

}  // namespace enfilade
