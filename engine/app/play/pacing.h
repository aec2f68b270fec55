// When pictures are begun and shown: evenly, and as late as can be, so that they show what was pressed last; and not at
// all where nothing that they show has changed.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "map/map.h"
#include "render/light_patch.h"
#include "render/view.h"
#include "world/snapshot.h"

namespace enfilade {

/// So long after the last event a page on which nothing moves counts as idle [ns].
inline constexpr std::int64_t kUntilIdle = 500'000'000;

/// Where nothing moves, events are looked for this often; where nobody sees the window, that often [1/s].
inline constexpr double kIdleHz = 30, kHiddenHz = 10;

/// Moments are those of now_ns() (platform/clock.h) [ns].
class Pacing {
public:
    /// period > 0: from one picture to the next [ns].
    void set_period(std::int64_t period) { period_ = period; }

    /// When the next picture is due; it is begun so much before as the slowest of the last ones took.
    std::int64_t due() const { return due_; }
    std::int64_t begin() const;

    /// A picture took so long to draw [ns].
    void drew(std::int64_t took);

    /// The moment that was due has passed, with a picture or without one. Who is late by more than a period begins
    /// anew.
    void go_on(std::int64_t now);

private:
    static constexpr std::size_t kKept = 30;         ///< pictures: half a second
    static constexpr std::int64_t kSpare = 500'000;  ///< for what drawing is not [ns]

    std::array<std::int64_t, kKept> took_{};
    std::size_t count_ = 0;
    std::int64_t period_ = 16'666'667, due_ = 0;
};

// Whether anything has changed.

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
