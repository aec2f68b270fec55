// Lists of cameras as CSV text: one row, one picture.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "base/finding.h"
#include "base/result.h"

namespace enfilade {

/// One camera. Numbers are finite and in their ranges: x, y and z up to kWorldLimit (math/vec.h) either way.
struct ViewRow {
    double x = 0, y = 0;       ///< [m]
    double z = 0;              ///< of the eye [m]
    double yaw_degrees = 0;    ///< 0 along +x, right positive
    double pitch_degrees = 0;  ///< up positive, -89..89
    std::string sector;        ///< empty: found from the position
    std::uint32_t line = 0;    ///< where it stands in the text, for messages
    bool operator==(const ViewRow&) const = default;
};

/// What the reader made of a list. Where findings has errors the list is refused.
struct ViewsReading {
    std::vector<ViewRow> views;
    Findings
        findings;  ///< in the order of the text: bad-header, bad-row, bad-number, out-of-range, not-utf8, too-large
};

/// Reads a list of views: the header "x,y,z,yaw,pitch" or "x,y,z,yaw,pitch,sector", then a row for each view. Blanks
/// around fields and empty lines do not count; a sector's name with a comma stands in double quotes, a double quote
/// in it is written twice. Any bytes are safe; at most kMaxViewsBytes are read.
ViewsReading read_views(std::string_view text);

/// Largest list that is read [bytes]: about a million views.
inline constexpr std::size_t kMaxViewsBytes = std::size_t{16} << 20;

/// Reads one view as it is given on a command line, "X,Y,Z,YAW,PITCH". An error, without a place, says which number is
/// wrong.
Result<ViewRow> parse_view(std::string_view text);

}  // namespace enfilade
