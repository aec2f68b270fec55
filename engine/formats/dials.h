// How exactly pictures are drawn: one promise, and the single dials under it.
//
// What is drawn exactly is drawn as it is because nothing cheaper was as right. Whoever wants to see what that costs
// turns a dial; `enfilade accuracy` measures the error and the price of each.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "base/result.h"

namespace enfilade {

/// The numbers in which texel positions are worked out.
enum class NumberKind : std::uint8_t {
    real64,   ///< "double": the default
    real32,   ///< "float"
    fixed16,  ///< "fixed": whole numbers of 1/65536 texel and 1/65536 m
    vanilla,  ///< by Doom's tables and formulas of 1993, for comparison
};

/// Which texels a pixel shows (render/sampling.h).
enum class Sampling : std::uint8_t {
    nearest,    ///< the one at its middle, of the picture as painted: the default
    mip,        ///< the one at its middle, of the picture made smaller until its texels are about as large as pixels
    bilinear,   ///< the four around its middle, of the picture as painted, blended by how near they are
    trilinear,  ///< the four around its middle in each of two pictures made smaller, with texels not larger and not
                ///< smaller than pixels, blended
};

/// Whether a pixel shows more than one texel.
constexpr bool is_blend(Sampling sampling) { return sampling == Sampling::bilinear || sampling == Sampling::trilinear; }

/// Whether distant pictures are made smaller.
constexpr bool needs_smaller_pictures(Sampling sampling) {
    return sampling == Sampling::mip || sampling == Sampling::trilinear;
}

/// How light falls off.
enum class LightSteps : std::uint8_t {
    as_map,  ///< "map": as the map says: the default
    smooth,  ///< in 256 steps
    bands,   ///< in Doom's 32
};

/// In how many steps fog hides what is far away.
enum class FogSteps : std::uint8_t {
    smooth,  ///< in 256: the default
    bands,   ///< in 32, as many as Doom's light has
};

/// How what a graphics card draws is told apart by distance, and cut off at portals.
enum class PortalMethod : std::uint8_t {
    exact,      ///< walls are put in order by the CPU, and nothing is cut off: the default
    plane24,    ///< by depths of 24 bits, cut off at the portal's plane
    plane32,    ///< by depths of 32 bits, nearer ones the finer
    oblique24,  ///< by a projection whose near plane is the portal's, depths of 24 bits
    oblique32,  ///< the same, of 32 bits
};

/// How many ticks the world takes in a second of play.
enum class TickRate : std::uint8_t {
    hz60,   ///< "60": the default
    hz35,   ///< "35": Doom's
    hz140,  ///< "140"
};

/// [1/s]
constexpr std::uint32_t ticks_per_second(TickRate rate) {
    switch (rate) {
        case TickRate::hz60: return 60;
        case TickRate::hz35: return 35;
        case TickRate::hz140: return 140;
    }
    return 60;
}

/// How the room is found in which a step of a body ends. Walls and links are met exactly either way.
enum class CrossingMethod : std::uint8_t {
    exact,  ///< by the way: through which portals it leads. The default
    naive,  ///< by the end of the step on the plan alone, whatever its height, as Build did: the room that the step
            ///< began in (or came to by its last link) if that contains it, else the first neighbour that does, else
            ///< the first room of the map that does. No cheaper: for comparison
};

/// How a world moves: the dials of play. A rate alone is one with exact crossings.
struct MotionDials {
    TickRate rate;
    CrossingMethod crossing;

    constexpr MotionDials(TickRate ticks = TickRate::hz60, CrossingMethod method = CrossingMethod::exact)
        : rate(ticks), crossing(method) {}
    bool operator==(const MotionDials&) const = default;
};

/// Largest width and height of a picture [px].
inline constexpr int kMaxPictureSide = 16384;

/// Most columns or rows between two exact positions.
inline constexpr int kMostSpan = 64;

/// Most rays along each side of a pixel: what sixty-four cannot smooth, more do not either.
inline constexpr int kMostSamples = 8;

/// Most links that a look may pass, whatever a map says.
inline constexpr int kMostLinks = 1000;

/// Places along a metre at which the light of lamps is worked out: a pool of light is round, and a room has a few
/// thousand of them.
inline constexpr int kUsualLightPoints = 4;

/// Most of them: a place every 1.6 cm, of which a lamp that reaches 8 m lights a million on a floor alone.
inline constexpr int kMostLightPoints = 64;

/// The default is exact. Dials of positions are about walls, steps, floors and ceilings; skies, things and other
/// pictures with holes stay exact. What a pixel belongs to, seen from the eye's room through as many links as are
/// looked through, is exact with all of them but `portals`.
struct Dials {
    /// The promise: no texel of a surface is off by more than this, along either side of its picture [texels], 0..64.
    /// 0 is exact: nothing is spent. Where it allows, neighbouring columns show the same texels, which is drawn once.
    double texel_error = 0;
    /// Texel positions are exact in every span-th column of a wall and row of a floor, and between them on a straight
    /// line. 1..kMostSpan; 1: exact in all.
    int span = 1;
    NumberKind number = NumberKind::real64;
    Sampling sampling = Sampling::nearest;
    /// The colour of a pixel is the mean, in linear light, of samples x samples rays spread evenly over it.
    /// 1..kMostSamples; samples times a side of the picture is at most kMaxPictureSide.
    int samples = 1;
    LightSteps light = LightSteps::as_map;
    FogSteps fog = FogSteps::smooth;
    /// Places along a metre of a surface at which the light of lamps is worked out; between them it goes on evenly.
    /// 1..kMostLightPoints. Time and memory grow with its square.
    int light_grid = kUsualLightPoints;
    /// What most engines do that draw portals by a depth and a stencil buffer, to see what it costs. Not with a true
    /// pitch.
    PortalMethod portals = PortalMethod::exact;
    int links = kMostLinks;  ///< links looked through in one chain, 0..kMostLinks; never more than the map says
    /// Of play alone: pictures know no ticks. What takes a second takes one at each rate, to within a tick or two.
    TickRate tick_rate = TickRate::hz60;
    /// Of play alone, too. Where rooms lie over each other, a naive player comes to be in another one than his way
    /// leads to; between two ticks his eye still follows the way.
    CrossingMethod crossing = CrossingMethod::exact;

    MotionDials motion() const { return {tick_rate, crossing}; }
    bool operator==(const Dials&) const = default;
};

/// Whether texels are drawn where and as they are.
constexpr bool are_texels_exact(const Dials& dials) {
    return dials.texel_error == 0 && dials.span == 1 && dials.number == NumberKind::real64 &&
           dials.sampling == Sampling::nearest;
}

/// Largest promise that means anything: most pictures are that wide [texels].
inline constexpr double kMostTexelError = 64;

/// Sets a promise by name or number: "exact" is 0, "fine" is 0.25 and "fast" 1; else a number from 0 to
/// kMostTexelError. "vanilla", which promises nothing, sets that kind of numbers. An error without a place says what
/// was expected; dials then stay as they were.
Result<void> set_accuracy(Dials& dials, std::string_view text);

/// Sets the dial of "NAME=VALUE": span, number, sampling, samples, light, fog, light_grid, portals, links, tick_rate or
/// crossing.
/// An error, without a place, where there is no such dial, or it has no such value; dials then stay as they were.
Result<void> set_dial(Dials& dials, std::string_view text);

/// What set_dial() would be given to get from the default to these, with blanks between: "span=8 number=float"; and
/// before them "accuracy=0.25" where something is promised. "exact" for the default.
std::string to_text(const Dials& dials);

}  // namespace enfilade
