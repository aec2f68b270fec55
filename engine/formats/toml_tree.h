// What a TOML text becomes: values in few large pieces of memory, and the two parsers that make them. Private to
// formats/; others look at it through TomlNode.
#pragma once
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/finding.h"
#include "formats/toml.h"

namespace enfilade {

struct TomlMember;

/// A value. What it points to belongs to the tree.
struct TomlValue {
    union {
        std::int64_t integer;
        double real;
        bool boolean;
        const char* text;
        std::vector<TomlValue>* items;     ///< of an array
        std::vector<TomlMember>* members;  ///< of a table, in the order of the text
    };
    TextPlace place;
    std::uint32_t length = 0;  ///< of a text or date [bytes]
    TomlKind kind = TomlKind::absent;
    bool has_header = false;  ///< an array or table that was begun by a [header], to which others may add

    TomlValue() : integer(0) {}
};

struct TomlMember {
    std::string_view key;
    TextPlace key_place;
    TomlValue value;
};

/// A whole document. Values stay where they are when it is moved.
struct TomlTree {
    std::unique_ptr<std::string> text;  ///< keys and strings lie in it, or in `strings`
    std::deque<std::string> strings;
    std::deque<std::vector<TomlValue>> arrays;
    std::deque<std::vector<TomlMember>> tables;
    TomlValue root;

    TomlValue new_array(TextPlace place);
    TomlValue new_table(TextPlace place);
};

/// Makes looks at values.
struct TomlAccess {
    static TomlNode look_at(const TomlValue& value) { return {&value, value.kind}; }
};

/// Parses what most files consist of: comments, bare keys, headers, strings without escapes, decimal numbers, true and
/// false, arrays, tables in braces. None for everything else, wrong or not: that is for the library, which takes
/// ten times as long. What it accepts, the library reads as the same values at the same places.
/// `text` has passed scan_toml. Cost: about 10 ns a byte.
std::optional<TomlTree> parse_plain_toml(std::string_view text);

/// Parses any TOML 1.0 with the library (toml.cpp), or notes why it is none.
std::optional<TomlTree> parse_any_toml(std::string_view text, Findings& findings);

// What the TOML library says is wrong with a text, in the words of this program.

/// "expected …, found …; do …" for one of the library's sentences ("Error while parsing SCOPE: REASON").
///
/// is_line_end : whether the place it names is the end of a line, which its sentences do not always tell.
/// A reason that is not known comes out as it is, so that nothing is lost with another version of the library.
std::string toml_words(std::string_view description, bool is_line_end);

/// Whether there are words of ours for this reason, with whatever was found in it left out.
bool has_toml_words(std::string_view scope, std::string_view reason);

// What is refused before the TOML library sees a text: bytes that are not UTF-8, and texts that would take memory,
// stack or time out of proportion.

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
