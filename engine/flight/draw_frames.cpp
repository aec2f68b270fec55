#include "flight/draw_frames.h"

#include <algorithm>
#include <atomic>
#include <memory>
#include <vector>

#include "base/parallel.h"

namespace enfilade {
namespace {

/// Frames that wait to be handed over, per worker: enough that nobody idles while they are.
constexpr std::size_t kWaitingPerWorker = 4;

}  // namespace

Status draw_frame(const FlightScene& scene, int number, Renderer& renderer, Frame& frame) {
    const FlightFrame shown = scene.flight.at(scene.map, number);
    return renderer.render(frame, nullptr, shown.snapshot, shown.view);
}

Status draw_frames(const FlightScene& scene, const DrawPlan& plan, const FrameTaker& take) {
    struct DrawTools {
        std::unique_ptr<Renderer> renderer;
        Frame frame;
        Status failed;
    };
    std::vector<DrawTools> tools(plan.workers);
    for (DrawTools& own : tools) {
        auto renderer = make_renderer({plan.renderer, plan.samples, 1, plan.open_gl}, scene.map, scene.textures);
        if (!renderer.ok()) return renderer.error();
        own.renderer = std::move(renderer).value();
        own.frame.resize(plan.width, plan.height);
    }
    std::atomic<bool> stop = false;
    const auto count = static_cast<std::size_t>(plan.last - plan.first + 1);
    parallel_for(count, plan.workers, [&](std::size_t i, std::size_t worker) {
        if (stop) return;
        DrawTools& own = tools[worker];
        const int number = plan.first + static_cast<int>(i);
        own.failed = draw_frame(scene, number, *own.renderer, own.frame);
        if (!own.failed) own.failed = take(number, own.frame, worker);
        if (own.failed) stop = true;
    });
    for (DrawTools& own : tools)
        if (own.failed) return own.failed;
    return {};
}

Status draw_frames_in_order(const FlightScene& scene, const DrawPlan& plan, const FrameTaker& take) {
    const int batch = static_cast<int>(plan.workers * kWaitingPerWorker);
    std::vector<Frame> waiting(static_cast<std::size_t>(batch));
    for (int first = plan.first; first <= plan.last; first += batch) {
        DrawPlan part = plan;
        part.first = first;
        part.last = std::min(plan.last, first + batch - 1);
        const auto keep = [&](int number, const Frame& frame, std::size_t) -> Status {
            waiting[static_cast<std::size_t>(number - first)] = frame;
            return {};
        };
        if (Status failed = draw_frames(scene, part, keep)) return failed;
        for (int number = part.first; number <= part.last; ++number)
            if (Status failed = take(number, waiting[static_cast<std::size_t>(number - first)], 0)) return failed;
    }
    return {};
}

}  // namespace enfilade
