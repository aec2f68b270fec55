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
        ASSERT_TRUE(write_file(path(), std::string_view(text)).ok());
        stamp_ += std::chrono::seconds(2);
        std::filesystem::last_write_time(path(), stamp_);
    }

    void walk(int ticks) {
        TickInput input;
        input.forward = 127;
        for (int i = 0; i < ticks; ++i) game_->tick(input);
    }

    std::string tape_path() const { return dir_.path("walk.tape"); }
    Tape recorded() const { return read_tape(read_file(tape_path()).value()).value(); }

    test::TempDir dir_;
    std::filesystem::file_time_type stamp_ = std::filesystem::file_time_type::clock::now();
    std::unique_ptr<Game> game_;
};

TEST_F(GameOnDisk, StartsAtThePlayersStart) {
    EXPECT_EQ(game_->player().place, (Place{SectorId(0u), {2, 2}}));
    EXPECT_EQ(game_->view(1, {}, {}).eye, (Vec2{2, 2}));
}

TEST_F(GameOnDisk, WalksThroughADoor) {
    walk(120);
    EXPECT_EQ(game_->player().place.sector, SectorId(1u));
}

TEST_F(GameOnDisk, TurnsTheHeadAheadOfTheTick) { EXPECT_EQ(game_->view(1, {1 << 30, 0}, {}).forward, (Vec2{0, 1})); }

