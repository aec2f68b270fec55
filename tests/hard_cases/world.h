// A map made in code with all that is needed to look at it.
#pragma once
#include "hard_cases/comparison.h"
#include "render/column/column_renderer.h"
#include "support/map_builder.h"
#include "support/trials.h"

namespace enfilade::test {

/// What the column renderer draws.
struct Drawn {
    Frame frame;
    FrameFacts facts;
};

struct MadeWorld {
    Map map;
    TextureSet textures;
    Snapshot snapshot;

    explicit MadeWorld(const MapFile& file) : map(built(file)), textures(textures_for(file)), snapshot(at_rest(map)) {}

    Subject subject() const { return {map.name, map, textures}; }

    Drawn draw(const View& view, PictureSize size) const {
        Drawn drawn;
        drawn.frame.resize(size.width, size.height);
        count_trials(drawn.frame.pixels.size(), "pixels");
        reset(drawn.facts, size.width, size.height);
        ColumnRenderer(map, textures).render(drawn.frame, &drawn.facts, snapshot, view);
        return drawn;
    }

    Comparison compare_with_reference(const View& view, PictureSize size) const {
        return compare(subject(), snapshot, view, size);
    }
};

}  // namespace enfilade::test
