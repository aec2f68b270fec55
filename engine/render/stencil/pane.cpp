#include "render/stencil/pane.h"

#include <algorithm>

namespace enfilade::stencil {

PanelOnScreen in_view(const Map& map, const Snapshot& snapshot, PanelId id, const Pose& pose) {
    const Panel& panel = map[id];
    const Segment seen = facing(panel, pose.eye);
    const Heights room = heights_of(snapshot, panel.sector, pose.eye_z);
    PanelOnScreen shown{id, in_view(seen, pose), {}};
    if (seen.a != panel.a) shown.place.swapped = !shown.place.swapped;
    shown.shown = {std::max(panel.bottom - pose.eye_z, room.floor), std::min(panel.top - pose.eye_z, room.ceiling)};
    return shown;
}

}  // namespace enfilade::stencil
