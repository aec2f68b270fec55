#include "app/bench.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/progress.h"

namespace enfilade {
namespace {

double ms(double ns) { return ns * 1e-6; }

/// Takes the middle of the sorted times, of an even number the lower one.
std::int64_t median_of(std::vector<std::int64_t>& times) {
    const auto middle = times.begin() + static_cast<std::ptrdiff_t>((times.size() - 1) / 2);
    std::nth_element(times.begin(), middle, times.end());
    return *middle;
}

/// As RFC 4180 has it.
std::string csv_field(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

std::string line_of(const std::string& subject, std::size_t number, const std::vector<BenchFrame>& frames,
                    std::size_t width) {
    double count = 0, minimum = 0, median = 0;
    const BenchFrame* slowest = nullptr;
    for (const BenchFrame& frame : frames) {
        if (frame.subject != number) continue;
        ++count;
        minimum += static_cast<double>(frame.minimum_ns);
        median += static_cast<double>(frame.median_ns);
        if (!slowest || frame.minimum_ns > slowest->minimum_ns) slowest = &frame;
    }
    if (!slowest) return "";
    return fmt::format("{:<{}} {:>8} {:>11.3f} {:>11.3f} {:>11.3f} (frame {})\n", subject, width, count,
                       ms(minimum / count), ms(median / count), ms(double(slowest->minimum_ns)), slowest->number);
}

}  // namespace

std::vector<BenchFrame> frames_in_turn(const std::vector<int>& counts) {
    std::vector<BenchFrame> frames;
    const int most = counts.empty() ? 0 : *std::ranges::max_element(counts);
    for (int number = 0; number < most; ++number)
        for (std::size_t subject = 0; subject < counts.size(); ++subject)
            if (number < counts[subject]) frames.push_back({subject, number});
    return frames;
}

Status measure(std::vector<BenchFrame>& frames, std::size_t rounds, const TimedDrawing& draw) {
    std::vector<std::vector<std::int64_t>> times(frames.size());
    Progress progress((rounds + 1) * frames.size(), "frames");
    for (std::size_t round = 0; round <= rounds; ++round)
        for (std::size_t i = 0; i < frames.size(); ++i) {
            const auto took_ns = draw(frames[i].subject, frames[i].number);
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
    std::string csv = "subject,frame,minimum_ns,median_ns\n";
    for (const BenchFrame& frame : frames)
        csv += fmt::format("{},{},{},{}\n", csv_field(subjects[frame.subject]), frame.number, frame.minimum_ns,
                           frame.median_ns);
    return csv;
}

std::string bench_table(const std::vector<std::string>& subjects, const std::vector<BenchFrame>& frames) {
    std::size_t width = 0;
    for (const std::string& subject : subjects) width = std::max(width, subject.size());
    std::string text =
        fmt::format("{:<{}} {:>8} {:>11} {:>11} {:>11}\n", "[ms]", width, "frames", "minimum", "median", "slowest");
    for (std::size_t i = 0; i < subjects.size(); ++i) text += line_of(subjects[i], i, frames, width);
    return text;
}

}  // namespace enfilade
