// More pictures one behind the other than a look takes: all renderers leave out the same ones, and things and panels
// count for what a look may cost.
#include <gtest/gtest.h>

#include <algorithm>

#include "render/column/column_renderer.h"
#include "render/openings.h"
#include "render/stencil/agreement.h"
#include "support/furnish.h"
#include "support/looks.h"
#include "support/map_builder.h"

namespace enfilade::test {
namespace {

constexpr PictureSize kLimitSize{97, 61};
constexpr int kMiddleColumn = 48;

constexpr std::size_t pixel(int x, int y) {
    return static_cast<std::size_t>(y) * kLimitSize.width + static_cast<std::size_t>(x);
}

/// Seen from (0.5, 4) along x.
struct Gallery {
    Map map;
    TextureSet textures;
    Sight sight;
    View view;
    explicit Gallery(const MapFile& file)
        : map(built(file)), textures(with_lattice(file)), sight(map, textures), view(look_from(map, {0.5, 4}, 2, 0)) {}

    static TextureSet with_lattice(const MapFile& file) {
        TextureSet textures = textures_for(file);
        if (const TextureId found = textures.find("lattice")) textures.textures[found.index] = lattice();
        return textures;
    }
};

/// A picture of 16 texels to the metre that stands on the floor.
ThingRecord thing_at(Vec2 position, double texels_per_m) {
    ThingRecord thing;
    thing.position = position;
    thing.size = texels_per_m;
    thing.frames = {{"lattice", 0, Vec2{32, 64}}};
    return thing;
}

/// Low things in a row, and behind them a tall one that is seen over all of them.
MapFile row_before_a_giant(std::size_t count) {
    MapFile file = map_of({box_room("hall", 0, 0, 64, 8, 0, 8)});
    for (std::size_t i = 0; i < count; ++i)
        file.things.push_back(thing_at({2 + 0.0625 * static_cast<double>(i), 4}, 256));
    file.things.push_back(thing_at({60, 4}, 8));
    return file;
}

bool shows_the_last_thing(const Gallery& gallery, const StencilPicture& picture) {
    const PixelSurface last = thing_id(gallery.map, ThingId(gallery.map.things.size() - 1));
    bool shows = false;
    for (int y = 0; y < kLimitSize.height; ++y) shows |= picture.facts.ids[pixel(kMiddleColumn, y)] == last;
    return shows;
}

void expect_the_same_in_all_renderers(Gallery& gallery) {
    const StencilPicture column = gallery.sight.by_column(gallery.view, kLimitSize),
                         reference = gallery.sight.by_reference(gallery.view, kLimitSize);
    std::size_t different = 0, certain = 0;
    for (std::size_t i = 0; i < column.facts.ids.size(); ++i) {
        ++certain;
        different +=
            column.facts.ids[i] != reference.facts.ids[i] || column.frame.pixels[i] != reference.frame.pixels[i];
    }
    EXPECT_EQ(different, 0u);
    EXPECT_GT(certain, column.facts.ids.size() / 2);
    expect_agreement(gallery.sight.compare(gallery.view, kLimitSize));
}

TEST(PictureLimit, IsMetByAsManyThingsAsItSays) {
    Gallery most(row_before_a_giant(kMostPictures - 1)), one_more(row_before_a_giant(kMostPictures));
    const auto is_shown = [](Gallery& gallery, StencilPicture picture) {
        return shows_the_last_thing(gallery, picture);
    };
    EXPECT_TRUE(is_shown(most, most.sight.by_column(most.view, kLimitSize)));
    EXPECT_TRUE(is_shown(most, most.sight.by_stencil(most.view, kLimitSize)));
    EXPECT_TRUE(is_shown(most, most.sight.by_reference(most.view, kLimitSize)));
    EXPECT_FALSE(is_shown(one_more, one_more.sight.by_column(one_more.view, kLimitSize)));
    EXPECT_FALSE(is_shown(one_more, one_more.sight.by_stencil(one_more.view, kLimitSize)));
    EXPECT_FALSE(is_shown(one_more, one_more.sight.by_reference(one_more.view, kLimitSize)));
}

TEST(PictureLimit, LeavesOutTheSameInAllRenderers) {
    Gallery gallery(row_before_a_giant(kMostPictures + 40));
    expect_the_same_in_all_renderers(gallery);
}

/// Rooms in a row, each with a thing, a panel and a fence in the doorway behind: three pictures a room.
MapFile furnished_rooms(int count) {
    std::vector<SectorRecord> rooms;
    for (int i = 0; i < count; ++i) {
        const double x = 0.5 * i;
        rooms.push_back(box_room("r" + std::to_string(i), x, 0, x + 0.5, 8, 0, 8));
        rooms.back().panels.push_back(panel({x + 0.25, 1}, {x + 0.25, 7}, 0, 0.5 + i * 0.0078125));
        std::vector<WallRecord>& walls = rooms.back().loops[0].walls;
        if (i + 1 < count) walls[1].next = "r" + std::to_string(i + 1);
        if (i > 0) walls[3].next = "r" + std::to_string(i - 1);
        if (i + 1 < count) walls[1].middle = spec("lattice");
    }
    MapFile file = map_of(std::move(rooms));
    for (int i = 2; i < count; ++i) {
        file.things.push_back(thing_at({0.5 * i + 0.375, 4}, 256));
        file.things.back().sector = "r" + std::to_string(i);
    }
    return file;
}

TEST(PictureLimit, CountsThingsPanelsAndFencesTogetherThroughAllRooms) {
    Gallery gallery(furnished_rooms(230));
    expect_the_same_in_all_renderers(gallery);
}

/// A hall whose ends lead into each other, full of things beside the way.
MapFile hall_of_things(int count) {
    MapFile file = map_of({box_room("hall", 0, 0, 8, 200, 0, 8)});
    std::vector<WallRecord>& walls = file.sectors[0].loops[0].walls;
    walls[1].name = "east";
    walls[3].name = "west";
    walls[1].next = walls[3].next = "hall";
    walls[1].via = "west";
    walls[3].via = "east";
    for (int i = 0; i < count; ++i) file.things.push_back(thing_at({1 + 6.0 * i / count, 0.5}, 640));
    file.render.max_depth = 1024;
    return file;
}

TEST(LookBudget, IsSpentOnThingsToo) {
    constexpr PictureSize kSmall{24, 15};
    Gallery gallery(hall_of_things(6000));
    const StencilPicture column = gallery.sight.by_column(gallery.view, kSmall),
                         stencil = gallery.sight.by_stencil(gallery.view, kSmall),
                         reference = gallery.sight.by_reference(gallery.view, kSmall);
    const std::size_t middle = 7 * 24 + 12;
    for (const StencilPicture* picture : {&column, &stencil, &reference}) {
        EXPECT_TRUE(picture->frame.is_cut_short);
        EXPECT_EQ(picture->facts.ids[middle], kRecursionEnd);
    }
    for (std::size_t i = 0; i < reference.facts.ids.size(); ++i) {
        EXPECT_EQ(column.facts.ids[i], reference.facts.ids[i]) << i;
    }
}

TEST(LookBudget, LetsOneLookOutOfARoomFullOfThings) {
    MapFile file = hall_of_things(70'000);
    const Map map = built(file);
    const TextureSet textures = textures_for(file);
    Frame frame;
    frame.resize(24, 15);
    ColumnRenderer renderer(map, textures);
    renderer.render(frame, nullptr, at_rest(map), look_from(map, {0.5, 4}, 2, 0));
    EXPECT_EQ(renderer.counts().deepest, 1);
    EXPECT_TRUE(renderer.counts().is_cut_short);  // at the next doorway
}

}  // namespace
}  // namespace enfilade::test
