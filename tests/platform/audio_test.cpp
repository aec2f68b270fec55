// The sound device, as far as a machine without one has it.
#include "platform/audio.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <thread>

#include "base/files.h"
#include "support/temp_dir.h"

namespace enfilade {
namespace {

/// SDL is told by the environment which driver to take.
struct Driver {
    explicit Driver(const char* name) { setenv("SDL_AUDIODRIVER", name, 1); }
    ~Driver() { unsetenv("SDL_AUDIODRIVER"); }
};

TEST(Audio, OpensWhereADriverIs) {
    const Driver driver("dummy");
    const auto audio = open_audio({});
    EXPECT_TRUE(audio.ok()) << audio.error().text();
}

TEST(Audio, SaysThatThereIsNoDevice) {
    const Driver driver("no_such_driver");
    const auto audio = open_audio({});
    ASSERT_FALSE(audio.ok());
    EXPECT_NE(audio.error().text().find("sound"), std::string::npos);
}

TEST(Audio, PlaysWhatIsHeard) {
    const Driver driver("disk");
    const test::TempDir dir;
    const std::string path = dir.path("played.raw");
    setenv("SDL_DISKAUDIOFILE", path.c_str(), 1);
    {
        auto audio = open_audio({Samples(kMixRate, 0.5f)});
        ASSERT_TRUE(audio.ok()) << audio.error().text();
        const Voice voice{SoundId(0u), Maker::thing, 0, 0, true, 1, -1};
        audio.value()->hear(std::vector{voice}, 0, 1);
        std::this_thread::sleep_for(std::chrono::milliseconds(200));
    }
    const auto bytes = read_file(path);
    ASSERT_TRUE(bytes.ok());
    std::vector<float> frames(bytes.value().size() / sizeof(float));
    std::memcpy(frames.data(), bytes.value().data(), frames.size() * sizeof(float));
    ASSERT_GT(frames.size(), 1000u);
    // After the device's first breath, all of it on the left.
    EXPECT_EQ(frames[frames.size() - 2], 0.5f);
    EXPECT_EQ(frames[frames.size() - 1], 0.0f);
}

}  // namespace
}  // namespace enfilade
