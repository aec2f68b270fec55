#include "app/accuracy/experiment.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/bench.h"
#include "app/messages.h"
#include "base/hash.h"
#include "base/parallel.h"
#include "formats/text_parts.h"
#include "math/predicates.h"
#include "platform/clock.h"
#include "space/trace.h"

namespace enfilade {

std::vector<AccuracySetting> accuracy_settings(bool is_quick) {
    std::vector<AccuracySetting> settings{{{}, {}, 0}};
    for (const double texels : {1e-6, 1e-4, 0.01, 0.1, 0.25, 0.5, 1.0, 4.0}) settings.push_back(promise_of(texels));
    for (const char* dial : {"span=4", "span=8", "span=16", "span=32", "number=float", "number=fixed", "number=vanilla",
                             "sampling=mip", "sampling=bilinear", "sampling=trilinear", "samples=2", "samples=4",
                             "light=bands", "light=smooth", "links=4"})
        settings.push_back(dial_of(dial));
    if (is_quick)
        std::erase_if(settings, [](const AccuracySetting& s) { return s.dials.samples > 2 || s.promise == 1e-4; });
    return settings;
}

AccuracySetting promise_of(double texels) {
    AccuracySetting setting{{"--accuracy", number_text(texels)}, {}, texels};
    setting.dials.texel_error = texels;
    return setting;
}

AccuracySetting dial_of(const std::string& text) {
    AccuracySetting setting{{"--dial", text}, {}, 0};
    ENFILADE_CHECK(set_dial(setting.dials, text).ok());
    return setting;
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
        view.ray_offset = ray_offset(map.render.rays);
        views.push_back(view);
    }
    return views;
}

std::string views_csv(const std::vector<View>& views) {
    constexpr double kDegrees = 180 / 3.14159265358979323846;
    std::string text = "x,y,z,yaw,pitch\n";
    for (const View& view : views)
        text += fmt::format("{},{},{},{},{}\n", view.eye.x, view.eye.y, view.eye_z, angle_of(view.forward).degrees(),
                            std::atan(view.pitch_tangent) * kDegrees);
    return text;
}

namespace {

/// One setting's pictures of all views, drawn once in each round.
struct Priced {
    std::unique_ptr<Renderer> renderer;
    std::vector<std::int64_t> rounds_ns;
};

Result<std::vector<Priced>> priced_settings(const OpenMap& map, const std::vector<AccuracySetting>& settings) {
    std::vector<Priced> all;
    for (const AccuracySetting& setting : settings) {
        auto renderer = make_renderer(one_thread(setting.dials), map.map, map.textures);
        if (!renderer.ok()) return renderer.error();
        all.push_back({std::move(renderer).value(), {}});
    }
    return all;
}

Result<std::int64_t> time_views(Renderer& renderer, const Snapshot& snapshot, const std::vector<View>& views,
                                Frame& frame) {
    const std::int64_t began_ns = now_ns();
    for (const View& view : views)
        if (const Result<void> done = renderer.render(frame, nullptr, snapshot, view); !done.ok()) return done.error();
    return now_ns() - began_ns;
}

/// Of the quarters of a list.
double quantile(std::vector<double> values, double part) {
    std::ranges::sort(values);
    return values[static_cast<std::size_t>(part * static_cast<double>(values.size() - 1) + 0.5)];
}

AccuracyPrice price_of(Priced& priced, const Priced& exact, double pixels) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < priced.rounds_ns.size(); ++i)
        ratios.push_back(static_cast<double>(priced.rounds_ns[i]) / static_cast<double>(exact.rounds_ns[i]));
    std::vector<std::int64_t> times = priced.rounds_ns;
    const auto minimum = static_cast<double>(*std::ranges::min_element(times));
    return {minimum / pixels,
            static_cast<double>(median_of(times)) / pixels,
            quantile(ratios, 0.25),
            quantile(ratios, 0.75),
            {}};
}

Result<double> count_of(const AccuracySetting& setting, const PricePlan& plan) {
    const std::string subject = plan.map_options.front() + ":" + plan.views_file;
    ChildBench bench{
        {subject}, setting.options, 1, static_cast<std::size_t>(plan.width) * static_cast<std::size_t>(plan.height)};
    bench.options.insert(bench.options.end(),
                         {"--threads", "1", "--size", std::to_string(plan.width) + "x" + std::to_string(plan.height)});
    bench.options.insert(bench.options.end(), plan.map_options.begin() + 1, plan.map_options.end());
    return instructions_per_pixel(subject, bench);
}

/// What is counted does not depend on what else the machine does: as many at once as it can.
Result<void> count_for(const std::vector<AccuracySetting>& settings, const PricePlan& plan,
                       std::vector<AccuracyPrice>& prices) {
    Progress progress(settings.size(), "settings counted");
    std::vector<Result<void>> counted(settings.size());
    ThreadPool pool(hardware_threads());
    pool.run(settings.size(), [&](std::size_t s, std::size_t worker) {
        const auto count = count_of(settings[s], plan);
        if (count.ok())
            prices[s].instructions = count.value();
        else
            counted[s] = count.error();
        progress.step(worker);
    });
    for (const Result<void>& one : counted)
        if (!one.ok()) return one.error();
    return {};
}

}  // namespace

Result<std::vector<AccuracyPrice>> measure_prices(const OpenMap& map, const std::vector<View>& views,
                                                  const std::vector<AccuracySetting>& settings, const PricePlan& plan) {
    auto all = priced_settings(map, settings);
    if (!all.ok()) return all.error();
    const Snapshot snapshot = at_rest(map.map);
    Frame frame;
    frame.resize(plan.width, plan.height);
    Progress progress((plan.rounds + 1) * settings.size(), "timings");
    for (std::size_t round = 0; round <= plan.rounds; ++round)
        for (std::size_t turn = 0; turn < settings.size(); ++turn) {
            // Another one begins each round: what is drawn before a picture warms or empties caches for it.
            Priced& priced = all.value()[(turn + round) % settings.size()];
            const auto took = time_views(*priced.renderer, snapshot, views, frame);
            if (!took.ok()) return took.error();
            if (round > 0) priced.rounds_ns.push_back(took.value());  // the first one pays for memory that grows
            progress.step(0);
        }
    std::vector<AccuracyPrice> prices;
    const double pixels = static_cast<double>(frame.pixels.size() * views.size());
    for (Priced& priced : all.value()) prices.push_back(price_of(priced, all.value().front(), pixels));
    if (!plan.views_file.empty())
        if (const Result<void> done = count_for(settings, plan, prices); !done.ok()) return done.error();
    return prices;
}

}  // namespace enfilade
