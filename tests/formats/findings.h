// Findings in a form that tests can compare and that reads well when they differ.
#pragma once
#include <string>
#include <vector>

#include "base/finding.h"

namespace enfilade {

/// "code line:column" for each finding.
inline std::vector<std::string> codes_and_places(const Findings& findings) {
    std::vector<std::string> texts;
    for (const Finding& f : findings)
        texts.push_back(f.code + " " + std::to_string(f.place.line) + ":" + std::to_string(f.place.column));
    return texts;
}

}  // namespace enfilade
