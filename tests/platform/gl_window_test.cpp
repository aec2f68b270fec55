// The window that OpenGL shows pictures in, on SDL's offscreen driver. On a machine without OpenGL these tests fail.
#include <SDL.h>
#include <dlfcn.h>
#include <epoxy/gl.h>
#include <gtest/gtest.h>
#include <link.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "platform/window.h"

namespace enfilade {
namespace {

constexpr std::uint32_t kGlRed = 0xFF0000FF, kGlBlue = 0xFFFF0000, kGlGray = 0xFF404040;  // 0xAABBGGRR

/// Mesa's drivers lose memory each time they are unloaded, which LeakSanitizer tells of: once loaded, they stay.
void keep_drivers_loaded() {
    std::vector<std::string> drivers;
    const auto note = [](dl_phdr_info* library, std::size_t, void* list) {
        const std::string name = library->dlpi_name;
        if (name.find("/dri/") != name.npos) static_cast<std::vector<std::string>*>(list)->push_back(name);
        return 0;
    };
    dl_iterate_phdr(note, &drivers);
    for (const std::string& driver : drivers)
        static_cast<void>(dlopen(driver.c_str(), RTLD_LAZY | RTLD_NOLOAD | RTLD_NODELETE));
}

class GlWindow : public testing::Test {
protected:
    GlWindow() {
        setenv("SDL_VIDEODRIVER", "offscreen", 1);
        setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
        auto opened = open_window({"test", 320, 200, false, true});
        EXPECT_TRUE(opened.ok()) << opened.error().text();
        window_ = std::move(opened).value();
        keep_drivers_loaded();
    }
    ~GlWindow() override { unsetenv("SDL_VIDEODRIVER"); }

    static Frame filled(int width, int height, std::uint32_t color) {
        Frame frame;
        frame.resize(width, height);
        std::fill(frame.pixels.begin(), frame.pixels.end(), color);
        return frame;
    }

    /// What the window shows there, counted from its upper left corner; 0xAABBGGRR.
    std::uint32_t shown(int x, int y) {
        const auto context = window_->gl()().value();
        EXPECT_TRUE(context->make_current().ok());
        std::uint32_t pixel = 0;
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glReadPixels(x, 199 - y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &pixel);
        return pixel | 0xFF000000u;
    }

    std::unique_ptr<Window> window_;
};

TEST_F(GlWindow, ShowsAFrameTheRightWayUp) {
    ASSERT_TRUE(window_->is_shown_by_gpu());
    Frame frame = filled(320, 200, kGlBlue);
    std::fill_n(frame.pixels.begin(), 320 * 100, kGlRed);
    ASSERT_TRUE(window_->present(frame).ok());
    EXPECT_EQ(shown(160, 10), kGlRed);
    EXPECT_EQ(shown(160, 190), kGlBlue);
}

TEST_F(GlWindow, KeepsTheFramesProportionsBetweenBlackBars) {
    ASSERT_TRUE(window_->present(filled(100, 100, kGlRed)).ok());
    EXPECT_EQ(shown(10, 100), 0xFF000000u);
    EXPECT_EQ(shown(160, 100), kGlRed);
    EXPECT_EQ(shown(310, 100), 0xFF000000u);
}

/// A picture that is drawn by the window's own OpenGL: its upper half red, its lower half gray.
class PictureOnTheCard : public GlWindow {
protected:
    PictureOnTheCard() {
        const auto context = window_->gl()().value();
        EXPECT_TRUE(context->make_current().ok());
        unsigned buffer = 0;
        glGenFramebuffers(1, &picture_.framebuffer);
        glGenRenderbuffers(1, &buffer);
        glBindFramebuffer(GL_FRAMEBUFFER, picture_.framebuffer);
        glBindRenderbuffer(GL_RENDERBUFFER, buffer);
        glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, 320, 200);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, buffer);
        glClearColor(0.25f, 0.25f, 0.25f, 1);
        glClear(GL_COLOR_BUFFER_BIT);
        glEnable(GL_SCISSOR_TEST);
        glScissor(0, 0, 320, 100);  // row 0 of the picture is row 0 here
        glClearColor(1, 0, 0, 1);
        glClear(GL_COLOR_BUFFER_BIT);
        picture_.width = 320;
        picture_.height = 200;
    }
    GlPicture picture_;
};

TEST_F(PictureOnTheCard, IsShownTheRightWayUp) {
    ASSERT_TRUE(window_->present(picture_, filled(320, 200, 0), 1).ok());
    EXPECT_EQ(shown(160, 10), kGlRed);
    EXPECT_EQ(shown(160, 190), kGlGray);
}

TEST_F(PictureOnTheCard, IsCoveredByWhatLiesOverIt) {
    Frame over = filled(320, 200, 0);
    over.pixels[0] = kGlBlue;
    over.pixels[1] = 0x80800000;  // half blue
    ASSERT_TRUE(window_->present(picture_, over, 1).ok());
    EXPECT_EQ(shown(0, 0), kGlBlue);
    EXPECT_EQ(shown(1, 0), 0xFF80007Fu);
    EXPECT_EQ(shown(2, 0), kGlRed);
}

TEST_F(PictureOnTheCard, IsBrightenedAndWhatLiesOverItIsNot) {
    Frame over = filled(320, 200, 0);
    over.pixels[199 * 320] = kGlGray;
    ASSERT_TRUE(window_->present(picture_, over, 2).ok());
    EXPECT_EQ(shown(160, 190), 0xFF808080u) << "the root of a quarter";
    EXPECT_EQ(shown(0, 199), kGlGray);
}

TEST_F(GlWindow, CanBeMadeAnewForTheOtherWay) {
    ASSERT_TRUE(window_->show_by_gpu(false).ok());
    EXPECT_FALSE(window_->is_shown_by_gpu());
    EXPECT_TRUE(window_->present(filled(320, 200, kGlRed)).ok());
    EXPECT_EQ(window_->size(), (PixelSize{320, 200}));
    ASSERT_TRUE(window_->show_by_gpu(true).ok());
    ASSERT_TRUE(window_->present(filled(320, 200, kGlBlue)).ok());
    EXPECT_EQ(shown(160, 100), kGlBlue);
}

}  // namespace
}  // namespace enfilade
