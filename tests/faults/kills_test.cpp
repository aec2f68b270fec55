// Processes that are killed at random moments: every file is the old one or the new one, whole.
#include <gmock/gmock.h>

#include <unistd.h>

#include <chrono>
#include <filesystem>

#include "app/play/game.h"
#include "base/hash.h"
#include "faults/work.h"

namespace enfilade::test {
namespace {

using ::testing::IsEmpty;

class Killed : public ::testing::Test {
protected:
    /// How long the work takes when nobody kills it [us].
    unsigned duration_us(const Workshop::Work& work) const {
        const auto began = std::chrono::steady_clock::now();
        shop_.run(work, [] {});
        const auto took = std::chrono::steady_clock::now() - began;
        return static_cast<unsigned>(std::chrono::duration_cast<std::chrono::microseconds>(took).count());
    }

    Workshop shop_;
    Random random_{20261122};
};

TEST_F(Killed, AtARandomMomentLeavesWholeFiles) {
    for (const Workshop::Work& work : shop_.works()) {
        if (work.files.empty()) continue;
        const unsigned duration = duration_us(work);
        std::size_t killed = 0, changed = 0;
        for (std::size_t trial = 0; trial < trials(20, 200); ++trial) {
            const auto after_us = static_cast<unsigned>(random_.below(duration + duration / 4));
            killed += shop_.run_and_kill(work, [&] { usleep(after_us); }).status == 128 + 9 ? 1 : 0;
            EXPECT_THAT(shop_.broken_files(work, false), IsEmpty()) << work.name << " after " << after_us << " us";
            changed += shop_.broken_files(work, true).size() < work.files.size() ? 1 : 0;
            shop_.clean_up();
        }
        std::printf("%-9s %4zu killed, %4zu after a file was written\n", work.name.c_str(), killed, changed);
        EXPECT_GT(killed, 0u) << work.name;
    }
}

TEST_F(Killed, WhileRecordingLeavesATapeThatCanBePlayed) {
    const Workshop::Work record{"tape",
                                [] {
                                    auto game = Game::start("map.toml", {}).value();
                                    if (!game->record("walk.tape").ok()) return 1;
                                    TickInput input;
                                    input.forward = 127;
                                    for (;;) game->tick(input);
                                },
                                {}};
    auto game = Game::start(shop_.path("map.toml"), {}).value();
    const std::string tape = shop_.path("walk.tape");
    for (std::size_t trial = 0; trial < trials(20, 200); ++trial) {
        std::filesystem::remove(tape);
        shop_.run_and_kill(record, [&] {
            constexpr std::size_t kSomeTicks = 1000;  // [bytes]
            std::error_code missing;
            while (std::filesystem::file_size(tape, missing) < kSomeTicks || missing) usleep(1000);
            usleep(static_cast<unsigned>(random_.below(20'000)));
        });
        const Result<void> result = game->load_saved(tape);
        EXPECT_TRUE(result.ok()) << result.error().text();
        EXPECT_GT(game->world().tick, 0u);
    }
}

}  // namespace
}  // namespace enfilade::test
