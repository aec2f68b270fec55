// The stencil renderer held against the column renderer, or where that cannot, the reference, pixel by pixel.
#pragma once
#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "hard_cases/poses.h"
#include "hard_cases/scenes.h"
#include "map/textures.h"
#include "platform/gl_context.h"
#include "render/lighting.h"
#include "render/stencil/stencil_renderer.h"
#include "world/snapshot.h"

namespace enfilade::test {

/// What a test of one scene is called.
inline std::string name_of_scene(const testing::TestParamInfo<NamedScene>& info) { return info.param.name; }

/// How pictures of one view, or of many, differ [px].
struct Agreement {
    std::uint64_t pixels = 0;
    std::uint64_t undrawn = 0;      ///< shows nothing
    std::uint64_t at_edges = 0;     ///< another surface, or another part of it, within a pixel of an edge
    std::uint64_t elsewhere = 0;    ///< another surface, and no edge near
    std::uint64_t other_texel = 0;  ///< same surface, another colour, but next to a texel's or a light band's edge; or
                                    ///< another surface, but next to a hole of a picture
    std::uint64_t wrong_color = 0;  ///< same surface, more than 2/255 off, and no such excuse
    int worst_difference = 0;       ///< of a channel where surfaces are the same and there is no such excuse
    double worst_share = 0;         ///< largest share of differing surfaces in one picture
    std::string worst_view, first_fault;

    Agreement& operator+=(const Agreement& other);
};

std::string describe(const Agreement& agreement);

/// A renderer in a headless context drawn by the CPU (Mesa's llvmpipe), whatever graphics card there is. Where there is
/// no such context the test program stops: a machine that cannot test this must not pass.
std::unique_ptr<StencilRenderer> software_stencil(const Map& map, const TextureSet& textures,
                                                  GlApi api = GlApi::desktop,
                                                  int light_points_per_m = kUsualLightPoints);

/// What one renderer drew.
struct StencilPicture {
    Frame frame;
    FrameFacts facts;
    std::vector<std::size_t> viewports;  ///< of each pixel, the number of the last that it is in; only by column
};

/// Whose picture is right.
enum class Truth : std::uint8_t { column, reference };

/// A map, what it shows, and both renderers.
class Sight {
public:
    Sight(const Map& map, const TextureSet& textures, GlApi api = GlApi::desktop,
          int light_points_per_m = kUsualLightPoints);

    /// Both pictures; a failure of OpenGL stops the test program.
    StencilPicture by_stencil(const View& view, PictureSize size);
    StencilPicture by_column(const View& view, PictureSize size) const;
    StencilPicture by_reference(const View& view, PictureSize size) const;

    /// With the column renderer's picture; tilted views, and where asked for all, with the reference's.
    Agreement compare(const View& view, PictureSize size, Truth truth = Truth::column);
    /// `count` random poses and as many where things coincide.
    Agreement compare_poses(int count, PictureSize size, std::uint64_t seed);
    Agreement compare_random_poses(int count, PictureSize size, std::uint64_t seed);

    Snapshot& snapshot() { return snapshot_; }
    StencilCounts counts() const { return stencil_->counts(); }

private:
    /// What a picture shows, and of which surface.
    struct Aside {
        Pixels pixels;
        std::vector<PixelSurface> ids;
    };
    StencilPicture truth_of(const View& view, PictureSize size) const;
    enum class Same : std::uint8_t { surface, color };
    bool is_hair_aside(const View& view, PictureSize size, std::size_t pixel, const StencilPicture& shown, Same what);
    const Aside& aside(std::size_t number, const View& view, PictureSize size);

    const Map& map_;
    const TextureSet& textures_;
    Snapshot snapshot_;
    std::unique_ptr<StencilRenderer> stencil_;
    mutable LightGrids lights_;
    Truth truth_ = Truth::column;  ///< of the view that is being compared
    std::vector<Aside> asides_;    ///< of the view that is being compared, as many as were asked for
};

/// Something was compared. At most one pixel in a thousand shows another surface, only at edges but for a share of all;
/// colours are right but for a share of all.
void expect_agreement(const Agreement& agreement, double wrong_share = 0, double elsewhere_share = 0);

}  // namespace enfilade::test
