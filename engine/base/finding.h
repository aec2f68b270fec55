// What a reader or a checker has to say about a text file: many findings at once, each with its place.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace enfilade {

/// A place in a text file. Lines and columns count from 1; 0 means "the file as a whole".
struct TextPlace {
    std::uint32_t line = 0;
    std::uint32_t column = 0;  ///< [characters], as editors count; a tab is one

    auto operator<=>(const TextPlace&) const = default;
};

enum class Severity : std::uint8_t { warning, error };

/// One thing that is wrong with a file.
struct Finding {
    TextPlace place;
    Severity severity = Severity::error;
    std::string code;      ///< stable short name for tests and tools, e.g. "unknown-key"
    std::string sentence;  ///< what was expected, what was found, what to do
};

using Findings = std::vector<Finding>;

/// True when at least one finding is an error: the file is refused.
bool has_errors(const Findings& findings);

/// Orders findings by place; findings at the same place keep their order.
void sort_by_place(Findings& findings);

/// "file:line:column: error|warning: sentence [code]". Without a place: "file: error: sentence [code]".
std::string to_text(const std::string& file, const Finding& finding);

}  // namespace enfilade
