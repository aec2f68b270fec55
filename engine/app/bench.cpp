#include "app/bench.h"

#include <fmt/format.h>
#include <algorithm>

#include "app/messages.h"
#include "app/options.h"
#include "base/files.h"
#include "base/hash.h"
#include "formats/script.h"
#include "formats/text_parts.h"
#include "render/frame.h"

namespace enfilade {

namespace {

constexpr std::string_view kWalkEnding = ".csv";

std::optional<std::vector<View>> views_of_walk(const Map& map, const std::string& path) {
    const auto rows = open_views(path);
    if (!rows) return {};
    std::vector<View> views;
    for (const ViewRow& row : *rows) {
        const auto view = view_from(map, row, lens_for(map.render));
        if (!view.ok()) {
            fail({path + ":" + std::to_string(row.line), view.error().what});
            return {};
        }
        views.push_back(view.value());
    }
    return views;
}

std::optional<std::vector<View>> view_of_player(const Map& map, const std::string& path) {
    const auto view = view_at_start(map, lens_for(map.render));
    if (view.ok()) return std::vector{view.value()};
    fail({path, "the map has no player to look from; give it a walk: " + path + ":WALK.csv"});
    return {};
}

bool names_script(const std::string& path) {
    const auto bytes = read_file(path);
    return bytes.ok() && is_script(as_text(bytes.value()));
}

}  // namespace

std::optional<WalkName> walk_name(const std::string& name) {
    if (!name.ends_with(kWalkEnding)) return {};
    const std::size_t colon = name.rfind(':');
    if (colon == std::string::npos) return {};
    return WalkName{name.substr(0, colon), name.substr(colon + 1)};
}

std::optional<BenchSubject> BenchSubject::open(const std::string& name, const std::vector<std::string>& texture_folders,
                                               Talk talk) {
    BenchSubject subject;
    const auto walk = walk_name(name);
    if (!walk && name.ends_with(kWalkEnding)) {
        fail({name, "expected MAP:WALK.csv, for a list of views does not say of which map they are"});
        return {};
    }
    if (!walk && names_script(name)) {
        subject.flight_ = open_flight(name, texture_folders, kUsualSkill, talk);
        return subject.flight_ ? std::optional(std::move(subject)) : std::nullopt;
    }
    subject.map_ = open_map(walk ? walk->map : name, texture_folders, kUsualSkill, talk);
    if (!subject.map_) return {};
    auto views = walk ? views_of_walk(subject.map(), walk->views) : view_of_player(subject.map(), name);
    if (!views) return {};
    subject.views_ = std::move(*views);
    subject.snapshot_ = snapshot_at(subject.map(), 0);
    return subject;
}

FlightFrame BenchSubject::frame(int number) const {
    return flight_ ? flight_->flight.at(map(), number)
                   : FlightFrame{views_[static_cast<std::size_t>(number)], snapshot_};
}

namespace {

double ms(double ns) { return ns * 1e-6; }

/// All frames of one subject.
struct SubjectSum {
    double frames = 0, minimum_ns = 0, median_ns = 0, pixels = 0, walls = 0, runs = 0, viewports = 0;
    Hash pictures;
    const BenchFrame* slowest = nullptr;

