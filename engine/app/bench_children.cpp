#include "app/bench.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>

#include "app/messages.h"
#include "app/programs.h"

namespace enfilade {

namespace {

constexpr std::string_view kHeader = "subject,frame,minimum_ns,median_ns";

template <class Number>
std::optional<Number> whole_number(std::string_view text) {
    Number number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && end == text.data() + text.size() && number >= 0 ? std::optional(number)
                                                                                   : std::nullopt;
}

/// The fields of a row from its end on; the first one, a name, may hold commas.
std::vector<std::string_view> fields_of(std::string_view row, std::size_t count) {
    std::vector<std::string_view> fields(count);
    for (std::size_t i = count; i-- > 1;) {
        const std::size_t comma = row.rfind(',');
        if (comma == std::string_view::npos) return {};
        fields[i] = row.substr(comma + 1);
        row = row.substr(0, comma);
    }
    fields[0] = row;
    return fields;
}

/// None where the row is none of a table with this header.
std::optional<PassFrame> read_row(std::string_view row, std::string_view header) {
    const auto fields = fields_of(row, static_cast<std::size_t>(std::ranges::count(header, ',')) + 1);
    if (fields.empty()) return {};
    const auto number = whole_number<int>(fields[1]);
    const auto ns = whole_number<std::int64_t>(fields[2]);
    if (!number || !ns) return {};
    PassFrame frame{std::string(fields[0]), *number, *ns, {}};
    if (header.ends_with(",hash")) frame.hash = std::string(fields.back());
    return frame;
}

std::string_view take_line(std::string_view& text) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return line;
}

/// One subject in one or both programs.
struct Row {
    std::string subject;
    std::array<double, 2> minimum_ns{}, median_ns{};  ///< means over the frames, by program
    std::size_t frames = 0, different = 0;
    bool is_told = true;  ///< by both programs, what the pictures are
};

std::vector<std::int64_t> times_of(const Passes& passes, std::size_t i) {
    std::vector<std::int64_t> times;
    for (const auto& pass : passes) times.push_back(pass[i].ns);
    return times;
}

void add_frame(const std::array<Passes, 2>& passes, std::size_t i, Row& row) {
    for (std::size_t program = 0; program < 2; ++program) {
        std::vector<std::int64_t> times = times_of(passes[program], i);
        row.minimum_ns[program] += static_cast<double>(*std::ranges::min_element(times));
        row.median_ns[program] += static_cast<double>(median_of(times));
    }
    const PassFrame &ours = passes[0][0][i], &theirs = passes[1][0][i];
    row.is_told &= ours.hash && theirs.hash;
    row.different += ours.hash != theirs.hash;
    ++row.frames;
}

std::vector<Row> rows_of(const std::array<Passes, 2>& passes) {
    std::vector<Row> rows;
    for (std::size_t i = 0; i < passes[0][0].size(); ++i) {
        const std::string& subject = passes[0][0][i].subject;
        auto row = std::ranges::find(rows, subject, &Row::subject);
        if (row == rows.end()) row = rows.insert(rows.end(), Row{subject});
        add_frame(passes, i, *row);
    }
    return rows;
}

std::string pictures_of(const Row& row) {
    if (!row.is_told) return "not told by both";
    return row.different == 0 ? "the same" : fmt::format("{} of {} differ", row.different, row.frames);
}

double ratio(const std::array<double, 2>& times) { return times[1] > 0 ? times[0] / times[1] : 0; }

}  // namespace

Result<std::vector<PassFrame>> read_pass(const std::string& program, std::string_view said) {
    std::vector<PassFrame> pass;
    std::string_view header, first;
    while (!said.empty()) {
        const std::string_view line = take_line(said);
        if (first.empty()) first = line;
        if (line.starts_with(kHeader)) header = line;
        if (auto frame = header.empty() ? std::nullopt : read_row(line, header)) pass.push_back(std::move(*frame));
    }
    if (!pass.empty()) return pass;
    return Error{program, fmt::format("expected rows of `{}…`, as `enfilade bench --csv -` writes them; found '{}'",
                                      kHeader, first)};
}

Result<void> compare_frames(const std::array<std::string, 2>& programs, const std::array<Passes, 2>& passes) {
    const auto& wanted = passes[0][0];
    for (std::size_t program = 0; program < 2; ++program)
        for (const auto& pass : passes[program])
            if (!std::ranges::equal(pass, wanted, &PassFrame::is_same_frame))
                return Error{programs[program], fmt::format("expected the {} frames that {} draws; found {} others",
                                                            wanted.size(), programs[0], pass.size())};
    return {};
}

std::string comparison_table(const std::array<Passes, 2>& passes) {
    const std::vector<Row> rows = rows_of(passes);
    std::size_t width = 4;
    for (const Row& row : rows) width = std::max(width, row.subject.size());
    std::string text = fmt::format("{:<{}} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9}  {}\n", "[ms]", width, "minimum",
                                   "median", "other's", "other's", "ratio", "ratio", "pictures");
    double minima = 0, medians = 0;
    for (const Row& row : rows) {
        const double frames = static_cast<double>(row.frames) * 1e6;
        text += fmt::format("{:<{}} {:>9.3f} {:>9.3f} {:>9.3f} {:>9.3f} {:>9.3f} {:>9.3f}  {}\n", row.subject, width,
                            row.minimum_ns[0] / frames, row.median_ns[0] / frames, row.minimum_ns[1] / frames,
                            row.median_ns[1] / frames, ratio(row.minimum_ns), ratio(row.median_ns), pictures_of(row));
        minima += ratio(row.minimum_ns) / static_cast<double>(rows.size());
        medians += ratio(row.median_ns) / static_cast<double>(rows.size());
    }
    return text + fmt::format("{:<{}} {:>9} {:>9} {:>9} {:>9} {:>9.3f} {:>9.3f}\n", "mean", width, "", "", "", "",
                              minima, medians);
}

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

/// One is like the other.
constexpr std::size_t kCountedRounds = 1;

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

}  // namespace

Result<double> instructions_per_pixel(const std::string& subject, const ChildBench& bench) {
    Words words{"valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null",
                fmt::format("--toggle-collect={}", kMeasuredFunction)};
    append(words, bench_words(this_program(), bench, {subject}, kCountedRounds));
    const auto said = said_by("valgrind", words);
    if (!said.ok()) return said.error();
    const auto instructions = collected(said.value());
    if (!instructions.ok()) return instructions.error();
    const auto pass = read_pass("valgrind", said.value());
    if (!pass.ok()) return pass.error();
    return static_cast<double>(instructions.value()) /
           static_cast<double>(kCountedRounds * pass.value().size() * bench.pixels);
}

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
    if (const Result<void> done = compare_frames(programs, passes); !done.ok()) return done.error();
    return comparison_table(passes);
}

Result<std::string> count_instructions(const ChildBench& bench) {
    if (!find_program("valgrind"))
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
