#include "app/picture_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <memory>

#include "app/messages.h"
#include "app/pictures.h"
#include "base/files.h"
#include "base/parallel.h"
#include "formats/text_parts.h"
#include "platform/clock.h"
#include "platform/gl_context.h"
#include "render/outside/outside_renderer.h"

namespace enfilade {
namespace {

/// What one thread draws with.
struct PictureTools {
    std::unique_ptr<Renderer> renderer;
    Frame frame;
    FrameFacts facts;
    std::unique_ptr<OutsideRenderer> outside;
    Frame outside_frame;
    Result<void> done;
};

/// Where a job puts what, by argument; what is not wanted is empty.
using Outputs = std::vector<std::pair<const char*, std::string>>;

Outputs picture_outputs(const PictureJob& job) {
    return {
        {"--out", job.out}, {"--ids", job.ids}, {"--from-above", job.from_above}, {"--from-behind", job.from_behind}};
}

Outputs all_outputs(const PictureJob& job) {
    Outputs all = picture_outputs(job);
    all.insert(all.end(), {{"--id-list", job.id_list}, {"--timing", job.timing}});
    return all;
}

class Drawing {
public:
    Drawing(const OpenMap& map, const PictureJob& job)
        : map_(map), job_(job), snapshot_(snapshot_at(map.map, job.time_s)), times_ns_(job.views.size()) {
        leave_out(job.left_out, snapshot_);
        const bool side_by_side = job.timing.empty() && job.views.size() >= job.threads;
        tools_.resize(side_by_side ? job.threads : 1);
        threads_each_ = side_by_side ? 1 : job.threads;
    }

    Result<void> run() {
        if (const Result<void> done = make_tools(); !done.ok()) return done.error();
        if (!job_.timing.empty())  // grows the renderer's memory, so that no view pays for it
            if (const Result<void> done = draw(tools_[0], 0); !done.ok()) return done.error();
        CutShortNote note(job_.out, job_.talk);
        Progress progress(job_.views.size(), "pictures", job_.talk);
        parallel_for(job_.views.size(), tools_.size(), [&](std::size_t i, std::size_t worker) {
            if (stop_) return;
            PictureTools& own = tools_[worker];
            own.done = draw(own, i);
            if (own.done.ok()) own.done = write(own, i);
            if (own.done.ok()) own.done = draw_outside(own, i, OutsideFrom::above, job_.from_above);
            if (own.done.ok()) own.done = draw_outside(own, i, OutsideFrom::behind, job_.from_behind);
            if (!own.done.ok()) stop_ = true;
            note.look_at(own.frame);
            progress.step(worker);
        });
        for (const PictureTools& own : tools_)
            if (!own.done.ok()) return own.done;
        if (const Result<void> done = flush_folders(); !done.ok()) return done.error();
        return write_timing();
    }

private:
    Result<void> make_tools() {
        for (PictureTools& own : tools_) {
            auto renderer = make_renderer({job_.renderer, job_.dials, threads_each_, open_gl_for_pictures}, map_.map,
                                          map_.textures);
            if (!renderer.ok()) return renderer.error();
            own.renderer = std::move(renderer).value();
            own.outside = std::make_unique<OutsideRenderer>(map_.map, map_.textures);
            own.frame.resize(job_.size.width, job_.size.height);
        }
        return {};
    }

    Result<void> draw(PictureTools& own, std::size_t i) {
        const bool want_facts = !job_.ids.empty();
        if (want_facts) reset(own.facts, job_.size.width, job_.size.height);
        const std::int64_t before = now_ns();
        Result<void> drawn =
            own.renderer->render(own.frame, want_facts ? &own.facts : nullptr, snapshot_, job_.views[i]);
        times_ns_[i] = now_ns() - before;
        return drawn;
    }

    Result<void> write(const PictureTools& own, std::size_t i) const {
        if (const Result<void> done = write(job_.out, i, image_of(own.frame)); !done.ok()) return done.error();
        if (job_.ids.empty()) return {};
        return write(job_.ids, i, ids_image(own.facts, own.frame.width, own.frame.height));
    }

    Result<void> draw_outside(PictureTools& own, std::size_t i, OutsideFrom from, const std::string& out) const {
        if (out.empty()) return {};
        const auto [width, height] = job_.size;
        own.outside_frame.resize(width, height);
        own.outside->render(own.outside_frame, snapshot_, job_.views[i], {from, job_.reach_m, width, height},
                            threads_each_);
        return write(out, i, image_of(own.outside_frame));
    }

    static Result<void> write(const std::string& out, std::size_t i, const Image& image) {
        return names_picture(out) ? write_picture(out, image) : write_numbered_picture(out, i, image);
    }

    Result<void> flush_folders() const {
        for (const auto& [argument, out] : picture_outputs(job_))
            if (!out.empty() && !names_picture(out))
                if (const Result<void> done = flush_folder(out); !done.ok()) return done.error();
        return {};
    }

    Result<void> write_timing() const {
        if (job_.timing.empty()) return {};
        std::string csv = "view,ns\n";
        for (std::size_t i = 0; i < times_ns_.size(); ++i) csv += fmt::format("{},{}\n", i, times_ns_[i]);
        return write_file(job_.timing, csv);
    }

    const OpenMap& map_;
    const PictureJob& job_;
    Snapshot snapshot_;
    std::vector<PictureTools> tools_;
    std::size_t threads_each_ = 1;
    std::vector<std::int64_t> times_ns_;
    std::atomic<bool> stop_ = false;
};

}  // namespace

namespace {

Result<void> check_places(const PictureJob& job) {
    const Outputs outputs = all_outputs(job);
    const auto is_standard_output = [](const auto& output) { return output.second == "-"; };
    if (std::ranges::count_if(outputs, is_standard_output) + !job.at.empty() > 1)
        return Error{
            "",
            "only one of --out, --ids, --id-list, --from-above, --from-behind and --timing can be '-', standard "
            "output, and none with --at, which tells there what it finds"};
    for (const auto& [argument, path] : outputs) {
        const auto is_same = [&p = path](const auto& output) { return output.second == p; };
        const bool is_place = !path.empty() && path != "-" && !std::filesystem::is_other(path);
        if (is_place && std::ranges::count_if(outputs, is_same) > 1)
            return Error{argument,
                         fmt::format("{} is given twice; each output needs a place of its own", in_quotes(path))};
    }
    return {};
}

}  // namespace

Result<void> check_outputs(const PictureJob& job) {
    if (const Result<void> valid = check_places(job); !valid.ok()) return valid.error();
    if (job.reach_m != kUsualReach && job.from_above.empty() && job.from_behind.empty())
        return Error{"--reach", "needs --from-above or --from-behind, whose pictures it is about"};
    for (const auto& [argument, path] : picture_outputs(job)) {
        if (names_film(path) && !names_picture(path))
            return Error{argument, "render writes pictures; `enfilade fly` writes films"};
        const std::size_t count = job.views.size();
        const std::string expected = count == 1 ? "a .png picture, or a folder for 000000.png"
                                                : fmt::format("a folder for {}", counted(count, "picture"));
        if (const Result<void> valid = refuse_other_kinds(argument, expected, path); !valid.ok()) return valid.error();
        if (count != 1 && names_picture(path)) return not_a(argument, expected, path);
    }
    return {};
}

Result<void> draw_pictures(const OpenMap& map, const PictureJob& job) {
    for (const auto& [argument, path] : picture_outputs(job))
        if (!path.empty() && !names_picture(path))
            if (const Result<void> done = make_folder(path); !done.ok()) return done.error();
    return Drawing(map, job).run();
}

}  // namespace enfilade
