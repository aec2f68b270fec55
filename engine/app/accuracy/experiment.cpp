#include "app/accuracy/experiment.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/accuracy/true_texels.h"
#include "app/messages.h"
#include "base/hash.h"
#include "formats/text_parts.h"
#include "math/predicates.h"
#include "render/reference/reference_renderer.h"
#include "space/trace.h"

namespace enfilade {
namespace {

AccuracySetting promise_of(double texels) {
    AccuracySetting setting{{"--accuracy", number_text(texels)}, {}, texels};
    setting.dials.texel_error = texels;
    return setting;
}

AccuracySetting dial_of(const std::string& text) {
    AccuracySetting setting{{"--dial", text}, {}, 0};
    ENFILADE_CHECK(!set_dial(setting.dials, text));
    return setting;
}

/// What can be measured of one view before anything is drawn by dials.
struct Truth {
    Frame smooth;                   ///< the colours of 64 rays for each pixel
    FrameFacts seen;                ///< by the reference
    std::vector<TrueTexel> texels;  ///< by pixel; id kNothing: not judged
    std::vector<double> exact;      ///< error of the exact picture there [texels]
};

/// What is looked at.
struct Scene {
    const OpenMap& map;
    Snapshot snapshot;
    LightGrids& lights;  ///< of the reference
    int width, height;   ///< of pictures [px]
};

/// A picture and what it shows.
struct Drawn {
    Frame frame;
    FrameFacts facts;
};

Drawn drawn_by(Renderer& renderer, const Scene& scene, const View& view) {
    Drawn drawn;
    drawn.frame.resize(scene.width, scene.height);
    reset(drawn.facts, scene.width, scene.height);
    const Status failed = renderer.render(drawn.frame, &drawn.facts, scene.snapshot, view);
    ENFILADE_CHECK(!failed);  // the CPU's renderers do not fail
    return drawn;
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

Truth truth_of(const Scene& scene, const View& view, Renderer& exact, Renderer& smooth) {
    Truth truth;
    truth.smooth = drawn_by(smooth, scene, view).frame;
    truth.texels = true_texels(scene, view);
    Frame unused;
    unused.resize(scene.width, scene.height);
    reset(truth.seen, scene.width, scene.height);
    render_reference(unused, &truth.seen, scene.map.map, scene.map.textures, scene.snapshot, view,
                     {.lights = &scene.lights});
    const Drawn drawn = drawn_by(exact, scene, view);
    for (std::size_t i = 0; i < truth.texels.size(); ++i)
        truth.exact.push_back(error_at(scene.map, truth.texels[i], drawn.facts, i).value_or(0));
    return truth;
}

int channel(std::uint32_t color, int shift) { return static_cast<int>(color >> shift & 0xFF); }

void add_colors(const Frame& frame, const Frame& smooth, AccuracyErrors& errors) {
    for (std::size_t i = 0; i < frame.pixels.size(); ++i)
        for (const int shift : {0, 8, 16}) {
            const int apart = channel(frame.pixels[i], shift) - channel(smooth.pixels[i], shift);
            errors.squared_color += apart * apart;
        }
}

std::uint32_t texel_under(double tiles, std::uint32_t size) { return texel_of(place_on_tile(tiles), size); }

bool is_other_texel(const TrueTexel& truth, TexelPosition drawn, const Texture& picture) {
    return texel_under(static_cast<double>(truth.u), picture.width) != texel_under(drawn.u, picture.width) ||
           texel_under(static_cast<double>(truth.v), picture.height) != texel_under(drawn.v, picture.height);
}

void add_picture(const OpenMap& map, const Truth& truth, const Drawn& drawn, const AccuracySetting& setting,
                 AccuracyErrors& errors) {
    const FrameFacts& facts = drawn.facts;
    add_colors(drawn.frame, truth.smooth, errors);
    errors.pixels += facts.ids.size();
    for (std::size_t i = 0; i < facts.ids.size(); ++i) {
        errors.unwritten += facts.writes[i] == 0;
        errors.written_more += facts.writes[i] > 1;
        errors.wrong_ids += !truth.seen.ambiguous[i] && facts.ids[i] != truth.seen.ids[i];
        const std::optional<double> error = error_at(map, truth.texels[i], facts, i);
        if (!error) continue;
        errors.texel_errors.push_back(static_cast<float>(*error));
        errors.wrong_texels += is_other_texel(truth.texels[i], facts.texels[i], map.textures[truth.texels[i].texture]);
        if (setting.promise > 0 && *error > setting.promise)
            ++(truth.exact[i] > setting.promise ? errors.beyond : errors.broken);
    }
}

}  // namespace

std::vector<AccuracySetting> accuracy_settings(bool is_quick) {
    std::vector<AccuracySetting> settings{{{}, {}, 0}};
    for (const double texels : {1e-6, 1e-4, 0.01, 0.1, 0.25, 0.5, 1.0, 4.0}) settings.push_back(promise_of(texels));
    for (const char* dial : {"span=4", "span=8", "span=16", "span=32", "number=float", "number=fixed", "sampling=mip",
                             "samples=2", "samples=4", "light=bands", "light=smooth", "links=4"})
        settings.push_back(dial_of(dial));
    if (is_quick)
        std::erase_if(settings, [](const AccuracySetting& s) { return s.dials.samples > 2 || s.promise == 1e-4; });
    return settings;
}

RendererChoice one_thread(const Dials& dials) {
    RendererChoice choice;
    choice.dials = dials;
    return choice;
}

std::string name_of(const AccuracySetting& setting) {
    return setting.options.empty() ? "exact" : fmt::format("{}", fmt::join(setting.options, " "));
}

std::string_view name_of(PoseKind kind) { return kind == PoseKind::random ? "random" : "lattice"; }

std::vector<View> poses_in(const Map& map, PoseKind kind, std::size_t count, std::uint64_t seed) {
    constexpr double kLattice = 0.5, kEighth = 45, kLeastRoom = 0.25, kMostPitch = 30;
    Random random(seed + static_cast<std::uint64_t>(kind));
    std::vector<View> views;
    while (views.size() < count) {
        View view;
        view.sector = SectorId(random.below(map.sectors.size()));
        const Sector& sector = map[view.sector];
        view.eye = {random.uniform(sector.min.x, sector.max.x), random.uniform(sector.min.y, sector.max.y)};
        const double room = sector.ceiling.z - sector.floor.z;
        if (kind == PoseKind::lattice)
            view.eye = {std::round(view.eye.x / kLattice) * kLattice, std::round(view.eye.y / kLattice) * kLattice};
        view.eye = snap_to_point_grid(view.eye);
        const double degrees =
            kind == PoseKind::lattice ? kEighth * static_cast<double>(random.below(8)) : random.uniform(-180, 180);
        const double part = kind == PoseKind::lattice ? 0.5 : random.uniform(0.1, 0.9);
        if (kind == PoseKind::random)
            view.pitch_tangent = tangent(Angle::from_degrees(random.uniform(-kMostPitch, kMostPitch)));
        if (room < kLeastRoom || !contains(map, view.sector, view.eye)) continue;
        view.eye_z = sector.floor.z + part * room;
        view.forward = direction(Angle::from_degrees(degrees));
        view.stretch = map.render.stretch;
        views.push_back(view);
    }
    return views;
}

double AccuracyErrors::mean() const {
    double sum = 0;
    for (const float error : texel_errors) sum += double(error);
    return texel_errors.empty() ? 0 : sum / static_cast<double>(texel_errors.size());
}

double AccuracyErrors::largest() const {
    return texel_errors.empty() ? 0 : double(*std::ranges::max_element(texel_errors));
}

double AccuracyErrors::per_mille() {
    if (texel_errors.empty()) return 0;
    const auto place = texel_errors.begin() + static_cast<std::ptrdiff_t>(texel_errors.size() * 999 / 1000);
    std::ranges::nth_element(texel_errors, place);
    return double(*place);
}

double AccuracyErrors::psnr() const {
    if (squared_color == 0) return std::numeric_limits<double>::infinity();
    return 10 * std::log10(255.0 * 255.0 * 3 * static_cast<double>(pixels) / squared_color);
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
    std::vector<AccuracyErrors> errors(settings.size());
    Progress progress(views.size() * settings.size(), "pictures");
    for (const View& view : views) {
        const Truth truth = truth_of(scene, view, *judge.value()[0], *judge.value()[1]);
        for (std::size_t s = 0; s < settings.size(); ++s) {
            add_picture(map, truth, drawn_by(*renderers.value()[s], scene, view), settings[s], errors[s]);
            progress.step(0);
        }
    }
    return errors;
}

}  // namespace enfilade
