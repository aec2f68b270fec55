// How large each number of a map may be: what building one leaves of the ranges in which its file was read.
//
// Each struct of map/map_fields.h with numbers has one limit for each of them, in their order, or does not compile:
// whoever gives a struct another number says how large it may be. Words, flags and ids are no numbers.
#pragma once
#include <array>
#include <concepts>
#include <cstddef>
#include <limits>
#include <optional>
#include <type_traits>

#include "formats/map_keys.h"
#include "formats/png.h"
#include "map/map_fields.h"

namespace enfilade {

/// What a number may be; of a Vec2, each of its two.
struct Limit {
    Range range;
    double grid = 0;  ///< of which it is a multiple [m]; 0: any number
};

template <class T>
inline constexpr bool kIsNumber = std::is_arithmetic_v<T> && !std::same_as<T, bool>;
template <>
inline constexpr bool kIsNumber<Vec2> = true;
template <class T>
inline constexpr bool kIsNumber<std::optional<T>> = kIsNumber<T>;
template <class T, std::size_t count>
inline constexpr bool kIsNumber<std::array<T, count>> = kIsNumber<T>;

namespace limits {

/// An index, or the first and the number of a range: Consistency (map/consistent.cpp) looks at what it leads to.
inline constexpr Limit kPlace{};
inline constexpr Limit kAnything{};  ///< every value has its meaning

inline constexpr Limit kVertex{kPositions, kVertexGrid};
inline constexpr Limit kPoint{kPositions, kPointGrid};
inline constexpr Limit kHeight{kHeights};
inline constexpr Limit kHeightDifference{{-2 * kWorldLimit, 2 * kWorldLimit}};
inline constexpr Limit kContrast{{kLeastContrast, kMostContrast}};

/// The widest picture by the smallest size [m].
inline constexpr double kWidest = kMaxImageSide / kTexelsPerMetre.low;
inline constexpr Limit kTile{{-kWidest, kWidest}};

/// Texels of the narrowest picture, and metres, to which what an opening cuts off was added, in the smallest tiles.
inline constexpr double kMostTiles = kMaxTextureOffset + (kMaxTextureOffset + 4 * kWorldLimit) / kMinTile;
inline constexpr Limit kOffset{{-kMostTiles, kMostTiles}};

inline constexpr Limit kUnit{{-1, 1}};                               ///< a sine or cosine
inline constexpr Limit kShift{{-4 * kWorldLimit, 4 * kWorldLimit}};  ///< less than 1 + sqrt 2 times the world's end
inline constexpr Limit kOrigin{{kOrigins.low / kTexelsPerMetre.low, kWidest}};
inline constexpr Limit kReach{{0, kWidest - kOrigin.range.low}};
inline constexpr Limit kMoment{{0, std::numeric_limits<double>::infinity()}};

}  // namespace limits

/// Of the numbers of the struct.
template <class T>
inline constexpr auto kLimits = std::array<Limit, 0>{};

template <>
inline constexpr auto kLimits<Angle> = std::array{limits::kAnything};

template <>
inline constexpr auto kLimits<TriggerRange> = std::array{limits::kPlace, limits::kPlace};

template <>
inline constexpr auto kLimits<TargetRange> = std::array{limits::kPlace, limits::kPlace};

/// c, s, flip, shift, rise
template <>
inline constexpr auto kLimits<Rigid> =
    std::array{limits::kUnit, limits::kUnit, limits::kUnit, limits::kShift, limits::kHeightDifference};

/// tile_m, offset_tiles, scroll
template <>
inline constexpr auto kLimits<Surface> = std::array{limits::kTile, limits::kOffset, Limit{kScrollSpeeds}};

/// a, link, contrast
template <>
inline constexpr auto kLimits<Wall> = std::array{limits::kVertex, limits::kPlace, limits::kContrast};

/// a, b, bottom, top, contrast
template <>
inline constexpr auto kLimits<Panel> =
    std::array{limits::kVertex, limits::kVertex, limits::kHeight, limits::kHeight, limits::kContrast};

/// z, origin, first_layer, layer_count
template <>
inline constexpr auto kLimits<Flat> =
    std::array{limits::kHeight, limits::kVertex, limits::kPlace, Limit{{0, kMostFlatLayers}}};

/// amplitude, period, phase
template <>
inline constexpr auto kLimits<BobRecord> = std::array{Limit{kAmplitudes}, Limit{kPeriods}, Limit{kPhases}};

/// dark, dark_s, bright_s, step, clock_hz
template <>
inline constexpr auto kLimits<LightEffectRecord> =
    std::array{Limit{kLight}, Limit{kPictureSeconds}, Limit{kPictureSeconds}, Limit{kLight}, Limit{kClocks}};

/// first_wall, wall_count, light, first_solid, solid_count, first_panel, panel_count, active_panels, first_touchable,
/// touchable_count, damage
template <>
inline constexpr auto kLimits<Sector> =
    std::array{limits::kPlace, limits::kPlace, Limit{kLight},  limits::kPlace, limits::kPlace, limits::kPlace,
               limits::kPlace, limits::kPlace, limits::kPlace, limits::kPlace, Limit{kHealth}};

/// origins_m, until_s
template <>
inline constexpr auto kLimits<SpriteFrame> = std::array{limits::kOrigin, limits::kMoment};

/// texels_per_m, reach_m
template <>
inline constexpr auto kLimits<Sprite> = std::array{Limit{kTexelsPerMetre}, limits::kReach};

/// position, turn, z, radius, height, light, gives_key, gives_health
template <>
inline constexpr auto kLimits<Thing> =
    std::array{limits::kPoint,
               Limit{kTurnSpeeds},
               Limit{{kHeights.low - kThingSizes.high, kHeights.high}},  // what hangs, from the ceiling
               Limit{kThingSizes, kPointGrid},
               Limit{kThingSizes},
               Limit{kLight},
               limits::kPlace,
               Limit{kHealth}};

/// position, z, color, brightness, reach
template <>
inline constexpr auto kLimits<PointLight> =
    std::array{limits::kPoint, limits::kHeight, Limit{kColors}, Limit{kBrightnesses}, Limit{kLightReaches, kPointGrid}};

/// level, up, color, brightness
template <>
inline constexpr auto kLimits<Sun> = std::array{limits::kUnit, Limit{{0, 1}}, Limit{kColors}, Limit{kBrightnesses}};

/// position, eye_z
template <>
inline constexpr auto kLimits<PlayerStart> = std::array{limits::kPoint, limits::kHeight};

/// key, after_s, z, by, speed, wait_s, step, crush_speed, light
template <>
inline constexpr auto kLimits<Trigger> =
    std::array{limits::kPlace,  Limit{kSeconds}, limits::kHeight, limits::kHeight, Limit{kSpeeds},
               Limit{kSeconds}, Limit{kStairs},  Limit{kSpeeds},  Limit{kLight}};

/// volume, reach_m
template <>
inline constexpr auto kLimits<Sound> = std::array{Limit{kLight}, Limit{kSoundReaches}};

/// seconds
template <>
inline constexpr auto kLimits<Animation> = std::array{Limit{kPictureSeconds}};

/// stretch, recursion_color, max_depth, fog_color, fog_reach
template <>
inline constexpr auto kLimits<RenderRecord> =
    std::array{Limit{kStretches}, Limit{kColors}, Limit{kDepths}, Limit{kColors}, Limit{kFogReaches}};

/// farthest_sound_m
template <>
inline constexpr auto kLimits<Map> = std::array{Limit{{0, kSoundReaches.high}}};

/// How many numbers a struct has.
template <class T>
constexpr std::size_t count_of_numbers() {
    return decltype(fields(std::declval<T&>(), [](auto&... part) {
        return std::integral_constant<std::size_t, (0 + ... + kIsNumber<std::remove_cvref_t<decltype(part)>>)>();
    }))::value;
}

}  // namespace enfilade
