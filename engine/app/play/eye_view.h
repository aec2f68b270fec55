// From an eye and what the mouse adds to its look, to the view that renderers draw.
#pragma once
#include "app/play/player_input.h"
#include "render/view.h"
#include "world/camera.h"

namespace enfilade {

/// The eye's view, the head turned further by `ahead`, up and down within kMaxPitchSteps.
/// true_pitch: for a renderer that turns its picture instead of shifting the horizon.
View view_of(const Eye& eye, const LookSteps& ahead, double fov_degrees, double stretch, bool true_pitch);

}  // namespace enfilade
