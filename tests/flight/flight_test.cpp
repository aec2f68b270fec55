// Frame n is a pure function of map, script and n.
#include "flight/flight.h"

#include <gtest/gtest.h>

#include "flight/scenes.h"

namespace enfilade {
namespace {

using test::go;
using test::leg;
using test::script_of;

Flight flight_in(const Map& map, const ScriptFile& script) {
    Findings findings;
    auto flight = Flight::plan(script, map, findings);
    EXPECT_TRUE(flight) << test::text_of(findings);
    return *flight;
}

TEST(Flight, HasAFrameAtItsStartAndOneAtItsEnd) {
    const Map map = test::built(test::hall_file());
    EXPECT_EQ(flight_in(map, script_of({leg(2)})).frames(), 21);
    EXPECT_EQ(flight_in(map, script_of({})).frames(), 1);
}

TEST(Flight, CountsFramesInWholeNumbers) {
    const Map map = test::built(test::hall_file());
    EXPECT_EQ(flight_in(map, script_of({leg(0.1), leg(0.2)})).frames(), 4);
}

TEST(Flight, ShowsTheTimeOfTheFrame) {
    const Map map = test::built(test::hall_file());
    EXPECT_EQ(flight_in(map, script_of({leg(2)})).at(map, 15).snapshot.time_s, 1.5);
}

TEST(Flight, SeesThroughTheScriptsLens) {
    MapFile file = test::hall_file();
    file.render.stretch = 1.2;
    const Map map = test::built(file);
    ScriptFile script = script_of({});
    script.fov_degrees = 70;
    const View view = flight_in(map, script).at(map, 0).view;
    EXPECT_EQ(view.fov_degrees, 70);
    EXPECT_EQ(view.stretch, 1.2);
}

/// The hall, with a further room behind a closed door, and a lamp-lit sector whose ceiling moves from the start.
MapFile hall_with_door() {
    MapFile file = test::map_of({test::box_room("main", 0, 0, 4, 4, 0, 3), test::box_room("door", 4, 0, 5, 4, 0, 0),
                                 test::box_room("room", 5, 0, 9, 4, 0, 3)});
    test::join_all(file);
    test::place_player(file, "main", {3, 2}, 1.5);
    TriggerRecord open, close;
    open.on = Activation::use;
    close.on = Activation::start;
    close.action = TriggerAction::close;
    test::sector(file, "door").triggers = {open};
    test::sector(file, "room").triggers = {close};
    return file;
}

TEST(Flight, OpensTheDoorThatALegUses) {
    const Map map = test::built(hall_with_door());
    ScriptFile script = script_of({leg(1), leg(2)});
    script.legs[1].press = Press::use;
    const Flight flight = flight_in(map, script);
    EXPECT_EQ(flight.at(map, 10).snapshot.sectors[1].ceiling_z, 0);
    EXPECT_EQ(flight.at(map, 15).snapshot.sectors[1].ceiling_z, 0.875);  // below the room, which has sunk to 1 m
    EXPECT_EQ(flight.at(map, 12).snapshot.sectors[1].ceiling_z, 0.4);
}

TEST(Flight, ShowsWhatTheStartOfTheMapSetsOff) {
    const Map map = test::built(hall_with_door());
    const Flight flight = flight_in(map, script_of({leg(2)}));
    EXPECT_EQ(flight.at(map, 0).snapshot.sectors[2].ceiling_z, 3);
    EXPECT_EQ(flight.at(map, 10).snapshot.sectors[2].ceiling_z, 1);
    EXPECT_EQ(flight.at(map, 20).snapshot.sectors[2].ceiling_z, 0);
}

TEST(Flight, GivesTheSameFrameInAnyOrder) {
    const Map map = test::built(test::linked_file());
    const Flight flight = flight_in(map, script_of({go(3, {5, 2}), go(1, {102, 3})}));
    for (int frame = flight.frames() - 1; frame >= 0; --frame) {
        const View again = flight.at(map, frame).view,
                   fresh = flight_in(map, script_of({go(3, {5, 2}), go(1, {102, 3})})).at(map, frame).view;
        EXPECT_EQ(again.eye, fresh.eye);
        EXPECT_EQ(again.sector, fresh.sector);
        EXPECT_EQ(again.forward, fresh.forward);
    }
}

TEST(Flight, RefusesAnEyeUnderTheFloor) {
    MapFile file = test::map_of({test::box_room("low", 0, 0, 4, 4, 0, 3), test::box_room("high", 4, 0, 8, 4, 1, 3)});
    test::join_all(file);
    test::place_player(file, "low", {2, 2}, 0.5, 0);
    Findings findings;
    EXPECT_FALSE(Flight::plan(script_of({leg(1), go(1, {6, 2})}), test::built(file), findings));
    ASSERT_EQ(findings.size(), 1u);
    EXPECT_EQ(findings[0].code, "eye-in-wall");
    EXPECT_EQ(findings[0].place.line, 2u);
}

}  // namespace
}  // namespace enfilade
