// A map as its author wrote it: names are still names, nothing is resolved, every record knows its place in the text.
// Defaults are already filled in; what has none is optional. map/ gives it meaning.
//
// Whoever fills in records keeps to what the reader lets through, which is not checked again. Where a field says
// nothing else: coordinates, heights and rises reach as far as kWorldLimit either way, sizes of pictures go from 2^-16
// to 2^16 texels per metre, pictures move by up to 1024 m/s along either axis, and angles are anything up to 2^30
// degrees.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/containers.h"
#include "base/finding.h"
#include "formats/effect_records.h"
#include "math/vec.h"

namespace enfilade {

// Outlines in short, as an author writes them: what the reader makes loops of.

/// An upright rectangle on the drawing, by any two corners that lie opposite.
struct RectRecord {
    Vec2 a, b;  ///< [m]
    TextPlace place{};
    bool operator==(const RectRecord&) const = default;
};

/// A regular polygon.
struct PolygonRecord {
    Vec2 center;        ///< [m]
    double radius = 1;  ///< from the centre to each corner, at least kVertexGrid [m]
    int corners = 8;    ///< 3..256
    double turn = 0;    ///< where the first corner lies: 0 is along +x, and it grows to the right [degrees]
    TextPlace place{};
    KeyPlaces places{};
    bool operator==(const PolygonRecord&) const = default;
};

/// A loop in short: its shape instead of its corners, and one wall for all that say nothing. Empty once a map is read.
template <class Wall>
struct Shorthand {
    Boxed<RectRecord> rect;
    Boxed<PolygonRecord> polygon;
    Boxed<Wall> wall;
    bool operator==(const Shorthand&) const = default;
};

// The parts of a map.

/// "NAME [SU,SV [OU,OV] [OUm,OVm]]".
struct TextureSpec {
    std::string name;            ///< "-" is no texture
    std::optional<Vec2> tile_m;  ///< SU, SV: metres per tile, 2^-16..2^16, below 0 mirrored; sky: wraps per turn,
                                 ///< tangent of its height. Absent: 1, 1
    Vec2 offset_tx;              ///< OU, OV: subtracted, up to 2^20 either way [texels]
    TextPlace place;
    Boxed<Vec2> offset_m{};  ///< OUm, OVm: subtracted, too [m]; absent: 0, 0. Few have it

    Vec2 moved_m() const { return offset_m ? *offset_m : Vec2{}; }
    void move_by(Vec2 metres) {
        const Vec2 offset = moved_m() + metres;
        offset_m = offset == Vec2{} ? Boxed<Vec2>() : Boxed<Vec2>(offset);
    }

    bool operator==(const TextureSpec&) const = default;
};

/// Which height a texture hangs from (its top row there) or stands on (its bottom row there).
enum class Peg : std::uint8_t { ceiling, floor, opening_top, opening_bottom };

/// What is left of a Doom line, sector or thing after conversion: kept, never interpreted.
struct DoomRecord {
    int special = 0;
    int tag = 0;
    int flags = 0;
    bool operator==(const DoomRecord&) const = default;
};

struct WallRecord {
    std::string name;  ///< empty: none
    std::optional<TextureSpec> texture, upper, lower, middle;
    Peg texture_peg = Peg::ceiling, upper_peg = Peg::opening_top, lower_peg = Peg::opening_bottom,
        middle_peg = Peg::opening_top;
    std::optional<double> size;  ///< texels per metre of all its textures, instead of metres per tile
    std::string next;            ///< name of the sector behind; empty: a solid wall
    std::string via;             ///< name of the wall of `next` it is linked to; empty: plain adjacency
    std::optional<double> rise;  ///< height added when passing the link [m]; absent: floor on floor
    bool mirror = false;
    bool blocks = false;    ///< portal: nobody passes, though one looks through; given on one side it counts for both
    bool way_back = false;  ///< one-way portal: whoever passes leaves a way back
    Vec2 scroll;            ///< how fast its pictures move along it and up [m/s]
    std::vector<TriggerRecord> triggers;
    std::optional<DoomRecord> doom;
    TextPlace place;
    KeyPlaces places{};

