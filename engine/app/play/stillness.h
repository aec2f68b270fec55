// When a picture need not be drawn again: where nothing that it shows has changed since.
#pragma once
#include <optional>
#include <vector>

#include "map/map.h"
#include "render/light_patch.h"
#include "render/view.h"
#include "world/snapshot.h"

namespace enfilade {

/// Whether both show the same of the same moment.
bool is_same_look(const View& a, const View& b);

/// Of one map: which sectors look different from moment to moment, whatever anybody does: their lights flicker, their
/// pictures scroll or follow one another, things in them turn. Lamps, and things that show one picture after the other,
/// are as they were between two changes: a candle asks for some pictures in a second, not for all that can be shown.
class Stillness {
public:
    explicit Stillness(const Map& map);

    /// Remembers what was drawn. seen: the sectors in the picture.
    void drew(const View& view, const Snapshot& snapshot, const std::vector<SectorId>& seen);

    /// The next picture is another, whatever it shows.
    void forget() { view_.reset(); }

    /// Whether a picture of this view at this moment would be the one that was drawn last. True only where that is
    /// certain; what moves out of sight counts as a change, too. Cost: the sectors that differ from the map at rest,
    /// and the lamps that flicker and the things with several pictures in what was seen.
    bool is_same(const View& view, const Snapshot& snapshot) const;

private:
    struct Moved {
        SectorId sector;
        double floor_z, ceiling_z, light;
        TextureId floor_picture;
        bool operator==(const Moved&) const = default;
    };
    struct Lamp {
        std::uint32_t light;  ///< index into Map::lights
        LampColor color;
    };
    struct ShownThing {
        ThingId thing;
        std::size_t frame;
    };
    static std::vector<Moved> moved_in(const Snapshot& snapshot);
    std::size_t frame_of(ThingId thing, const Snapshot& snapshot) const;
    bool changes_by_itself(SectorId sector, const Snapshot& snapshot) const;
    void remember_changing(SectorId sector, const Snapshot& snapshot);
    bool is_as_lit_and_shown(const Snapshot& snapshot) const;

    const Map& map_;
    LightImages lamps_;            ///< none where no lamp of the map flickers
    std::vector<bool> is_lively_;  ///< by sector
    std::optional<View> view_;     ///< none: nothing was drawn, or it changes by itself
    std::vector<Moved> moved_;
    std::vector<Lamp> lit_;          ///< the flickering lamps of what was seen
    std::vector<ShownThing> shown_;  ///< the things there that have several pictures
    std::vector<ThingId> taken_;
    std::vector<WallId> pressed_;
    WallId way_back_;
};

}  // namespace enfilade
