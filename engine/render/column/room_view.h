// A viewport while what stands in its room is looked for.
#pragma once
#include "render/column/nearest_walls.h"
#include "render/column/row_split.h"
#include "render/column/scene.h"
#include "render/column/viewport.h"
#include "render/pose.h"

namespace enfilade::column {

struct RoomView {
    const Scene& scene;
    const Viewport& viewport;
    const Pose& pose;
    const RelativeHeights& here;
    const NearestWalls& nearest;
};

/// The part of a picture that is between the room's floor and ceiling.
inline RelativeHeights within(const RelativeHeights& room, double bottom, double top) {
    return {bottom > room.floor ? bottom : room.floor, top < room.ceiling ? top : room.ceiling};
}

}  // namespace enfilade::column
