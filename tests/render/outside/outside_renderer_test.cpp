// Pictures from outside, pixel for pixel, of maps that are painted in one colour each.
#include "render/outside/outside_renderer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "support/map_builder.h"

namespace enfilade {
namespace {

using test::box_room;

constexpr std::uint32_t kFloor = 0xFF40C080, kCeiling = 0xFF0000FF, kWall = 0xFFC08040, kFarFloor = 0xFF8040C0;
constexpr std::uint32_t kBackground = 0xFF281C14;

class FromOutside : public ::testing::Test {
protected:
    /// With pictures of one colour each; "far" has a floor of its own.
    void load(MapFile file) {
        for (SectorRecord& sector : file.sectors)
            if (sector.name == "far") sector.floor.texture = test::spec("far_floor");
        map_ = test::built(file);
        textures_ = test::textures_for(file);
        for (Texture& texture : textures_.textures) std::ranges::fill(texture.pixels, color_of(texture.name));
        renderer_.emplace(map_, textures_);
        view_.sector = SectorId(0u);
        view_.eye = {2, 2};
        view_.eye_z = 1;
        frame_.resize(480, 360);
    }

    static std::uint32_t color_of(const std::string& name) {
        if (name == "floor") return kFloor;
        if (name == "far_floor") return kFarFloor;
        return name == "ceiling" ? kCeiling : kWall;
    }

    void draw(OutsideFrom from = OutsideFrom::above, std::size_t workers = 1) {
        renderer_->render(frame_, at_rest(map_), view_, {from, 24, 320, 200}, workers);
    }

    /// The pixel that shows a point.
    std::uint32_t at(Vec2 p, double z, OutsideFrom from = OutsideFrom::above) const {
        const OutsideCamera camera(from, view_, 24, frame_.width, frame_.height);
        const PicturePoint point = camera.project(p, z);
        const int x = int(point.x / point.w), y = int(point.y / point.w);
        return frame_.pixels[std::size_t(y * frame_.width + x)];
    }

    static std::uint32_t dim(std::uint32_t color) { return shaded(color, 104); }
    static std::uint32_t dimmer(std::uint32_t color) { return shaded(color, 64); }

