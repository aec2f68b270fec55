// When pictures are begun and shown, and when they need not be drawn again.
#include <gtest/gtest.h>

#include "app/play/pacing.h"
#include "support/map_builder.h"
#include "world/world.h"

namespace enfilade {
namespace {

constexpr std::int64_t kMs = 1'000'000;

TEST(Pacing, ShowsPicturesEvenlyHoweverLongTheyTake) {
    Pacing pacing;
    pacing.set_period(10 * kMs);
    pacing.go_on(100 * kMs);
    const std::int64_t first = pacing.due();
    for (int i = 1; i < 20; ++i) {
        pacing.drew((i % 5) * kMs);
        pacing.go_on(pacing.due() + kMs / 2);
        EXPECT_EQ(pacing.due(), first + i * 10 * kMs);
    }
}

TEST(Pacing, BeginsAsMuchEarlierAsTheSlowestTook) {
    Pacing pacing;
    pacing.set_period(16 * kMs);
    pacing.go_on(kMs);
    pacing.drew(2 * kMs), pacing.drew(5 * kMs), pacing.drew(3 * kMs);
    EXPECT_LT(pacing.begin(), pacing.due() - 5 * kMs);
    EXPECT_GT(pacing.begin(), pacing.due() - 6 * kMs);
}

TEST(Pacing, NeverBeginsMoreThanAPeriodEarlier) {
    Pacing pacing;
    pacing.set_period(16 * kMs);
    pacing.go_on(kMs);
    pacing.drew(200 * kMs);
    EXPECT_EQ(pacing.begin(), pacing.due() - 16 * kMs);
}

TEST(Pacing, DoesNotHurryAfterAPictureThatWasLate) {
    Pacing pacing;
    pacing.set_period(10 * kMs);
    pacing.go_on(100 * kMs);
    pacing.go_on(500 * kMs);
    EXPECT_EQ(pacing.due(), 510 * kMs);
}

TEST(Pacing, FollowsAShorterPeriodAtOnce) {
    Pacing pacing;
    pacing.set_period(1000 * kMs);
    pacing.go_on(100 * kMs);
    pacing.set_period(10 * kMs);
    pacing.go_on(101 * kMs);
    EXPECT_EQ(pacing.due(), 111 * kMs);
}

// When a picture need not be drawn again.

/// Two rooms, one seen and one not; each test changes one thing.
class TwoRooms : public ::testing::Test {
protected:
    void SetUp() override {
        file_ = test::map_of({test::box_room("here", 0, 0, 4, 4), test::box_room("there", 4, 0, 8, 4)});
    }

    /// Whether the picture drawn at rest, so many seconds after the start, is still the same, `change` later.
    template <class Change>
    bool is_same_after(Change change, double drawn_s = 0) {
        MapFile file = file_;
        test::join_all(file);
        const Map map = test::built(file);
        Snapshot snapshot = at_rest(map);
        snapshot.time_s = drawn_s;
        View view;
        view.sector = SectorId(0u);
        view.eye = {2, 2};
        view.eye_z = 1.5;
        Stillness stillness(map);
        stillness.drew(view, snapshot, {SectorId(0u)});
        change(view, snapshot);
        return stillness.is_same(view, snapshot);
    }
    bool is_same_later() {
        return is_same_after([](View&, Snapshot& snapshot) { snapshot.time_s += 0.1; });
    }

    /// Whether the picture drawn at one moment is the same at another [s].
    bool is_same_between(double drawn_s, double later_s) {
        return is_same_after([&](View&, Snapshot& snapshot) { snapshot.time_s = later_s; }, drawn_s);
    }

