#include "render/column/room_columns.h"

#include "render/built_in.h"

namespace enfilade::column {

void RoomColumns::note(const RoomView& view, MaskedColumns& masked) {
    const bool has_things = built_in::kThings && things_.gather(view, masked);
    if (!built_in::kPanels || !panels_.gather(view, masked)) {
        if (has_things) things_.note_all(view, masked);
        return;
    }
    // A panel may be before a thing in one column and behind it in the next.
    for (int x = view.viewport.begin; x < view.viewport.end; ++x)
        if (!view.viewport.rows_at(x).is_closed()) note_column(view, x, masked);
}

void RoomColumns::note_column(const RoomView& view, int x, MaskedColumns& masked) {
    std::size_t thing = 0;
    for (const PanelColumns::Look& panel : panels_.at(view, x)) {
        for (; thing < things_.count() && depth_steps(things_.depth(thing)) <= depth_steps(panel.hit.depth); ++thing)
            things_.note(view, thing, x, masked);
        panels_.note(view, panel, x, masked);
    }
    for (; thing < things_.count(); ++thing) things_.note(view, thing, x, masked);
}

}  // namespace enfilade::column
