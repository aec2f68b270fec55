// Looks that cost more than a frame may: all renderers end them at the same doorway, in the recursion colour, and say
// so.
#include "render/openings.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "render/column/column_renderer.h"
#include "render/reference/reference_renderer.h"
#include "render/stencil/agreement.h"
#include "support/looks.h"
#include "support/map_builder.h"

namespace enfilade::test {
namespace {

constexpr PictureSize kBudgetSize{96, 60};
constexpr std::size_t kPixels = std::size_t{96} * 60, kMiddle = std::size_t{30} * 96 + 48;
constexpr std::uint32_t kRecursionColor = 0xFFFF00FFu;

/// A tall hall of which each of many north walls leads in again by the south wall opposite, for ever.
MapFile hall_of_links(int walls, int max_depth) {
    std::vector<Vec2> outline;
    for (int i = 0; i <= walls; ++i) outline.push_back({i * 0.25, 0});
    for (int i = walls; i >= 0; --i) outline.push_back({i * 0.25, 4});
    MapFile file = map_of({room("hall", outline, -500, 500)});
    for (int i = 0; i < walls; ++i) {
        WallRecord &north = file.sectors[0].loops[0].walls[static_cast<std::size_t>(i)],
                   &south = file.sectors[0].loops[0].walls[static_cast<std::size_t>(2 * walls - i)];
        north.name = "n" + std::to_string(i);
        south.name = "s" + std::to_string(i);
        north.next = south.next = "hall";
        north.via = south.name;
        south.via = north.name;
    }
    file.render.max_depth = max_depth;
    return file;
}

/// Rooms in a row, one metre long and 64 m wide, each with a doorway as wide as itself into the next.
MapFile row_of_rooms(int count) {
    std::vector<SectorRecord> rooms;
    for (int i = 0; i < count; ++i) {
        rooms.push_back(box_room("r" + std::to_string(i), i, 0, i + 1, 64, -2000, 2000));
        std::vector<WallRecord>& walls = rooms.back().loops[0].walls;
        if (i + 1 < count) walls[1].next = "r" + std::to_string(i + 1);
        if (i > 0) walls[3].next = "r" + std::to_string(i - 1);
    }
    return map_of(std::move(rooms));
}

struct BudgetPlace {
    Map map;
    TextureSet textures;
    Sight sight;
    View view;
    BudgetPlace(const MapFile& file, Vec2 eye, double yaw_degrees)
        : map(built(file)),
          textures(textures_for(file)),
          sight(map, textures),
          view(look_from(map, eye, 0, yaw_degrees)) {}
};

BudgetPlace hall(int walls, int max_depth) {
    return {hall_of_links(walls, max_depth), {walls * 0.125 + 0.0625, 2}, -90};
}

std::size_t ends_in(const StencilPicture& picture) {
    return static_cast<std::size_t>(std::ranges::count(picture.facts.ids, kRecursionEnd));
}

std::size_t different_surfaces(const StencilPicture& one, const StencilPicture& truth) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < kPixels; ++i) count += one.facts.ids[i] != truth.facts.ids[i];
    return count;
}

void expect_all_cut_short_alike(BudgetPlace& place) {
    const StencilPicture column = place.sight.by_column(place.view, kBudgetSize),
                         stencil = place.sight.by_stencil(place.view, kBudgetSize),
                         reference = place.sight.by_reference(place.view, kBudgetSize);
    for (const StencilPicture* picture : {&column, &stencil, &reference}) {
        EXPECT_TRUE(picture->frame.is_cut_short);
        EXPECT_EQ(picture->facts.ids[kMiddle], kRecursionEnd);
        EXPECT_EQ(picture->frame.pixels[kMiddle], kRecursionColor);
        EXPECT_EQ(std::ranges::count(picture->facts.ids, kNothing), 0);
    }
    EXPECT_EQ(different_surfaces(column, reference), 0u);
    EXPECT_EQ(different_surfaces(stencil, reference), 0u);
}

// hard case R23
TEST(LookBudget, EndsLooksThroughLinksInAllRenderersAlike) {
    BudgetPlace place = hall(500, 1024);
    expect_all_cut_short_alike(place);
}

TEST(LookBudget, EndsLooksThroughPlainDoorwaysInAllRenderersAlike) {
    BudgetPlace place(row_of_rooms(2000), {0.5, 32}, 0);
    expect_all_cut_short_alike(place);
}

TEST(LookBudget, IsNotMetBeforeTheDepthOfAnyHonestMap) {
    BudgetPlace links = hall(500, 60), rooms(row_of_rooms(1800), {0.5, 32}, 0);
    for (BudgetPlace* place : {&links, &rooms}) {
        EXPECT_FALSE(place->sight.by_column(place->view, kBudgetSize).frame.is_cut_short);
        EXPECT_FALSE(place->sight.by_stencil(place->view, kBudgetSize).frame.is_cut_short);
        EXPECT_FALSE(place->sight.by_reference(place->view, kBudgetSize).frame.is_cut_short);
    }
    EXPECT_GT(ends_in(links.sight.by_column(links.view, kBudgetSize)), 0u);  // of depth, not of the budget
}

TEST(LookBudget, BoundsTheWallsLookedAtByTheColumnsOfThePicture) {
    for (const int walls : {500, 1000, 2000}) {
        BudgetPlace place = hall(walls, 1024);
        Frame frame;
        frame.resize(kBudgetSize.width, kBudgetSize.height);
        ColumnRenderer renderer(place.map, place.textures);
        renderer.render(frame, nullptr, at_rest(place.map), place.view);
        const std::size_t each = cost_of_look_into(place.map.sectors[0], 0);
        EXPECT_LE(renderer.counts().viewports * each, std::size_t(kBudgetSize.width) * (kLookBudget + each)) << walls;
        EXPECT_GT(renderer.counts().viewports, std::size_t(kBudgetSize.width)) << walls;
    }
}

TEST(LookBudget, IsTheSameForAnyNumberOfThreads) {
    BudgetPlace place = hall(500, 1024);
    Frame whole, parts;
    for (Frame* frame : {&whole, &parts}) frame->resize(kBudgetSize.width, kBudgetSize.height);
    ColumnStrips(place.map, place.textures, 1).render(whole, nullptr, at_rest(place.map), place.view);
    EXPECT_TRUE(whole.is_cut_short);
    for (const std::size_t threads : {2u, 7u}) {
        ColumnStrips(place.map, place.textures, threads).render(parts, nullptr, at_rest(place.map), place.view);
        EXPECT_EQ(parts.pixels, whole.pixels) << threads;
        EXPECT_TRUE(parts.is_cut_short);
    }
}

TEST(LookBudget, IsForgottenInTheNextFrame) {
    BudgetPlace place = hall(500, 1024);
    View wall = place.view;
    wall.forward = {1, 0};
    wall.eye = {124.75, 2};
    wall.fov_degrees = 10;
    ColumnRenderer column(place.map, place.textures);
    Frame frame;
    frame.resize(kBudgetSize.width, kBudgetSize.height);
    for (const bool to_links : {true, false}) {
        const View& view = to_links ? place.view : wall;
        column.render(frame, nullptr, at_rest(place.map), view);
        EXPECT_EQ(frame.is_cut_short, to_links);
        EXPECT_EQ(place.sight.by_stencil(view, kBudgetSize).frame.is_cut_short, to_links);
        EXPECT_EQ(place.sight.by_reference(view, kBudgetSize).frame.is_cut_short, to_links);
    }
}

}  // namespace
}  // namespace enfilade::test
