#include "app/bench_children.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>

#include "app/bench_passes.h"
#include "app/child_program.h"
#include "app/progress.h"

namespace enfilade {
namespace {

using Words = std::vector<std::string>;

void append(Words& words, const Words& more) { words.insert(words.end(), more.begin(), more.end()); }

Words bench_words(const std::string& program, const ChildBench& bench, const Words& subjects, std::size_t rounds) {
    Words words{program, "bench"};
    append(words, subjects);
    append(words, bench.options);
    append(words, {"--rounds", std::to_string(rounds), "--csv", "-"});
    return words;
}

/// The first line that is not valgrind's.
std::string first_words(std::string_view said) {
    while (said.starts_with("==")) said.remove_prefix(std::min(said.find('\n'), said.size() - 1) + 1);
    return std::string(said.substr(0, said.find('\n')));
}

/// What the program says of one pass, or why it says nothing.
Result<std::string> said_by(const std::string& program, const Words& words) {
    auto end = run_child(words);
    if (!end.ok()) return end.error();
    if (end.value().exit_code == 0) return std::move(end).value().said;
    return Error{program,
                 fmt::format("expected it to measure what this program measures; it ended with {} and said: {}",
                             end.value().exit_code, first_words(end.value().said))};
}

Result<std::vector<PassFrame>> pass_of(const std::string& program, const ChildBench& bench) {
    const auto said = said_by(program, bench_words(program, bench, bench.subjects, 1));
    if (!said.ok()) return said.error();
    return read_pass(program, said.value());
}

/// The number after callgrind's "Collected :".
Result<std::int64_t> collected(const std::string& said) {
    constexpr std::string_view kLabel = "Collected : ";
    const std::size_t at = said.find(kLabel);
    std::int64_t count = 0;
    if (at != std::string::npos) std::from_chars(said.data() + at + kLabel.size(), said.data() + said.size(), count);
    if (count > 0) return count;
    return Error{"valgrind",
                 "expected a count of the renderer's instructions and found none; does this program still "
                 "have the names of its functions? Measure one that is not stripped"};
}

/// Of all frames together, drawn once uncounted by `bench` and then `rounds` times.
struct Counted {
    std::int64_t instructions = 0;
    std::size_t frames = 0;
};

Result<Counted> count_rounds(const std::string& subject, const ChildBench& bench, std::size_t rounds) {
    Words words{"valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null",
                fmt::format("--toggle-collect={}", kMeasuredFunction)};
    append(words, bench_words(this_program(), bench, {subject}, rounds));
    const auto said = said_by("valgrind", words);
    if (!said.ok()) return said.error();
    const auto instructions = collected(said.value());
    if (!instructions.ok()) return instructions.error();
    const auto pass = read_pass("valgrind", said.value());
    if (!pass.ok()) return pass.error();
    return Counted{instructions.value(), pass.value().size()};
}

Result<double> instructions_per_pixel(const std::string& subject, const ChildBench& bench) {
    const auto once = count_rounds(subject, bench, 1);
    if (!once.ok()) return once.error();
    const auto twice = count_rounds(subject, bench, 2);
    if (!twice.ok()) return twice.error();
    return static_cast<double>(twice.value().instructions - once.value().instructions) /
           static_cast<double>(once.value().frames * bench.pixels);
}

}  // namespace

Result<std::string> compare_with(const std::string& other, const ChildBench& bench) {
    const std::array<std::string, 2> programs{this_program(), other};
    std::array<Passes, 2> passes;
    Progress progress(2 * bench.rounds, "passes");
    for (std::size_t turn = 0; turn < 2 * bench.rounds; ++turn) {
        const std::size_t program = (turn + turn / 2) % 2;  // 0 1 1 0 0 1 1 0
        auto pass = pass_of(programs[program], bench);
        if (!pass.ok()) return pass.error();
        passes[program].push_back(std::move(pass).value());
        progress.step(0);
    }
    if (Status failed = compare_frames(programs, passes)) return *failed;
    return comparison_table(passes);
}

Result<std::string> count_instructions(const ChildBench& bench) {
    if (!is_installed("valgrind"))
        return Error{"--instructions",
                     "expected valgrind to be installed, which counts them; install it, or leave the "
                     "option out"};
    std::size_t width = 0;
    for (const std::string& subject : bench.subjects) width = std::max(width, subject.size());
    std::string text = fmt::format("{:<{}} {}\n", "", width, "instructions/pixel");
    Progress progress(bench.subjects.size(), "subjects");
    for (const std::string& subject : bench.subjects) {
        const auto count = instructions_per_pixel(subject, bench);
        if (!count.ok()) return count.error();
        text += fmt::format("{:<{}} {:>18.3f}\n", subject, width, count.value());
        progress.step(0);
    }
    return text;
}

}  // namespace enfilade
