#include "app/accuracy/picture_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/accuracy/errors.h"
#include "app/messages.h"
#include "app/pictures.h"
#include "base/files.h"
#include "formats/png.h"
#include "render/reference/reference_renderer.h"
#include "render/view.h"

namespace enfilade {
namespace {

constexpr int kWidth = 640, kHeight = 400;         // of the whole picture [px]
constexpr int kCropWidth = 120, kCropHeight = 75;  // of the part [px]
constexpr std::size_t kLeft = 60, kTop = 195;      // a wall that goes away from the eye, and the floor before it
constexpr int kZoom = 3, kGap = 6;                 // [1], [px of the file]

Image crop_of(const JudgedPicture& picture) {
    constexpr std::uint32_t kPaper = 0xFFFFFFFF;
    Image image{2 * kCropWidth * kZoom + kGap, kCropHeight * kZoom, {}};
    image.pixels.assign(std::size_t{image.width} * image.height, kPaper);
    for (std::uint32_t y = 0; y < image.height; ++y)
        for (std::uint32_t x = 0; x < kCropWidth * kZoom; ++x) {
            const auto column = kLeft + x / kZoom;
            const auto i = (kTop + y / kZoom) * kWidth + column;
            image.pixels[std::size_t{y} * image.width + x] = picture.frame.pixels[i];
            image.pixels[std::size_t{y} * image.width + x + kCropWidth * kZoom + kGap] = error_color(picture.errors[i]);
        }
    return image;
}

}  // namespace

std::vector<AccuracySetting> crop_settings() {
    return {AccuracySetting(),
            promise_of(0.25),
            promise_of(1),
            promise_of(4),
            dial_of("span=16"),
            dial_of("number=fixed"),
            dial_of("number=vanilla"),
            dial_of("sampling=mip"),
            dial_of("samples=4")};
}

std::string crop_name(const AccuracySetting& setting) {
    std::string name = name_of(setting);
    name = name.substr(name.rfind(' ') + 1);
    std::ranges::replace(name, '=', '-');
    return name;
}

std::uint32_t error_color(std::optional<double> texel_error) {
    constexpr std::uint32_t kNone = 0xFF204020;
    constexpr std::array<std::array<double, 3>, 5> kStops{
        {{0, 0, 0}, {40, 60, 200}, {220, 30, 40}, {255, 220, 40}, {255, 255, 255}}};  // red, green, blue
    constexpr double kLeast = -6, kMost = 1;                                          // powers of ten
    if (!texel_error) return kNone;
    const double power = std::clamp(std::log10(std::max(*texel_error, 1e-30)), kLeast, kMost);
    const double place = (power - kLeast) / (kMost - kLeast) * (kStops.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(place), kStops.size() - 2);
    const double part = place - static_cast<double>(below);
    std::uint32_t color = 0xFF;
    for (std::size_t i = 3; i-- > 0;)
        color = color << 8 | static_cast<std::uint32_t>(kStops[below][i] * (1 - part) + kStops[below + 1][i] * part);
    return color;
}

Result<void> write_crops(const std::string& folder, const OpenMap& map, const std::vector<AccuracySetting>& settings) {
    const auto view = view_at_start(map.map, lens_for(map.map.render));
    if (!view.ok()) return view.error();
    if (const Result<void> done = make_folder(folder); !done.ok()) return done.error();
    const auto pictures = judge_pictures(map, view.value(), settings, kWidth, kHeight);
    if (!pictures.ok()) return pictures.error();
    for (std::size_t s = 0; s < settings.size(); ++s) {
        const Image crop = crop_of(pictures.value()[s]);
        if (const Result<void> done = write_picture(folder + "/" + crop_name(settings[s]) + ".png", crop); !done.ok())
            return done.error();
    }
    return {};
}

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
