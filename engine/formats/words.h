// The words that stand for enumerated values in files: one list for reading and for writing.
#pragma once
#include <array>
#include <string_view>

#include "formats/map_file.h"

namespace enfilade {

/// In the order of the enumeration's values.
inline constexpr std::array<std::string_view, 4> kPegWords{"ceiling", "floor", "opening_top", "opening_bottom"};
inline constexpr std::array<std::string_view, 2> kLightModelWords{"smooth", "classic"};

constexpr const auto& words_of(Peg) { return kPegWords; }
constexpr const auto& words_of(LightModel) { return kLightModelWords; }

}  // namespace enfilade
