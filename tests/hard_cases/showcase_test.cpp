// The showcase of all effects: what moves looks as the reference draws it, in the middle of its way, too.
#include "support/showcase.h"

#include "hard_cases/comparison.h"

namespace enfilade::test {
namespace {

constexpr int kEvery = 9;               ///< frame is compared: at 10 a second everything is caught on its way
constexpr PictureSize kSmall{117, 83};  ///< odd sides have a ray exactly along the look

TEST_F(Showcase, LooksAsInTheReferenceWhileThingsMove) {
    const Subject subject{"maps/effects.toml", *loaded_.map, loaded_.textures};
    Comparison sum;
    for (int number = 0; number < flight_->frames(); number += kEvery) {
        const FlightFrame frame = flight_->at(*loaded_.map, number);
        sum += compare(subject, frame.snapshot, frame.view, kSmall);
        ASSERT_TRUE(sum.is_faultless()) << "frame " << number << ": " << describe(sum);
    }
}

TEST_F(Showcase, MovesFloorsCeilingsLightsAndSwitches) {
    const Snapshot first = flight_->at(*loaded_.map, 0).snapshot,
                   last = flight_->at(*loaded_.map, flight_->frames() - 1).snapshot;
    std::size_t floors = 0, ceilings = 0, lights = 0;
    for (std::size_t i = 0; i < first.sectors.size(); ++i) {
        floors += first.sectors[i].floor_z != last.sectors[i].floor_z;
        ceilings += first.sectors[i].ceiling_z != last.sectors[i].ceiling_z;
        lights += first.sectors[i].light != last.sectors[i].light;
    }
    EXPECT_GE(floors, 10u);   // eight stairs, the vat, the shuttle
    EXPECT_GE(ceilings, 2u);  // the shutter, the press
    EXPECT_GE(lights, 1u);    // the study
    EXPECT_GE(last.pressed.size(), 4u);
}

}  // namespace
}  // namespace enfilade::test
