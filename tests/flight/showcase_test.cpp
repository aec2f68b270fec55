// Frames of the showcase of all effects, drawn in whatever order: time can be entered anywhere.
#include "support/showcase.h"

#include <numeric>

#include "base/hash.h"
#include "flight/flight.h"

namespace enfilade::test {
namespace {

using Hashes = std::vector<std::uint64_t>;

constexpr int kWidth = 48, kHeight = 30;  ///< enough to see what moves [px]

class ShowcaseFrames : public Showcase {
protected:
    FlightScene scene(const Flight& flight) const { return {flight, *loaded_.map, loaded_.textures}; }

    /// Of the frames from first to last, drawn one after the other.
    Hashes in_order(const Flight& flight, int first, int last) const {
        Hashes all;
        const DrawPlan plan{RendererKind::column, {}, kWidth, kHeight, first, last, 1, {}};
        EXPECT_TRUE(draw_frames_in_order(scene(flight), plan, [&](int, const Frame& frame, std::size_t) {
                        all.push_back(hash_of(frame));
                        return Result<void>{};
                    }).ok());
        return all;
    }
};

TEST_F(ShowcaseFrames, AreTheSameInRandomOrder) {
    const int count = flight_->frames();
    std::vector<int> order(static_cast<std::size_t>(count));
    std::iota(order.begin(), order.end(), 0);
    Random random(26);
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
    const FlightScene flown = scene(*flight_);
    auto renderer = make_renderer({}, flown.map, flown.textures);
    ASSERT_TRUE(renderer.ok());
    Hashes shuffled(order.size());
    Frame frame;
    frame.resize(kWidth, kHeight);
    for (const int number : order) {
        ASSERT_TRUE(draw_frame(scene(*flight_), number, *renderer.value(), frame).ok());
        shuffled[static_cast<std::size_t>(number)] = hash_of(frame);
    }
    EXPECT_EQ(shuffled, in_order(*flight_, 0, count - 1));
}

TEST_F(ShowcaseFrames, AreTheSameInTwoHalvesThatKnowNothingOfEachOther) {
    const int last = flight_->frames() - 1, middle = last / 2;
    const auto other = plan();
    ASSERT_TRUE(other);
    Hashes halves = in_order(*flight_, 0, middle);
    const Hashes second = in_order(*other, middle + 1, last);
    halves.insert(halves.end(), second.begin(), second.end());
    EXPECT_EQ(halves, in_order(*flight_, 0, last));
}

}  // namespace
}  // namespace enfilade::test
