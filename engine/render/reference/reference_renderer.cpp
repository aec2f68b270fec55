#include "render/reference/reference_renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "base/parallel.h"
#include "base/result.h"
#include "render/reference/cast_ray.h"
#include "render/sampling.h"

namespace enfilade {

// Which texels a pixel shows where it is not the one at its middle: the rules of render/sampling.h once more, in the
// plainest numbers. Only the smaller pictures themselves are shared with the column renderer.

namespace {

constexpr double kParts = kBlendParts;

/// Two texels along one side of a picture, and the second one's weight [1].
struct Neighbors {
    std::size_t first, second;
    double weight;
};

Neighbors neighbors(TilePlace place, std::uint32_t size_px) {
    const double from_middle = place * 0x1p-32 * size_px - 0.5;  // exact: no more than 48 bits [texels]
    const double rounded = std::floor(from_middle * kParts + 0.5) / kParts, whole = std::floor(rounded);
    const std::int64_t first = static_cast<std::int64_t>(whole), size = size_px;
    return {static_cast<std::size_t>((first + size) % size), static_cast<std::size_t>((first + 1) % size),
            rounded - whole};
}

/// A colour and how much it counts.
struct Weighed {
    std::uint32_t color;
    double weight;
};

template <std::size_t kCount>
std::uint32_t mean_of(const std::array<Weighed, kCount>& colors) {
    std::uint32_t mean = 0xFF000000u;
    for (const int shift : {0, 8, 16}) {
        double sum = 0;
        for (const Weighed& weighed : colors) sum += weighed.weight * (weighed.color >> shift & 0xFF);
        mean |= static_cast<std::uint32_t>(std::floor(sum + 0.5)) << shift;
    }
    return mean;
}

/// As painted, and where a color table has darkened it.
struct TwoColors {
    std::uint32_t painted, darkened;
};

/// table: of the level that darkens; null: the picture goes by none.
TwoColors bilinear(const Texture& picture, TilePlace u, TilePlace v, const std::uint32_t* table) {
    const Neighbors across = neighbors(u, picture.width), down = neighbors(v, picture.height);
    std::array<Weighed, 4> painted{}, darkened{};
    for (std::size_t i = 0; i < 4; ++i) {
        const bool is_right = i / 2 == 1, is_lower = i % 2 == 1;
        const std::size_t x = is_right ? across.second : across.first, y = is_lower ? down.second : down.first;
        const std::size_t place = x * picture.height + y;
        const double weight =
            (is_right ? across.weight : 1 - across.weight) * (is_lower ? down.weight : 1 - down.weight);
        painted[i] = {picture.pixels[place], weight};
        darkened[i] = {table ? table[picture.numbers[place]] : 0, weight};
    }
    return {mean_of(painted), table ? mean_of(darkened) : 0};
}

/// Where texels are so far apart: x of the 2^level. >= 1.
struct Doublings {
    int level = 0;
    double x = 1;  ///< 1..2
};

Doublings doublings(double texels_per_pixel) {
    constexpr int kMost = 31;
    Doublings found{0, static_cast<float>(texels_per_pixel)};
    for (; found.x >= 2 && found.level < kMost; ++found.level) found.x /= 2;
    return found.level == kMost || !(found.x > 1) ? Doublings{found.level, 1} : found;
}

std::uint32_t mix(std::uint32_t color, std::uint32_t next, double part) {
    return mean_of(std::array{Weighed{color, 1 - part}, Weighed{next, part}});
}

}  // namespace

std::uint32_t several_texels(const ReferenceScene& scene, const Texture& picture, const TexelsSeen& seen,
                             const Lighting& lighting, double depth, LightCell lamplight) {
    const TexelSampling& sampling = *scene.sampling;
    const Doublings size = doublings(seen.texels_per_pixel);
    if (sampling.kind == Sampling::mip) {
        const int level = size.level + (size.x > std::sqrt(2.0) ? 1 : 0);
        return lit(scene, texel(sampling.mips->at(picture, level), seen.u, seen.v), lighting, depth, lamplight);
    }
    const Shade shade = shade_at(lighting, depth);
    const std::uint32_t* const table =
        picture.numbers.empty() ? nullptr : darkened_colors(scene.textures.color_table, shade);
    TwoColors colors;
    if (sampling.kind == Sampling::trilinear) {
        const double part = std::floor((size.x - 1) * kParts) / kParts;
        const TwoColors larger = bilinear(sampling.mips->at(picture, size.level), seen.u, seen.v, table);
        const TwoColors smaller = bilinear(sampling.mips->at(picture, size.level + 1), seen.u, seen.v, table);
        colors = {mix(larger.painted, smaller.painted, part), mix(larger.darkened, smaller.darkened, part)};
    } else {
        colors = bilinear(picture, seen.u, seen.v, table);
    }
    return table ? lit_above(colors.darkened, colors.painted, shade, lamplight) : lit(colors.painted, shade, lamplight);
}

// The picture, column by column.

namespace {

/// The rays of one column of a picture, from the top. Not tilted they follow one path in the plane, each only as far as
/// it goes; else each has its own.
class ColumnOfRays {
public:
    ColumnOfRays(const ReferenceScene& scene, const View& view, const Projection& projection, int x)
        : scene_(scene), view_(view), projection_(projection), x_(x) {
        if (!view.tilt) path_.emplace(scene.map, &scene.snapshot.things, view, projection.slope(x));
    }

    Seen cast_ray(int y) {
        const Seen seen = follow(ray_course(projection_, x_, y));
        is_cut_short_ |= seen.cut_short;
        return seen;
    }

