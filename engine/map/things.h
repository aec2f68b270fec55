// Things and what they look like: from records to values. Private to map/.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "map/draft.h"

namespace enfilade {

/// Makes sprites of records, each only once: a hundred barrels share one.
class SpriteShelf {
public:
    explicit SpriteShelf(Draft& draft) : draft_(draft) {}

    /// What the thing looks like; none where it has no frames.
    SpriteId sprite_of(const ThingRecord& thing);

private:
    using OriginKey = std::optional<std::pair<double, double>>;
    using FrameKey = std::tuple<std::string, double, OriginKey>;       ///< picture, seconds, origin
    using SpriteKey = std::tuple<int, double, std::vector<FrameKey>>;  ///< rotations, size, frames

    Draft& draft_;
    std::map<SpriteKey, SpriteId> known_;
};

/// Adds the thing, which is inside the sector, to the draft's map.
void add_thing(Draft& draft, const ThingRecord& record, SectorId sector, SpriteShelf& sprites);

/// Sorts the solid things by sector.
void list_solid_things(Map& map);

/// Sorts the things that do something when touched by sector; their triggers and keys are known.
void list_touchables(Map& map);

}  // namespace enfilade
