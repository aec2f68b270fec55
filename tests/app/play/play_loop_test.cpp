// Playing on when a part of the program fails.
#include "app/play/play_loop.h"

#include <gmock/gmock.h>

#include "app/pictures.h"
#include "base/files.h"
#include "base/result.h"
#include "formats/map_toml.h"
#include "support/map_builder.h"
#include "support/temp_dir.h"

namespace enfilade {
namespace {

using ::testing::HasSubstr;

/// Shows nothing and lets somebody quit after some frames.
class BlindWindow : public Window {
public:
    explicit BlindWindow(int frames) : frames_(frames) {}
    void poll(std::vector<InputEvent>& events) override {
        if (shown_ >= frames_ || ++polled_ > frames_) events.emplace_back(QuitRequest{});
    }
    Result<void> present(const Frame&) override {
        ++shown_;
        return is_lost_ ? Result<void>(Error{"", "the display went away"}) : Result<void>();
    }
    PixelSize size() const override { return {16, 10}; }
    void grab_mouse(bool) override {}
    bool mouse_grabbed() const override { return false; }
    void set_title(const std::string&) override {}
    void set_fullscreen(bool) override {}
    bool fullscreen() const override { return false; }
    double refresh_hz() const override { return 1000; }

    int shown() const { return shown_; }
    int polled() const { return polled_; }
    void lose() { is_lost_ = true; }

private:
    int frames_, shown_ = 0, polled_ = 0;
    bool is_lost_ = false;
};

class BrokenRenderer : public Renderer {
public:
    Result<void> render(Frame&, FrameFacts*, const Snapshot&, const View&) override {
        ENFILADE_CHECK(1 == 2);
        return {};
    }
};

class Playing : public ::testing::Test {
protected:
    Playing() {
        MapFile file = test::map_of({test::box_room("room", 0, 0, 8, 4, 0, 3)});
        test::place_player(file, "room", {2, 2}, 1.55);
        EXPECT_TRUE(write_file(dir_.path("map.toml"), std::string_view(write_map(file))).ok());
        game_ = Game::start(dir_.path("map.toml"), {}).value();
        options_.save = dir_.path("a.save");
        options_.mute = true;
    }

    Result<void> play(BlindWindow& window) {
        Settings settings;
        settings.renderer = RendererKind::stencil;  // column is the other
        settings.vsync = false;
        store_.change_for_now(settings);
        return PlayLoop(*game_, window, store_, options_, std::make_unique<BrokenRenderer>()).run();
    }

    test::TempDir dir_;
    std::unique_ptr<Game> game_;
    PlayOptions options_;
    SettingsStore store_;
};

TEST_F(Playing, GoesOnByAnotherRendererWhereOneBreaksItsContract) {
    BlindWindow window(20);
    const Result<void> result = play(window);
    EXPECT_TRUE(result.ok()) << result.error().text();
    EXPECT_GE(window.shown(), 1);
    EXPECT_GT(window.polled(), 20);
}

TEST_F(Playing, ShowsWhatThePlayerShouldKnowAtTheBeginning) {
    class FirstPicture : public BlindWindow {
    public:
        using BlindWindow::BlindWindow;
        Result<void> present(const Frame& frame) override {
            if (shown() == 0) picture = hash_of(frame);
            return BlindWindow::present(frame);
        }
        PixelSize size() const override { return {320, 200}; }
        std::uint64_t picture = 0;
    } without(2), with(2);
    ASSERT_TRUE(play(without).ok());
    options_.note = "The map begins anew.";
    ASSERT_TRUE(play(with).ok());
    EXPECT_NE(with.picture, without.picture);
}

TEST_F(Playing, SavesTheGameWhereTheWindowFails) {
    options_.tape = dir_.path("walk.tape");
    BlindWindow window(1000);
    window.lose();
    const Result<void> result = play(window);
    ASSERT_FALSE(result.ok());
    EXPECT_THAT(result.error().text(), HasSubstr("the display went away; the game was saved"));
    EXPECT_TRUE(game_->load_saved(options_.save).ok());
    EXPECT_TRUE(read_tape(read_file(options_.tape).value()).ok());
}

TEST_F(Playing, EndsWithASentenceWhereWhatItShowsBreaks) {
    class BrokenWindow : public BlindWindow {
    public:
        using BlindWindow::BlindWindow;
        Result<void> present(const Frame&) override {
            ENFILADE_CHECK(shown() == 1);
            return {};
        }
    } window(1000);
    const Result<void> result = play(window);
    ASSERT_FALSE(result.ok());
    EXPECT_THAT(result.error().text(), HasSubstr("a fault in this program, please report it: "));
    EXPECT_THAT(result.error().text(), HasSubstr("shown() == 1; the game was saved"));
    EXPECT_TRUE(game_->load_saved(options_.save).ok());
}

}  // namespace
}  // namespace enfilade
