// The table of things: complete in itself, and read as written.
#include "wadconv/workbench.h"

#include <gmock/gmock.h>

#include <set>
#include <string>

namespace enfilade::wadconv {
namespace {

TEST(ThingTable, FindsEveryTypeByItsNumber) {
    for (const ThingType& type : thing_types()) EXPECT_EQ(find_thing_type(type.number), &type) << type.kind;
}

TEST(ThingTable, HasNothingForUnknownNumbers) {
    for (int number : {-1, 0, 90, 32000, 65535}) EXPECT_EQ(find_thing_type(number), nullptr) << number;
}

TEST(ThingTable, CallsNoTwoTypesTheSame) {
    std::set<std::string_view> kinds;
    for (const ThingType& type : thing_types()) EXPECT_TRUE(kinds.insert(type.kind).second) << type.kind;
}

TEST(ThingTable, HasFramesExactlyForWhatCanBeSeen) {
    for (const ThingType& type : thing_types()) {
        EXPECT_EQ(type.sprite.empty(), type.frames.empty()) << type.kind;
        EXPECT_TRUE(type.sprite.empty() || type.sprite.size() == 4) << type.kind;
    }
}

TEST(ThingTable, NeverStopsInTheMiddleOfAnAnimation) {
    for (const ThingType& type : thing_types()) {
        std::size_t frames = 0, endless = 0;
        for (std::string_view rest = type.frames; !rest.empty(); ++frames) endless += take_frame(rest).tics == 0;
        EXPECT_TRUE(endless == 0 || frames == 1) << type.kind;
    }
}

TEST(TakeFrame, ReadsLetterTicsAndBrightness) {
    std::string_view frames = "A10 B7* C";
    const IdleFrame a = take_frame(frames), b = take_frame(frames), c = take_frame(frames);
    EXPECT_EQ(a.letter, 'A');
    EXPECT_EQ(a.tics, 10);
    EXPECT_FALSE(a.is_bright);
    EXPECT_EQ(b.tics, 7);
    EXPECT_TRUE(b.is_bright);
    EXPECT_EQ(c.letter, 'C');
    EXPECT_EQ(c.tics, 0);
    EXPECT_TRUE(frames.empty());
}

}  // namespace
}  // namespace enfilade::wadconv