    /// As if the wall had begun elsewhere: metres.x further on, metres.y higher.
    void move_pictures(Vec2 metres) {
        for (auto* spec : {&texture, &upper, &lower})
            if (*spec) (*spec)->move_by(metres);
    }
    bool operator==(const WallRecord&) const = default;
};

/// A closed loop: wall i joins vertex i to i + 1, the last closes.
struct LoopRecord {
    std::string name;
    std::vector<Vec2> vertices;  ///< as written; rounding to the grid is map/'s business
    std::vector<TextPlace> vertex_places;
    std::vector<WallRecord> walls;  ///< same length as vertices
    bool is_whole = true;           ///< the reader found every vertex and as many walls; if not, its shape says nothing
    TextPlace place;
    KeyPlaces places{};
    Boxed<Shorthand<WallRecord>> shorthand{};
    bool operator==(const LoopRecord&) const = default;
};

/// A picture with alpha that is laid over a floor, a ceiling or a sky.
struct FlatLayerRecord {
    TextureSpec texture;
    double turn = 0;  ///< over a sky: how fast it turns, -1024..1024 [degrees/s]
    Vec2 scroll;      ///< over a floor or ceiling: how fast it moves along x and y [m/s]
    TextPlace place;
    KeyPlaces places{};
    bool operator==(const FlatLayerRecord&) const = default;
};

struct FlatRecord {
    double z = 0;  ///< [m]
    std::optional<TextureSpec> texture;
    std::optional<double> size;  ///< texels per metre
    bool is_relative = false;    ///< texture origin at the first vertex of the first loop, not at the world's origin
    bool parallax = false;       ///< drawn as sky
    bool carries = false;        ///< floor: whoever stands on it moves with the picture
    Vec2 scroll;                 ///< how fast the picture moves along x and y [m/s]
    Boxed<BobRecord> bob;        ///< it goes up and down by itself
    std::vector<FlatLayerRecord> layers;  ///< laid over it, the first one farthest
    TextPlace place;
    KeyPlaces places{};
    bool operator==(const FlatRecord&) const = default;
};

/// A free-standing two-sided wall inside a sector.
struct PanelRecord {
    Vec2 a, b;                   ///< its ends; rounding to the grid is map/'s business [m]
    double bottom = 0, top = 0;  ///< heights above the map's zero [m]
    TextureSpec texture;
    std::optional<double> size;  ///< texels per metre
    bool one_sided = false;      ///< seen only from the right of a -> b
    bool blocks = false;         ///< nobody passes, at whatever height
    Vec2 scroll;                 ///< how fast its picture moves along it and up [m/s]
    std::vector<TriggerRecord> triggers;
    std::optional<DoomRecord> doom;
    TextPlace place;
    KeyPlaces places{};
    bool operator==(const PanelRecord&) const = default;
};

struct SectorRecord {
    std::string name;
    double light = 1;  ///< 0..1
    std::string sun;   ///< which one shines on it; empty: none
    FlatRecord floor;
    FlatRecord ceiling{2, {}, {}, false, false, false, {}, {}, {}, {}, {}};
    std::vector<LoopRecord> loops;
    std::vector<PanelRecord> panels;
    std::vector<std::string> tags;  ///< what triggers may call it besides its name; others may have the same
    std::string group;              ///< those with the same one move as one; empty: it moves alone
    std::vector<TriggerRecord> triggers;
    std::optional<LightEffectRecord> light_effect;
    int damage = 0;                      ///< what a second on its floor costs, 0..1000 [points of health]
    bool unlit = false;                  ///< its light is the same at any distance and in any direction
    bool secret = false;                 ///< counted, and told, when it is found
    std::string move_sound, stop_sound;  ///< when its floor or ceiling moves, and when it arrives; empty: silent
    std::string down_sound;              ///< instead of move_sound on the way down; empty: no other
    std::optional<DoomRecord> doom;
    TextPlace place;
    KeyPlaces places{};
    Boxed<Shorthand<WallRecord>>
        shorthand{};  ///< of its outline, which is its first loop; `wall` is that of all its loops
    bool operator==(const SectorRecord&) const = default;
};

/// One picture of a sprite's animation, shown for some seconds.
struct SpriteFrameRecord {
    std::string texture;            ///< with 8 rotations, the picture names are texture + "1" … texture + "8"
    double seconds = 0;             ///< 0..86400 [s]; 0: for ever
    std::optional<Vec2> origin_tx;  ///< the texel that sits at the thing's position, from the picture's top left;
                                    ///< absent: the bottom middle of each picture
    TextPlace place{};
    KeyPlaces places{};
    bool operator==(const SpriteFrameRecord&) const = default;
};

/// Skills are counted from 1, the easiest, as in Doom.
inline constexpr int kMostSkill = 5;

/// Stands at every skill.
inline constexpr std::uint8_t kAllSkills = (1u << kMostSkill) - 1;

/// Which floors and ceilings stop short of a solid thing.
enum class HoldsUp : std::uint8_t { all, all_but_crushers, nothing };

struct ThingRecord {
    std::string name;         ///< empty: none
    std::string kind;         ///< `class`: what it is, e.g. "Barrel"
    std::string sector;       ///< empty: found from the position
    Vec2 position;            ///< [m]
    std::optional<double> z;  ///< feet [m]; absent: on the floor, or under the ceiling if hanging
    double yaw_degrees = 0;
    double turn = 0;                  ///< how fast it turns right, -7200..7200 [degrees/s]
    Boxed<BobRecord> bob;             ///< its picture goes up and down
    double radius = 0.5, height = 1;  ///< of its body, 0..1024 [m]
    bool solid = false, hanging = false;
    HoldsUp holds_up = HoldsUp::all;  ///< solid: which floors and ceilings stop short of it
    int rotations = 1;                ///< 1 or 8
    std::vector<SpriteFrameRecord> frames;
    double size = 32;                  ///< texels per metre
    std::optional<double> light;       ///< its own light, 0..1, instead of the sector's
    std::uint8_t skills = kAllSkills;  ///< bit n - 1: it stands at skill n
    bool multiplayer = false;          ///< stands only where several play
    std::vector<TriggerRecord> triggers;
    std::string gives_key;           ///< picked up by touch: the key of this name; empty: none
    int gives_health = 0;            ///< picked up by touch, 0..1000 [points]
    std::string sound;               ///< heard from it, over and over; empty: silent
    std::optional<DoomRecord> doom;  ///< special: type number; tag: 0; flags: the thing's
    TextPlace place;
    KeyPlaces places{};
    bool operator==(const ThingRecord&) const = default;
};

struct PlayerRecord {
    std::string sector = "main";
    Vec2 position;           ///< [m]
    double eye_z = 0;        ///< [m]
    double yaw_degrees = 0;  ///< the tutorial's radians are converted by the reader
    TextPlace place;
    KeyPlaces places{};
    bool operator==(const PlayerRecord&) const = default;
};

enum class LightModel : std::uint8_t { smooth, classic };

/// How the rows of a sky's picture lie on the screen: round as on a cylinder about the eye, or straight.
enum class SkyRows : std::uint8_t { round, straight };

/// Where the ray of a pixel passes through it: its middle, or its upper left corner.
enum class RayPoint : std::uint8_t { middle, corner };

/// Whether the floors, ceilings and walls that a thing's picture reaches into cut it.
enum class ThingEdges : std::uint8_t { cut, whole };

struct RenderRecord {
    double stretch = 1;  ///< of pictures upwards, 1/8..8; Doom's is 1.2
    LightModel light = LightModel::smooth;
    std::uint32_t recursion_color = 0xFF00FF;  ///< shown where a chain of links is cut, 0xRRGGBB
    int max_depth = 64;                        ///< links followed in one chain, 0..1024
    std::uint32_t fog_color = 0xC0C8D0;        ///< 0xRRGGBB
    double fog_reach = 0;                      ///< depth at which fog hides half of everything but sky; 0: no fog [m]
    SkyRows sky = SkyRows::round;
    ThingEdges things = ThingEdges::cut;
    RayPoint rays = RayPoint::middle;
    std::string color_table;     ///< picture of what becomes of colours in the dark (map/textures.h); empty: none
    std::uint32_t fog_step = 1;  ///< by which fog grows, 1..256 [1/256]; a dial's: no map tells it
    TextPlace place{};
    KeyPlaces places{};
    bool operator==(const RenderRecord&) const = default;
};

/// An opening between two rooms, written once: it cuts a wall of each, and what lies between the two walls becomes
/// sectors of its own. Private to the reader: a map that was read has none.
struct OpeningRecord {
    std::vector<std::string> between;   ///< the two sectors
    std::optional<Vec2> at;             ///< its middle, on a wall of the first; absent: of the stretch where they face
    std::optional<Vec2> to;             ///< a link: its middle on a wall of the second
    std::optional<double> width;        ///< [m]; absent: the whole stretch where the walls face each other
    std::optional<double> depth;        ///< of a link: how deep the sectors behind the first wall are [m]
    std::optional<double> bottom, top;  ///< absolute heights of its sill and its lintel [m]
    int steps = 0;                      ///< stairs: how many
    std::optional<TextureSpec> leaf;    ///< a door: its picture
    WallRecord wall;      ///< what its walls look like: `texture` its sides and steps; the others as those of a wall
    SectorRecord sector;  ///< what its sectors are like; their name is that of the opening
    TextPlace place;
    KeyPlaces places{};
    bool operator==(const OpeningRecord&) const = default;
};

/// A map file that is put into this one. Private to the reader: a map that was read has none.
struct PrefabRecord {
    std::string name;  ///< what its rooms are called after: "NAME.room"
    std::string file;  ///< seen from the map's folder
    Vec2 at;           ///< where its (0, 0) comes to lie [m]
    double z = 0;      ///< what is added to its heights [m]
    double turn = 0;   ///< how far it is turned to the right about its (0, 0) [degrees]
    TextPlace place;
    KeyPlaces places{};
    bool operator==(const PrefabRecord&) const = default;
};

/// The whole file.
struct MapFile {
    int format = 0;  ///< 0: tutorial dialect, 1: enfilade dialect
    std::string name;
    std::vector<std::string> textures{"textures"};  ///< folders, relative to the map
    std::optional<double> size;  ///< texels per metre of every wall and flat that says nothing else; absent: 1 m a tile
    RenderRecord render;
    std::vector<SectorRecord> sectors;
    std::vector<PrefabRecord> prefabs;    ///< none once it is read: what they put in is among the others
    std::vector<OpeningRecord> openings;  ///< none once it is read: walls are cut, and what lies between is a sector
    std::optional<PlayerRecord> player;
    std::vector<ThingRecord> things;
    std::vector<PointLightRecord> lights;
    std::vector<SunRecord> suns;
    std::vector<AnimationRecord> animations;
    std::vector<SwitchRecord> switches;
    std::vector<SoundRecord> sounds;
    bool operator==(const MapFile&) const = default;
};

}  // namespace enfilade
