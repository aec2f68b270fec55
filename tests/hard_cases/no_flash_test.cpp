// Walking through every link of the maps: no frame on the way shows what lies behind the doorway on paper.
//
// What would flash is seen in two ways. The last frame before the doorway and the first behind it show the same
// surfaces, because the eye has hardly moved; and every frame is what the reference sees, whose rays know no paper.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "hard_cases/comparison.h"
#include "hard_cases/linked_maps.h"
#include "math/vec.h"
#include "render/column/column_renderer.h"
#include "space/trace.h"

namespace enfilade::test {
namespace {

constexpr PictureSize kWalkSize{64, 40};
constexpr double kEyeHeight = 1.55;  ///< of one who stands [m]
constexpr double kApproach = 0.125;  ///< where a walk starts, before the doorway: within every threshold [m]
constexpr double kStep = 0x1p-16;    ///< a 65th of a millimetre [m]
constexpr int kSlivers = 8;          ///< surfaces thinner than a pixel that a step may show or hide, of 2560 [px]
constexpr int kSteps = 6;            ///< before the doorway, and as many behind it
constexpr int kTwelfth = 12;         ///< of the 144 links of the cells, which are alike, this part is walked

/// Through which part of the doorway, which way across it, and where one looks meanwhile.
struct Way {
    const char* name;
    double part;   ///< of the wall, from its start
    double slant;  ///< metres to the side per metre ahead
    Vec2 look;     ///< ahead and to the right of the way straight through; length 1
};

constexpr Way kWays[] = {{"forward", 0.5, 0, {1, 0}},
                         {"backward", 0.375, 0, {-1, 0}},
                         {"sideways", 0.625, 0, {0, 1}},
                         {"diagonally", 0.25, 1, {0.6, -0.8}}};

struct Shot {
    Place place;
    View view;
};

/// Walks through one link of a map and looks.
class Walker {
public:
    Walker(const LoadedMap& loaded, WallId door, const Way& way) : loaded_(loaded), map_(*loaded.map), way_(way) {
        const Wall& wall = map_[door];
        const Vec2 along = (wall.b - wall.a) * (1 / wall.length);
        ahead_ = {along.y, -along.x};  // out of the room, which is on the wall's right
        right_ = right_of(ahead_);
        middle_ = wall.a + (wall.b - wall.a) * way.part;
        sector_ = wall.sector;
    }

    /// The view after a walk to `distance` metres behind the doorway, none where something stands in the way. Whoever
    /// gets behind the doorway has stood on its line, exactly where the way says.
    std::optional<View> at(double distance) const {
        const Place from{sector_, on_way(-kApproach)};
        if (!contains(map_, from.sector, from.point)) return std::nullopt;
        const Trace to_door = trace(map_, from, on_way(std::min(distance, 0.0)));
        if (to_door.stopped) return std::nullopt;
        if (distance <= 0) return view_from(to_door.end, to_door.passage);
        const Vec2 target = snap_to_point_grid(to_door.passage.apply(on_way(distance)));
        const Trace on = trace(map_, to_door.end, target);
        if (on.stopped) return std::nullopt;
        return view_from(on.end, then(to_door.passage, on.passage));
    }

    std::vector<PixelSurface> surfaces(const View& view) const {
        Frame frame;
        frame.resize(kWalkSize.width, kWalkSize.height);
        FrameFacts facts;
        reset(facts, kWalkSize.width, kWalkSize.height);
        ColumnRenderer(map_, loaded_.textures).render(frame, &facts, at_rest(map_), view);
        return facts.ids;
    }

    Comparison against_reference(const std::string& name, const View& view) const {
        return compare({name, map_, loaded_.textures}, at_rest(map_), view, kWalkSize);
    }

private:
    /// passage: from where the walk began.
    View view_from(const Place& place, const Rigid& passage) const {
        View view;
        view.sector = place.sector;
        view.eye = place.point;
        view.eye_z = passage.apply_height(eye_height());
        view.forward = passage.turn(ahead_ * way_.look.x + right_ * way_.look.y);
        return view;
    }

    /// As of one who stands; in a window, half way up.
    double eye_height() const {
        const Sector& sector = map_[sector_];
        return std::min(sector.floor.z + kEyeHeight, (sector.floor.z + sector.ceiling.z) / 2);
    }

    Vec2 on_way(double distance) const {
        return snap_to_point_grid(middle_ + (ahead_ + right_ * way_.slant) * distance);
    }

    const LoadedMap& loaded_;
    const Map& map_;
    const Way& way_;
    Vec2 ahead_, right_, middle_;
    SectorId sector_;
};

/// Whether the pixels around i show the surface. Edges move by less than a pixel in a step.
bool is_around(const std::vector<PixelSurface>& ids, int x, int y, PixelSurface id) {
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, kWalkSize.height - 1); ++v)
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, kWalkSize.width - 1); ++u)
            if (ids[static_cast<std::size_t>(v * kWalkSize.width + u)] == id) return true;
    return false;
}

/// Pixels of `after` that show what was nowhere near them before.
int flashes(const std::vector<PixelSurface>& before, const std::vector<PixelSurface>& after) {
    int count = 0;
    for (int y = 0; y < kWalkSize.height; ++y)
        for (int x = 0; x < kWalkSize.width; ++x)
            count += !is_around(before, x, y, after[static_cast<std::size_t>(y * kWalkSize.width + x)]);
    return count;
}

