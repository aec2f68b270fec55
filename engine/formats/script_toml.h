// Flythrough scripts as text.
#pragma once
#include <string_view>
#include <vector>

#include "base/finding.h"
#include "formats/key.h"
#include "formats/script.h"

namespace enfilade {

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

}  // namespace enfilade
