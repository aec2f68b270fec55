// What it costs to leave portals to the graphics card's depths and planes, as most engines do that draw them by it.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "app/open_map.h"
#include "base/result.h"
#include "formats/dials.h"

namespace enfilade {

/// How near an eye is to the linked portal that it looks through [m].
inline constexpr std::array kPortalDistances{1.0, 0.1, 0.01, 0.001, 0.0};

/// Of pictures by one method of the stencil renderer, from one distance.
struct PortalErrors {
    std::uint64_t pixels = 0;     ///< judged: where the reference is sure of its own
    std::uint64_t at_edges = 0;   ///< of those: another surface than the true one, which is there within a pixel
    std::uint64_t elsewhere = 0;  ///< another one that is not
    std::uint64_t unwritten = 0;  ///< nothing at all
};

struct PortalErrorRow {
    PortalMethod method = PortalMethod::exact;
    double distance_m = 0;  ///< one of kPortalDistances
    PortalErrors errors;
    double time_ratio = 1;  ///< of all pictures from there: the least times, by those of the exact method
};

/// How much is tried.
struct PortalPlan {
    std::size_t views = 24;  ///< from each distance, over all maps, >= 1
    int width = 320, height = 200;
    int rounds = 3;  ///< of timing, >= 1
};

/// Looks through links from random places before them, up to 60 degrees aslant. By method, then by distance; nothing
/// where no map has a link. An error where there is no OpenGL that can do it.
Result<std::vector<PortalErrorRow>> measure_portals(const std::vector<OpenMap>& maps, const PortalPlan& plan);

/// A section of the report, in Markdown.
std::string portal_page(const Result<std::vector<PortalErrorRow>>& rows);

/// An error where the exact method shows what is nowhere near.
Result<void> check_portals(const std::vector<PortalErrorRow>& rows);

}  // namespace enfilade
