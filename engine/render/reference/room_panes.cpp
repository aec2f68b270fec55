#include "render/reference/room_panes.h"

#include <algorithm>
#include <iterator>

#include "render/reference/panels_met.h"
#include "render/reference/things_met.h"
#include "render/sprite.h"

namespace enfilade {
namespace {

bool is_nearer(const MetPane& a, const MetPane& b) { return depth_steps(a.depth) < depth_steps(b.depth); }

/// Would a shift change the order?
bool is_order_close(const MetPane& a, const MetPane& b) {
    return depth_steps(a.depth + kAmbiguous) > depth_steps(b.depth - kAmbiguous) &&
           depth_steps(a.depth) != depth_steps(b.depth);
}

}  // namespace

bool add_room_panes(const Scene& scene, const RoomRay& ray, std::vector<Pane>& panes) {
    std::vector<MetPane> things, panels, met;
    bool ambiguous = find_things_met(scene, ray, things);
    ambiguous |= find_panels_met(scene, ray, panels);
    std::merge(things.begin(), things.end(), panels.begin(), panels.end(), std::back_inserter(met), is_nearer);
    for (std::size_t i = 0; i < met.size(); ++i) {
        ambiguous |= met[i].pane.ambiguous || (i > 0 && is_order_close(met[i - 1], met[i]));
        panes.push_back(met[i].pane);
    }
    return ambiguous;
}

}  // namespace enfilade
