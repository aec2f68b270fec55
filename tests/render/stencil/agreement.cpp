#include "render/stencil/agreement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <sstream>
#include <utility>

#include "render/column/column_renderer.h"
#include "render/reference/reference_renderer.h"
#include "support/trials.h"

namespace enfilade::test {
namespace {

/// Pixels may differ by this in a channel and still be the same colour.
constexpr int kSameColor = 2;

/// OpenGL computes in floats, good to 2^-24 of a position: texels this near to each other may be confused [texels].
constexpr double kTexelSlack = 0.01;

/// Graphics cards put edges on a grid of 1/256 px: this far aside their picture may be right [px].
constexpr double kAside[] = {0, -1.0 / 256, 1.0 / 256, -1.0 / 128, 1.0 / 128, -1.0 / 64, 1.0 / 64};

Vec2 unit(Vec2 v) { return v * (1 / std::sqrt(dot(v, v))); }

[[noreturn]] void stop(const std::string& why) {
    std::fprintf(stderr, "%s\n", why.c_str());
    std::abort();
}

/// -180..180
double degrees_of(Vec2 unit_vector) {
    const double degrees = angle_of(unit_vector).degrees();
    return degrees > 180 ? degrees - 360 : degrees;
}

std::string text_of(const View& v, PictureSize size) {
    char text[400];
    if (v.tilt)
        std::snprintf(text, sizeof text,
                      "--view %.17g,%.17g,%.17g,%.17g,%.17g --true-pitch --roll %.17g --size %dx%d --fov %.17g",
                      v.eye.x, v.eye.y, v.eye_z, angle_of(v.forward).degrees(), degrees_of(v.tilt->pitch),
                      degrees_of(v.tilt->roll), size.width, size.height, v.fov_degrees);
    else
        std::snprintf(text, sizeof text,
                      "--view %.17g,%.17g,%.17g,%.17g,%.17g --size %dx%d --fov %.17g --stretch %.17g", v.eye.x, v.eye.y,
                      v.eye_z, angle_of(v.forward).degrees(), std::atan(v.pitch_tangent) * 180 / 3.14159265358979,
                      size.width, size.height, v.fov_degrees, v.stretch);
    return std::string(text) + (v.ray_offset == Vec2{} ? "" : "  # the map's rays = \"corner\"");
}

int difference(std::uint32_t a, std::uint32_t b) {
    int largest = 0;
    for (int shift = 0; shift < 24; shift += 8)
        largest = std::max(largest, std::abs(int(a >> shift & 255) - int(b >> shift & 255)));
    return largest;
}

const Texture& texture_of(const Map& map, const TextureSet& textures, PixelSurface id) {
    const auto first_wall = static_cast<PixelSurface>(1 + 2 * map.sectors.size());
    if (id < first_wall) {
        const Sector& sector = map.sectors[(id - 1) / 2];
        return textures[map[(id % 2 ? sector.floor : sector.ceiling).surface].texture];
    }
    const auto first_thing = first_wall + static_cast<PixelSurface>(3 * map.walls.size());
    const auto first_panel = first_thing + static_cast<PixelSurface>(map.things.size());
    if (id >= first_panel) return textures[map.panels[id - first_panel].surface.texture];
    if (id >= first_thing) return textures[map[map.things[id - first_thing].sprite].frames[0].views[0]];
    const Wall& wall = map.walls[(id - first_wall) / 3];
    const SurfaceId parts[] = {wall.kind == WallKind::portal ? wall.middle : wall.texture, wall.upper, wall.lower};
    return textures[map[parts[(id - first_wall) % 3]].texture];
}

/// A floor or ceiling in a row that is level as far as the card's floats go: it is at the very height of the eye and
/// seen on edge, and how far away is a quotient of two numbers that vanish.
bool is_flat_on_edge(const Map& map, const View& view, PictureSize size, PixelSurface id, int y) {
    constexpr double kLevel = 1e-10;  // [m/m]
    const auto first_wall = static_cast<PixelSurface>(1 + 2 * map.sectors.size());
    return id < first_wall && !view.tilt && std::fabs(Projection(view, size.width, size.height).climb(y)) < kLevel;
}

/// Just where classic light goes over to its next level.
bool is_near_band(const Map& map, double depth) {
    constexpr double kLevels = 40, kNear = 1e-4;  // levels at 1 m; what floats leave of 1 / depth
    const double level = kLevels / depth;
    return map.render.light == LightModel::classic && std::fabs(level - std::round(level)) < kNear * level;
}

bool is_near_edge(double texels) { return std::fabs(texels - std::round(texels)) < kTexelSlack; }

bool is_near_texels_edge(const Map& map, const TextureSet& textures, const FrameFacts& facts, std::size_t pixel) {
    const Texture& texture = texture_of(map, textures, facts.ids[pixel]);
    const TexelPosition at = facts.texels[pixel];
    return is_near_edge(static_cast<double>(at.u) * texture.width) ||
           is_near_edge(static_cast<double>(at.v) * texture.height);
}

/// The surface is a picture with holes, and a neighbouring texel may be one, or none.
bool is_at_rim(const Map& map, const TextureSet& textures, const FrameFacts& facts, std::size_t pixel) {
    const PixelSurface id = facts.ids[pixel];
    if (id == kNothing || id == kRecursionEnd) return false;
    return texture_of(map, textures, id).has_holes && is_near_texels_edge(map, textures, facts, pixel);
}

/// A pixel that differs from one around it.
template <class T>
bool is_at_change(const std::vector<T>& pixels, PictureSize size, int x, int y) {
    const auto at = [&](int i, int j) {
        i = std::clamp(i, 0, size.width - 1);
        j = std::clamp(j, 0, size.height - 1);
        return pixels[static_cast<std::size_t>(j * size.width + i)];
    };
    for (int j = y - 1; j <= y + 1; ++j)
        for (int i = x - 1; i <= x + 1; ++i)
            if (at(i, j) != at(x, y)) return true;
    return false;
}

/// A pixel between different surfaces, or beside one.
bool is_at_edge(const StencilPicture& p, PictureSize size, int x, int y) {
    return is_at_change(p.facts.ids, size, x, y);
}

/// A pixel at the edge of a doorway that one looks through: a surface that is seen on both sides of it is another part
/// of it there.
bool is_at_doorway(const StencilPicture& p, PictureSize size, int x, int y) {
    return !p.viewports.empty() && is_at_change(p.viewports, size, x, y);
}

/// A viewport comes after those that it is in.
std::vector<std::size_t> viewports_by_pixel(const ColumnRenderer& renderer, PictureSize size) {
    std::vector<std::size_t> numbers(static_cast<std::size_t>(size.width * size.height));
    std::size_t number = 0;
    for (const ViewportOutline& outline : renderer.viewports()) {
        ++number;
        for (int x = outline.begin; x < outline.end; ++x)
            for (int y = outline.top[std::size_t(x - outline.begin)];
                 y < outline.bottom[std::size_t(x - outline.begin)]; ++y)
                numbers[static_cast<std::size_t>(y * size.width + x)] = number;
    }
    return numbers;
}

}  // namespace

Agreement& Agreement::operator+=(const Agreement& o) {
    pixels += o.pixels;
    undrawn += o.undrawn;
    at_edges += o.at_edges;
    elsewhere += o.elsewhere;
    other_texel += o.other_texel;
    wrong_color += o.wrong_color;
    worst_difference = std::max(worst_difference, o.worst_difference);
    if (o.worst_share > worst_share) {
        worst_share = o.worst_share;
        worst_view = o.worst_view;
    }
    if (first_fault.empty()) first_fault = o.first_fault;
    return *this;
}

std::string describe(const Agreement& a) {
    std::ostringstream text;
    text << "of " << a.pixels << " pixels " << a.undrawn << " undrawn, " << a.at_edges
         << " of another surface at edges, " << a.elsewhere << " elsewhere, " << a.other_texel
         << " of a neighbouring texel, " << a.wrong_color << " of a wrong colour; colours differ by at most "
         << a.worst_difference << "; in the worst picture " << a.worst_share * 100
         << " % of another surface: " << a.worst_view;
    if (!a.first_fault.empty()) text << "\n  " << a.first_fault;
    return text.str();
}

std::unique_ptr<StencilRenderer> software_stencil(const Map& map, const TextureSet& textures, GlApi api,
                                                  int light_points_per_m) {
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    auto context = open_headless_gl(api);
    if (!context.ok()) stop("no OpenGL to test with: " + context.error().text());
    auto renderer = StencilRenderer::make(std::move(context).value(), map, textures, light_points_per_m);
    if (!renderer.ok()) stop("no stencil renderer to test: " + renderer.error().text());
    return std::move(renderer).value();
}

Sight::Sight(const Map& map, const TextureSet& textures, GlApi api, int light_points_per_m)
    : map_(map),
      textures_(textures),
      snapshot_(at_rest(map)),
      stencil_(software_stencil(map, textures, api, light_points_per_m)),
      lights_(map, light_points_per_m) {}

namespace {
StencilPicture blank(PictureSize size) {
    StencilPicture picture;
    picture.frame.resize(size.width, size.height);
    reset(picture.facts, size.width, size.height);
    return picture;
}
}  // namespace

StencilPicture Sight::by_stencil(const View& view, PictureSize size) {
    StencilPicture picture = blank(size);
    if (const Result<void> done = stencil_->render(picture.frame, &picture.facts, snapshot_, view); !done.ok())
        stop(done.error().text());
    return picture;
}

StencilPicture Sight::by_column(const View& view, PictureSize size) const {
    StencilPicture picture = blank(size);
    ColumnRenderer renderer(map_, textures_, {lights_});
    renderer.render(picture.frame, &picture.facts, snapshot_, view);
    picture.viewports = viewports_by_pixel(renderer, size);
    return picture;
}

StencilPicture Sight::by_reference(const View& view, PictureSize size) const {
    StencilPicture picture = blank(size);
    render_reference(picture.frame, &picture.facts, map_, textures_, snapshot_, view, {.lights = &lights_});
    return picture;
}

StencilPicture Sight::truth_of(const View& view, PictureSize size) const {
    if (view.tilt) return by_reference(view, size);
    StencilPicture by_columns = by_column(view, size);
    if (truth_ == Truth::column) return by_columns;
    StencilPicture truth = by_reference(view, size);
    truth.viewports = std::move(by_columns.viewports);
    return truth;
}

/// What the truth is for the view moved by the number'th pair of kAside.
const Sight::Aside& Sight::aside(std::size_t number, const View& view, PictureSize size) {
    while (asides_.size() <= number) {
        const double dx = kAside[asides_.size() / std::size(kAside)], dy = kAside[asides_.size() % std::size(kAside)];
        const Projection projection(view, size.width, size.height);
        View moved = view;
        const double slope = dx * 2 * projection.half_fov_tangent() / size.width;
        moved.forward = unit(view.forward + right_of(view.forward) * slope);
        const double steeper = dy / projection.focal_y();
        if (moved.tilt)
            moved.tilt->pitch = unit(moved.tilt->pitch + right_of(moved.tilt->pitch) * steeper);
        else
            moved.pitch_tangent += steeper;
        StencilPicture picture = truth_of(moved, size);
        asides_.push_back({std::move(picture.frame.pixels), std::move(picture.facts.ids)});
    }
    return asides_[number];
}

/// What the truth would show had the picture been taken a hair aside: surfaces thinner than that, and where
/// one surface is seen twice side by side, have edges that its picture does not show.
bool Sight::is_hair_aside(const View& view, PictureSize size, std::size_t pixel, const StencilPicture& shown,
                          Same what) {
    for (std::size_t number = 0; number < std::size(kAside) * std::size(kAside); ++number) {
        const Aside& truth = aside(number, view, size);
        const bool same_color = difference(truth.pixels[pixel], shown.frame.pixels[pixel]) <= kSameColor;
        if (truth.ids[pixel] == shown.facts.ids[pixel] && (what == Same::surface || same_color)) return true;
    }
    return false;
}

Agreement Sight::compare(const View& view, PictureSize size, Truth whose) {
    truth_ = whose;
    asides_.clear();
    const StencilPicture shown = by_stencil(view, size), truth = truth_of(view, size);
    Agreement result;
    result.pixels = truth.frame.pixels.size();
    count_trials(result.pixels, "pixels");
    for (std::size_t i = 0; i < truth.frame.pixels.size(); ++i) {
        const int x = int(i) % size.width, y = int(i) / size.width;
        const PixelSurface id = truth.facts.ids[i];
        result.undrawn += shown.facts.ids[i] == kNothing;
        bool is_fault = shown.facts.ids[i] == kNothing;
        if (shown.facts.ids[i] != id &&
            (is_at_rim(map_, textures_, shown.facts, i) || is_at_rim(map_, textures_, truth.facts, i))) {
            ++result.other_texel;
        } else if (shown.facts.ids[i] != id) {
            const bool at_edge = is_at_edge(truth, size, x, y) || is_hair_aside(view, size, i, shown, Same::surface);
            ++(at_edge ? result.at_edges : result.elsewhere);
            is_fault |= !at_edge;
        } else if (const int off = difference(shown.frame.pixels[i], truth.frame.pixels[i]);
                   id != kRecursionEnd && off > kSameColor) {
            const bool near = is_near_band(map_, truth.facts.depths[i]) ||
                              is_near_texels_edge(map_, textures_, truth.facts, i) ||
                              is_hair_aside(view, size, i, shown, Same::color);
            const bool at_edge =
                !near && (is_at_doorway(truth, size, x, y) || is_flat_on_edge(map_, view, size, id, y));
            ++(near ? result.other_texel : at_edge ? result.at_edges : result.wrong_color);
            const bool is_wrong = !near && !at_edge;
            if (is_wrong) result.worst_difference = std::max(result.worst_difference, off);
            is_fault |= is_wrong;
        }
        if (is_fault && result.first_fault.empty()) {
            const auto &ours = shown.facts, &theirs = truth.facts;
            char text[300];
            std::snprintf(text, sizeof text,
                          "pixel (%d, %d): surface %u, not %u; colour %08x, not %08x; depth %.9g, not %.9g; texel %.9g "
                          "%.9g, not %.9g %.9g; ",
                          x, y, ours.ids[i], id, shown.frame.pixels[i], truth.frame.pixels[i], ours.depths[i],
                          theirs.depths[i], double(ours.texels[i].u), double(ours.texels[i].v),
                          double(theirs.texels[i].u), double(theirs.texels[i].v));
            result.first_fault = text + text_of(view, size) + " --sector " + map_[view.sector].name;
        }
    }
    result.worst_share = double(result.at_edges + result.elsewhere) / double(result.pixels);
    result.worst_view = text_of(view, size) + " --sector " + map_[view.sector].name;
    return result;
}

Agreement Sight::compare_poses(int count, PictureSize size, std::uint64_t seed) {
    Random random(seed);
    Agreement sum;
    for (int i = 0; i < count; ++i) {
        sum += compare(random_pose(map_, random), size);
        sum += compare(lattice_pose(map_, size, random), size);
    }
    return sum;
}

Agreement Sight::compare_random_poses(int count, PictureSize size, std::uint64_t seed) {
    Random random(seed);
    Agreement sum;
    for (int i = 0; i < count; ++i) sum += compare(random_pose(map_, random), size);
    return sum;
}

void expect_agreement(const Agreement& a, double wrong_share, double elsewhere_share) {
    EXPECT_GT(a.pixels, 0u) << "nothing was looked at";
    EXPECT_EQ(a.undrawn, 0u) << describe(a);
    EXPECT_LE(double(a.elsewhere), elsewhere_share * double(a.pixels)) << describe(a);
    EXPECT_LE(double(a.wrong_color), wrong_share * double(a.pixels)) << describe(a);
    EXPECT_LE(double(a.at_edges), 0.001 * double(a.pixels)) << describe(a);
}

}  // namespace enfilade::test
