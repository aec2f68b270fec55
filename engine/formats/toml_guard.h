// What is refused before the TOML library sees a text: bytes that are not UTF-8, and texts that would take memory,
// stack or time out of proportion.
#pragma once
#include <cstddef>
#include <optional>
#include <string_view>

#include "base/finding.h"
#include "formats/toml.h"

namespace enfilade {

/// How deep tables and arrays may be nested, dotted keys and headers included. The deepest honest file (a wall's
/// table in a loop in a sector) needs 7; the library recurses, so this also bounds the stack.
inline constexpr int kMaxTomlDepth = 64;

/// Dots in keys (`floor.z = 0`), in a whole file. The library looks each such key up in a list of all of them, which
/// takes time with the square of their number: 65536 are half a second.
inline constexpr std::size_t kMaxDottedKeys = std::size_t{1} << 16;

/// Headers of tables with a dot (`[sectors.floor]`), in a whole file, for the same reason; enough for 131072 sectors
/// with two of them each.
inline constexpr std::size_t kMaxDottedHeaders = std::size_t{1} << 18;

/// Bytes and values of a text that is for the library. It takes ten times the time and twice the memory of the plain
/// parser: so much of it is read in ten seconds, in 1.4 gigabytes.
inline constexpr TomlLimits kLibraryLimits{std::size_t{40} << 20, 9'000'000};

/// The first reason not to parse a text: too-large, not-utf8, too-deep, or bad-toml for letters beyond ASCII and quotes
/// in bare words, of which this can say more than the library. A text without one may still be wrong.
/// Cost: a few ns a byte, no memory.
std::optional<Finding> scan_toml(std::string_view text, const TomlLimits& limits);

/// The first reason not to give a text that has passed scan_toml to the library: too-large, by kLibraryLimits,
/// kMaxDottedKeys and kMaxDottedHeaders. Cost: as of scan_toml.
std::optional<Finding> scan_for_library(std::string_view text);

}  // namespace enfilade
