// Maps in which many of one thing meet many of another: what is taken for them grows with the text, not with its
// square.
#include <gmock/gmock.h>

#include <functional>
#include <ostream>

#include "formats/map_toml.h"
#include "support/count_allocations.h"
#include "support/map_builder.h"

namespace enfilade {
namespace {

using namespace test;

std::string numbered(const char* what, std::size_t i) { return what + std::to_string(i); }

TriggerRecord trigger_about(std::vector<std::string> targets) {
    TriggerRecord trigger;
    trigger.targets = std::move(targets);
    return trigger;
}

/// A hall of many walls, and as many closets.
MapFile hall_and_closets(std::size_t n) {
    std::vector<Vec2> outline{{0, 1}, {0, 0}};
    for (std::size_t i = 1; i <= n; ++i) outline.push_back({static_cast<double>(i), 0});
    outline.push_back({static_cast<double>(n), 1});
    MapFile file = map_of({room("hall", outline)});
    for (std::size_t i = 0; i < n; ++i) {
        const auto x = static_cast<double>(i);
        file.sectors.push_back(box_room(numbered("closet", i), x, 2, x + 1, 3));
    }
    return file;
}

std::vector<SectorRecord*> closets(MapFile& file) {
    std::vector<SectorRecord*> all;
    for (std::size_t i = 1; i < file.sectors.size(); ++i) all.push_back(&file.sectors[i]);
    return all;
}

/// Each wall of the hall, and its number.
void each_wall(MapFile& file, const std::function<void(WallRecord&, std::size_t)>& change) {
    std::vector<WallRecord>& walls = file.sectors[0].loops[0].walls;
    for (std::size_t i = 0; i < walls.size(); ++i) change(walls[i], i);
}

void one_tag_and_many_triggers(MapFile& file) {
    for (SectorRecord* closet : closets(file)) closet->tags = {"t"};
    each_wall(file, [](WallRecord& wall, std::size_t) { wall.triggers = {trigger_about({"t"})}; });
}

void one_tag_and_a_trigger_in_each(MapFile& file) {
    for (SectorRecord* closet : closets(file)) {
        closet->tags = {"t"};
        closet->triggers = {trigger_about({"t"})};
    }
}

void many_models_of_one_tag(MapFile& file) {
    for (SectorRecord* closet : closets(file)) closet->tags = {"t"};
    each_wall(file, [](WallRecord& wall, std::size_t) {
        wall.triggers = {trigger_about({"hall"})};
        wall.triggers[0].action = TriggerAction::floor;
        wall.triggers[0].like = "t";
    });
}

void one_trigger_that_says_one_tag_often(MapFile& file) {
    for (SectorRecord* closet : closets(file)) closet->tags = {"t"};
    each_wall(file, [](WallRecord& wall, std::size_t i) {
        if (i == 0) wall.triggers = {trigger_about({})};
    });
    file.sectors[0].loops[0].walls[0].triggers[0].targets.assign(file.sectors.size(), "t");
}

void two_tags_of_the_same_sectors(MapFile& file) {
    for (SectorRecord* closet : closets(file)) closet->tags = {"s", "t"};
    each_wall(file, [](WallRecord& wall, std::size_t) { wall.triggers = {trigger_about({"s", "t"})}; });
}

void many_tags_of_one_sector(MapFile& file) {
    for (std::size_t i = 0; i < file.sectors.size(); ++i) file.sectors[0].tags.push_back(numbered("t", i));
    each_wall(file, [](WallRecord& wall, std::size_t i) { wall.triggers = {trigger_about({numbered("t", i)})}; });
}

void many_triggers_without_target(MapFile& file) {
    for (SectorRecord* closet : closets(file)) closet->triggers.assign(2, trigger_about({}));
}

void many_unknown_targets(MapFile& file) {
    each_wall(file, [](WallRecord& wall, std::size_t i) { wall.triggers = {trigger_about({numbered("u", i)})}; });
}

void many_sounds_in_many_sectors(MapFile& file) {
    for (std::size_t i = 0; i < file.sectors.size(); ++i) {
        file.sounds.push_back({});
        file.sounds.back().name = file.sounds.back().file = numbered("sound", i);
        file.sectors[i].move_sound = file.sectors[i].stop_sound = numbered("sound", i / 2);
    }
}

void many_animations_and_switches(MapFile& file) {
    for (std::size_t i = 0; i < file.sectors.size(); ++i) {
        file.animations.push_back({{numbered("frame", 2 * i), numbered("frame", 2 * i + 1)}, 1, {}});
        file.switches.push_back({numbered("off", i), numbered("on", i), {}});
    }
}

void many_pictures(MapFile& file) {
    each_wall(file, [](WallRecord& wall, std::size_t i) { wall.texture = spec(numbered("wall", i)); });
}

void many_panels(MapFile& file) {
    for (std::size_t i = 0; i + 1 < file.sectors.size(); ++i) {
        PanelRecord panel;
        panel.a = {static_cast<double>(i) + 0.25, 0.5};
        panel.b = {static_cast<double>(i) + 0.75, 0.5};
        panel.top = 1;
        panel.texture = spec("panel");
        panel.triggers = {trigger_about({})};
        file.sectors[0].panels.push_back(panel);
    }
}

void many_things_of_many_frames(MapFile& file) {
    for (std::size_t i = 0; i < file.sectors.size(); ++i) {
        ThingRecord thing;
        thing.position = {0.5, 0.5};
        thing.name = numbered("thing", i);
        thing.rotations = 8;
        thing.frames.assign(8, {"frame", 1, {}});
        thing.frames[i % 8].texture = numbered("other", i);
        file.things.push_back(thing);
    }
}

void many_lamps(MapFile& file) {
    for (std::size_t i = 0; i < file.sectors.size(); ++i) {
        PointLightRecord light;
        light.position = {0.5, 0.5};
        light.z = 1;
        light.reach = 1;
        light.effect = LightEffectRecord{};
        file.lights.push_back(light);
    }
}

void many_portals_into_one_sector(MapFile& file) {
    each_wall(file, [](WallRecord& wall, std::size_t) {
        wall.next = "closet0";
        wall.via = "door";
    });
    file.sectors[1].loops[0].walls[0].name = "door";
}

struct Shape {
    const char* name;
    void (*furnish)(MapFile&);

