// Which effects this build can draw: all of them, unless CMake was told -DENFILADE_WITHOUT="fog;sky".
//
// Leaving one out serves a single purpose: to measure what it costs where nothing uses it (tests/bench/effect_cost.sh).
// Each constant is asked at the one place where the effect's path is chosen; a map that has the effect is then drawn as
// if it had not.
#pragma once
#include <algorithm>
#include <array>
#include <string_view>

#ifndef ENFILADE_WITHOUT
#define ENFILADE_WITHOUT ""
#endif

namespace enfilade::built_in {

/// Every effect that can be left out.
inline constexpr std::array<std::string_view, 14> kNames{
    "fog",    "sky",       "flat_layers", "masked",   "panels",  "things", "point_lights", "changing_lights",
    "movers", "scrolling", "animation",   "switches", "mirrors", "links"};

/// The names in ENFILADE_WITHOUT, between commas, each given to visit(name) until one answers true.
template <class Visit>
consteval bool any_left_out(Visit visit) {
    std::string_view rest = ENFILADE_WITHOUT;
    while (!rest.empty()) {
        const std::string_view name = rest.substr(0, rest.find(','));
        if (visit(name)) return true;
        rest.remove_prefix(std::min(rest.size(), name.size() + 1));
    }
    return false;
}

static_assert(!any_left_out([](std::string_view name) {
    return std::find(kNames.begin(), kNames.end(), name) == kNames.end();
}),
              "ENFILADE_WITHOUT names an effect that nobody knows");

consteval bool has(std::string_view effect) {
    return !any_left_out([&](std::string_view name) { return name == effect; });
}

inline constexpr bool kFog = has("fog");                         ///< distance fog
inline constexpr bool kSky = has("sky");                         ///< ceilings and floors that show a sky
inline constexpr bool kFlatLayers = has("flat_layers");          ///< clouds over a sky, foam over water
inline constexpr bool kMasked = has("masked");                   ///< fences and windows in portals
inline constexpr bool kPanels = has("panels");                   ///< pictures that hang in rooms
inline constexpr bool kThings = has("things");                   ///< pictures that stand in rooms
inline constexpr bool kPointLights = has("point_lights");        ///< lamps that light surfaces around them
inline constexpr bool kChangingLights = has("changing_lights");  ///< rooms whose light flickers, flashes or glows
inline constexpr bool kMovers = has("movers");        ///< floors and ceilings that are not where the map has them
inline constexpr bool kScrolling = has("scrolling");  ///< surfaces whose pictures move
inline constexpr bool kAnimation = has("animation");  ///< surfaces whose pictures follow one another
inline constexpr bool kSwitches = has("switches");    ///< switches with two faces
inline constexpr bool kMirrors = has("mirrors");      ///< walls that show the room before them
inline constexpr bool kLinks = has("links");          ///< portals that lead elsewhere

}  // namespace enfilade::built_in
