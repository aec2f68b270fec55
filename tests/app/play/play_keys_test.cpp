// What keys and wheel do while one plays: pressed at a real window, seen in its pictures.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <thread>

#include "app/play/driven_window.h"
#include "app/play/play_loop.h"
#include "base/files.h"
#include "formats/map_toml.h"
#include "support/map_builder.h"
#include "support/temp_dir.h"

namespace enfilade {
namespace {

/// On purpose, so that nothing is to be said about them.
void have_no_pictures(MapFile& file) {
    for (SectorRecord& sector : file.sectors) {
        sector.floor.texture = sector.ceiling.texture = test::spec("-");
        for (LoopRecord& loop : sector.loops)
            for (WallRecord& wall : loop.walls) wall.texture = test::spec("-");
    }
}

class KeysOfPlay : public ::testing::Test {
protected:
    KeysOfPlay() {
        MapFile file = test::map_of({test::box_room("room", 0, 0, 8, 4, 0, 3)});
        have_no_pictures(file);
        test::place_player(file, "room", {2, 2}, 1.55);
        EXPECT_TRUE(write_file(dir_.path("map.toml"), std::string_view(write_map(file))).ok());
        game_ = Game::start(dir_.path("map.toml"), {}).value();
        options_.save = dir_.path("a.save");
        options_.mute = true;
        Settings settings;
        settings.size = PictureSize{320, 200};
        settings.vsync = false;
        store_.change_for_now(settings);
    }

    void play_until(int pictures) {
        window_.quit_after(pictures);
        auto renderer = make_renderer({}, game_->map(), game_->textures());
        PlayLoop loop(*game_, window_, store_, options_, std::move(renderer).value());
        const Result<void> result = loop.run();
        EXPECT_TRUE(result.ok()) << result.error().text();
    }

    /// In a page of the menu that was just opened.
    void choose_after(int pictures, int row) {
        for (int i = 0; i < row; ++i) window_.press_after(pictures, SDL_SCANCODE_DOWN);
        window_.press_after(pictures, SDL_SCANCODE_RETURN);
    }

    /// Pixels of the n-th picture that lie below the notices and left of the inset.
    std::vector<std::uint32_t> own_view(int number) const {
        const Frame& frame = window_.picture(number);
        std::vector<std::uint32_t> pixels;
        for (int y = 100; y < 200; ++y)
            pixels.insert(pixels.end(), frame.pixels.begin() + y * 320, frame.pixels.begin() + (y + 1) * 320);
        return pixels;
    }
    static std::uint32_t at(const Frame& frame, int x, int y) { return frame.pixels[std::size_t(y * frame.width + x)]; }