TEST_F(GameOnDisk, LooksNoFurtherUpThanThePlayerCan) {
    const double limit = game_->view(1, {0, kMaxPitchSteps}, {}).pitch_tangent;
    EXPECT_EQ(game_->view(1, {0, 0x7000'0000}, {}).pitch_tangent, limit);
}

TEST_F(GameOnDisk, StandsAtTheStartAgainAfterARestart) {
    walk(60);
    game_->restart();
    EXPECT_EQ(game_->player().place, (Place{SectorId(0u), {2, 2}}));
}

TEST_F(GameOnDisk, RecordsAWalkThatCanBePlayedAgain) {
    ASSERT_TRUE(game_->record(tape_path()).ok());
    walk(100);
    game_->end_recording();
    EXPECT_EQ(recorded(), game_->tape());
    EXPECT_EQ(recorded().ticks.size(), 100u);
    EXPECT_TRUE(replay(game_->map(), recorded()).ok());
}

TEST_F(GameOnDisk, HasEveryTickOnTheTapeAtOnce) {
    ASSERT_TRUE(game_->record(tape_path()).ok());
    for (std::size_t ticks = 0; ticks < 20; ++ticks) {
        EXPECT_EQ(recorded().ticks.size(), ticks);
        EXPECT_FALSE(recorded().final_hash);
        EXPECT_TRUE(replay(game_->map(), recorded()).ok());
        walk(1);
    }
}

TEST_F(GameOnDisk, BeginsTheRecordingAgainAfterARestart) {
    ASSERT_TRUE(game_->record(tape_path()).ok());
    walk(50);
    game_->restart();
    walk(10);
    game_->end_recording();
    EXPECT_EQ(recorded(), game_->tape());
    EXPECT_EQ(recorded().ticks.size(), 10u);
}

TEST_F(GameOnDisk, ForgetsOnTheTapeWhatWasRewound) {
    ASSERT_TRUE(game_->record(tape_path()).ok());
    walk(50);
    game_->rewind(30);
    TickInput back;
    back.forward = -127;
    for (int i = 0; i < 5; ++i) game_->tick(back);
    game_->end_recording();
    EXPECT_EQ(recorded(), game_->tape());
    EXPECT_EQ(recorded().ticks.size(), 25u);
}

TEST_F(GameOnDisk, EndsTheRecordingOnceWhereItCannotBeWritten) {
    std::filesystem::create_symlink("/dev/full", tape_path());
    EXPECT_FALSE(game_->record(tape_path()).ok());
    EXPECT_FALSE(game_->is_recording());
    walk(10);
    EXPECT_FALSE(game_->take_recording_fault());
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
    ASSERT_TRUE(game_->reload().ok());
    EXPECT_EQ(game_->player().place, before.place);
    EXPECT_EQ(game_->player().yaw, before.yaw);
    EXPECT_EQ(game_->map().sectors[0].ceiling.z, 5);
}

TEST_F(GameOnDisk, LiftsThePlayerOntoAFloorThatWasRaised) {
    MapFile raised = two_rooms();
    for (SectorRecord& sector : raised.sectors) sector.floor.z = 1;
    raised.player->eye_z = 2.55;
    save(raised);
    ASSERT_TRUE(game_->reload().ok());
    EXPECT_EQ(game_->player().feet_z, 1);
}

TEST_F(GameOnDisk, PutsThePlayerAtTheStartWhereHisRoomIsGone) {
    walk(120);
    MapFile one = test::map_of({test::box_room("left", 0, 0, 8, 4, 0, 3)});
    test::place_player(one, "left", {2, 2}, 1.55);
    save(one);
    ASSERT_TRUE(game_->reload().ok());
    EXPECT_EQ(game_->player().place, (Place{SectorId(0u), {2, 2}}));
}

TEST_F(GameOnDisk, KeepsTheMapBeforeWhereTheNewOneHasErrors) {
    save_text("format = 1\nnonsense = 3\n");
    const Result<void> result = game_->reload();
    ASSERT_FALSE(result.ok());
    EXPECT_NE(result.error().text().find("map.toml:2:1: error:"), std::string::npos) << result.error().text();
    EXPECT_EQ(game_->map().sectors.size(), 2u);
    EXPECT_FALSE(game_->map_changed());  // until it is saved again
}

TEST_F(GameOnDisk, TellsWhatIsWrongWithAMapThatCanBePlayedAllTheSame) {
    MapFile file = two_rooms();
    file.sectors[0].floor.texture = test::spec("nowhere_to_be_found");
    save(file);
    ASSERT_TRUE(game_->reload().ok());
    ASSERT_FALSE(game_->warnings().empty());
    EXPECT_NE(game_->warnings()[0].find("'nowhere_to_be_found' is in none of the texture folders"), std::string::npos)
        << game_->warnings()[0];
}

TEST_F(GameOnDisk, KeepsTheMapBeforeWhereAQuoteIsForgottenBeforeAnAccent) {
    save_text("format = 1'é'\n");
    const Result<void> result = game_->reload();
    ASSERT_FALSE(result.ok());
    EXPECT_NE(result.error().text().find("map.toml:1:11: error: "), std::string::npos) << result.error().text();
    EXPECT_EQ(game_->map().sectors.size(), 2u);
}

TEST_F(GameOnDisk, EndsTheRecordingWhenTheMapIsLoadedAgain) {
    ASSERT_TRUE(game_->record(tape_path()).ok());
    walk(10);
    save(two_rooms());
    ASSERT_TRUE(game_->reload().ok());
    EXPECT_FALSE(game_->is_recording());
    EXPECT_EQ(recorded().ticks.size(), 10u);
    EXPECT_TRUE(recorded().final_hash);
}

TEST(Game, RefusesAMapWithoutPlayer) {
    const test::TempDir dir;
    const std::string text = write_map(test::map_of({test::box_room("main", 0, 0, 4, 4)}));
    ASSERT_TRUE(write_file(dir.path("map.toml"), std::string_view(text)).ok());
    EXPECT_FALSE(Game::start(dir.path("map.toml"), {}).ok());
}

TEST(Game, RefusesAFileThatIsNotThere) { EXPECT_FALSE(Game::start("/no/such/map.toml", {}).ok()); }

TEST_F(GameOnDisk, ComesBackToWhereItWasSaved) {
    walk(30);
    const std::uint64_t saved = hash(game_->world());
    ASSERT_TRUE(game_->save(dir_.path("deep/in/a.save")).ok());
    walk(60);
    ASSERT_TRUE(game_->load_saved(dir_.path("deep/in/a.save")).ok());
    EXPECT_EQ(hash(game_->world()), saved);
}

TEST_F(GameOnDisk, RefusesAGameThatWasSavedInAnotherMap) {
    ASSERT_TRUE(game_->save(dir_.path("a.save")).ok());
    MapFile wider = two_rooms();
    wider.sectors[0].light = 0.5;
    save(wider);
    ASSERT_TRUE(game_->reload().ok());
    const Result<void> result = game_->load_saved(dir_.path("a.save"));
    ASSERT_FALSE(result.ok());
    EXPECT_NE(result.error().text().find("before it was changed"), std::string::npos) << result.error().text();
}

TEST_F(GameOnDisk, RefusesASavedGameThatIsDamagedAndGoesOn) {
    walk(10);
    ASSERT_TRUE(game_->save(dir_.path("a.save")).ok());
    Bytes cut = read_file(dir_.path("a.save")).value();
    cut.resize(20);
    ASSERT_TRUE(write_file(dir_.path("a.save"), std::span<const std::byte>(cut)).ok());
    const std::uint64_t before = hash(game_->world());
    EXPECT_FALSE(game_->load_saved(dir_.path("a.save")).ok());
    EXPECT_EQ(hash(game_->world()), before);
}

TEST_F(GameOnDisk, GoesOnWhereARecordingWasStopped) {
    ASSERT_TRUE(game_->record(tape_path()).ok());
    walk(30);
    const std::uint64_t then = hash(game_->world());
    std::filesystem::copy(tape_path(), dir_.path("stopped.tape"));
    walk(30);
    ASSERT_TRUE(game_->load_saved(dir_.path("stopped.tape")).ok());
    EXPECT_EQ(hash(game_->world()), then);
    EXPECT_FALSE(game_->is_recording());
}

TEST_F(GameOnDisk, KeepsTheLastThreeGamesThatWereSaved) {
    std::vector<std::uint64_t> saved;
    for (int i = 0; i < 5; ++i) {
        walk(10);
        ASSERT_TRUE(game_->save(dir_.path("a.save")).ok());
        saved.push_back(hash(game_->world()));
    }
    for (const auto& [name, hash_then] :
         {std::pair("a.save", saved[4]), {"a.save.1", saved[3]}, {"a.save.2", saved[2]}}) {
        ASSERT_TRUE(game_->load_saved(dir_.path(name)).ok()) << name;
        EXPECT_EQ(hash(game_->world()), hash_then) << name;
    }
    EXPECT_FALSE(std::filesystem::exists(dir_.path("a.save.3")));
}

TEST_F(GameOnDisk, SaysThatThereIsNoPlaceToSaveIn) {
    for (const Result<void>& result : {game_->save(""), game_->load_saved("")}) {
        ASSERT_FALSE(result.ok());
        EXPECT_NE(result.error().text().find("there is no home folder to save games in"), std::string::npos);
    }
}

TEST_F(GameOnDisk, NeverReplacesAGameByOneThatCannotBeLoaded) {
    walk(10);
    ASSERT_TRUE(game_->save(dir_.path("a.save")).ok());
    const std::uint64_t saved = hash(game_->world());
    save_text("format = 1\nnonsense = 3\n");
    ASSERT_FALSE(game_->reload().ok());
    walk(10);
    const Result<void> result = game_->save(dir_.path("a.save"));
    ASSERT_FALSE(result.ok());
    EXPECT_NE(result.error().text().find("no longer the map that is played"), std::string::npos)
        << result.error().text();
    save(two_rooms());
    ASSERT_TRUE(game_->load_saved(dir_.path("a.save")).ok());
    EXPECT_EQ(hash(game_->world()), saved);
    ASSERT_TRUE(game_->save(dir_.path("a.save")).ok());
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

TEST_F(GameOnDisk, TicksAtTheRateThatWasAskedForOrAtThatOfASavedGame) {
    const std::unique_ptr<Game> doom = Game::start(path(), {}, kUsualSkill, TickRate::hz35).value();
    TickInput input;
    input.forward = 127;
    for (int i = 0; i < 50; ++i) doom->tick(input);
    EXPECT_EQ(doom->tape().rate, 35u);
    ASSERT_TRUE(doom->save(dir_.path("saved")).ok());
    walk(10);
    ASSERT_TRUE(game_->load_saved(dir_.path("saved")).ok());
    EXPECT_EQ(game_->tick_rate(), TickRate::hz35);
    EXPECT_EQ(hash(game_->world()), hash(doom->world()));
    game_->rewind(20);
    EXPECT_EQ(game_->tick_rate(), TickRate::hz35);
    ASSERT_TRUE(game_->record(tape_path()).ok());
    game_->restart();
    walk(5);
    game_->end_recording();
    EXPECT_EQ(game_->tick_rate(), TickRate::hz35) << "a tape that is recorded has one rate";
    EXPECT_TRUE(replay(game_->map(), recorded()).ok());
}

TEST_F(GameOnDisk, FindsRoomsAsItWasAskedToOrAsInASavedGame) {
    const MotionDials naive{TickRate::hz140, CrossingMethod::naive};
    const std::unique_ptr<Game> build = Game::start(path(), {}, kUsualSkill, naive).value();
    build->tick({.forward = 127});
    EXPECT_TRUE(build->tape().is_naive);
    ASSERT_TRUE(build->save(dir_.path("saved")).ok());
    ASSERT_TRUE(game_->load_saved(dir_.path("saved")).ok());
    game_->restart();
    EXPECT_EQ(game_->world().history.motion(), naive);
}

TEST_F(GameOnDisk, EntersAnotherMapAndRefusesOneThatIsNotThere) {
    walk(20);
    const std::uint64_t before = hash(game_->world());
    EXPECT_FALSE(game_->enter(dir_.path("nowhere.toml")).ok());
    EXPECT_EQ(hash(game_->world()), before);
    MapFile next = two_rooms();
    next.player->position = {3, 1};
    ASSERT_TRUE(write_file(dir_.path("next.toml"), std::string_view(write_map(next))).ok());
    ASSERT_TRUE(game_->enter(dir_.path("next.toml")).ok());
    EXPECT_EQ(game_->player().place.point, (Vec2{3, 1}));
    EXPECT_FALSE(game_->map_changed());
}

TEST_F(GameOnDisk, KnowsWhereItsWallsAreWrittenAsLongAsTheFileIsTheSame) {
    EXPECT_EQ(game_->places().walls.size(), game_->map().walls.size());
    const std::unique_ptr<Game> other = Game::start(path(), {}).value();
    save_text("# changed\n" + write_map(two_rooms()));
    EXPECT_TRUE(other->places().walls.empty());
    EXPECT_TRUE(other->reload().ok());
    EXPECT_EQ(other->places().walls.size(), other->map().walls.size());
}

}  // namespace
}  // namespace enfilade
