// When a picture need not be drawn again: where nothing that it shows has changed since.
#pragma once
#include <optional>
#include <vector>

#include "map/map.h"
#include "render/view.h"
#include "world/snapshot.h"

namespace enfilade {

/// Whether both show the same of the same moment.
bool is_same_look(const View& a, const View& b);

/// Of one map: which sectors look different from moment to moment, whatever anybody does: their lights flicker, their
/// pictures scroll or follow one another, things in them turn.
class Stillness {
public:
    explicit Stillness(const Map& map);

    /// Remembers what was drawn. seen: the sectors in the picture.
    void drew(const View& view, const Snapshot& snapshot, const std::vector<SectorId>& seen);

    /// The next picture is another, whatever it shows.
    void forget() { view_.reset(); }

    /// Whether a picture of this view at this moment would be the one that was drawn last. True only where that is
    /// certain; what moves out of sight counts as a change, too. Cost: the sectors that differ from the map at rest.
    bool is_same(const View& view, const Snapshot& snapshot) const;

private:
    struct Moved {
        SectorId sector;
        double floor_z, ceiling_z, light;
        TextureId floor_picture;
        bool operator==(const Moved&) const = default;
    };
    static std::vector<Moved> moved_in(const Snapshot& snapshot);

    const Map& map_;
    std::vector<bool> is_lively_;  ///< by sector
    std::optional<View> view_;     ///< none: nothing was drawn, or it changes by itself
    std::vector<Moved> moved_;
    std::vector<ThingId> taken_;
    std::vector<WallId> pressed_;
    WallId way_back_;
};

}  // namespace enfilade
