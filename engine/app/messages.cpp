#include "app/messages.h"

#include <fmt/format.h>
#include <unistd.h>

#include "base/terminal.h"
#include "formats/text_parts.h"
#include "platform/clock.h"

namespace enfilade {
namespace {

/// Between two drawings of the line [ns]: as often as an eye follows.
constexpr std::int64_t kPause = 100'000'000;

constexpr std::size_t kBarWidth = 30;  ///< [characters]

}  // namespace

int fail(const Error& error) {
    print_text(stderr, "enfilade: " + error.text() + "\n");
    return kFailed;
}

int refuse_usage(const Error& error) {
    fail(error);
    return kUsage;
}

Progress::Progress(std::size_t total, std::string noun, Talk talk)
    : total_(total),
      noun_(std::move(noun)),
      started_ns_(now_ns()),
      last_drawn_ns_(started_ns_ + kPause),
      on_terminal_(talk == Talk::usual && isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
    if (on_terminal_) redraw_line("");
}

void Progress::step(std::size_t worker) {
    const std::size_t done = done_.fetch_add(1) + 1;
    if (!on_terminal_ || worker != 0 || now_ns() - last_drawn_ns_ < kPause) return;
    last_drawn_ns_ = now_ns();
    draw(done);
}

void Progress::draw(std::size_t done) {
    const std::size_t filled = kBarWidth * done / total_;
    const double passed_s = double(now_ns() - started_ns_) * 1e-9;
    redraw_line(fmt::format("[{:#<{}}{:.<{}}] {} of {} {}, {:.0f} s left", "", filled, "", kBarWidth - filled, done,
                            total_, noun_, passed_s / double(done) * double(total_ - done)));
}

CutShortNote::~CutShortNote() {
    if (count_ == 0 || talk_ == Talk::errors_only) return;
    print_text(stderr, fmt::format("{}: note: in {} {}\n", out_, counted(count_, "picture"), kCutShort));
}

}  // namespace enfilade
