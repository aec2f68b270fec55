// What each setting costs: time, in turn with all others, and instructions, which repeat.
#include <algorithm>
#include <thread>

#include "app/accuracy/report.h"
#include "app/bench.h"
#include "app/messages.h"
#include "base/parallel.h"
#include "platform/clock.h"

namespace enfilade {
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
    ThreadPool pool(std::max(1u, std::thread::hardware_concurrency()));
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