    void add(const BenchFrame& frame) {
        ++frames;
        minimum_ns += static_cast<double>(frame.minimum_ns);
        median_ns += static_cast<double>(frame.median_ns);
        pixels += static_cast<double>(frame.counts.pixels);
        walls += static_cast<double>(frame.counts.walls);
        runs += static_cast<double>(frame.counts.runs);
        viewports += static_cast<double>(frame.counts.viewports);
        pictures.add(frame.counts.hash);
        if (!slowest || frame.minimum_ns > slowest->minimum_ns) slowest = &frame;
    }
};

std::string line_of(const std::string& subject, const SubjectSum& sum, std::size_t width) {
    return fmt::format(
        "{:<{}} {:>7} {:>9.3f} {:>9.3f} {:>9.3f} {:>5} {:>8.3f} {:>7.0f} {:>8.0f} {:>9.0f} {:>9.0f}  {:016x}\n",
        subject, width, sum.frames, ms(sum.minimum_ns / sum.frames), ms(sum.median_ns / sum.frames),
        ms(double(sum.slowest->minimum_ns)), sum.slowest->number, sum.pixels > 0 ? sum.minimum_ns / sum.pixels : 0.0,
        sum.walls / sum.frames, sum.runs / sum.frames, sum.viewports / sum.frames, sum.pixels / sum.frames,
        sum.pictures.value());
}

}  // namespace

BenchCounts counts_of(const Map& map, const Frame& frame, const FrameFacts& facts) {
    BenchCounts counts;
    counts.hash = hash_of(frame);
    const std::size_t width = static_cast<std::size_t>(frame.width);
    std::vector<std::uint32_t> walls;
    for (std::size_t i = 0; i < facts.ids.size(); ++i) {
        counts.pixels += facts.writes[i];
        if (i >= width && facts.ids[i] == facts.ids[i - width]) continue;
        ++counts.runs;
        const auto owner = owner_of(map, facts.ids[i]);
        if (owner && owner->kind == SurfaceKind::wall) walls.push_back(owner->index);
    }
    std::ranges::sort(walls);
    counts.walls = static_cast<std::size_t>(std::ranges::unique(walls).begin() - walls.begin());
    return counts;
}

std::int64_t median_of(std::vector<std::int64_t>& times) {
    const auto middle = times.begin() + static_cast<std::ptrdiff_t>((times.size() - 1) / 2);
    std::nth_element(times.begin(), middle, times.end());
    return *middle;
}

std::vector<BenchFrame> frames_in_turn(const std::vector<int>& counts) {
    std::vector<BenchFrame> frames;
    const int most = counts.empty() ? 0 : *std::ranges::max_element(counts);
    for (int number = 0; number < most; ++number)
        for (std::size_t subject = 0; subject < counts.size(); ++subject)
            if (number < counts[subject]) frames.push_back({subject, number});
    return frames;
}

Result<void> measure(std::vector<BenchFrame>& frames, std::size_t rounds, const TimedDrawing& draw, Talk talk) {
    std::vector<std::vector<std::int64_t>> times(frames.size());
    Progress progress((rounds + 1) * frames.size(), "frames", talk);
    for (std::size_t round = 0; round <= rounds; ++round)
        for (std::size_t i = 0; i < frames.size(); ++i) {
            const auto took_ns = draw(frames[i].subject, frames[i].number, round > 0);
            if (!took_ns.ok()) return took_ns.error();
            if (round > 0) times[i].push_back(took_ns.value());
            progress.step(0);
        }
    for (std::size_t i = 0; i < frames.size(); ++i) {
        frames[i].minimum_ns = *std::ranges::min_element(times[i]);
        frames[i].median_ns = median_of(times[i]);
    }
    return {};
}

std::string bench_csv(const std::vector<std::string>& subjects, const std::vector<BenchFrame>& frames) {
    std::string csv = "subject,frame,minimum_ns,median_ns,walls,runs,viewports,pixels,hash\n";
    for (const BenchFrame& frame : frames) {
        const BenchCounts& counts = frame.counts;
        csv += fmt::format("{},{},{},{},{},{},{},{},{:016x}\n", csv_field(subjects[frame.subject]), frame.number,
                           frame.minimum_ns, frame.median_ns, counts.walls, counts.runs, counts.viewports,
                           counts.pixels, counts.hash);
    }
    return csv;
}

std::string bench_table(const std::vector<std::string>& subjects, const std::vector<BenchFrame>& frames) {
    std::size_t width = 4;
    for (const std::string& subject : subjects) width = std::max(width, subject.size());
    std::vector<SubjectSum> sums(subjects.size());
    for (const BenchFrame& frame : frames) sums[frame.subject].add(frame);
    std::string text = fmt::format("{:<{}} {:>7} {:>9} {:>9} {:>9} {:>5} {:>8} {:>7} {:>8} {:>9} {:>9}  {}\n", "[ms]",
                                   width, "frames", "minimum", "median", "slowest", "frame", "ns/pixel", "walls",
                                   "runs", "viewports", "pixels", "pictures");
    for (std::size_t i = 0; i < subjects.size(); ++i)
        if (sums[i].slowest) text += line_of(subjects[i], sums[i], width);
    return text;
}

}  // namespace enfilade
