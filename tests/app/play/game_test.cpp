// A map that is being played.
#include "app/play/game.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "base/files.h"
#include "formats/map_toml.h"
#include "support/map_builder.h"
#include "support/temp_dir.h"
#include "world/replay.h"

namespace enfilade {
namespace {

class GameOnDisk : public ::testing::Test {
protected:
    GameOnDisk() {
        save(two_rooms());
        auto started = Game::start(path(), {});
        EXPECT_TRUE(started.ok()) << started.error().text();
        game_ = std::move(started).value();
    }

    static MapFile two_rooms() {
        MapFile file =
            test::map_of({test::box_room("left", 0, 0, 8, 4, 0, 3), test::box_room("right", 8, 0, 16, 4, 0, 3)});
        test::join_all(file);
        test::place_player(file, "left", {2, 2}, 1.55);
        return file;
    }

    std::string path() const { return dir_.path("map.toml"); }

    /// Saves the map with a time stamp of its own, however fast the test is.
    void save(const MapFile& file) { save_text(write_map(file)); }
    void save_text(const std::string& text) {
        ASSERT_FALSE(write_file(path(), std::string_view(text)));
        stamp_ += std::chrono::seconds(2);
        std::filesystem::last_write_time(path(), stamp_);
    }

    void walk(int ticks) {
        TickInput input;
        input.forward = 127;
        for (int i = 0; i < ticks; ++i) game_->tick(input);
    }