    /// Whether one of them ended because its budget was spent.
    bool is_cut_short() const { return is_cut_short_; }

private:
    Seen follow(const RayCourse& course) {
        if (!view_.tilt) return enfilade::cast_ray(scene_, *path_, course);
        RayPath path(scene_.map, &scene_.snapshot.things, turned(view_, course.quarters), course.slope);
        return enfilade::cast_ray(scene_, path, course);
    }

    const ReferenceScene& scene_;
    const View& view_;
    const Projection& projection_;
    int x_;
    std::optional<RayPath> path_;
    bool is_cut_short_ = false;
};

/// One ray a pixel: the centre's. True where one of them was cut short.
bool render_column(Frame& frame, FrameFacts* facts, const ReferenceScene& scene, const View& view,
                   const Projection& projection, int x) {
    ColumnOfRays rays(scene, view, projection, x);
    for (int y = 0; y < frame.height; ++y) {
        const Seen seen = rays.cast_ray(y);
        const std::size_t i =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.width) + static_cast<std::size_t>(x);
        frame.pixels[i] = seen.color;
        if (!facts) continue;
        facts->ids[i] = seen.id;
        facts->depths[i] = seen.depth;
        facts->texels[i] = seen.texel;
        facts->writes[i] = 1;
    }
    return rays.is_cut_short();
}

/// Replaces the colours of a column by means of samples x samples rays a pixel. `fine` is the projection of a
/// picture that many times larger, whose pixel centres are the samples. True where a ray was cut short.
bool supersample_column(Frame& frame, const ReferenceScene& scene, const View& view, const Projection& fine,
                        int samples, int x) {
    std::vector<LightMean> means(static_cast<std::size_t>(frame.height));
    bool is_cut_short = false;
    for (int sub_x = x * samples; sub_x < (x + 1) * samples; ++sub_x) {
        ColumnOfRays rays(scene, view, fine, sub_x);
        for (int sub_y = 0; sub_y < frame.height * samples; ++sub_y)
            means[static_cast<std::size_t>(sub_y / samples)].add(rays.cast_ray(sub_y).color);
        is_cut_short |= rays.is_cut_short();
    }
    for (int y = 0; y < frame.height; ++y)
        frame
            .pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.width) + static_cast<std::size_t>(x)] =
            means[static_cast<std::size_t>(y)].color(static_cast<std::uint32_t>(samples * samples));
    return is_cut_short;
}

/// Of the picture that this projection is of. Nothing where the nearest texel is shown.
std::optional<TexelSampling> sampling_of(Sampling kind, const MipChains* mips, const Projection& projection) {
    if (kind == Sampling::nearest) return {};
    return TexelSampling{kind, mips, 2 * projection.half_fov_tangent() / projection.width(), projection.focal_y()};
}

/// The scene in which texels are so large.
ReferenceScene with(ReferenceScene scene, const std::optional<TexelSampling>& sampling) {
    scene.sampling = sampling ? &*sampling : nullptr;
    return scene;
}

}  // namespace

void render_reference(Frame& frame, FrameFacts* facts, const Map& map, const TextureSet& textures,
                      const Snapshot& snapshot, const View& view, const ReferenceOptions& options) {
    ENFILADE_CHECK(options.samples >= 1 && options.workers >= 1 && snapshot.sectors.size() == map.sectors.size());
    const Projection projection(view, frame.width, frame.height);
    const Projection fine(finer(view, options.samples), frame.width * options.samples, frame.height * options.samples);
    LightGrids own_lights(map), &lights = options.lights ? *options.lights : own_lights;
    std::optional<MipChains> own_mips;
    const MipChains* mips = options.mips;
    if (!mips && needs_smaller_pictures(options.sampling)) mips = &own_mips.emplace(textures);
    const auto sampling = sampling_of(options.sampling, mips, projection);
    const auto fine_sampling = sampling_of(options.sampling, mips, fine);
    const std::optional<OwnLight> own =
        options.own_light ? std::optional<OwnLight>(std::in_place, map, snapshot) : std::nullopt;
    const ReferenceScene scene{map, textures, snapshot, Lamplight(snapshot, lights, own ? &*own : nullptr),
                               view.tilt.has_value()};
    const ReferenceScene middles = with(scene, sampling), samples = with(scene, fine_sampling);
    frame.resize(frame.width, frame.height);
    if (facts) reset(*facts, frame.width, frame.height);
    std::vector<char> cut_short(static_cast<std::size_t>(frame.width));
    const auto column = [&](std::size_t index, std::size_t) {
        const int x = static_cast<int>(index);
        if (facts || options.samples == 1)
            cut_short[index] |= render_column(frame, facts, middles, view, projection, x);
        if (options.samples > 1) cut_short[index] |= supersample_column(frame, samples, view, fine, options.samples, x);
    };
    parallel_for(static_cast<std::size_t>(frame.width), static_cast<std::size_t>(options.workers), column);
    frame.is_cut_short = std::ranges::count(cut_short, 0) != frame.width;
}

PixelFacts look_through_pixel(const Map& map, const TextureSet& textures, const Snapshot& snapshot, const View& view,
                              int width, int height, int x, int y) {
    ENFILADE_CHECK(x >= 0 && x < width && y >= 0 && y < height && snapshot.sectors.size() == map.sectors.size());
    const Projection projection(view, width, height);
    const ReferenceScene scene{map, textures, snapshot};
    const Seen seen = ColumnOfRays(scene, view, projection, x).cast_ray(y);
    return {seen.id, seen.depth, seen.texel};
}

}  // namespace enfilade
