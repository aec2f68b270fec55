// One TOML text read twice: by the quick parser and by the library.
#pragma once
#include <string>
#include <string_view>

namespace enfilade {

/// What both parsers make of a text that the guard lets pass: every value with its place, in the order of the text.
struct ParsedTwice {
    bool is_plain = false;   ///< the quick parser accepts it; else nothing is told
    std::string plain, any;  ///< by the quick parser, by the library
};

ParsedTwice parse_twice(std::string_view text);

}  // namespace enfilade
