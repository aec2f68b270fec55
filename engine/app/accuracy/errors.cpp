#include "app/accuracy/errors.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/accuracy/true_texels.h"
#include "app/messages.h"
#include "render/reference/reference_renderer.h"
#include "space/trace.h"

namespace enfilade {
namespace {

/// What is looked at.
struct Scene {
    const OpenMap& map;
    Snapshot snapshot;
    LightGrids& lights;  ///< of the reference
    int width, height;   ///< of pictures [px]
};

/// A view, and what is seen when its eye has moved a little.
struct MovingView {
    View start, turned, stepped;
};

/// The same as pictures.
struct MovingPicture {
    Frame start, turned, stepped;
};

/// What can be measured of one view before anything is drawn by dials.
struct Truth {
    MovingPicture smooth;           ///< the colours of 64 rays for each pixel
    FrameFacts seen;                ///< by the reference
    std::vector<TrueTexel> texels;  ///< by pixel; id kNothing: not judged
    std::vector<double> exact;      ///< error of the exact picture there [texels]
};

/// What is added up over views.
struct Tally {
    AccuracyErrors errors;
    std::vector<float> texel_errors;
    double squared_color = 0, ssim = 0;
    double turned = 0, stepped = 0;  ///< squared changes
    std::size_t views = 0;
};

MovingView moving(const Map& map, const View& view, const Scene& scene) {
    constexpr double kStep = 0.02, kTurn = 1.0 / 64;  // [m], [px]
    const double pixel = 2 * Projection(view, scene.width, scene.height).half_fov_tangent() / scene.width;
    MovingView moved{view, view, view};
    moved.turned.forward = direction(angle_of(view.forward) + Angle::from_radians(pixel * kTurn));
    moved.stepped.eye = snap_to_point_grid(view.eye + view.forward * kStep);
    if (!contains(map, view.sector, moved.stepped.eye)) moved.stepped.eye = view.eye;
    return moved;
}

Frame picture_of(Renderer& renderer, FrameFacts* facts, const Scene& scene, const View& view) {
    Frame frame;
    frame.resize(scene.width, scene.height);
    if (facts) reset(*facts, scene.width, scene.height);
    const Result<void> drawn = renderer.render(frame, facts, scene.snapshot, view);
    ENFILADE_CHECK(drawn.ok());  // the CPU's renderers do not fail
    return frame;
}

MovingPicture pictures_of(Renderer& renderer, FrameFacts* facts, const Scene& scene, const MovingView& view) {
    return {picture_of(renderer, facts, scene, view.start), picture_of(renderer, nullptr, scene, view.turned),
            picture_of(renderer, nullptr, scene, view.stepped)};
}

using Renderers = std::vector<std::unique_ptr<Renderer>>;

Result<Renderers> renderers_for(const OpenMap& map, const std::vector<AccuracySetting>& settings) {
    Renderers renderers;
    for (const AccuracySetting& setting : settings) {
        auto renderer = make_renderer(one_thread(setting.dials), map.map, map.textures);
        if (!renderer.ok()) return renderer.error();
        renderers.push_back(std::move(renderer).value());
    }
    return renderers;
}

std::vector<TrueTexel> true_texels(const Scene& scene, const View& view) {
    const int width = scene.width, height = scene.height;
    std::vector<TrueTexel> texels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (int x = 0; x < width; ++x) {
        TrueColumn column(scene.map.map, scene.snapshot, view, width, height, x);
        for (int y = 0; y < height; ++y)
            if (const auto texel = column.at(y)) texels[static_cast<std::size_t>(y * width + x)] = *texel;
    }
    return texels;
}

/// The step of the tie rule that a texel is read from (render/shade.h) [tiles].
double place_read(double tiles) { return place_on_tile(tiles) * 0x1p-32; }

/// How far the place that pixel i was read from is off; none where it is not judged.
std::optional<double> error_at(const OpenMap& map, const TrueTexel& truth, const FrameFacts& facts, std::size_t i) {
    if (truth.id == kNothing || truth.id != facts.ids[i]) return {};
    const Texture& picture = map.textures[truth.texture];
    const TexelPosition read{place_read(facts.texels[i].u), place_read(facts.texels[i].v)};
    return texel_error(truth, read, picture.width, picture.height);
}

Truth truth_of(const Scene& scene, const MovingView& view, Renderer& exact, Renderer& smooth) {
    Truth truth;
    truth.smooth = pictures_of(smooth, nullptr, scene, view);
    truth.texels = true_texels(scene, view.start);
    Frame unused;
    unused.resize(scene.width, scene.height);
    reset(truth.seen, scene.width, scene.height);
    render_reference(unused, &truth.seen, scene.map.map, scene.map.textures, scene.snapshot, view.start,
                     {.lights = &scene.lights});
    FrameFacts facts;
    picture_of(exact, &facts, scene, view.start);
    for (std::size_t i = 0; i < truth.texels.size(); ++i)
        truth.exact.push_back(error_at(scene.map, truth.texels[i], facts, i).value_or(0));
    return truth;
}

int channel(std::uint32_t color, int shift) { return static_cast<int>(color >> shift & 0xFF); }

std::uint32_t texel_under(double tiles, std::uint32_t size) { return texel_of(place_on_tile(tiles), size); }

bool is_other_texel(const TrueTexel& truth, TexelPosition drawn, const Texture& picture) {
    return texel_under(static_cast<double>(truth.u), picture.width) != texel_under(drawn.u, picture.width) ||
           texel_under(static_cast<double>(truth.v), picture.height) != texel_under(drawn.v, picture.height);
}

void add_colors(const MovingPicture& drawn, const MovingPicture& smooth, Tally& tally) {
    tally.squared_color += squared_change(smooth.start, drawn.start);
    tally.ssim += structural_similarity(smooth.start, drawn.start);
    tally.turned += squared_change(drawn.start, drawn.turned);
    tally.stepped += squared_change(drawn.start, drawn.stepped);
    ++tally.views;
}

void add_facts(const OpenMap& map, const Truth& truth, const FrameFacts& facts, double promise, Tally& tally) {
    AccuracyErrors& errors = tally.errors;
    errors.pixels += facts.ids.size();
    for (std::size_t i = 0; i < facts.ids.size(); ++i) {
        errors.unwritten += facts.writes[i] == 0;
        errors.written_more += facts.writes[i] > 1;
        errors.wrong_ids += facts.ids[i] != truth.seen.ids[i];
        const std::optional<double> error = error_at(map, truth.texels[i], facts, i);
        if (!error) continue;
        tally.texel_errors.push_back(static_cast<float>(*error));
        errors.wrong_texels += is_other_texel(truth.texels[i], facts.texels[i], map.textures[truth.texels[i].texture]);
        if (promise > 0 && *error > promise) ++(truth.exact[i] > promise ? errors.beyond : errors.broken);
    }
}

/// 1 where neither changes.
double change_ratio(double squared, double squared_truth) {
    if (squared == squared_truth) return 1;
    return std::sqrt(squared / std::max(squared_truth, 1.0));
}

AccuracyErrors errors_of(Tally& tally, const Tally& smooth) {
    AccuracyErrors errors = tally.errors;
    std::vector<float>& all = tally.texel_errors;
    std::ranges::sort(all);
    errors.judged = all.size();
    if (!all.empty()) {
        for (const float error : all) errors.mean += double(error) / static_cast<double>(all.size());
        errors.per_mille = double(all[all.size() * 999 / 1000]);
        errors.largest = double(all.back());
    }
    errors.psnr = signal_to_noise(tally.squared_color, errors.pixels);
    errors.ssim = tally.ssim / static_cast<double>(tally.views);
    errors.shimmer_turned = change_ratio(tally.turned, smooth.turned);
    errors.shimmer_stepped = change_ratio(tally.stepped, smooth.stepped);
    return errors;
}

// Structural similarity.

int brightness(std::uint32_t color) {
    return (77 * channel(color, 0) + 150 * channel(color, 8) + 29 * channel(color, 16)) >> 8;  // Rec. 601
}

/// Of the squares at (left, top).
double square_similarity(const Frame& a, const Frame& b, int left, int top) {
    constexpr double kSteady = 0.01 * 255 * 0.01 * 255, kContrast = 0.03 * 255 * 0.03 * 255, kCount = 64;
    double sum_a = 0, sum_b = 0, sum_aa = 0, sum_bb = 0, sum_ab = 0;
    for (int y = top; y < top + 8; ++y)
        for (int x = left; x < left + 8; ++x) {
            const auto i = static_cast<std::size_t>(y * a.width + x);
            const double from_a = brightness(a.pixels[i]), from_b = brightness(b.pixels[i]);
            sum_a += from_a, sum_b += from_b;
            sum_aa += from_a * from_a, sum_bb += from_b * from_b, sum_ab += from_a * from_b;
        }
    const double mean_a = sum_a / kCount, mean_b = sum_b / kCount;
    const double var_a = sum_aa / kCount - mean_a * mean_a, var_b = sum_bb / kCount - mean_b * mean_b;
    const double both = sum_ab / kCount - mean_a * mean_b;
    return (2 * mean_a * mean_b + kSteady) * (2 * both + kContrast) /
           ((mean_a * mean_a + mean_b * mean_b + kSteady) * (var_a + var_b + kContrast));
}

}  // namespace

double squared_change(const Frame& from, const Frame& to) {
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < from.pixels.size(); ++i)
        for (const int shift : {0, 8, 16}) {
            const int apart = channel(to.pixels[i], shift) - channel(from.pixels[i], shift);
            sum += apart * apart;
        }
    return static_cast<double>(sum);
}

