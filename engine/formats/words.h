// The words that stand for enumerated values in files: one list for reading and for writing.
#pragma once
#include <array>
#include <string_view>
#include <type_traits>

#include "formats/map_file.h"
#include "formats/script.h"

namespace enfilade {

// Each list is in the order of the enumeration's values.
inline constexpr std::array<std::string_view, 4> kPegWords{"ceiling", "floor", "opening_top", "opening_bottom"};
inline constexpr std::array<std::string_view, 2> kLightModelWords{"smooth", "classic"};
inline constexpr std::array<std::string_view, 2> kSkyRowsWords{"round", "straight"};
inline constexpr std::array<std::string_view, 2> kThingEdgesWords{"cut", "whole"};
inline constexpr std::array<std::string_view, 2> kEaseWords{"smooth", "linear"};
inline constexpr std::array<std::string_view, 2> kPressWords{"none", "use"};
inline constexpr std::array<std::string_view, 3> kRendererWords{"column", "stencil", "reference"};
inline constexpr std::array<std::string_view, 5> kActivationWords{"use", "cross", "enter", "touch", "start"};
inline constexpr std::array<std::string_view, 15> kTriggerActionWords{
    "door",  "open",   "close", "close_then_open", "lift",     "shuttle", "floor", "ceiling",
    "crush", "stairs", "stop",  "light",           "teleport", "exit",    "sound"};
inline constexpr std::array<std::string_view, 10> kHeightLevelWords{
    "here",           "lowest_floor",    "highest_floor", "next_floor_up", "next_floor_down",
    "lowest_ceiling", "highest_ceiling", "floor",         "ceiling",       "lowest_ceiling_or_own"};
inline constexpr std::array<std::string_view, 3> kLightLevelWords{"given", "brightest", "darkest"};
inline constexpr std::array<std::string_view, 4> kLightKindWords{"flicker", "strobe", "glow", "fire"};
inline constexpr std::array<std::string_view, 2> kBobShapeWords{"sine", "triangle"};
inline constexpr std::array<std::string_view, 3> kHoldsUpWords{"all", "all_but_crushers", "nothing"};

constexpr const auto& words_of(Peg) { return kPegWords; }
constexpr const auto& words_of(LightModel) { return kLightModelWords; }
constexpr const auto& words_of(SkyRows) { return kSkyRowsWords; }
constexpr const auto& words_of(ThingEdges) { return kThingEdgesWords; }
constexpr const auto& words_of(Ease) { return kEaseWords; }
constexpr const auto& words_of(Press) { return kPressWords; }
constexpr const auto& words_of(RendererKind) { return kRendererWords; }
constexpr const auto& words_of(Activation) { return kActivationWords; }
constexpr const auto& words_of(TriggerAction) { return kTriggerActionWords; }
constexpr const auto& words_of(HeightLevel) { return kHeightLevelWords; }
constexpr const auto& words_of(LightLevel) { return kLightLevelWords; }
constexpr const auto& words_of(LightKind) { return kLightKindWords; }
constexpr const auto& words_of(BobShape) { return kBobShapeWords; }
constexpr const auto& words_of(HoldsUp) { return kHoldsUpWords; }

/// A type whose values are words in files.
template <class T>
concept Word = std::is_enum_v<T> && requires(T word) { words_of(word); };

template <Word W>
constexpr std::string_view to_word(W word) {
    return words_of(word)[static_cast<std::size_t>(word)];
}

}  // namespace enfilade
