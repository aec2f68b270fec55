// A flythrough as its author wrote it: a map, a picture, and what the camera does, leg by leg. flight/ plays it.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/finding.h"
#include "formats/dials.h"
#include "math/vec.h"

namespace enfilade {

struct KeyInfo;  // formats/key.h

/// How a leg gets from its start to its end: with even speed, or starting and stopping gently.
enum class Ease : std::uint8_t { smooth, linear };

/// What the camera's hand does at the moment a leg starts.
enum class Press : std::uint8_t { none, use };

/// One span of time. Whatever a leg does not mention stays as the leg before left it. Coordinates are in the space
/// where the camera is when the leg starts; if it passes linked portals on the way, the leg goes on in the space
/// behind them, and the next leg starts there.
struct LegRecord {
    double seconds = 0;          ///< 0..kMaxLegSeconds; 0 is a cut: a jump to the end, which must then need no way
    std::optional<Vec2> to;      ///< where the eye goes, in a straight line [m]
    std::optional<double> to_z;  ///< height the eye goes to, absolute [m]; absent: keeps its height
    std::optional<double> look_degrees;   ///< yaw at the end, reached the shorter way round (right on a tie)
    std::optional<double> turn_degrees;   ///< turned during the leg, right positive; -36000..36000, a hundred turns
    std::optional<Vec2> look_at;          ///< point that is looked at when the leg ends, reached the shorter way round
    std::optional<double> pitch_degrees;  ///< pitch at the end, up positive, -89..89
    Press press = Press::none;
    Ease ease = Ease::smooth;
    TextPlace place;
};

/// Where the camera starts; what is absent is as at the player's start.
struct StartRecord {
    std::string sector;          ///< empty: the player's, or where x and y are given, found from them
    std::optional<double> x, y;  ///< both or none [m]
    std::optional<double> z;     ///< of the eye [m]
    std::optional<double> yaw_degrees, pitch_degrees;  ///< pitch: up positive, -89..89
    TextPlace place;
};

enum class RendererKind : std::uint8_t { column, stencil, reference };

/// The whole file. Frame n shows the time n / rate, so that it can be drawn without the frames before it.
struct ScriptFile {
    std::string map;                ///< path, relative to the script
    int width = 640, height = 400;  ///< 1..kMaxPictureSide [px]
    int rate = 30;                  ///< frames a second, 1..kMaxFrameRate
    RendererKind renderer = RendererKind::column;
    double fov_degrees = 90;  ///< horizontal, 1..179
    Dials dials;
    std::string tape;  ///< path of recorded input, relative to the script, instead of legs; empty: none
    StartRecord start;
    std::vector<LegRecord> legs;  ///< empty exactly where there is a tape
    TextPlace map_place, tape_place;
};

/// Seconds all legs take together.
inline double seconds_of(const ScriptFile& script) {
    double seconds = 0;
    for (const LegRecord& leg : script.legs) seconds += leg.seconds;
    return seconds;
}

// Scripts as text.

/// What the reader made of a script. Where findings has errors the script is refused.
struct ScriptReading {
    ScriptFile script;
    Findings findings;  ///< sorted by place
};

/// Reads a flythrough script; maps/FORMAT.md tells authors about it. Numbers come out finite and in their ranges.
/// Any bytes are safe; scripts over kMaxScriptBytes are refused.
ScriptReading read_script(std::string_view text);

/// Whether a text is meant to be a script: one that names a map, as no map does.
bool is_script(std::string_view text);

/// Every key of a script, for the tests of schema and manual.
std::vector<KeyInfo> script_keys();

/// Largest script that is read [bytes].
inline constexpr std::size_t kMaxScriptBytes = std::size_t{1} << 20;

/// Longest leg, so that a script cannot ask for more frames than anyone can draw [s].
inline constexpr double kMaxLegSeconds = 3600;

/// Longest flythrough [s]: with the highest rate, the number of frames still fits 32 bits.
inline constexpr double kMaxScriptSeconds = 86400;

/// Most frames a second.
inline constexpr int kMaxFrameRate = 1000;

/// More frames than kMaxScriptSeconds have at kMaxFrameRate.
inline constexpr int kMaxFlightFrames = 100'000'000;

}  // namespace enfilade
