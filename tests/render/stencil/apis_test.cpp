// The same pictures by OpenGL and OpenGL ES, by one renderer and another; and pictures that cannot be.
#include <gtest/gtest.h>

#include <thread>

#include "hard_cases/scenes.h"
#include "render/stencil/agreement.h"
#include "support/looks.h"
#include "support/map_builder.h"

namespace enfilade::test {
namespace {

constexpr PictureSize kApiSize{160, 100};

struct Hall {
    MapFile file = linked_rooms();
    Map map = built(file);
    TextureSet textures = textures_for(file);
    View view = look_from(map, {10, 12}, 1.5, 30);
};

TEST(StencilApis, DrawTheSamePicture) {
    const Hall hall;
    const StencilPicture desktop = Sight(hall.map, hall.textures, GlApi::desktop).by_stencil(hall.view, kApiSize);
    const StencilPicture es = Sight(hall.map, hall.textures, GlApi::es).by_stencil(hall.view, kApiSize);
    EXPECT_EQ(desktop.frame.pixels, es.frame.pixels);
}

TEST(StencilRenderer, DrawsTheSameWithAndWithoutFacts) {
    const Hall hall;
    const auto renderer = software_stencil(hall.map, hall.textures);
    const StencilPicture with_facts = Sight(hall.map, hall.textures).by_stencil(hall.view, kApiSize);
    Frame frame;
    frame.resize(kApiSize.width, kApiSize.height);
    EXPECT_TRUE(renderer->render(frame, nullptr, at_rest(hall.map), hall.view).ok());
    EXPECT_EQ(frame.pixels, with_facts.frame.pixels);
}

TEST(StencilRenderer, DrawsOnAnyThread) {
    const Hall hall;
    Sight sight(hall.map, hall.textures);
    const StencilPicture here = sight.by_stencil(hall.view, kApiSize);
    StencilPicture there;
    std::thread([&] { there = sight.by_stencil(hall.view, kApiSize); }).join();
    EXPECT_EQ(here.frame.pixels, there.frame.pixels);
}

// hard case G12
TEST(StencilRenderer, ChangesItsSize) {
    const Hall hall;
    Sight sight(hall.map, hall.textures);
    const StencilPicture first = sight.by_stencil(hall.view, kApiSize);
    sight.by_stencil(hall.view, {33, 7});
    EXPECT_EQ(sight.by_stencil(hall.view, kApiSize).frame.pixels, first.frame.pixels);
}

// hard cases R12, G12
TEST(StencilRenderer, DrawsASinglePixel) {
    const Hall hall;
    expect_agreement(Sight(hall.map, hall.textures).compare(hall.view, {1, 1}));
}

/// A context that was lost.
class LostContext final : public GlContext {
public:
    Result<void> make_current() override { return Error{"OpenGL", "the context was lost"}; }
    void release() override {}
};

TEST(StencilRenderer, SaysThatTheContextWasLost) {
    const Hall hall;
    const auto renderer = StencilRenderer::make(std::make_unique<LostContext>(), hall.map, hall.textures);
    ASSERT_FALSE(renderer.ok());
    EXPECT_EQ(renderer.error().text(), "OpenGL: the context was lost");
}

}  // namespace
}  // namespace enfilade::test