class LinkedMap : public testing::TestWithParam<std::string> {
protected:
    void SetUp() override {
        loaded_ = load_linked_map(GetParam());
        std::vector<WallId> links = links_of(*loaded_.map);
        ASSERT_FALSE(links.empty());
        const std::size_t stride = links.size() > 100 ? kTwelfth : 1;
        for (std::size_t i = 0; i < links.size(); i += stride) doors_.push_back(links[i]);
    }

    /// Behind a one-way link there is something else to see when one looks back: there only the look ahead is steady.
    bool is_steady(WallId door, const Way& way) const {
        const Map& map = *loaded_.map;
        return map[map[door].exit].exit == door || way.look.x == 1;
    }

    std::string say(WallId door, const Way& way) const {
        const Map& map = *loaded_.map;
        return std::string(way.name) + " out of '" + map[map[door].sector].name + "'";
    }

    LoadedMap loaded_;
    std::vector<WallId> doors_;
};

// hard case R5
TEST_P(LinkedMap, ShowsTheSameSurfacesJustBeforeADoorwayAndJustBehindIt) {
    int walks = 0;
    for (const WallId door : doors_) {
        for (const Way& way : kWays) {
            if (!is_steady(door, way)) continue;
            const Walker walker(loaded_, door, way);
            std::vector<PixelSurface> before;
            for (int step = -kSteps; step <= kSteps; ++step) {
                const auto view = walker.at(step * kStep);
                ASSERT_TRUE(view) << say(door, way);
                std::vector<PixelSurface> ids = walker.surfaces(*view);
                if (step > -kSteps) {
                    EXPECT_LE(flashes(before, ids), kSlivers) << say(door, way) << ", step " << step;
                }
                before = std::move(ids);
            }
            ++walks;
        }
    }
    RecordProperty("walks", walks);
}

// hard cases R4, R24
TEST_P(LinkedMap, ShowsWhatTheReferenceSeesBeforeOnAndBehindEveryDoorway) {
    Comparison sum;
    for (const WallId door : doors_)
        for (const Way& way : kWays)
            for (const double distance : {-kStep, 0.0, kStep, kApproach / 2})
                if (const auto view = Walker(loaded_, door, way).at(distance))
                    sum += Walker(loaded_, door, way).against_reference("maps/" + GetParam() + ".toml", *view);
    EXPECT_TRUE(sum.is_faultless()) << describe(sum);
    EXPECT_GT(sum.pixels, 0u);
}

/// Exactly through a vertex: diagonally past the wall beside the doorway, or along its frame. What these hide changes
/// there from one step to the next, so only the reference tells what is to be seen. Who is on the line of a frame is
/// beside it or in it, as the tie rule says, on the other side of a link that turns maybe not the same: some are
/// stopped.
// hard case R3
TEST_P(LinkedMap, ShowsWhatTheReferenceSeesOnTheWayThroughTheVeryEndOfADoorway) {
    Comparison sum;
    int stood = 0, passed = 0;
    for (const WallId door : doors_)
        for (const double end : {0.0, 1.0})
            for (const double slant : {-1.0, 0.0, 1.0}) {
                const Way way{"through its end", end, slant, {0.8, slant < 0 ? -0.6 : 0.6}};
                for (const double distance : {-kStep, 0.0, kStep, kApproach / 2}) {
                    const auto view = Walker(loaded_, door, way).at(distance);
                    if (!view) continue;
                    stood += distance == 0;
                    passed += distance == kStep;
                    EXPECT_TRUE(contains(*loaded_.map, view->sector, view->eye));
                    sum += Walker(loaded_, door, way).against_reference("maps/" + GetParam() + ".toml", *view);
                }
            }
    EXPECT_TRUE(sum.is_faultless()) << describe(sum);
    EXPECT_GT(stood, 0);
    RecordProperty("passed", passed);
}

/// From well before the doorway to well behind it at once: the walk goes on in the room behind the link, at the place
/// that the link's own transform says.
// hard case C15
TEST_P(LinkedMap, IsCrossedInOneGreatStride) {
    const Map& map = *loaded_.map;
    int strides = 0;
    for (const WallId door : doors_) {
        const Wall& wall = map[door];
        const Vec2 along = (wall.b - wall.a) * (1 / wall.length), ahead{along.y, -along.x};
        const Vec2 middle = (wall.a + wall.b) * 0.5;
        const Place from{wall.sector, snap_to_point_grid(middle - ahead * kApproach)};
        const Vec2 to = snap_to_point_grid(middle + ahead);
        const Trace stride = trace(map, from, to);
        if (stride.stopped) continue;  // something stands right behind this one
        ++strides;
        ASSERT_FALSE(stride.crossings.empty());
        EXPECT_EQ(stride.crossings.front().portal, door);
        EXPECT_TRUE(contains(map, stride.end.sector, stride.end.point));
        const Vec2 off = stride.end.point - stride.passage.apply(to);
        EXPECT_LE(dot(off, off), 16 * kPointGrid * kPointGrid);
    }
    EXPECT_GT(strides, 0);
}

INSTANTIATE_TEST_SUITE_P(Maps, LinkedMap, testing::ValuesIn(kLinkedMaps));

}  // namespace
}  // namespace enfilade::test
