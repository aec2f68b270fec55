// What pixels show, in words.
#include "app/pixel_text.h"

#include <gmock/gmock.h>

#include "support/map_builder.h"

namespace enfilade {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

/// A hall with a step up into a niche under the sky, a panel, and a statue.
MapFile furnished_hall() {
    MapFile file = test::map_of(
        {test::box_room("hall", 0, 0, 8, 4, 0, 4), test::room("niche", {{8, 1}, {10, 1}, {10, 3}, {8, 3}}, 1, 3)});
    test::split_and_join(file);
    WallRecord& door = test::wall(file, "hall", {8, 1}, {8, 3});
    door.lower = test::spec("riser"), door.upper = test::spec("lintel");
    test::sector(file, "hall").ceiling.parallax = true;
    PanelRecord panel;
    panel.a = {4, 3}, panel.b = {4, 3.5}, panel.top = 4, panel.texture = test::spec("grille");
    test::sector(file, "hall").panels.push_back(panel);
    ThingRecord statue;
    statue.kind = "statue";
    statue.position = {4, 1};
    statue.frames.push_back({"figure", 0, {}});
    file.things.push_back(statue);
    return file;
}

class PixelText : public ::testing::Test {
protected:
    PixelText() {
        const MapFile file = furnished_hall();
        map_ = {test::built(file), test::textures_for(file)};
        places_.walls.assign(map_.map.walls.size(), {40, 1});
        places_.floors.assign(2, {10, 1});
        places_.sectors.assign(2, {5, 1});
        view_.sector = SectorId(0u);
        view_.eye = {2, 2};
        view_.eye_z = 1.5;
    }

    /// In the direction of a point.
    std::string text(Vec2 p, double z) const {
        const double depth = p.x - 2;
        const int x = int(80 * (1 + (p.y - 2) / depth)), y = int(60 - 80 * (z - 1.5) / depth);
        return pixel_text(map_, at_rest(map_.map), {view_, 160, 120, x, y}, "hall.toml", places_);
    }

    OpenMap map_;
    MapPlaces places_;
    View view_;
};

TEST_F(PixelText, NamesWallsByTheirPartsAndNumbers) {
    EXPECT_THAT(text({8, 2}, 0.5), StartsWith("lower part of wall 2 of sector 'hall', 6.00 m ahead, texel "));
    EXPECT_THAT(text({8, 2}, 0.5), HasSubstr(" of 'riser'; hall.toml:40"));
    EXPECT_THAT(text({8, 2}, 3.5), StartsWith("upper part of wall 2 of sector 'hall'"));
    EXPECT_THAT(text({10, 2}, 2), StartsWith("wall 1 of sector 'niche', 8.00 m ahead"));
}

TEST_F(PixelText, NamesFlatsAndTheSky) {
    EXPECT_THAT(text({5, 2}, 0), StartsWith("floor of sector 'hall', "));
    EXPECT_THAT(text({5, 2}, 0), HasSubstr("of 'floor'; hall.toml:10"));
    EXPECT_THAT(text({6, 2}, 4), StartsWith("sky of sector 'hall', texel "));
}

TEST_F(PixelText, NamesThingsAndPanels) {
    EXPECT_THAT(text({4, 1}, 1), StartsWith("thing 0 ('statue') of sector 'hall', 2.00 m ahead, at 0."));
    EXPECT_THAT(text({4, 3.25}, 1), StartsWith("panel 0 of sector 'hall', 2.00 m ahead"));
}

TEST_F(PixelText, NamesTheLineOfTheSectorOrTheFileWhereItKnowsNoNearer) {
    EXPECT_THAT(text({4, 3.25}, 1), HasSubstr("; hall.toml:5"));
    places_ = {};
    EXPECT_TRUE(text({8, 2}, 0.5).ends_with("; hall.toml"));
}

}  // namespace
}  // namespace enfilade