    Map map_;
    TextureSet textures_;
    View view_;
    Frame frame_;
    std::optional<OutsideRenderer> renderer_;  ///< of the map that was loaded last
};

TEST_F(FromOutside, LooksThroughTheRoofAndLightsWhatTheEyeSees) {
    load(test::map_of({box_room("room", 0, 0, 8, 4)}));
    draw();
    EXPECT_EQ(at({6, 2.2}, 0), kFloor);
    EXPECT_EQ(at({1, 2}, 0), dim(kFloor)) << "behind the eye";
    EXPECT_EQ(at({2.5, 3.9}, 0), dim(kFloor)) << "beside its view";
    EXPECT_EQ(at({8, 2.2}, 1), kWall);
    EXPECT_EQ(at({12, 2}, 0), kBackground);
    EXPECT_EQ(std::ranges::count(frame_.pixels, kCeiling), 0);
}

TEST_F(FromOutside, LightsWallsWithoutSpeckles) {
    load(test::map_of({test::room("room", {{0, 0}, {8, 0}, {6, 4}, {0, 4}})}));
    draw();
    const std::uint32_t lit = shaded(kWall, Shade(256 * map_.walls[1].contrast));
    for (double part = 0.2; part < 0.8; part += 0.01)
        for (double z = 0.3; z < 1.8; z += 0.1)
            if (const Vec2 p = Vec2{8, 0} + Vec2{-2, 4} * part; at(p, z) != kEyeMark) {
                EXPECT_EQ(at(p, z), lit) << part;
            }
}

TEST_F(FromOutside, DrawsTheEyeAndTheEdgesOfItsView) {
    load(test::map_of({box_room("room", 0, 0, 8, 4)}));
    draw();
    EXPECT_EQ(at({3, 1}, 1), kEyeMark);
    EXPECT_EQ(at({3, 3}, 1), kEyeMark);
    EXPECT_GT(std::ranges::count(frame_.pixels, kEyeMark), 20);
}

TEST_F(FromOutside, ShowsALinkedRoomWhereItAppearsAndFramesItsDoor) {
    MapFile file = test::map_of({box_room("room", 0, 0, 4, 4), box_room("far", 104, 50, 112, 54, 7, 9)});
    test::link(file, "room", {4, 0}, {4, 4}, "far", {104, 54}, {104, 50});
    load(file);
    view_.fov_degrees = 40;
    draw();
    EXPECT_EQ(at({10, 2.2}, 0), kFarFloor);
    EXPECT_EQ(at({5.5, 0.3}, 0), dimmer(kFarFloor));
    EXPECT_GT(std::ranges::count(frame_.pixels, kLinkMark), 40);
    EXPECT_EQ(std::ranges::count(frame_.pixels, kMirrorMark), 0);
}

TEST_F(FromOutside, ShowsTheRoomInAMirrorBehindIt) {
    MapFile file = test::map_of({box_room("room", 0, 0, 4, 4)});
    test::wall(file, "room", {4, 0}, {4, 4}).mirror = true;
    load(file);
    draw();
    EXPECT_EQ(at({6.5, 2.2}, 0), kFloor);
    EXPECT_EQ(at({8, 2.2}, 1), kWall) << "the wall behind the eye";
    EXPECT_EQ(at({8.2, 2.2}, 2.2), kBackground);
    EXPECT_GT(std::ranges::count(frame_.pixels, kMirrorMark), 40);
}

TEST_F(FromOutside, ShowsNeighboursThatAreNotSeenDimly) {
    MapFile file = test::map_of({box_room("room", 0, 0, 4, 4), box_room("far", 4, 0, 8, 4)});
    test::join_all(file);
    load(file);
    view_.forward = {-1, 0};
    draw();
    EXPECT_EQ(at({6, 2}, 0), dim(kFarFloor));
}

TEST_F(FromOutside, LooksOverTheShoulderFromBehind) {
    load(test::map_of({box_room("room", -20, 0, 8, 4)}));
    draw(OutsideFrom::behind);
    EXPECT_EQ(at({6, 2.2}, 0, OutsideFrom::behind), kFloor);
    EXPECT_EQ(at({2, 2.5}, 0, OutsideFrom::behind), dim(kFloor));
    EXPECT_EQ(at({8, 2.2}, 1.5, OutsideFrom::behind), kWall);
}

TEST_F(FromOutside, DrawsTheSameWithAnyNumberOfThreads) {
    MapFile file = test::map_of({box_room("room", 0, 0, 4, 4)});
    test::link(file, "room", {4, 0}, {4, 4}, "room", {0, 4}, {0, 0});
    load(file);
    draw(OutsideFrom::behind, 1);
    const auto alone = frame_.pixels;
    draw(OutsideFrom::behind, 5);
    EXPECT_EQ(frame_.pixels, alone);
}

TEST_F(FromOutside, ForgetsTheMapBefore) {
    load(test::map_of({box_room("room", 0, 0, 8, 4)}));
    draw();
    load(test::map_of({box_room("far", 0, 0, 8, 4)}));
    draw();
    EXPECT_EQ(at({6, 2.2}, 0), kFarFloor);
}

TEST_F(FromOutside, LooksAtTheHouseFromAnotherPlace) {
    MapFile file = test::map_of({box_room("room", 0, 0, 8, 4), box_room("far", 20, 0, 24, 4)});
    load(file);
    View camera = view_;
    camera.sector = SectorId(1u);
    camera.eye = {22, -10};
    camera.eye_z = 8;
    camera.forward = {0, 1};
    camera.fov_degrees = 140;
    camera.pitch_tangent = -8.0 / 12;  // at the middle of the far floor, over its near wall
    OutsideLook look;
    look.camera = &camera;
    renderer_->render(frame_, at_rest(map_), view_, look, 1);
    EXPECT_EQ(frame_.pixels[std::size_t(180 * 480 + 240)], dim(kFarFloor));
    EXPECT_GT(std::ranges::count(frame_.pixels, dim(kFloor)), 0) << "the room of the eye";
}

TEST_F(FromOutside, ShowsThingsFromTheSideOnWhichItIs) {
    MapFile file = test::map_of({box_room("room", 0, 0, 12, 4)});
    ThingRecord statue;
    statue.position = {7, 2};
    statue.rotations = 8;  // looks along +x: its back, picture 5, to who looks that way
    statue.frames.push_back({"statue", 0, {}});
    file.things.push_back(statue);
    load(file);
    const auto paint = [&](const std::string& name, std::uint32_t color) {
        std::ranges::fill(textures_.textures[textures_.find(name).index].pixels, color);
    };
    paint("statue5", 0xFF00FF00), paint("statue1", 0xFFFF00FF);
    draw();
    EXPECT_EQ(at({7, 2}, 0.5), 0xFF00FF00u);
    View camera = view_;
    camera.eye = {30, 2};
    camera.forward = {-1, 0};
    OutsideLook look;
    look.camera = &camera;
    renderer_->render(frame_, at_rest(map_), view_, look, 1);
    EXPECT_GT(std::ranges::count(frame_.pixels, 0xFFFF00FFu), 0);
}

}  // namespace
}  // namespace enfilade
