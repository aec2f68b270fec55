// From a place in a map, as somebody gives it in numbers, to a view that is inside the map.
#pragma once
#include <optional>
#include <string>

#include "base/result.h"
#include "formats/views_csv.h"
#include "map/map.h"
#include "render/view.h"
#include "world/snapshot.h"
#include "world/world.h"

namespace enfilade {

/// How the eye sees, apart from where it is.
struct Lens {
    double fov_degrees = 90;
    double stretch = 1;
    Vec2 ray_offset{};        ///< View::ray_offset [px]
    bool true_pitch = false;  ///< pitch turns the picture instead of shifting its horizon
    double roll_degrees = 0;  ///< with true_pitch: how far the head leans to its right
};

/// As the map wants to be seen.
Lens lens_for(const RenderRecord& render, double fov_degrees = 90);

/// The view, its eye put onto the point grid. An error where the named sector does not exist or does not hold the eye,
/// or where no sector does; of several that overlap, the one that comes first in the map is taken.
Result<View> view_from(const Map& map, const ViewRow& row, const Lens& lens);

/// "the eye at z = 9 is not below the ceiling of sector 'hall' at 3 m", or not above its floor; none where it is
/// between them.
std::optional<std::string> hidden_eye(const Map& map, const Snapshot& snapshot, const View& view);

/// What the player sees at the start, or an error where the map has no player.
Result<View> view_at_start(const Map& map, const Lens& lens);

/// What an eye of the world sees (world/world.h).
View view_from(const Eye& eye, const Lens& lens);

}  // namespace enfilade
