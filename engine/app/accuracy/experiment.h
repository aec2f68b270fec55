// The experiment of `enfilade accuracy`: scenes and places to look from, settings of the dials, and how far what is
// drawn is from the truth.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "app/open_map.h"
#include "flight/renderer.h"
#include "render/frame.h"
#include "render/view.h"
#include "world/snapshot.h"

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

/// How far pictures of one setting are from the truth.
struct AccuracyErrors {
    std::uint64_t pixels = 0;
    std::uint64_t wrong_ids = 0;      ///< show another surface than the reference, which is sure of its own
    std::uint64_t unwritten = 0;      ///< by the opaque pass
    std::uint64_t written_more = 0;   ///< than once
    std::uint64_t wrong_texels = 0;   ///< of those judged: another texel than the true one
    std::uint64_t broken = 0;         ///< off by more than is promised, where exact is not
    std::uint64_t beyond = 0;         ///< off by more than is promised, where exact is, too: grazing or far
    double squared_color = 0;         ///< sum over pixels and channels, to a picture of 64 rays for each pixel
    std::vector<float> texel_errors;  ///< of those judged: walls, floors and ceilings with the right id [texels]

    double mean() const;
    double largest() const;
    /// Of all but one in a thousand. Reorders them.
    double per_mille();
    /// Peak signal to noise [dB]; infinite where nothing differs.
    double psnr() const;
};

/// Draws every view by every setting and holds it against the truth. Views are not tilted. Shows on a terminal how far
/// it is. By setting; an error where a renderer cannot be made.
Result<std::vector<AccuracyErrors>> measure_errors(const OpenMap& map, const std::vector<View>& views,
                                                   const std::vector<AccuracySetting>& settings, int width, int height);

}  // namespace enfilade
