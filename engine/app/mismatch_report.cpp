// Frames that are not as they were recorded, or not as another renderer draws them: found, and shown on a page.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <optional>

#include "app/messages.h"
#include "app/pictures.h"
#include "app/recorded_flight.h"
#include "base/files.h"
#include "base/owned_folder.h"
#include "base/text.h"
#include "flight/comparison.h"
#include "formats/text_parts.h"

namespace enfilade {
namespace {

namespace fs = std::filesystem;

/// Writes one picture into the folder; gives its name there.
Result<std::string> add_picture(const std::string& folder, int frame, const char* what, const Frame& picture) {
    const std::string name = fmt::format("{:06}-{}.png", frame, what);
    if (const Result<void> done = write_picture((fs::path(folder) / name).string(), image_of(picture)); !done.ok())
        return done.error();
    return name;
}

Result<void> add_difference(const std::string& folder, const BadFrame& bad, MismatchRow& row) {
    auto expected = add_picture(folder, bad.mismatch.frame, "expected", *bad.expected);
    if (!expected.ok()) return expected.error();
    row.expected_picture = expected.value();
    const Difference difference = difference_of(*bad.expected, reduced(bad.actual, bad.reduction));
    auto picture = add_picture(folder, bad.mismatch.frame, "difference", difference.picture);
    if (!picture.ok()) return picture.error();
    row.difference_picture = picture.value();
    row.reduction = bad.reduction;
    row.pixels = difference.pixels;
    row.of_pixels = difference.picture.pixels.size();
    row.largest = difference.largest;
    return {};
}

Result<MismatchRow> add_row(const std::string& folder, const BadFrame& bad) {
    MismatchRow row;
    row.mismatch = bad.mismatch;
    row.expected_origin = bad.expected_origin;
    auto actual = add_picture(folder, bad.mismatch.frame, "actual", bad.actual);
    if (!actual.ok()) return actual.error();
    row.actual_picture = actual.value();
    if (bad.expected)
        if (const Result<void> done = add_difference(folder, bad, row); !done.ok()) return done.error();
    return row;
}

/// Whether a report names its pictures so: 000012-actual.png.
bool is_picture(std::string_view name) {
    const std::size_t digits = std::min(name.find_first_not_of("0123456789"), name.size());
    const std::string_view rest = name.substr(digits);
    return digits >= 6 && (rest == "-actual.png" || rest == "-expected.png" || rest == "-difference.png");
}

}  // namespace

namespace {

std::string page_in(const std::string& folder) { return (fs::path(folder) / "index.html").string(); }

/// Paths of the pictures that reports put there.
std::vector<std::string> pictures_in(const std::string& folder) {
    std::vector<std::string> paths;
    for (const std::string& name : list_folder(folder))
        if (is_picture(name)) paths.push_back((fs::path(folder) / name).string());
    return paths;
}

/// Those of an earlier report that this one does not show.
std::vector<std::string> surplus_pictures(const std::string& folder, const std::vector<MismatchRow>& rows) {
    std::vector<std::string> surplus = pictures_in(folder);
    for (const MismatchRow& row : rows)
        for (const std::string& name : {row.actual_picture, row.expected_picture, row.difference_picture})
            std::erase(surplus, (fs::path(folder) / name).string());
    return surplus;
}

}  // namespace

Result<void> remove_report(const std::string& folder, const std::string& of_file) {
    std::vector<std::string> files = pictures_in(folder);
    if (files.empty()) return {};
    files.insert(files.end(), {page_in(folder), folder});
    return remove_superseded(files, of_file);
}

Result<void> write_report(const std::string& folder, const ReportText& text, const std::vector<BadFrame>& frames) {
    if (const Result<void> done = make_folder(folder); !done.ok()) return done.error();
    std::vector<MismatchRow> rows;
    for (const BadFrame& bad : frames) {
        auto row = add_row(folder, bad);
        if (!row.ok()) return row.error();
        rows.push_back(std::move(row).value());
    }
    if (const Result<void> done = write_file(page_in(folder), mismatch_page(text, rows)); !done.ok())
        return done.error();
    return remove_superseded(surplus_pictures(folder, rows), page_in(folder));
}

namespace {

Result<Frame> drawn_by(RendererKind kind, const FlightScene& scene, const DrawPlan& plan, int number) {
    const Dials dials = dials_for(kind, plan.dials);
    const auto renderer = make_renderer({kind, dials, plan.workers, plan.open_gl}, scene.map, scene.textures);
    if (!renderer.ok()) return renderer.error();
    Frame frame;
    frame.resize(plan.width, plan.height);
    if (const Result<void> done = draw_frame(scene, number, *renderer.value(), frame); !done.ok()) return done.error();
    return frame;
}

/// Which of the frames found a report shows, growing: the first, and those that a picture was kept of; where there is
/// none of these, the next ones.
std::vector<Mismatch> choose_shown(const std::vector<Mismatch>& found, const KeptPictures& kept) {
    std::vector<Mismatch> shown{found.front()}, others;
    for (std::size_t i = 1; i < found.size() && shown.size() < kMostShown; ++i) {
        const bool has_picture = kept.of({static_cast<std::uint32_t>(found[i].frame), found[i].expected}).has_value();
        (has_picture ? shown : others).push_back(found[i]);
    }
    others.resize(shown.size() > 1 ? 0 : std::min(others.size(), kMostShown - shown.size()));
    shown.insert(shown.end(), others.begin(), others.end());
    std::ranges::sort(shown, {}, &Mismatch::frame);
    return shown;
}

BadFrame bad_frame(const Mismatch& mismatch, std::optional<KeptPicture> kept, Frame actual) {
    BadFrame bad{mismatch, {}, std::move(actual), "no picture of this frame was kept", 1};
    if (!kept) return bad;
    bad.expected = std::move(kept->picture);
    bad.reduction = kept->reduction;
    bad.expected_origin = kept->reduction == 1 ? "as it was recorded"
                                               : fmt::format("as it was recorded, {} times smaller", kept->reduction);
    return bad;
}

/// What a reader of the report can do.
std::string advice_on(const KeptPictures& kept, const std::string& script_path) {
    std::string advice = fmt::format(
        "If the change was meant, record them again with `enfilade fly {} --record` and the options that were "
        "given here.",
        script_path);
    if (!kept.what_is_missing().empty())
        advice += fmt::format(
            " {} To see what was expected, run the same in the version that was right, and check again "
            "with the recording that this makes.",
            kept.what_is_missing());
    return advice;
}

Result<void> report_mismatches(const FlightScene& scene, const DrawPlan& plan, const std::string& script_path,
                               const FrameRecording& recording, const std::vector<Mismatch>& found,
                               const std::string& folder, Talk talk) {
    const KeptPictures kept(script_path, recording, plan);
    std::vector<BadFrame> shown;
    for (const Mismatch& mismatch : choose_shown(found, kept)) {
        auto actual = drawn_by(plan.renderer, scene, plan, mismatch.frame);
        if (!actual.ok()) return actual.error();
        auto picture = kept.of({static_cast<std::uint32_t>(mismatch.frame), mismatch.expected});
        shown.push_back(bad_frame(mismatch, std::move(picture), std::move(actual).value()));
    }
    if (talk == Talk::usual && !kept.what_is_missing().empty())
        print_to_stderr(script_path + ": " + kept.what_is_missing() + "\n");
    return write_report(folder, {"Flythrough " + script_path, advice_on(kept, script_path), found.size()}, shown);
}

/// Frames of the plan of which more than `allowed` pixels are different with another renderer.
Result<std::vector<int>> disagreements(const FlightScene& scene, const DrawPlan& plan, RendererKind other,
                                       double allowed, Talk talk) {
    struct CheckTools {
        std::unique_ptr<Renderer> renderer;
        Frame frame;
    };
    std::vector<CheckTools> tools(plan.workers);
    for (CheckTools& own : tools) {
        auto renderer =
            make_renderer({other, dials_for(other, plan.dials), 1, plan.open_gl}, scene.map, scene.textures);
        if (!renderer.ok()) return renderer.error();
        own.renderer = std::move(renderer).value();
    }
    std::vector<char> differs(frames_of(plan), 0);
    Progress progress(differs.size(), "frames", talk);
    const Result<void> drawn =
        draw_frames(scene, plan, [&](int number, const Frame& frame, std::size_t worker) -> Result<void> {
            CheckTools& own = tools[worker];
            own.frame.resize(plan.width, plan.height);
            if (const Result<void> done = draw_frame(scene, number, *own.renderer, own.frame); !done.ok())
                return done.error();
            differs[std::size_t(number - plan.first)] = double(difference_of(own.frame, frame).pixels) > allowed;
            progress.step(worker);
            return {};
        });
    if (!drawn.ok()) return drawn.error();
    std::vector<int> numbers;
    for (std::size_t i = 0; i < differs.size(); ++i)
        if (differs[i]) numbers.push_back(plan.first + int(i));
    return numbers;
}

}  // namespace

Result<FlightVerdict> check_flight(const FlightScene& scene, const DrawPlan& plan, const std::string& script_path,
                                   const std::string& report_folder, Talk talk) {
    const auto recorded = read_recording(script_path, read_file);
    if (!recorded.ok()) return recorded.error();
    if (const Result<void> valid = refuse_recording(recorded.value(), plan, scene.flight.frames(), script_path);
        !valid.ok())
        return valid.error();
    Progress progress(frames_of(plan), "frames", talk);
    const auto hashes = hash_frames(scene, plan, [&](int, const Frame&, std::size_t worker) -> Result<void> {
        progress.step(worker);
        return {};
    });
    if (!hashes.ok()) return hashes.error();
    const auto found = mismatches(recorded.value().frames, plan.first, hashes.value());
    if (found.empty()) return FlightVerdict{};
    if (const Result<void> done =
            report_mismatches(scene, plan, script_path, recorded.value(), found, report_folder, talk);
        !done.ok())
        return done.error();
    FlightVerdict verdict{{}, page_in(report_folder)};
    std::ranges::transform(found, std::back_inserter(verdict.differing), &Mismatch::frame);
    return verdict;
}

Result<FlightVerdict> compare_renderers(const FlightScene& scene, const DrawPlan& plan, RendererKind other,
                                        double tolerance, const std::string& report_folder, Talk talk) {
    const auto disagreeing = disagreements(scene, plan, other, tolerance * plan.width * plan.height, talk);
    if (!disagreeing.ok()) return disagreeing.error();
    const std::vector<int>& found = disagreeing.value();
    if (found.empty()) return FlightVerdict{};
    std::vector<BadFrame> shown;
    for (std::size_t i = 0; i < std::min(found.size(), kMostShown); ++i) {
        auto expected = drawn_by(other, scene, plan, found[i]), actual = drawn_by(plan.renderer, scene, plan, found[i]);
        if (!expected.ok()) return expected.error();
        if (!actual.ok()) return actual.error();
        const Mismatch mismatch{found[i], hash_of(expected.value()), hash_of(actual.value())};
        shown.push_back(
            {mismatch, std::move(expected).value(), std::move(actual).value(), "drawn by the other renderer", 1});
    }
    const ReportText text{"Two renderers", "What is expected was drawn by the other renderer.", found.size()};
    if (const Result<void> done = write_report(report_folder, text, shown); !done.ok()) return done.error();
    return FlightVerdict{found, page_in(report_folder)};
}

}  // namespace enfilade