double signal_to_noise(double squared, std::uint64_t pixels) {
    constexpr double kPeak = 255, kColors = 3;
    return squared == 0 ? kNoNoise : 10 * std::log10(kPeak * kPeak * kColors * static_cast<double>(pixels) / squared);
}

double structural_similarity(const Frame& a, const Frame& b) {
    ENFILADE_CHECK(a.width == b.width && a.height == b.height && a.width >= 8 && a.height >= 8);
    double sum = 0, squares = 0;
    for (int top = 0; top + 8 <= a.height; top += 8)
        for (int left = 0; left + 8 <= a.width; left += 8, ++squares) sum += square_similarity(a, b, left, top);
    return sum / squares;
}

Result<std::vector<AccuracyErrors>> measure_errors(const OpenMap& map, const std::vector<View>& views,
                                                   const std::vector<AccuracySetting>& settings, int width,
                                                   int height) {
    Dials smooth;
    smooth.samples = kMostSamples;
    auto renderers = renderers_for(map, settings);
    if (!renderers.ok()) return renderers.error();
    auto judge = renderers_for(map, {{{}, {}, 0}, {{}, smooth, 0}});
    if (!judge.ok()) return judge.error();
    LightGrids lights(map.map);
    const Scene scene{map, at_rest(map.map), lights, width, height};
    std::vector<Tally> tallies(settings.size());
    Tally true_tally;
    Progress progress(views.size() * settings.size(), "pictures");
    for (const View& start : views) {
        const MovingView view = moving(map.map, start, scene);
        const Truth truth = truth_of(scene, view, *judge.value()[0], *judge.value()[1]);
        add_colors(truth.smooth, truth.smooth, true_tally);
        for (std::size_t s = 0; s < settings.size(); ++s) {
            FrameFacts facts;
            add_colors(pictures_of(*renderers.value()[s], &facts, scene, view), truth.smooth, tallies[s]);
            add_facts(map, truth, facts, settings[s].promise, tallies[s]);
            progress.step(0);
        }
    }
    std::vector<AccuracyErrors> errors;
    for (Tally& tally : tallies) errors.push_back(errors_of(tally, true_tally));
    return errors;
}

Result<std::vector<JudgedPicture>> judge_pictures(const OpenMap& map, const View& view,
                                                  const std::vector<AccuracySetting>& settings, int width, int height) {
    auto renderers = renderers_for(map, settings);
    if (!renderers.ok()) return renderers.error();
    LightGrids lights(map.map);
    const Scene scene{map, at_rest(map.map), lights, width, height};
    const std::vector<TrueTexel> texels = true_texels(scene, view);
    std::vector<JudgedPicture> pictures;
    for (const std::unique_ptr<Renderer>& renderer : renderers.value()) {
        FrameFacts facts;
        JudgedPicture picture{picture_of(*renderer, &facts, scene, view), {}};
        for (std::size_t i = 0; i < texels.size(); ++i) picture.errors.push_back(error_at(map, texels[i], facts, i));
        pictures.push_back(std::move(picture));
    }
    return pictures;
}

}  // namespace enfilade
