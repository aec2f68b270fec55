// Small maps and scripts for tests of flythroughs.
#pragma once
#include "flight/flight.h"
#include "support/map_builder.h"

namespace enfilade::test {

/// A hall of 8 x 6 m and a niche to its east, 2 to 4 in y; the player in the hall at (2, 3), looking east.
inline MapFile hall_file() {
    MapFile file = map_of({box_room("hall", 0, 0, 8, 6, 0, 3), box_room("niche", 8, 2, 10, 4, 0, 3)});
    split_and_join(file);
    place_player(file, "hall", {2, 3}, 1.5, 0);
    return file;
}

/// Two rooms 100 m apart; the east wall of "here" leads into "there", turned by a quarter and 1 m higher.
inline MapFile linked_file() {
    MapFile file = map_of({box_room("here", 0, 0, 4, 4, 0, 3), box_room("there", 100, 0, 104, 4, 1, 4)});
    link(file, "here", {4, 0}, {4, 4}, "there", {100, 0}, {104, 0});
    place_player(file, "here", {2, 2}, 1.5, 0);
    return file;
}

inline LegRecord leg(double seconds) {
    LegRecord record;
    record.seconds = seconds;
    record.ease = Ease::linear;
    return record;
}

inline LegRecord go(double seconds, Vec2 to) {
    LegRecord record = leg(seconds);
    record.to = to;
    return record;
}

/// Ten frames a second, 64 x 40 pixels; leg i stands in line i + 1.
inline ScriptFile script_of(std::vector<LegRecord> legs) {
    ScriptFile script;
    script.width = 64;
    script.height = 40;
    script.rate = 10;
    script.legs = std::move(legs);
    for (std::size_t i = 0; i < script.legs.size(); ++i) script.legs[i].place = {static_cast<std::uint32_t>(i + 1), 1};
    return script;
}

}  // namespace enfilade::test
