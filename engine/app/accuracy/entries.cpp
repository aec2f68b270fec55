#include "app/accuracy/entries.h"

#include <fmt/format.h>

#include <cmath>

#include "app/accuracy/errors.h"
#include "app/messages.h"
#include "app/pictures.h"
#include "base/files.h"
#include "render/reference/reference_renderer.h"

namespace enfilade {
namespace {

std::string colors_in(const EntryPlan& plan) { return plan.folder + "/colors"; }
std::string ids_in(const EntryPlan& plan) { return plan.folder + "/ids"; }

/// What a view truly looks like.
struct TrueView {
    Frame colors;
    Image ids;
};

/// Draws true views, one after the other.
class TruthPainter {
public:
    static Result<TruthPainter> make(const EntryPlan& plan, const OpenMap& map) {
        Dials smooth;
        smooth.samples = kMostSamples;
        auto renderer = make_renderer(one_thread(smooth), map.map, map.textures);
        if (!renderer.ok()) return renderer.error();
        return TruthPainter(plan, map, std::move(renderer).value());
    }

    TrueView paint(const View& view) {
        Frame colors, unused;
        colors.resize(plan_.width, plan_.height);
        unused.resize(plan_.width, plan_.height);
        const Result<void> drawn = smooth_->render(colors, nullptr, snapshot_, view);
        ENFILADE_CHECK(drawn.ok());  // the CPU's renderers do not fail
        FrameFacts facts;
        reset(facts, plan_.width, plan_.height);
        render_reference(unused, &facts, map_.map, map_.textures, snapshot_, view, {});
        for (std::size_t i = 0; i < facts.ids.size(); ++i)
            if (facts.ambiguous[i]) facts.ids[i] = kNothing;
        return {std::move(colors), ids_image(facts, plan_.width, plan_.height)};
    }

private:
    TruthPainter(const EntryPlan& plan, const OpenMap& map, std::unique_ptr<Renderer> smooth)
        : plan_(plan), map_(map), snapshot_(at_rest(map.map)), smooth_(std::move(smooth)) {}

    const EntryPlan& plan_;
    const OpenMap& map_;
    Snapshot snapshot_;
    std::unique_ptr<Renderer> smooth_;
};

Result<Image> read_picture(const EntryPlan& plan, const std::string& path) {
    const auto bytes = read_file(path);
    if (!bytes.ok()) return bytes.error();
    auto image = read_png(bytes.value());
    if (!image.ok()) return Error{path, image.error().what};
    const int width = static_cast<int>(image.value().width), height = static_cast<int>(image.value().height);
    if (width == plan.width && height == plan.height) return image;
    return Error{path, fmt::format("expected a picture of {} x {} pixels; found {} x {}", plan.width, plan.height,
                                   width, height)};
}

void add_ids(const Image& truth, const Image& entry, EntryScore& score) {
    constexpr std::uint32_t kColor = 0x00FFFFFF;
    for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
        if ((truth.pixels[i] & kColor) == 0) continue;
        ++score.judged_ids;
        score.wrong_ids += ((truth.pixels[i] ^ entry.pixels[i]) & kColor) != 0;
    }
}

}  // namespace

Result<void> export_truth(const EntryPlan& plan, const OpenMap& map) {
    auto painter = TruthPainter::make(plan, map);
    if (!painter.ok()) return painter.error();
    for (const std::string& folder : {colors_in(plan), ids_in(plan)})
        if (const Result<void> done = make_folder(folder); !done.ok()) return done.error();
    if (const Result<void> done = write_file(plan.folder + "/views.csv", views_csv(plan.views)); !done.ok())
        return done.error();
    Progress progress(plan.views.size(), "views");
    for (std::size_t i = 0; i < plan.views.size(); ++i) {
        const TrueView truth = painter.value().paint(plan.views[i]);
        if (const Result<void> done = write_numbered_picture(colors_in(plan), i, image_of(truth.colors)); !done.ok())
            return done.error();
        if (const Result<void> done = write_numbered_picture(ids_in(plan), i, truth.ids); !done.ok())
            return done.error();
        progress.step(0);
    }
    return {};
}

Result<EntryScore> score_entry(const EntryPlan& plan, const OpenMap& map) {
    auto painter = TruthPainter::make(plan, map);
    if (!painter.ok()) return painter.error();
    EntryScore score;
    double squared = 0;
    const bool has_ids = read_file(numbered_picture(ids_in(plan), 0)).ok();
    for (std::size_t i = 0; i < plan.views.size(); ++i) {
        const TrueView truth = painter.value().paint(plan.views[i]);
        auto colors = read_picture(plan, numbered_picture(colors_in(plan), i));
        if (!colors.ok()) return colors.error();
        const Frame entry = frame_of(colors.value());
        squared += squared_change(truth.colors, entry);
        score.ssim += structural_similarity(truth.colors, entry) / static_cast<double>(plan.views.size());
        if (!has_ids) continue;
        const auto ids = read_picture(plan, numbered_picture(ids_in(plan), i));
        if (!ids.ok()) return ids.error();
        add_ids(truth.ids, ids.value(), score);
    }
    score.psnr = signal_to_noise(
        squared, static_cast<std::uint64_t>(plan.width) * static_cast<std::uint64_t>(plan.height) * plan.views.size());
    return score;
}

}  // namespace enfilade
