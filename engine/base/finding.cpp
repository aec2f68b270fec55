#include "base/finding.h"

#include <algorithm>
#include <iterator>

#include "base/text.h"

namespace enfilade {

bool has_errors(const Findings& findings) {
    return std::any_of(findings.begin(), findings.end(),
                       [](const Finding& f) { return f.severity == Severity::error; });
}

void sort_by_place(Findings& findings) {
    std::stable_sort(findings.begin(), findings.end(),
                     [](const Finding& a, const Finding& b) { return a.place < b.place; });
}

const SourceFile* source_of(TextPlace& place, const std::vector<SourceFile>& sources) {
    const auto behind = std::ranges::upper_bound(sources, place.line, {}, &SourceFile::first_line);
    if (behind == sources.begin()) return nullptr;
    const SourceFile& source = *std::prev(behind);
    place.line -= source.first_line - 1;
    return &source;
}

void tell_files(Findings& findings, const std::vector<SourceFile>& sources) {
    for (Finding& finding : findings)
        if (const SourceFile* source = source_of(finding.place, sources)) finding.file = source->path;
}

namespace {

/// How much of a line is shown, and how much of it before the caret where it is longer [characters].
constexpr std::size_t kShown = 96, kShownBefore = 64;

/// The characters of a line from one to another, a blank for each tab, and how many there are in all.
std::string characters_from(std::string_view line, std::size_t first, std::size_t count, std::size_t& all) {
    std::string shown;
    all = 0;
    for (const char c : line) {
        all += (static_cast<unsigned char>(c) & 0xC0) != 0x80;  // bytes that begin a character
        if (all > first && all <= first + count) shown += c == '\t' ? ' ' : c;
    }
    return printable_line(shown);
}

}  // namespace

std::string caret_lines(std::string_view text, TextPlace place) {
    if (place.line == 0 || place.column == 0) return "";
    for (std::uint32_t line = 1; line < place.line; ++line) {
        const std::size_t end = text.find('\n');
        if (end == std::string_view::npos) return "";
        text.remove_prefix(end + 1);
    }
    const std::string_view line = text.substr(0, text.find_first_of("\r\n"));
    const std::size_t column = place.column - 1, first = column < kShown ? 0 : column - kShownBefore;
    std::size_t all = 0;
    const std::string shown = characters_from(line, first, kShown, all);
    if (column > all) return "";
    const std::string number = std::to_string(place.line), before = first > 0 ? "…" : "";
    return "  " + number + " | " + before + shown + (all > first + kShown ? "…" : "") + "\n  " +
           std::string(number.size(), ' ') + " | " + std::string(column - first + (first > 0), ' ') + "^\n";
}

std::string to_text(const std::string& file, const Finding& finding) {
    std::string text = finding.file ? *finding.file : file;
    if (finding.place.line != 0)
        text += ":" + std::to_string(finding.place.line) + ":" + std::to_string(finding.place.column);
    text += finding.severity == Severity::error ? ": error: " : ": warning: ";
    return text + finding.sentence + " [" + finding.code + "]";
}

}  // namespace enfilade
