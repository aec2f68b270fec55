// What is drawn into a picture from outside to explain it: the eye, the edges of what it sees, and the portals that it
// looks through.
#pragma once
#include "render/outside/room_facets.h"

namespace enfilade {

/// Colours of the automap, so that one learns them once [0xAABBGGRR].
inline constexpr std::uint32_t kLinkMark = 0xFFFF80C0, kMirrorMark = 0xFFFFE080, kDoorwayMark = 0xFF909090,
                               kEyeMark = 0xFF40FF40;

/// Adds the frames of all portals that looks pass: links and mirrors whole, plain doorways by their sills.
/// Only right after rooms.look().
void add_portal_marks(const OutsideScene& scene, const SeenRooms& rooms, std::vector<Facet>& facets);

/// Adds the eye, a pyramid that opens the way it looks, and the two edges of its field of view.
void add_eye_marks(const OutsideScene& scene, const SeenRooms& rooms, std::vector<Facet>& facets);

}  // namespace enfilade
