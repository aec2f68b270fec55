// What the steps of one map's conversion hand on to each other, and Doom's numbers that they know. Private to the
// converter.
#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "formats/effect_records.h"
#include "formats/map_file.h"
#include "wadconv/convert.h"
#include "wadconv/parts.h"
#include "wadconv/pictures.h"
#include "wadconv/report.h"
#include "wadconv/wad.h"

namespace enfilade::wadconv {

// Every type of thing that Doom and Doom II maps place, with its size, its looks and how it stands or hangs.
// Source: the numbers of Matthew S. Fell's "The Unofficial Doom Specs" (1994), §4.2.1, sizes and idle frames as in
// Doom's own tables (id Software, info.c, 1993).

/// One picture of an idle animation.
struct IdleFrame {
    char letter;        ///< of the sprite's frames
    std::uint8_t tics;  ///< how long it is shown [1/35 s]; 0: for ever
    bool is_bright;     ///< drawn at full light
};

struct ThingType {
    int number;                   ///< as in THINGS
    std::string_view kind;        ///< what it is, e.g. "Zombieman"
    std::int16_t radius, height;  ///< [map units]
    bool is_solid;
    bool hangs;               ///< from the ceiling
    std::string_view sprite;  ///< four letters; empty: nothing to be seen (starts, exits, targets)
    std::string_view frames;  ///< idle animation as "A10 B10*": letter, tics, '*' where bright; no tics: for ever
};

/// Whether the type can be shot: it holds up what moves until it is crushed, where mere decoration never does.
bool can_be_shot(int number);

/// Tics in a second.
inline constexpr double kTicsPerSecond = 35;

/// Types with a meaning of their own.
inline constexpr int kFirstStart = 1, kLastStart = 4, kDeathmatchStart = 11, kTeleportExit = 14;

/// All types, by rising number.
std::span<const ThingType> thing_types();

/// The type of that number, or null.
const ThingType* find_thing_type(int number);

/// Every frame of every thing that stands idle, as "POSSA"; some several times.
std::vector<std::string> idle_frames();

/// Takes the first frame off a text of frames; a text that is none gives letter 0.
IdleFrame take_frame(std::string_view& frames);

// What Doom's lines do: every type of Doom and Doom II, and those of Boom that have a word here, as plain data.
// Source: the published tables (Matthew S. Fell, "The Unofficial Doom Specs", 1994, §4.3.3; the Boom reference, 1998,
// part I), times and speeds as measured there: map units and tics of 1/35 s.

/// How a line is set off. `push`: used, and acts on the sector behind it; the others on the sectors of its tag.
enum class How : std::uint8_t { push, use, cross, shoot };

enum class Times : std::uint8_t { once, again };

/// Cards and skulls of one colour open the same.
enum class DoorKey : std::uint8_t { none, blue, yellow, red };

/// What becomes of the floor's picture, and of what the floor does to who stands on it.
enum class FloorChange : std::uint8_t {
    none,
    picture,      ///< the picture of the sector in front of the line
    harmless,     ///< the same, and the floor no longer hurts
    as_in_front,  ///< picture and nature of the sector in front of the line
    as_beside,    ///< picture and nature of a sector around that has the height that the floor gets
};

/// What needs more than a word's own measures.
enum class SpecialCase : std::uint8_t {
    none,
    shortest_lower,  ///< `by` is the height of the shortest lower texture around
    donut,           ///< the pillar goes down into the ring, and the ring rises around it
    secret_exit,
};

struct LineAction {
    int special = 0;
    How how = How::use;
    Times times = Times::again;
    TriggerAction action = TriggerAction::door;
    double speed = 0;  ///< [map units / tic]
    double wait = 0;   ///< [tics]
    HeightLevel to = HeightLevel::here;
    double by = 0;  ///< [map units]; stairs: the height of one
    bool crushes = false;
    double crush_speed = 0;  ///< once it comes down on somebody; 0: as before [map units / tic]
    DoorKey key = DoorKey::none;
    FloorChange change = FloorChange::none;
    SpecialCase special_case = SpecialCase::none;
    int light = -1;  ///< 0..255, or -1: `light_of`, or a strobe where that is `given`
    LightLevel light_of = LightLevel::given;
};

/// All that are listed one by one, by rising number.
std::span<const LineAction> line_actions();

/// What the type does; nothing for 0, for types that are no action (scrollers), that only monsters set off, or that are
/// not known. Also knows Boom's generalized doors and lifts.
std::optional<LineAction> line_action_of(int special);

/// How far the wall's picture moves along it in a tic, to the right positive, or 0 [texels].
int scroll_of(int special);

// Doom's lines as triggers.

/// What triggers call the sectors of a tag, and the exit of a teleport.
std::string tag_name(int tag);
std::string exit_name(std::uint32_t sector);

/// Damage for every 32 tics on a floor, by the sector's special; 0: none [points of health].
int damage_of(int special);

/// What floors cost a second [points of health], where Doom takes so much every 32 tics.
int damage_a_second(int damage);

/// By sector: whether a thing to teleport to stands in it.
using Exits = std::vector<bool>;

/// Makes triggers of lines. Everything it is given must outlive it.
class TriggerMaker {
public:
    TriggerMaker(const DoomMap& doom, const Parts& parts, const Pictures& pictures, const Neighbours& neighbours,
                 const Exits& exits, Report& report);

