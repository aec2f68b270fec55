// OpenGL contexts without a display. On a machine that has none these tests fail, and should.
#include "platform/gl_context.h"

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <thread>

namespace enfilade {
namespace {

class HeadlessGl : public testing::TestWithParam<GlApi> {
protected:
    void SetUp() override {
        setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
        auto opened = open_headless_gl(GetParam());
        ASSERT_TRUE(opened.ok()) << opened.error().text();
        context_ = std::move(opened).value();
    }
    std::unique_ptr<GlContext> context_;
};

TEST_P(HeadlessGl, IsOfTheApiThatWasAskedFor) {
    ASSERT_TRUE(context_->make_current().ok());
    EXPECT_EQ(epoxy_is_desktop_gl(), GetParam() == GlApi::desktop);
    context_->release();
}

TEST_P(HeadlessGl, IsNewEnough) {
    ASSERT_TRUE(context_->make_current().ok());
    EXPECT_GE(epoxy_gl_version(), GetParam() == GlApi::desktop ? 33 : 30);
    context_->release();
}

TEST_P(HeadlessGl, IsCurrentOnOneThreadAfterAnother) {
    Result<void> result = context_->make_current();
    context_->release();
    std::thread([&] {
        if (result.ok()) result = context_->make_current();
        context_->release();
    }).join();
    EXPECT_TRUE(result.ok()) << result.error().text();
}

TEST_P(HeadlessGl, OutlivesAnotherOne) {
    {
        const auto other = open_headless_gl(GetParam());
    }
    const Result<void> result = context_->make_current();
    EXPECT_TRUE(result.ok());
    context_->release();
}

INSTANTIATE_TEST_SUITE_P(Apis, HeadlessGl, testing::Values(GlApi::desktop, GlApi::es),
                         [](const auto& api) { return api.param == GlApi::desktop ? "OpenGL" : "OpenGLES"; });

}  // namespace
}  // namespace enfilade
