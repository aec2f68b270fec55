// What stands in a room: its things and panels, in one order in every column.
#pragma once
#include "render/column/panel_columns.h"
#include "render/column/thing_columns.h"

namespace enfilade::column {

/// Notes the things and panels of one viewport at a time. A viewport without them costs a look at two empty lists.
class RoomColumns {
public:
    /// Notes every column of every picture, of each column the nearest first; of a thing and a panel at one depth, in
    /// steps (render/sprite.h), the thing. To be called before the viewport's masked walls are noted: they stand at the
    /// end of the room, behind all that is in it.
    void note(const RoomView& view, MaskedColumns& masked);

private:
    void note_column(const RoomView& view, int x, MaskedColumns& masked);

    ThingColumns things_;
    PanelColumns panels_;
};

}  // namespace enfilade::column
