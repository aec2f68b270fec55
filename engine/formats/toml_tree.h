// What a TOML text becomes: values in few large pieces of memory, and the two parsers that make them. Private to
// formats/; others look at it through TomlNode.
#pragma once
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

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
    std::uint32_t length = 0;  ///< of a text [bytes]
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
/// `text` has passed scan_toml (formats/toml_guard.h). Cost: about 10 ns a byte.
std::optional<TomlTree> parse_plain_toml(std::string_view text);

/// Parses any TOML 1.0 with the library (toml.cpp), or notes why it is none.
std::optional<TomlTree> parse_any_toml(std::string_view text, Findings& findings);

}  // namespace enfilade
