#include "command/command.h"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>

#include "base/text.h"

namespace enfilade {
namespace {

/// Between two drawings of the line [ns]: as often as an eye follows.
constexpr std::int64_t kPause = 100'000'000;

constexpr std::size_t kBarWidth = 30;  ///< [characters]

std::int64_t steady_ns() {
    using namespace std::chrono;
    return duration_cast<nanoseconds>(steady_clock::now().time_since_epoch()).count();
}

}  // namespace

Progress::Progress(std::size_t total, std::string noun, Talk talk)
    : total_(total),
      noun_(std::move(noun)),
      started_ns_(steady_ns()),
      last_drawn_ns_(started_ns_ + kPause),
      on_terminal_(talk == Talk::usual && isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
    if (on_terminal_) redraw_line("");
}

void Progress::show(std::size_t done, std::size_t total, std::size_t worker) {
    if (!on_terminal_ || worker != 0 || steady_ns() - last_drawn_ns_ < kPause) return;
    last_drawn_ns_ = steady_ns();
    draw(done, total);
}

void Progress::draw(std::size_t done, std::size_t total) const {
    const std::size_t filled = kBarWidth * done / total;
    const double passed_s = double(steady_ns() - started_ns_) * 1e-9;
    redraw_line(fmt::format("[{:#<{}}{:.<{}}] {} of {} {}, {:.0f} s left", "", filled, "", kBarWidth - filled, done,
                            total, noun_, passed_s / double(done) * double(total - done)));
}

}  // namespace enfilade
