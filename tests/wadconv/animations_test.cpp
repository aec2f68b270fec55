// Pictures that follow one another, and faces of switches.
#include "wadconv/pictures.h"

#include <gmock/gmock.h>

#include "wadconv/wad_builder.h"

namespace enfilade::wadconv {
namespace {

using namespace test;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

PictureOrder some_pictures() {
    return {{{"SFALL1", "sfall1"},
             {"SFALL2", "sfall2"},
             {"SFALL3", "sfall3"},
             {"SFALL4", "sfall4"},
             {"SW1EXIT", "sw1exit"},
             {"SW2EXIT", "sw2exit"},
             {"SW1ODD", "sw1odd"}},
            {{"NUKAGE1", "flats/nukage1"}, {"NUKAGE2", "flats/nukage2"}, {"NUKAGE3", "flats/nukage3"}}};
}

void put_padded(ByteWriter& out, const std::string& name) {
    put_name(out, name);
    out.u8(0);
}

/// One entry of ANIMATED.
void put_animation(ByteWriter& out, int kind, const std::string& last, const std::string& first, std::uint32_t tics) {
    out.u8(static_cast<std::uint8_t>(kind));
    put_padded(out, last);
    put_padded(out, first);
    out.u32(tics);
}

WadPile pile_with(const std::string& lump, const ByteWriter& bytes) {
    WadBuilder wad;
    wad.add(lump, bytes_of(bytes));
    return pile_of({wad.finish()});
}

TEST(Animations, AreDoomsOwn) {
    const auto found = list_animations(pile_of({WadBuilder().finish()}), some_pictures());
    ASSERT_THAT(found, SizeIs(2));
    EXPECT_THAT(found[0].frames, ElementsAre("flats/nukage1", "flats/nukage2", "flats/nukage3"));
    EXPECT_EQ(found[0].seconds, 8 / 35.);
    EXPECT_THAT(found[1].frames, ElementsAre("sfall1", "sfall2", "sfall3", "sfall4"));
}

TEST(Animations, AreThoseOfTheLumpWhereThereIsOne) {
    ByteWriter lump;
    put_animation(lump, 1, "SFALL3", "SFALL2", 5);
    put_animation(lump, 0, "NUKAGE2", "NUKAGE1", 70);
    lump.u8(255);
    const auto found = list_animations(pile_with("ANIMATED", lump), some_pictures());
    ASSERT_THAT(found, SizeIs(2));
    EXPECT_THAT(found[0].frames, ElementsAre("sfall2", "sfall3"));
    EXPECT_EQ(found[1].seconds, 2);
}

TEST(Animations, LeaveOutWhatIsNotThereOrTwice) {
    ByteWriter lump;
    put_animation(lump, 1, "SFALL3", "SFALL2", 5);
    put_animation(lump, 1, "SFALL4", "SFALL3", 5);  // SFALL3 is taken
    put_animation(lump, 1, "SFALL1", "SFALL2", 5);  // backward
    put_animation(lump, 0, "LAVA4", "LAVA1", 5);
    put_animation(lump, 0, "NUKAGE2", "NUKAGE1", 5);
    const Bytes whole = bytes_of(lump);
    ByteWriter cut;
    for (std::size_t i = 0; i + 1 < whole.size(); ++i) cut.u8(std::to_integer<std::uint8_t>(whole[i]));
    EXPECT_THAT(list_animations(pile_with("ANIMATED", cut), some_pictures()), SizeIs(1));
}

TEST(Switches, AreWallsWithTwoFaces) {
    const auto found = list_switches(pile_of({WadBuilder().finish()}), some_pictures());
    ASSERT_THAT(found, SizeIs(1));
    EXPECT_EQ(found[0].off, "sw1exit");
    EXPECT_EQ(found[0].on, "sw2exit");
}

TEST(Switches, AreThoseOfTheLumpWhereThereIsOne) {
    ByteWriter lump;
    for (const char* name : {"SFALL1", "SFALL2"}) put_padded(lump, name);
    lump.u16(1);
    for (const char* name : {"SFALL3", "SFALL4"}) put_padded(lump, name);
    lump.u16(0);
    const auto found = list_switches(pile_with("SWITCHES", lump), some_pictures());
    ASSERT_THAT(found, SizeIs(1));
    EXPECT_EQ(found[0].on, "sfall2");
}

}  // namespace
}  // namespace enfilade::wadconv
