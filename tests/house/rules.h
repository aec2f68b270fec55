// The rules of the house, each as a function from one source file to its complaints.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace enfilade::house {

/// One text file of the project.
struct SourceFile {
    std::string path;  ///< from the top of the project, with '/': "engine/space/trace.h"
    std::string text;
};

/// Sentences of the form "path:line: what is wrong"; empty where all is well.
using Complaints = std::vector<std::string>;

/// Includes point only down the one-way table base <- math <- … <- app; the renderers never include one another;
/// wadconv sees base, math, formats and map; an include of our own is written from engine/.
Complaints check_layers(const SourceFile& file);

/// A library that only one place may know: SDL in engine/platform, toml++ in engine/formats, OpenGL in the stencil
/// renderer and engine/platform, files in base/files.cpp and base/output_file.cpp, threads in base/parallel.cpp and
/// from engine/platform on up.
Complaints check_fenced_libraries(const SourceFile& file);

/// A header has `#pragma once`, and its first line is a comment that says what it holds.
Complaints check_header_form(const SourceFile& file);

/// Fewer than kMaxLines lines.
Complaints check_length(const SourceFile& file);

/// No marks of unfinished work, no shared ownership.
Complaints check_forbidden_words(const SourceFile& file);

/// No flag that lets a compiler change what floating-point code computes.
Complaints check_float_flags(const SourceFile& file);

/// No instruction that approximates a reciprocal or a square root: processors answer differently.
Complaints check_approximations(const SourceFile& file);

/// In space/ and world/, no function of the C mathematics library whose last bit differs between machines.
Complaints check_libm(const SourceFile& file);

/// What people read goes through base/text.h, which lets nothing pass that a terminal obeys.
Complaints check_printing(const SourceFile& file);

/// Nothing else names standard output than what reports a failure to write to it: OutputFile, by which
/// command/command.h prints.
Complaints check_standard_output(const SourceFile& file);

/// No file is opened by C's streams, by SDL or by toml++; C++'s streams are a library that check_fenced_libraries()
/// keeps away.
Complaints check_opening(const SourceFile& file);

/// Names of files come from base/file_name.h alone, and what is put behind a '/' is no name as it was found.
Complaints check_names_of_files(const SourceFile& file);

/// Nothing is removed or renamed but by base/owned_folder.h and base/files.h, which see to it that its successor is
/// there; by the script `run`, nothing at all.
Complaints check_removals(const SourceFile& file);

/// A source file longer than this answers more than one question [lines].
inline constexpr int kMaxLines = 500;

/// `throw`, `try` and `catch` stand where attempts are made and ended, and where a library throws; errors are Results.
Complaints check_exceptions(const SourceFile& file);

/// The text with comments and the insides of string and character literals replaced by blanks; lines stay where
/// they are. Raw strings are not known; the house has none with quotes in them.
std::string without_comments_and_strings(std::string_view text);

}  // namespace enfilade::house
