// Many frames on several threads.
#include "flight/flight.h"

#include <gtest/gtest.h>

#include <atomic>

#include "flight/scenes.h"

namespace enfilade {
namespace {

class FlightThroughALink : public ::testing::Test {
protected:
    FlightThroughALink() {
        Findings findings;
        const ScriptFile script = test::script_of({test::go(3, {5, 2}), test::go(1, {102, 3})});
        flight_ = Flight::plan(script, map_, findings);
        EXPECT_TRUE(flight_) << test::text_of(findings);
    }

    FlightScene scene() const { return {*flight_, map_, textures_}; }
    DrawPlan plan(int first, int last, std::size_t workers) const {
        return {RendererKind::column, {}, 64, 40, first, last, workers, {}};
    }
    std::vector<std::uint64_t> hashes(int first, int last, std::size_t workers) const {
        std::vector<std::uint64_t> all(static_cast<std::size_t>(last - first + 1));
        const Result<void> result =
            draw_frames(scene(), plan(first, last, workers), [&](int number, const Frame& frame, std::size_t) {
                all[static_cast<std::size_t>(number - first)] = hash_of(frame);
                return Result<void>{};
            });
        EXPECT_TRUE(result.ok());
        return all;
    }

    MapFile file_ = test::linked_file();
    Map map_ = test::built(file_);
    TextureSet textures_ = test::textures_for(file_);
    std::optional<Flight> flight_;
};

TEST_F(FlightThroughALink, LooksTheSameForAnyNumberOfWorkers) {
    const auto one = hashes(0, 40, 1);
    for (const std::size_t workers : {2u, 3u, 8u}) EXPECT_EQ(hashes(0, 40, workers), one) << workers;
}

TEST_F(FlightThroughALink, LooksTheSameInTwoHalves) {
    auto halves = hashes(0, 19, 1);
    const auto second = hashes(20, 40, 2);
    halves.insert(halves.end(), second.begin(), second.end());
    EXPECT_EQ(halves, hashes(0, 40, 1));
}

TEST_F(FlightThroughALink, ShowsSomethingElseInEveryFrame) {
    auto all = hashes(0, 40, 1);
    std::ranges::sort(all);
    EXPECT_EQ(std::ranges::unique(all).size(), 0u);
}

TEST_F(FlightThroughALink, HandsFramesOverInOrder) {
    int next = 3;
    std::vector<std::uint64_t> in_order;
    EXPECT_TRUE(draw_frames_in_order(scene(), plan(3, 40, 2), [&](int number, const Frame& frame, std::size_t) {
                    EXPECT_EQ(number, next++);
                    in_order.push_back(hash_of(frame));
                    return Result<void>{};
                }).ok());
    EXPECT_EQ(in_order, hashes(3, 40, 1));
}

TEST_F(FlightThroughALink, StopsAtAnError) {
    std::atomic<int> taken = 0;
    const Result<void> result =
        draw_frames(scene(), plan(0, 40, 1), [&](int number, const Frame&, std::size_t) -> Result<void> {
            ++taken;
            if (number == 5) return Error{"disk", "full"};
            return {};
        });
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().text(), "disk: full");
    EXPECT_EQ(taken, 6);
}

TEST_F(FlightThroughALink, StopsAtAnErrorInOrder) {
    int taken = 0;
    EXPECT_FALSE(draw_frames_in_order(scene(), plan(0, 40, 2), [&](int, const Frame&, std::size_t) -> Result<void> {
                     ++taken;
                     return Error{"disk", "full"};
                 }).ok());
    EXPECT_EQ(taken, 1);
}

}  // namespace
}  // namespace enfilade
