// Pictures and a page about frames that are not what they should be.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "flight/comparison.h"

namespace enfilade {

/// A frame that differs, with both its pictures.
struct BadFrame {
    Mismatch mismatch;
    std::optional<Frame> expected;  ///< none: nobody knows what it looked like
    Frame actual;
    std::string expected_origin;  ///< as in MismatchRow
    int reduction = 1;            ///< of expected, which is compared with the actual picture reduced as much
};

/// Frames that a report shows; more would be more than anybody looks at.
inline constexpr std::size_t kMostShown = 12;

/// Takes out of the folder what an earlier report put there, and the folder where nothing else is in it. What is not a
/// report's stays.
void remove_report(const std::string& folder);

/// Writes the pictures and index.html into the folder, which is made where it is missing, instead of an earlier report.
Status write_report(const std::string& folder, const ReportText& text, const std::vector<BadFrame>& frames);

}  // namespace enfilade