    MapFile file_;
};

TEST_F(TwoRooms, StayTheSameWhereNothingHappens) { EXPECT_TRUE(is_same_later()); }

TEST_F(TwoRooms, ChangeWithTheView) {
    EXPECT_FALSE(is_same_after([](View& view, Snapshot&) { view.eye.x += 1.0 / 1024; }));
    EXPECT_FALSE(is_same_after([](View& view, Snapshot&) { view.eye_z += 0.01; }));
    EXPECT_FALSE(is_same_after([](View& view, Snapshot&) { view.forward = {0, 1}; }));
    EXPECT_FALSE(is_same_after([](View& view, Snapshot&) { view.pitch_tangent = 0.1; }));
    EXPECT_FALSE(is_same_after([](View& view, Snapshot&) { view.fov_degrees = 91; }));
    EXPECT_FALSE(is_same_after([](View& view, Snapshot&) { view.tilt = Tilt{}; }));
}

TEST_F(TwoRooms, ChangeWithWhatMovesAndWhatIsTaken) {
    EXPECT_FALSE(is_same_after([](View&, Snapshot& snapshot) {
        snapshot.sectors[1].floor_z = 1;
        snapshot.changed.emplace_back(1u);
    }));
    EXPECT_FALSE(is_same_after([](View&, Snapshot& snapshot) { snapshot.taken.emplace_back(0u); }));
    EXPECT_FALSE(is_same_after([](View&, Snapshot& snapshot) { snapshot.pressed.emplace_back(0u); }));
    EXPECT_FALSE(is_same_after([](View&, Snapshot& snapshot) { snapshot.way_back = WallId(0u); }));
}

TEST_F(TwoRooms, AreNeverTheSameWhereALightFlickersInSight) {
    file_.sectors[0].light_effect.emplace();
    EXPECT_FALSE(is_same_later());
}

TEST_F(TwoRooms, StayTheSameWhereALightFlickersOutOfSight) {
    file_.sectors[1].light_effect.emplace();
    EXPECT_TRUE(is_same_later());
}

/// A strobe is dark for half a second, then bright for half a second, over and over.
PointLightRecord strobe_at(Vec2 position) {
    PointLightRecord lamp;
    lamp.position = position;
    lamp.z = 1;
    lamp.reach = 1;
    LightEffectRecord& effect = lamp.effect.emplace();
    effect.kind = LightKind::strobe;
    effect.dark_s = effect.bright_s = 0.5;
    effect.in_step = true;
    return lamp;
}

TEST_F(TwoRooms, ChangeWhenALampInSightDoesAndNotBetween) {
    file_.lights = {strobe_at({2, 1})};
    int changes = 0;
    for (int hundredths = 1; hundredths <= 200; ++hundredths) {
        const double from = (hundredths - 1) / 100.0, to = hundredths / 100.0;
        changes += !is_same_between(from, to);
    }
    EXPECT_GE(changes, 3);  // twice a second, of which the first and the last may lie outside
    EXPECT_LE(changes, 5);
}

TEST_F(TwoRooms, StayTheSameWhereALampFlickersOutOfReach) {
    file_.lights = {strobe_at({7, 1})};
    for (int hundredths = 1; hundredths <= 200; ++hundredths) EXPECT_TRUE(is_same_between(0, hundredths / 100.0));
}

TEST_F(TwoRooms, ChangeWhenAThingShowsItsNextPicture) {
    ThingRecord candle;
    candle.sector = "here";
    candle.position = {3, 2};
    candle.frames = {{"candle_1", 0.5, {}}, {"candle_2", 0.5, {}}};
    file_.things = {candle};
    EXPECT_TRUE(is_same_between(0.1, 0.4));
    EXPECT_FALSE(is_same_between(0.4, 0.6));
    EXPECT_TRUE(is_same_between(0.6, 0.9));
    EXPECT_TRUE(is_same_between(0.6, 1.6));
}

TEST_F(TwoRooms, AreNeverTheSameWhereAThingTurns) {
    ThingRecord key;
    key.sector = "here";
    key.position = {3, 2};
    key.turn = 90;
    key.frames = {{"key_1", 0, {}}};
    file_.things = {key};
    EXPECT_FALSE(is_same_later());
}

TEST_F(TwoRooms, AreNeverTheSameWhereAFloorBobs) {
    file_.sectors[0].floor.bob.emplace();
    EXPECT_FALSE(is_same_later());
}

TEST(Stillness, IsNothingWhereNothingWasSeen) {
    const Map map = test::built(test::map_of({test::box_room("here", 0, 0, 4, 4)}));
    Stillness stillness(map);
    View view;
    view.sector = SectorId(0u);
    EXPECT_FALSE(stillness.is_same(view, at_rest(map)));
    stillness.drew(view, at_rest(map), {});
    EXPECT_FALSE(stillness.is_same(view, at_rest(map)));
    stillness.drew(view, at_rest(map), {SectorId(0u)});
    EXPECT_TRUE(stillness.is_same(view, at_rest(map)));
    stillness.forget();
    EXPECT_FALSE(stillness.is_same(view, at_rest(map)));
}

}  // namespace
}  // namespace enfilade