    testing::TempDir dir_;
    std::filesystem::file_time_type stamp_ = std::filesystem::file_time_type::clock::now();
    std::unique_ptr<Game> game_;
};

TEST_F(GameOnDisk, StartsAtThePlayersStart) {
    EXPECT_EQ(game_->player().place, (Place{SectorId(0u), {2, 2}}));
    EXPECT_EQ(game_->view(1, {}, 90).eye, (Vec2{2, 2}));
}

TEST_F(GameOnDisk, WalksThroughADoor) {
    walk(120);
    EXPECT_EQ(game_->player().place.sector, SectorId(1u));
}

TEST_F(GameOnDisk, TurnsTheHeadAheadOfTheTick) { EXPECT_EQ(game_->view(1, {1 << 30, 0}, 90).forward, (Vec2{0, 1})); }

TEST_F(GameOnDisk, LooksNoFurtherUpThanThePlayerCan) {
    const double limit = game_->view(1, {0, kMaxPitchSteps}, 90).pitch_tangent;
    EXPECT_EQ(game_->view(1, {0, 0x7000'0000}, 90).pitch_tangent, limit);
}

TEST_F(GameOnDisk, StandsAtTheStartAgainAfterARestart) {
    walk(60);
    game_->restart();
    EXPECT_EQ(game_->player().place, (Place{SectorId(0u), {2, 2}}));
}

TEST_F(GameOnDisk, RecordsAWalkThatCanBePlayedAgain) {
    game_->record();
    walk(100);
    const Tape tape = game_->tape();
    EXPECT_EQ(tape.ticks.size(), 100u);
    EXPECT_TRUE(replay(game_->map(), tape).ok());
}

TEST_F(GameOnDisk, BeginsTheRecordingAgainAfterARestart) {
    game_->record();
    walk(50);
    game_->restart();
    walk(10);
    EXPECT_EQ(game_->tape().ticks.size(), 10u);
    EXPECT_TRUE(replay(game_->map(), game_->tape()).ok());
}

TEST_F(GameOnDisk, SeesThatTheMapWasSaved) {
    EXPECT_FALSE(game_->map_changed());
    save(two_rooms());
    EXPECT_TRUE(game_->map_changed());
}

TEST_F(GameOnDisk, KeepsThePlayerWhereHeIsWhenTheMapIsLoadedAgain) {
    walk(120);
    const Player before = game_->player();
    MapFile higher = two_rooms();
    for (SectorRecord& sector : higher.sectors) sector.ceiling.z = 5;
    save(higher);
    ASSERT_FALSE(game_->reload());
    EXPECT_EQ(game_->player().place, before.place);
    EXPECT_EQ(game_->player().yaw, before.yaw);
    EXPECT_EQ(game_->map().sectors[0].ceiling.z, 5);
}

TEST_F(GameOnDisk, LiftsThePlayerOntoAFloorThatWasRaised) {
    MapFile raised = two_rooms();
    for (SectorRecord& sector : raised.sectors) sector.floor.z = 1;
    raised.player->eye_z = 2.55;
    save(raised);
    ASSERT_FALSE(game_->reload());
    EXPECT_EQ(game_->player().feet_z, 1);
}

TEST_F(GameOnDisk, PutsThePlayerAtTheStartWhereHisRoomIsGone) {
    walk(120);
    MapFile one = test::map_of({test::box_room("left", 0, 0, 8, 4, 0, 3)});
    test::place_player(one, "left", {2, 2}, 1.55);
    save(one);
    ASSERT_FALSE(game_->reload());
    EXPECT_EQ(game_->player().place, (Place{SectorId(0u), {2, 2}}));
}

TEST_F(GameOnDisk, KeepsTheMapBeforeWhereTheNewOneHasErrors) {
    save_text("format = 1\nnonsense = 3\n");
    const Status refused = game_->reload();
    ASSERT_TRUE(refused);
    EXPECT_NE(refused->text().find("map.toml:2:1: error:"), std::string::npos) << refused->text();
    EXPECT_EQ(game_->map().sectors.size(), 2u);
    EXPECT_FALSE(game_->map_changed());  // until it is saved again
}

TEST_F(GameOnDisk, EndsTheRecordingWhenTheMapIsLoadedAgain) {
    game_->record();
    save(two_rooms());
    ASSERT_FALSE(game_->reload());
    EXPECT_FALSE(game_->is_recording());
}

TEST(Game, RefusesAMapWithoutPlayer) {
    const testing::TempDir dir;
    const std::string text = write_map(test::map_of({test::box_room("main", 0, 0, 4, 4)}));
    ASSERT_FALSE(write_file(dir.path("map.toml"), std::string_view(text)));
    EXPECT_FALSE(Game::start(dir.path("map.toml"), {}).ok());
}

TEST(Game, RefusesAFileThatIsNotThere) { EXPECT_FALSE(Game::start("/no/such/map.toml", {}).ok()); }

TEST_F(GameOnDisk, ComesBackToWhereItWasSaved) {
    walk(30);
    const std::uint64_t saved = hash(game_->world());
    ASSERT_FALSE(game_->save(dir_.path("deep/in/a.save")));
    walk(60);
    ASSERT_FALSE(game_->load_saved(dir_.path("deep/in/a.save")));
    EXPECT_EQ(hash(game_->world()), saved);
}

TEST_F(GameOnDisk, RefusesAGameThatWasSavedInAnotherMap) {
    ASSERT_FALSE(game_->save(dir_.path("a.save")));
    MapFile wider = two_rooms();
    wider.sectors[0].light = 0.5;
    save(wider);
    ASSERT_FALSE(game_->reload());
    const Status refused = game_->load_saved(dir_.path("a.save"));
    ASSERT_TRUE(refused);
    EXPECT_NE(refused->text().find("before it was changed"), std::string::npos) << refused->text();
}

TEST_F(GameOnDisk, RefusesASavedGameThatIsCutShortAndGoesOn) {
    walk(10);
    ASSERT_FALSE(game_->save(dir_.path("a.save")));
    auto bytes = read_file(dir_.path("a.save"));
    ASSERT_TRUE(bytes.ok());
    Bytes cut = bytes.value();
    cut.resize(cut.size() / 2);
    ASSERT_FALSE(write_file(dir_.path("a.save"), std::span<const std::byte>(cut)));
    const std::uint64_t before = hash(game_->world());
    EXPECT_TRUE(game_->load_saved(dir_.path("a.save")));
    EXPECT_EQ(hash(game_->world()), before);
}

TEST_F(GameOnDisk, GoesBackInTime) {
    walk(20);
    const std::uint64_t then = hash(game_->world());
    walk(50);
    game_->rewind(50);
    EXPECT_EQ(hash(game_->world()), then);
    game_->rewind(1000);
    EXPECT_EQ(game_->world().tick, 0u);
}

TEST_F(GameOnDisk, EntersAnotherMapAndRefusesOneThatIsNotThere) {
    walk(20);
    const std::uint64_t before = hash(game_->world());
    EXPECT_TRUE(game_->enter(dir_.path("nowhere.toml")));
    EXPECT_EQ(hash(game_->world()), before);
    MapFile next = two_rooms();
    next.player->position = {3, 1};
    ASSERT_FALSE(write_file(dir_.path("next.toml"), std::string_view(write_map(next))));
    ASSERT_FALSE(game_->enter(dir_.path("next.toml")));
    EXPECT_EQ(game_->player().place.point, (Vec2{3, 1}));
    EXPECT_FALSE(game_->map_changed());
}

}  // namespace
}  // namespace enfilade
