// What is refused before the TOML library sees a text: bytes that are not UTF-8, and texts that would take memory,
// stack or time out of proportion.
#pragma once
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

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

/// Parts of a text that are not worth a thread of their own are not cut off [bytes].
inline constexpr std::size_t kLeastTomlPart = std::size_t{1} << 18;

/// What one look over a text tells.
struct TomlScan {
    /// The first reason not to parse the text: too-large, not-utf8, too-deep, or bad-toml for what the library does
    /// not survive. A text without one may still be wrong.
    std::optional<Finding> problem;
    /// Offsets at which the text may be cut into parts that are TOML on their own, ascending and at least
    /// kLeastTomlPart apart: headers `[[name]]` without a dot. Only to be trusted where the text before them is valid.
    std::vector<std::size_t> cuts;
};

/// Cost: a few ns a byte, no memory but the cuts.
TomlScan scan_toml(std::string_view text, const TomlLimits& limits);

}  // namespace enfilade