    test::TempDir dir_;
    std::unique_ptr<Game> game_;
    PlayOptions options_;
    SettingsStore store_;
    test::DrivenWindow window_;
};

/// The room, with a wall where there was none, and another room behind it.
MapFile changed_map() {
    MapFile file = test::map_of({test::box_room("room", 0, 0, 5, 4, 0, 3), test::box_room("far", 5, 0, 9, 4, 1, 2)});
    test::join_all(file);
    have_no_pictures(file);
    test::place_player(file, "room", {2, 2}, 1.55);
    return file;
}

TEST_F(KeysOfPlay, LookIntoTheMapAsItIsNowWhereItsFileWasChanged) {
    constexpr auto kUntilItIsLookedAt = std::chrono::milliseconds(300);
    window_.press_after(2, SDL_SCANCODE_F4);
    window_.after(5, [&] {
        EXPECT_TRUE(write_file(dir_.path("map.toml"), std::string_view(write_map(changed_map()))).ok());
        std::this_thread::sleep_for(kUntilItIsLookedAt);
    });
    play_until(12);
    EXPECT_EQ(game_->map().sectors.size(), 2u);
    const auto part = [&](int number, int y, int begin, int end) {
        const Frame& frame = window_.picture(number);
        return std::vector(frame.pixels.begin() + y * 320 + begin, frame.pixels.begin() + y * 320 + end);
    };
    EXPECT_NE(part(11, 120, 0, 180), part(4, 120, 0, 180)) << "the player's view";
    EXPECT_NE(part(11, 135, 200, 300), part(4, 135, 200, 300)) << "the view from outside";
}

constexpr std::uint32_t kRim = 0xFFE0E0E0;  ///< of the inset

TEST_F(KeysOfPlay, AreListedByF1AlsoOverTheMenuAndTakenAway) {
    window_.press_after(5, SDL_SCANCODE_F1);
    window_.press_after(10, SDL_SCANCODE_F1);
    window_.press_after(15, SDL_SCANCODE_ESCAPE);
    window_.press_after(20, SDL_SCANCODE_F1);
    play_until(25);
    EXPECT_NE(own_view(9), own_view(4));
    EXPECT_EQ(own_view(14), own_view(4));
    EXPECT_NE(own_view(19), own_view(24));
}

TEST_F(KeysOfPlay, ShowTheViewFromOutsideInACornerThenInFullThenNot) {
    window_.press_after(5, SDL_SCANCODE_F4);
    window_.press_after(10, SDL_SCANCODE_F4);
    window_.press_after(15, SDL_SCANCODE_F4);
    play_until(20);
    EXPECT_EQ(at(window_.picture(9), 192, 79), kRim);
    EXPECT_EQ(own_view(9), own_view(4));
    EXPECT_EQ(at(window_.picture(14), 192, 79), kRim);
    EXPECT_NE(own_view(14), own_view(4));
    EXPECT_NE(at(window_.picture(19), 192, 79), kRim);
    EXPECT_EQ(own_view(19), own_view(4));
}

TEST_F(KeysOfPlay, LookAtThePlayerFromBehindAndFromNearer) {
    window_.press_after(4, SDL_SCANCODE_F4);
    window_.press_after(4, SDL_SCANCODE_F4);
    window_.press_after(10, SDL_SCANCODE_F6);
    window_.after(15, [&] { window_.wheel(1); });
    window_.press_after(20, SDL_SCANCODE_MINUS);
    play_until(25);
    EXPECT_NE(own_view(14), own_view(9));
    EXPECT_NE(own_view(19), own_view(14));
    EXPECT_EQ(own_view(24), own_view(14));
}

TEST_F(KeysOfPlay, TellWhatOneLooksAt) {
    window_.press_after(5, SDL_SCANCODE_F7);
    window_.press_after(10, SDL_SCANCODE_F7);
    play_until(15);
    EXPECT_NE(own_view(9), own_view(4));
    EXPECT_EQ(own_view(14), own_view(4));
}

TEST_F(KeysOfPlay, ChangeTheFieldOfViewWithControlAndTheWheel) {
    window_.after(5, [&] { window_.key(SDL_SCANCODE_LCTRL, true), window_.wheel(1), window_.wheel(1); });
    window_.after(5, [&] { window_.key(SDL_SCANCODE_LCTRL, false); });
    window_.after(10, [&] { window_.wheel(-1), window_.wheel(-1); });
    window_.after(40, [&] { window_.key(SDL_SCANCODE_RCTRL, true), window_.wheel(-1), window_.wheel(-1); });
    window_.after(40, [&] { window_.key(SDL_SCANCODE_RCTRL, false); });
    play_until(120);
    EXPECT_NE(own_view(39), own_view(4));
    EXPECT_EQ(own_view(119), own_view(4)) << "the wheel alone is another thing";
}

TEST_F(KeysOfPlay, OpenTheMenuWhereTheFocusIsLost) {
    window_.after(5, [&] { window_.lose_focus(); });
    window_.press_after(10, SDL_SCANCODE_ESCAPE);
    play_until(15);
    EXPECT_NE(own_view(9), own_view(4));
    EXPECT_EQ(own_view(14), own_view(4));
}

TEST_F(KeysOfPlay, LetTheGameStandStillWithoutTheFocusUnlessThePlayerWishesOtherwise) {
    std::uint64_t lost = 0, later = 0, lost_again = 0, at_last = 0;
    window_.after(5, [&] { window_.lose_focus(); });
    window_.after(6, [&] { lost = game_->world().tick; });
    window_.after(60, [&] { later = game_->world().tick; });
    choose_after(60, 5);                       // Options
    window_.press_after(60, SDL_SCANCODE_UP);  // its last row
    window_.press_after(60, SDL_SCANCODE_RIGHT);
    window_.press_after(60, SDL_SCANCODE_ESCAPE);
    window_.press_after(60, SDL_SCANCODE_ESCAPE);
    window_.after(70, [&] { window_.lose_focus(), lost_again = game_->world().tick; });
    window_.after(140, [&] { at_last = game_->world().tick; });
    play_until(141);
    EXPECT_EQ(later, lost);
    EXPECT_GT(at_last, lost_again + 1);
}

TEST_F(KeysOfPlay, StopGoingBackInTimeWhereTheMenuOpens) {
    std::uint64_t before = 0, after = 0;
    window_.after(60, [&] { window_.key(SDL_SCANCODE_R, true); });
    window_.press_after(61, SDL_SCANCODE_ESCAPE);
    window_.after(62, [&] { window_.key(SDL_SCANCODE_R, false); });
    window_.press_after(63, SDL_SCANCODE_ESCAPE);
    window_.after(70, [&] { before = game_->world().tick; });
    window_.after(140, [&] { after = game_->world().tick; });
    play_until(141);
    EXPECT_GT(after, before);
}

TEST_F(KeysOfPlay, FlyAwayFromTheBodyAndComeBackToIt) {
    options_.tape = dir_.path("walk.tape");
    const Place body = game_->player().place;
    window_.press_after(5, SDL_SCANCODE_F8);
    window_.after(6, [&] { window_.key(SDL_SCANCODE_W, true); });
    window_.after(100, [&] { window_.key(SDL_SCANCODE_W, false); });
    window_.press_after(110, SDL_SCANCODE_F8);
    play_until(115);
    EXPECT_NE(own_view(109), own_view(4));
    EXPECT_EQ(own_view(114), own_view(4));
    EXPECT_EQ(game_->player().place, body);
    const Tape tape = read_tape(read_file(options_.tape).value()).value();
    EXPECT_GT(tape.ticks.size(), 3u) << "the world goes on";
    for (const InputRecord& tick : tape.ticks) EXPECT_EQ(tick, InputRecord{});
}

TEST_F(KeysOfPlay, EndTheFlightWhereTheGameBeginsAgain) {
    window_.press_after(5, SDL_SCANCODE_F8);
    window_.after(6, [&] { window_.key(SDL_SCANCODE_W, true); });
    window_.after(60, [&] { window_.key(SDL_SCANCODE_W, false); });
    window_.press_after(61, SDL_SCANCODE_ESCAPE);
    choose_after(62, 3);  // Restart map
    play_until(70);
    EXPECT_EQ(own_view(69), own_view(4));
}

TEST_F(KeysOfPlay, ShowNoPictureTwice) {
    int before = 0, after = 0;
    window_.after(100, [&] { before = window_.shown(); });
    window_.after(200, [&] { after = window_.shown(); });
    play_until(201);
    EXPECT_EQ(after, before);
    EXPECT_GT(before, 0);
}

TEST_F(KeysOfPlay, ShowEveryStepOfOneWhoWalks) {
    int before = 0, after = 0;
    window_.after(99, [&] { window_.key(SDL_SCANCODE_W, true); });
    window_.after(100, [&] { before = window_.shown(); });
    window_.after(160, [&] { after = window_.shown(); });
    play_until(161);
    EXPECT_GT(after, before + 40);
}

TEST_F(KeysOfPlay, ShowTheMenuOnceAndThenAtEveryKey) {
    int before = 0, unchanged = 0, moved = 0;
    window_.press_after(20, SDL_SCANCODE_ESCAPE);
    window_.after(25, [&] { before = window_.shown(); });
    window_.after(40, [&] { unchanged = window_.shown(); });
    window_.press_after(40, SDL_SCANCODE_DOWN);
    window_.after(45, [&] { moved = window_.shown(); });
    play_until(46);
    EXPECT_EQ(unchanged, before);
    EXPECT_EQ(moved, before + 1);
}

TEST_F(KeysOfPlay, AreThoseOfTheSettings) {
    Settings settings = store_.now();
    bind(settings.bindings, Control::outside, KeyCode::k);
    store_.change_for_now(settings);
    window_.press_after(5, SDL_SCANCODE_K);
    play_until(10);
    EXPECT_EQ(at(window_.picture(9), 192, 79), kRim);
}

TEST_F(KeysOfPlay, SaveASettingThatTheMenuChanged) {
    store_ = SettingsStore(dir_.path("settings.toml"));
    window_.press_after(5, SDL_SCANCODE_ESCAPE);
    choose_after(6, 5);  // Options
    const auto row = &setting_named("scale") - all_settings().data();
    for (auto i = row; i > 0; --i) window_.press_after(6, SDL_SCANCODE_DOWN);
    window_.press_after(6, SDL_SCANCODE_RIGHT);
    window_.press_after(7, SDL_SCANCODE_ESCAPE);
    window_.press_after(7, SDL_SCANCODE_ESCAPE);
    play_until(10);
    EXPECT_EQ(SettingsStore(dir_.path("settings.toml")).now().scale, 2);
    EXPECT_EQ(window_.picture(9).width, 160) << "half of the window";
}

TEST_F(KeysOfPlay, GiveTheRendererBackThatWasThereBeforeTruePitch) {
    window_.press_after(5, SDL_SCANCODE_ESCAPE);
    choose_after(6, 5);  // Options
    const auto row = &setting_named("true_pitch") - all_settings().data();
    for (auto i = row; i > 0; --i) window_.press_after(6, SDL_SCANCODE_DOWN);
    window_.press_after(6, SDL_SCANCODE_RIGHT);
    RendererKind with = RendererKind::column;
    window_.after(8, [&] { with = store_.now().renderer; });
    window_.press_after(9, SDL_SCANCODE_LEFT);
    play_until(12);
    EXPECT_EQ(with, RendererKind::stencil);
    EXPECT_FALSE(store_.now().true_pitch);
    EXPECT_EQ(store_.now().renderer, RendererKind::column);
}

TEST_F(KeysOfPlay, ShowWhatADialDoes) {
    const auto play_on = [&](int pictures) {
        window_.quit_after(pictures);
        EXPECT_TRUE(PlayLoop(*game_, window_, store_, options_).run().ok());
    };
    play_on(5);
    options_.dials = {"samples=2", "portals=plane24"};  // the column renderer has one of them
    play_on(10);
    EXPECT_NE(own_view(9), own_view(4));
}

TEST_F(KeysOfPlay, BrightenThePicture) {
    Settings settings = store_.now();
    window_.after(10, [&] {
        settings.brightness = 2;
        store_.change_for_now(settings);
        window_.press_after(11, SDL_SCANCODE_F15);  // any event
    });
    play_until(20);
    const std::uint32_t before = own_view(9)[0] & 255, after = own_view(19)[0] & 255;
    EXPECT_EQ(after, std::uint32_t(std::lround(255 * std::sqrt(before / 255.0))));
}

}  // namespace
}  // namespace enfilade