    friend void PrintTo(const Shape& shape, std::ostream* out) { *out << shape.name; }
};

constexpr Shape kShapes[] = {
    {"OneTagAndManyTriggers", one_tag_and_many_triggers},
    {"OneTagAndATriggerInEach", one_tag_and_a_trigger_in_each},
    {"ManyModelsOfOneTag", many_models_of_one_tag},
    {"OneTriggerThatSaysOneTagOften", one_trigger_that_says_one_tag_often},
    {"TwoTagsOfTheSameSectors", two_tags_of_the_same_sectors},
    {"ManyTagsOfOneSector", many_tags_of_one_sector},
    {"ManyTriggersWithoutTarget", many_triggers_without_target},
    {"ManyUnknownTargets", many_unknown_targets},
    {"ManySoundsInManySectors", many_sounds_in_many_sectors},
    {"ManyAnimationsAndSwitches", many_animations_and_switches},
    {"ManyPictures", many_pictures},
    {"ManyPanels", many_panels},
    {"ManyThingsOfManyFrames", many_things_of_many_frames},
    {"ManyLamps", many_lamps},
    {"ManyPortalsIntoOneSector", many_portals_into_one_sector},
};

/// What is taken for a map of a shape [bytes].
struct Taken {
    std::size_t text, reading, building;
};

Taken taken_for(const Shape& shape, std::size_t n) {
    MapFile file = hall_and_closets(n);
    shape.furnish(file);
    const TextureSet textures = textures_for(file);
    const std::string text = write_map(file);
    const std::size_t before = allocated_bytes();
    const MapReading reading = read_map(text);
    const std::size_t between = allocated_bytes();
    Findings findings;
    build_map(file, textures, findings);
    return {text.size(), between - before, allocated_bytes() - between};
}

class Growth : public testing::TestWithParam<Shape> {};

// Vectors that double make steps: 1.5 times the growth of the text lies between those and a square, which makes 2.
TEST_P(Growth, IsNoFasterThanThatOfTheText) {
    const Taken small = taken_for(GetParam(), 600), large = taken_for(GetParam(), 1200);
    const double growth = 1.5 * static_cast<double>(large.text) / static_cast<double>(small.text);
    EXPECT_LE(static_cast<double>(large.reading), growth * static_cast<double>(small.reading));
    EXPECT_LE(static_cast<double>(large.building), growth * static_cast<double>(small.building));
}

INSTANTIATE_TEST_SUITE_P(OfMaps, Growth, testing::ValuesIn(kShapes),
                         [](const auto& shape) { return std::string(shape.param.name); });

Map built_with(void (*furnish)(MapFile&), std::size_t n) {
    MapFile file = hall_and_closets(n);
    furnish(file);
    return built(file);
}

TEST(TargetLists, AreSharedByTriggersWithTheSameTargets) {
    EXPECT_EQ(built_with(one_tag_and_many_triggers, 100).targets.size(), 100u);
    EXPECT_EQ(built_with(two_tags_of_the_same_sectors, 100).targets.size(), 100u);
    EXPECT_EQ(built_with(one_trigger_that_says_one_tag_often, 100).targets.size(), 100u);
    EXPECT_EQ(built_with(many_triggers_without_target, 100).targets.size(), 100u);
}

TEST(TargetLists, KeepTheOrderOfTheNamesAndEachSectorOnce) {
    MapFile file = hall_and_closets(3);
    for (SectorRecord* closet : closets(file)) closet->tags = {"t"};
    file.sectors[0].triggers = {trigger_about({"closet2", "t", "hall", "closet0"}), trigger_about({"t", "closet2"})};
    const Map map = built(file);
    using testing::ElementsAre;
    EXPECT_THAT(map.targets_of(map.triggers[0]), ElementsAre(SectorId(3u), SectorId(1u), SectorId(2u), SectorId(0u)));
    EXPECT_THAT(map.targets_of(map.triggers[1]), ElementsAre(SectorId(1u), SectorId(2u), SectorId(3u)));
}

std::size_t count_of(const Findings& findings, const char* code) {
    return static_cast<std::size_t>(
        std::count_if(findings.begin(), findings.end(), [&](const Finding& f) { return f.code == code; }));
}

TEST(TargetLists, AreRefusedWhereTriggersPutLargeTagsTogetherInTooManyWays) {
    MapFile file = hall_and_closets(6000);
    for (SectorRecord* closet : closets(file)) closet->tags = {"t"};
    each_wall(file, [](WallRecord& wall, std::size_t i) {
        if (i < 6000) wall.triggers = {trigger_about({"t", numbered("closet", i)})};
    });
    const TextureSet textures = textures_for(file);
    const std::size_t before = allocated_bytes();
    Findings findings;
    EXPECT_FALSE(build_map(file, textures, findings));
    EXPECT_EQ(count_of(findings, "too-many-targets"), 1u) << text_of(findings);
    EXPECT_LT(allocated_bytes() - before, std::size_t{200} << 20);
}

TEST(TargetLists, MayNameOneLargeTagAnyNumberOfTimes) {
    MapFile file = hall_and_closets(5000);
    one_trigger_that_says_one_tag_often(file);
    EXPECT_FALSE(has_errors(findings_of(file)));
}

TEST(TargetLists, AreRefusedWhereOneActionWouldChangeTooMuchAtOnce) {
    MapFile file = hall_and_closets(1000);
    for (SectorRecord* closet : closets(file)) closet->tags = {"t"};
    file.sectors[0].triggers.assign(1048, trigger_about({"t"}));
    EXPECT_EQ(count_of(findings_of(file), "too-many-targets"), 0u);
    file.sectors[0].triggers.push_back(trigger_about({"t"}));
    EXPECT_EQ(count_of(findings_of(file), "too-many-targets"), 1u);
}

TEST(TargetLists, AreRefusedWhereTheStartWouldChangeTooMuchAtOnce) {
    MapFile file = hall_and_closets(1100);
    one_tag_and_a_trigger_in_each(file);
    EXPECT_EQ(count_of(findings_of(file), "too-many-targets"), 0u);
    for (SectorRecord* closet : closets(file)) closet->triggers[0].on = Activation::start;
    EXPECT_EQ(count_of(findings_of(file), "too-many-targets"), 1u);
}

TEST(Keys, MayBeAsManyAsTheBitsThatSayWhoHasThem) {
    MapFile file = hall_and_closets(70);
    each_wall(file, [](WallRecord& wall, std::size_t i) {
        wall.triggers = {trigger_about({"hall"})};
        wall.triggers[0].key = numbered("key", i % 64);
    });
    EXPECT_EQ(built(file).keys.size(), 64u);
    file.sectors[0].loops[0].walls[64].triggers[0].key = "one more";
    file.sectors[0].loops[0].walls[65].triggers[0].key = "another";
    EXPECT_EQ(count_of(findings_of(file), "too-many-keys"), 1u);
}

}  // namespace
}  // namespace enfilade
