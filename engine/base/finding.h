// What a reader or a checker has to say about a text file: many findings at once, each with its place.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/containers.h"

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
    std::string code;           ///< stable short name for tests and tools, e.g. "unknown-key"
    std::string sentence;       ///< what was expected, what was found, what to do
    Boxed<std::string> file{};  ///< the path, where the place is in another file than the one that was read
};

using Findings = std::vector<Finding>;

/// True when at least one finding is an error: the file is refused.
bool has_errors(const Findings& findings);

/// Orders findings by place; findings at the same place keep their order.
void sort_by_place(Findings& findings);

/// A file that was read into another one. While both are one thing its places follow those of the other: line 1 of it
/// counts as `first_line`, which no line of the other has.
struct SourceFile {
    std::string path;
    std::uint32_t first_line = 0;
};

/// The place in its own file, where `place` is in one of the sources (sorted by first_line), and which that is; null
/// for the file that they were read into.
const SourceFile* source_of(TextPlace& place, const std::vector<SourceFile>& sources);

/// Gives findings in sources their file and the place in it.
void tell_files(Findings& findings, const std::vector<SourceFile>& sources);

/// The line of the text at this place, numbered, and below it a caret under the column, each with its end; of a long
/// line only what is around. Nothing where the place is not in the text. Cost: O(text up to there).
std::string caret_lines(std::string_view text, TextPlace place);

/// "file:line:column: error|warning: sentence [code]". Without a place: "file: error: sentence [code]".
std::string to_text(const std::string& file, const Finding& finding);

}  // namespace enfilade
