// The way back that a one-way portal leaves: when it is there, for whom, and when it is gone.
#include <gtest/gtest.h>

#include <array>
#include <utility>

#include "world/one_way_maps.h"
#include "world/snapshot.h"
#include "world/step.h"
#include "world/voices.h"
#include "world/world.h"

namespace enfilade {
namespace {

using namespace test;

/// A link, a pair of neighbours, and a link that turns and rises, each with a way back.
std::vector<OneWayPair> pairs_with_way_back() {
    OneWayPair link, neighbours, turned;
    neighbours.is_link = false;
    turned.near_turn = {16, 63};
    turned.far_turn = {-33, 56};
    turned.rise = 8;
    std::vector<OneWayPair> pairs{link, neighbours, turned};
    for (OneWayPair& pair : pairs) pair.way_back = true;
    return pairs;
}

/// Calls visit(game) for a player before the portal of each pair.
template <class Visit>
void in_each_pair_with_way_back(Visit visit) {
    for (const OneWayPair& pair : pairs_with_way_back()) {
        OneWayMap rooms(pair);
        rooms.place({-1.5, 0});
        SCOPED_TRACE(testing::Message() << (pair.is_link ? "link" : "neighbours") << ", turned by " << pair.far_turn.x);
        Game game(rooms.file());
        ASSERT_NO_FATAL_FAILURE(visit(game));
    }
}

WallId open_way(const Game& game) { return game.world.history.way_back(static_cast<double>(game.world.tick)); }

void pass(Game& game) {
    game.hold(kForward, 60);
    ASSERT_EQ(game.room(), "far");
}

TEST(WayBack, LetsBackWhoHasPassed) {
    in_each_pair_with_way_back([](Game& game) {
        ASSERT_NO_FATAL_FAILURE(pass(game));
        EXPECT_TRUE(open_way(game));
        for (int i = 0; i < 90; ++i) {
            game.hold(kBack);
            ASSERT_TRUE(game.is_contained()) << i;
        }
        EXPECT_EQ(game.room(), "near");
        EXPECT_FALSE(open_way(game)) << "one is back, and the portal is what it was";
    });
}

TEST(WayBack, IsTheWayThereReversed) {
    in_each_pair_with_way_back([](Game& game) {
        ASSERT_NO_FATAL_FAILURE(pass(game));
        const WallId back = open_way(game), there = game.map[back].exit;
        const Vec2 point = snap_to_point_grid((game.map[there].a + game.map[there].b) * 0.5);
        EXPECT_EQ(game.map.carried(game.map[back], game.map.carried(game.map[there], point)), point);
        EXPECT_EQ(game.map[back].behind, game.map[there].sector);
    });
}

TEST(WayBack, IsAWallForWhoNeverPassed) {
    for (const OneWayPair& pair : pairs_with_way_back()) {
        OneWayMap rooms(pair);
        rooms.place_beyond({2, 0}, 180);
        Game game(rooms.file());
        game.hold(kForward, 120);
        EXPECT_EQ(game.room(), "far");
        EXPECT_GE(rooms.local(game.map, game.player().place).x, kBodyRadius - 2 * kPointGrid);
    }
}

TEST(WayBack, OpensAgainEachTimeOnePasses) {
    in_each_pair_with_way_back([](Game& game) {
        for (int turn = 0; turn < 3; ++turn) {
            ASSERT_NO_FATAL_FAILURE(pass(game));
            EXPECT_TRUE(open_way(game));
            game.hold(kBack, 90);
            ASSERT_EQ(game.room(), "near");
            EXPECT_FALSE(open_way(game));
        }
    });
}

/// The far room's wall opposite the exit leads into a third room, by a door of its own or by plain neighbourhood.
MapFile with_third_room(bool is_link) {
    OneWayPair pair;
    pair.way_back = true;
    OneWayMap rooms(pair);
    rooms.place({-1.5, 0});
    MapFile file = rooms.file();
    const double x = is_link ? 300 : 200 + kDepth;
    file.sectors.push_back(box_room("third", x, 100 - kHalfSide, x + 4, 100 + kHalfSide, 0, 3));
    const Vec2 top{200 + kDepth, 100 - kHalfSide}, bottom{200 + kDepth, 100 + kHalfSide};
    if (is_link)
        link(file, "far", top, bottom, "third", {x, bottom.y}, {x, top.y});
    else
        join_all(file);
    return file;
}

TEST(WayBack, IsGoneWhenOneLeavesByAnotherDoor) {
    Game game(with_third_room(true));
    ASSERT_NO_FATAL_FAILURE(pass(game));
    EXPECT_TRUE(open_way(game));
    game.hold(kForward, 80);
    ASSERT_EQ(game.room(), "third");
    EXPECT_FALSE(open_way(game));
    game.hold(kBack, 150);
    EXPECT_EQ(game.room(), "far") << "it is a wall again";
}

TEST(WayBack, StaysWhereOneOnlyWalksIntoTheNextRoom) {
    Game game(with_third_room(false));
    ASSERT_NO_FATAL_FAILURE(pass(game));
    game.hold(kForward, 80);
    ASSERT_EQ(game.room(), "third");
    EXPECT_TRUE(open_way(game));
    game.hold(kBack, 180);
    EXPECT_EQ(game.room(), "near");
}

TEST(WayBack, IsGoneWhenOneIsCarriedOff) {
    MapFile file = with_third_room(true);
    ThingRecord& there = file.things.emplace_back();
    there.name = "there";
    there.position = {302, 100};
    sector(file, "far").triggers = {trigger_on(Activation::enter, TriggerAction::teleport, {"there"})};
    Game game(file);
    game.hold(kForward, 60);
    ASSERT_EQ(game.room(), "third");
    EXPECT_FALSE(open_way(game));
}

TEST(WayBack, IsSeenOnlyWhileItStandsOpen) {
    in_each_pair_with_way_back([](Game& game) {
        Snapshot snapshot = at_rest(game.map);
        const auto portals = [&] {
            show(now(game.map, game.world), snapshot);
            int count = 0;
            for (std::size_t i = 0; i < game.map.walls.size(); ++i)
                count += kind_now(game.map, snapshot, WallId(i)) == WallKind::portal;
            return count;
        };
        EXPECT_EQ(portals(), 1);
        ASSERT_NO_FATAL_FAILURE(pass(game));
        EXPECT_EQ(portals(), 2);
        game.hold(kBack, 90);
        EXPECT_EQ(portals(), 1);
    });
}

/// The room of the eye at fine steps of the time between the last two ticks; contained in each.
std::vector<std::string> rooms_of_eye(const Game& game) {
    std::vector<std::string> rooms;
    for (int step = 0; step <= 16; ++step) {
        const Eye eye = eye_between_ticks(game.map, game.world, step / 16.0);
        EXPECT_TRUE(contains(game.map, eye.place.sector, eye.place.point)) << step;
        const std::string& room = game.map[eye.place.sector].name;
        if (rooms.empty() || rooms.back() != room) rooms.push_back(room);
    }
    return rooms;
}

TEST(WayBack, CarriesTheEyeBetweenTwoTicks) {
    in_each_pair_with_way_back([](Game& game) {
        while (game.room() == "near") game.hold(kForward);
        EXPECT_EQ(rooms_of_eye(game), (std::vector<std::string>{"near", "far"}));
        EXPECT_TRUE(game.world.history.way_back(static_cast<double>(game.world.tick) - 0.5))
            << "who looks back while walking backwards sees the room at once";
        for (int i = 0; i < 90 && game.room() == "far"; ++i) game.hold(kBack);
        EXPECT_EQ(rooms_of_eye(game), (std::vector<std::string>{"far", "near"}));
    });
}

TEST(WayBack, IsRewoundWithEverythingElse) {
    in_each_pair_with_way_back([](Game& game) {
        Timeline timeline(game.world);
        std::vector<std::uint64_t> hashes{hash(timeline.world())};
        for (int i = 0; i < 200; ++i) {
            timeline.play(game.map, i < 60 ? kForward : kBack);
            hashes.push_back(hash(timeline.world()));
        }
        for (const std::size_t tick : {200u, 133u, 90u, 61u, 33u, 0u})
            EXPECT_EQ(hash(timeline.after(game.map, tick)), hashes[tick]) << tick;
    });
}

TEST(WayBack, LetsSoundThroughWhileItStandsOpen) {
    MapFile file = with_third_room(true);
    SoundRecord& hum = file.sounds.emplace_back();
    hum.name = "hum";
    hum.file = "hum.wav";
    ThingRecord& thing = file.things.emplace_back();
    thing.position = {-2, 1};
    thing.sound = "hum";
    Game game(file);
    Hearing hearing(game.map);
    const std::array lengths{1.0};
    const auto is_heard = [&] {
        const Listener ear{game.player().place, game.player().yaw};
        return !voices_at(now(game.map, game.world), hearing, ear, lengths).empty();
    };
    ASSERT_NO_FATAL_FAILURE(pass(game));
    EXPECT_TRUE(is_heard());
    game.hold(kForward, 80);
    ASSERT_EQ(game.room(), "third");
    game.hold(kBack, 150);
    ASSERT_EQ(game.room(), "far");
    EXPECT_FALSE(is_heard());
}

}  // namespace
}  // namespace enfilade
