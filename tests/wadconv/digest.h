// Everything a conversion does with an archive but for writing files.
#pragma once
#include <string>
#include <vector>

#include "base/files.h"

namespace enfilade::wadconv::test {

/// What came of the bytes; the text of the first error where there is one.
struct Outcome {
    std::size_t pictures = 0, maps = 0;
    bool has_all_sides = true;  ///< of each map that was converted, every side became something
    std::string error;
};

/// Any bytes at all; patches come behind what they change. Each map that is sound is drawn from its player's start.
Outcome digest(std::vector<Bytes> archives);

}  // namespace enfilade::wadconv::test
