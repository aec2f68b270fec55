#include "base/finding.h"

#include <algorithm>

namespace enfilade {

bool has_errors(const Findings& findings) {
    return std::any_of(findings.begin(), findings.end(),
                       [](const Finding& f) { return f.severity == Severity::error; });
}

void sort_by_place(Findings& findings) {
    std::stable_sort(findings.begin(), findings.end(),
                     [](const Finding& a, const Finding& b) { return a.place < b.place; });
}

std::string to_text(const std::string& file, const Finding& finding) {
    std::string text = file;
    if (finding.place.line != 0)
        text += ":" + std::to_string(finding.place.line) + ":" + std::to_string(finding.place.column);
    text += finding.severity == Severity::error ? ": error: " : ": warning: ";
    return text + finding.sentence + " [" + finding.code + "]";
}

}  // namespace enfilade