    /// What the wall in front of the line does, front side and all; none where the line's type is not known or can do
    /// nothing here (Report says why). `is_open`: one may pass.
    std::vector<TriggerRecord> triggers_of(std::uint32_t line, bool is_open) const;

private:
    struct LineJob {
        std::uint32_t line;
        const LineAction& line_action;
        TriggerRecord base;                  ///< without targets
        std::vector<std::uint32_t> sectors;  ///< of the line's tag
    };
    std::vector<TriggerRecord> remote(LineJob& job) const;
    std::vector<TriggerRecord> teleport(const LineJob& job) const;
    TriggerRecord leave_map(const LineJob& job) const;
    std::vector<TriggerRecord> one_by_one(const LineJob& job) const;
    std::vector<TriggerRecord> staircase(const LineJob& job, std::uint32_t sector) const;
    std::vector<TriggerRecord> donut(const LineJob& job, std::uint32_t pillar) const;
    std::vector<std::uint32_t> stairs_from(std::uint32_t sector) const;
    std::uint32_t beside_of_height(std::uint32_t sector, std::int16_t floor) const;
    void change_as(std::uint32_t model, bool takes_nature, TriggerRecord& trigger) const;
    void strobe(const LineJob& job, TriggerRecord& trigger) const;
    double shortest_lower(std::uint32_t sector) const;
    std::uint32_t front_of(std::uint32_t line) const;
    std::vector<std::string> targets_of(std::uint32_t sector) const;
    const DoomSector& sector(std::uint32_t number) const { return doom_.sectors[number]; }

    const DoomMap& doom_;
    const Parts& parts_;
    const Pictures& pictures_;
    const Neighbours& neighbours_;
    const Exits& exits_;
    Report& report_;
    std::map<int, std::vector<std::uint32_t>> by_tag_;  ///< sectors that became parts
    std::vector<std::string> names_;                    ///< of each sector's first part; empty: it has none
};

/// A sector's heights as converted [map units].
struct DoomHeights {
    std::int32_t floor = 0;
    std::int32_t ceiling = 0;  ///< >= floor
};

/// The map on its way. file.sectors[i] is parts.parts[i].
struct Workbench {
    const DoomMap& doom;
    const Pictures& pictures;
    const Sounds& sounds;
    const Parts& parts;
    const Neighbours& neighbours;
    const TriggerMaker& triggers;
    std::vector<DoomHeights> heights;  ///< by Doom sector
    Report& report;
    MapFile& file;

    const Sidedef& side_of(const Edge& edge) const { return doom.sides[edge.side]; }
    const DoomHeights& heights_of(const Part& part) const { return heights[part.sector]; }
};

/// [m] from map units.
constexpr double metres(double units) { return units / kUnitsPerMetre; }
constexpr Vec2 metres(Point p) { return {p.x / kUnitsPerMetre, p.y / kUnitsPerMetre}; }

inline Point point_of(const DoomThing& thing) { return {thing.x, -std::int32_t{thing.y}}; }

bool is_sky(std::string_view flat);

/// convert_sectors.cpp: ceilings below floors raised, doors opened if asked.
std::vector<DoomHeights> settle_heights(const DoomMap& doom, const Parts& parts, bool open_doors, Report& report);

/// convert_sectors.cpp: names, floors, ceilings and light of file.sectors.
void convert_sectors(Workbench& bench);

/// convert_walls.cpp: the loops of file.sectors.
void convert_walls(Workbench& bench);

/// The texture of a side with its offset [texels], or nothing for "-", Doom's "no texture" and unknown names.
std::optional<TextureSpec> texture_spec(Workbench& bench, const std::string& name, const Sidedef& side,
                                        std::uint32_t line);

/// By line: the lowest of its edges that bounds a part, which is the right side's if that does; or kNone.
std::vector<std::uint32_t> first_walls(const DoomMap& doom, const Parts& parts);

/// What is left of a line: the special with its tag, unless it became words, and the flags beyond those in `said`;
/// nothing where nothing is. Counts specials that are left.
std::optional<DoomRecord> left_over(Workbench& bench, const Linedef& line, bool has_words, std::uint16_t said);

/// convert_panels.cpp: lines that bound no part but show a picture or mean something.
void convert_panels(Workbench& bench);

/// The number of the sector that each thing to teleport to stands in, by thing; kNone for other things, for those
/// outside, and for all but the first of a sector.
std::vector<std::uint32_t> exits_of(const DoomMap& doom, const Parts& parts);

/// Adds the animations and switches that the map's pictures take part in.
void convert_picture_changes(Workbench& bench);

/// Adds the sounds of what moves, is switched and is picked up, as far as the archives have them.
void convert_sounds(Workbench& bench);

/// convert.cpp: things and the player's start.
void convert_things(Workbench& bench);

// How the light of Doom's sectors changes, as this format's light effects.
// Source: Matthew S. Fell, "The Unofficial Doom Specs" (1994), §4.9.1; times as Doom has them (p_lights.c, 1993).

/// Light levels of Doom reach from 0 to 255; its 16 steps are level / 16, so that 256 parts make light * 16 exact.
inline constexpr double kLightLevels = 256;

/// Flashes once a second from `dark` [0..255].
LightEffectRecord slow_strobe(int dark);

/// What a sector's special makes of its light, which is `light`, with `darkest` the darkest around it; none where it is
/// steady, or where there is nothing darker to go to.
std::optional<LightEffectRecord> light_effect_of(int special, int light, int darkest);

}  // namespace enfilade::wadconv
