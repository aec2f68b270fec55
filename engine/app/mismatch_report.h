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
    Frame expected;  ///< of no size: there is none
    Frame actual;
    std::string expected_origin;  ///< as in MismatchRow
};

/// Frames that a report shows; more would be more than anybody looks at.
inline constexpr std::size_t kMostShown = 12;

/// Writes the pictures and index.html into the folder, which is made where it is missing.
Status write_report(const std::string& folder, const std::string& title, const std::vector<BadFrame>& frames,
                    std::size_t total);

}  // namespace enfilade
