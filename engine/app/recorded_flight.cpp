#include "app/recorded_flight.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "app/mismatch_report.h"
#include "app/pictures.h"
#include "app/progress.h"
#include "base/files.h"
#include "formats/frame_hashes.h"
#include "formats/number_text.h"
#include "formats/png.h"

namespace enfilade {
namespace {

namespace fs = std::filesystem;

std::string with_ending(const std::string& script_path, const char* ending) {
    return fs::path(script_path).replace_extension(ending).string();
}

std::size_t count_of(const DrawPlan& plan) { return std::size_t(plan.last - plan.first + 1); }

/// The hash of every frame of the plan, in order; `also` sees every frame, too.
Result<std::vector<std::uint64_t>> hash_frames(const FlightScene& scene, const DrawPlan& plan,
                                               const FrameTaker& also = {}) {
    std::vector<std::uint64_t> hashes(count_of(plan));
    Progress progress(hashes.size(), "frames");
    const Status failed = draw_frames(scene, plan, [&](int number, const Frame& frame, std::size_t worker) -> Status {
        hashes[std::size_t(number - plan.first)] = hash_of(frame);
        progress.step(worker);
        return also ? also(number, frame, worker) : Status{};
    });
    if (failed) return *failed;
    return hashes;
}

/// Numbers of the pictures in the folder, sorted.
std::vector<int> kept_numbers(const std::string& folder) {
    std::vector<int> numbers;
    std::error_code unreadable;
    for (const auto& entry : fs::directory_iterator(folder, unreadable)) {
        int number = -1;
        const bool numbered = std::sscanf(entry.path().stem().c_str(), "%d", &number) == 1;
        if (numbered && entry.path().string() == numbered_picture(folder, std::size_t(number)))
            numbers.push_back(number);
    }
    std::ranges::sort(numbers);
    return numbers;
}

/// Which frames to keep as pictures; those that are not kept any more are removed.
std::vector<int> choose_kept(const std::string& folder, const DrawPlan& plan, int keep_every) {
    std::vector<int> chosen;
    const auto before = kept_numbers(folder);
    for (int number = 0; keep_every > 0 && number <= plan.last; number += keep_every) chosen.push_back(number);
    if (keep_every <= 0)
        std::ranges::copy_if(before, std::back_inserter(chosen), [&](int number) { return number <= plan.last; });
    for (const int number : before)
        if (!std::ranges::binary_search(chosen, number)) fs::remove(numbered_picture(folder, std::size_t(number)));
    return chosen;
}

Result<FrameRecording> read_recorded(const std::string& script_path) {
    const std::string path = hashes_path(script_path);
    const auto bytes = read_file(path);
    if (!bytes.ok()) return Error{path, bytes.error().what + "; `enfilade fly --record` makes it"};
    auto recording = read_frame_hashes(as_text(bytes.value()));
    if (!recording.ok()) return Error{path + ":" + recording.error().where, recording.error().what};
    return recording;
}

std::string size_text(std::uint32_t width, std::uint32_t height) { return fmt::format("{}x{}", width, height); }

/// Where the recording is of pictures that these can never be equal to.
Status other_pictures(const FrameRecording& recording, const DrawPlan& plan, const std::string& script_path) {
    if (!recording.pictures) return {};
    const RecordedPictures& pictures = *recording.pictures;
    const std::string recorded = size_text(pictures.width, pictures.height),
                      drawn = size_text(std::uint32_t(plan.width), std::uint32_t(plan.height));
    if (recorded != drawn)
        return Error{script_path,
                     fmt::format("the recording has pictures of {0} pixels, and these have {1}; check with "
                                 "--size {0}, or record it again with --record",
                                 recorded, drawn)};
    if (pictures.renderer != name_of(plan.renderer))
        return Error{script_path,
                     fmt::format("the recording was drawn by the {0} renderer, and these pictures are by {1}; "
                                 "check with --renderer {0}, or compare the two with --check --against {0}",
                                 pictures.renderer, name_of(plan.renderer))};
    return {};
}

/// Where the recording does not cover exactly the frames of the flight.
Status other_frames(const std::vector<FrameHash>& recorded, int frames, const std::string& script_path) {
    bool same = recorded.size() == std::size_t(frames);
    for (std::size_t i = 0; same && i < recorded.size(); ++i) same = recorded[i].frame == i;
    if (same) return {};
    return Error{script_path, fmt::format("the flight has {}, but {} others were recorded; record it again with "
                                          "--record if that is meant",
                                          counted(std::size_t(frames), "frame"), recorded.size())};
}

std::optional<Frame> kept_picture(const std::string& script_path, int number) {
    const auto bytes = read_file(numbered_picture(kept_pictures_folder(script_path), std::size_t(number)));
    if (!bytes.ok()) return {};
    auto image = read_png(bytes.value());
    if (!image.ok()) return {};
    return Frame{int(image.value().width), int(image.value().height), std::move(image.value().pixels)};
}

Result<Frame> drawn_by(RendererKind kind, const FlightScene& scene, const DrawPlan& plan, int number) {
    const auto renderer = make_renderer(kind, plan.workers, plan.open_gl);
    if (!renderer.ok()) return renderer.error();
    Frame frame;
    frame.resize(plan.width, plan.height);
    if (Status failed = draw_frame(scene, number, *renderer.value(), frame)) return *failed;
    return frame;
}

Status report_mismatches(const FlightScene& scene, const DrawPlan& plan, const std::string& script_path,
                         const std::vector<Mismatch>& found, const std::string& folder) {
    std::vector<BadFrame> shown;
    for (std::size_t i = 0; i < std::min(found.size(), kMostShown); ++i) {
        const int number = found[i].frame;
        auto actual = drawn_by(plan.renderer, scene, plan, number);
        if (!actual.ok()) return actual.error();
        BadFrame bad{found[i], {}, std::move(actual).value(), "as it was recorded"};
        if (auto kept = kept_picture(script_path, number)) {
            bad.expected = std::move(*kept);
        } else {
            auto expected = drawn_by(RendererKind::reference, scene, plan, number);
            if (!expected.ok()) return expected.error();
            bad.expected = std::move(expected).value();
            bad.expected_origin = "not kept; here the reference renderer's picture of now";
        }
        shown.push_back(std::move(bad));
    }
    return write_report(folder, "Flythrough " + script_path, shown, found.size());
}

Error differ(const std::string& where, std::size_t bad, std::size_t all, int first, const std::string& folder) {
    return {where, fmt::format("{} of {} frames differ, frame {} first; see {}", bad, all, first,
                               (fs::path(folder) / "index.html").string())};
}

/// Frames of the plan of which more than `allowed` pixels are different with another renderer.
Result<std::vector<int>> disagreements(const FlightScene& scene, const DrawPlan& plan, RendererKind other,
                                       double allowed) {
    struct Desk {
        std::unique_ptr<Renderer> renderer;
        Frame frame;
    };
    std::vector<Desk> desks(plan.workers);
    for (Desk& desk : desks) {
        auto renderer = make_renderer(other, 1, plan.open_gl);
        if (!renderer.ok()) return renderer.error();
        desk.renderer = std::move(renderer).value();
    }
    std::vector<char> differs(count_of(plan), 0);
    Progress progress(differs.size(), "frames");
    const Status failed = draw_frames(scene, plan, [&](int number, const Frame& frame, std::size_t worker) -> Status {
        Desk& desk = desks[worker];
        desk.frame.resize(plan.width, plan.height);
        if (Status other_failed = draw_frame(scene, number, *desk.renderer, desk.frame)) return other_failed;
        differs[std::size_t(number - plan.first)] = double(difference_of(desk.frame, frame).pixels) > allowed;
        progress.step(worker);
        return {};
    });
    if (failed) return *failed;
    std::vector<int> numbers;
    for (std::size_t i = 0; i < differs.size(); ++i)
        if (differs[i]) numbers.push_back(plan.first + int(i));
    return numbers;
}

}  // namespace

std::string hashes_path(const std::string& script_path) { return with_ending(script_path, ".hashes"); }

std::string kept_pictures_folder(const std::string& script_path) { return with_ending(script_path, ".frames"); }

Status record_flight(const FlightScene& scene, const DrawPlan& plan, const std::string& script_path, int keep_every) {
    const std::string folder = kept_pictures_folder(script_path);
    const std::vector<int> kept = choose_kept(folder, plan, keep_every);
    if (!kept.empty())
        if (Status failed = make_folder(folder)) return failed;
    const auto hashes = hash_frames(scene, plan, [&](int number, const Frame& frame, std::size_t) -> Status {
        if (!std::ranges::binary_search(kept, number)) return {};
        return write_picture(numbered_picture(folder, std::size_t(number)), image_of(frame));
    });
    if (!hashes.ok()) return hashes.error();
    FrameRecording recording{
        RecordedPictures{std::uint32_t(plan.width), std::uint32_t(plan.height), name_of(plan.renderer)}, {}};
    for (const std::uint64_t hash : hashes.value())
        recording.frames.push_back({static_cast<std::uint32_t>(recording.frames.size()), hash});
    return write_file(hashes_path(script_path), write_frame_hashes(recording));
}

Status check_flight(const FlightScene& scene, const DrawPlan& plan, const std::string& script_path,
                    const std::string& report_folder) {
    const auto recorded = read_recorded(script_path);
    if (!recorded.ok()) return recorded.error();
    if (Status others = other_pictures(recorded.value(), plan, script_path)) return others;
    if (Status others = other_frames(recorded.value().frames, scene.flight.frames(), script_path)) return others;
    const auto hashes = hash_frames(scene, plan);
    if (!hashes.ok()) return hashes.error();
    const auto found = mismatches(recorded.value().frames, plan.first, hashes.value());
    if (found.empty()) return {};
    if (Status failed = report_mismatches(scene, plan, script_path, found, report_folder)) return failed;
    return differ(script_path, found.size(), hashes.value().size(), found.front().frame, report_folder);
}

Status compare_renderers(const FlightScene& scene, const DrawPlan& plan, RendererKind other, double tolerance,
                         const std::string& report_folder) {
    const auto disagreeing = disagreements(scene, plan, other, tolerance * plan.width * plan.height);
    if (!disagreeing.ok()) return disagreeing.error();
    const std::vector<int>& found = disagreeing.value();
    if (found.empty()) return {};
    std::vector<BadFrame> shown;
    for (std::size_t i = 0; i < std::min(found.size(), kMostShown); ++i) {
        auto expected = drawn_by(other, scene, plan, found[i]), actual = drawn_by(plan.renderer, scene, plan, found[i]);
        if (!expected.ok()) return expected.error();
        if (!actual.ok()) return actual.error();
        const Mismatch mismatch{found[i], hash_of(expected.value()), hash_of(actual.value())};
        shown.push_back(
            {mismatch, std::move(expected).value(), std::move(actual).value(), "drawn by the other renderer"});
    }
    if (Status failed = write_report(report_folder, "Two renderers", shown, found.size())) return failed;
    return differ("", found.size(), count_of(plan), found.front(), report_folder);
}

}  // namespace enfilade
