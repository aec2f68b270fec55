// Playing on when a part of the program fails.
#include "app/play/play_loop.h"

#include <gmock/gmock.h>

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
    Status present(const Frame&) override {
        ++shown_;
        return is_lost_ ? Status(Error{"", "the display went away"}) : Status();
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
    Status render(Frame&, FrameFacts*, const Snapshot&, const View&) override {
        ENFILADE_CHECK(1 == 2);
        return {};
    }
};

class Playing : public ::testing::Test {
protected:
    Playing() {
        MapFile file = test::map_of({test::box_room("room", 0, 0, 8, 4, 0, 3)});
        test::place_player(file, "room", {2, 2}, 1.55);
        EXPECT_FALSE(write_file(dir_.path("map.toml"), std::string_view(write_map(file))));
        game_ = Game::start(dir_.path("map.toml"), {}).value();
        options_.save = dir_.path("a.save");
        options_.mute = true;
    }

    Status play(BlindWindow& window) {
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
    const Status failed = play(window);
    EXPECT_FALSE(failed) << failed->text();
    EXPECT_GE(window.shown(), 1);
    EXPECT_GT(window.polled(), 20);
}

TEST_F(Playing, SavesTheGameWhereTheWindowFails) {
    options_.tape = dir_.path("walk.tape");
    BlindWindow window(1000);
    window.lose();
    const Status failed = play(window);
    ASSERT_TRUE(failed);
    EXPECT_THAT(failed->text(), HasSubstr("the display went away; the game was saved"));
    EXPECT_FALSE(game_->load_saved(options_.save));
    EXPECT_TRUE(read_tape(read_file(options_.tape).value()).ok());
}

TEST_F(Playing, EndsWithASentenceWhereWhatItShowsBreaks) {
    class BrokenWindow : public BlindWindow {
    public:
        using BlindWindow::BlindWindow;
        Status present(const Frame&) override {
            ENFILADE_CHECK(shown() == 1);
            return {};
        }
    } window(1000);
    const Status failed = play(window);
    ASSERT_TRUE(failed);
    EXPECT_THAT(failed->text(), HasSubstr("a fault in this program, please report it: "));
    EXPECT_THAT(failed->text(), HasSubstr("shown() == 1; the game was saved"));
    EXPECT_FALSE(game_->load_saved(options_.save));
}

}  // namespace
}  // namespace enfilade
