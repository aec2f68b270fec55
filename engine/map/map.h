// The world that never changes: sectors, walls and portals, resolved and checked. Read this first.
//
// A Map is built once (map/load.h) and then only looked at. Everything is a value in a vector, joined by ids. What
// moves or changes light is not here but in world/: functions take the heights of the moment beside the map.
//
// The words of this code, each for one thing:
//
//   grid        where points lie: vertices on multiples of 2^-10 m, bodies and eyes on 2^-32 m (math/vec.h)
//   record      a table of a map file as its author wrote it (formats/map_file.h); building resolves it into the map
//   finding     an error or a warning about a file, with its place there (base/finding.h)
//   sector      a room: a floor, a ceiling, and loops of walls around it
//   loop        walls of a sector that close: an outline, or around a hole
//   wall        a directed edge of a sector, which is on its right
//   portal      a wall that one sees and walks through, into the sector behind it
//   exit        of a portal: the wall of that sector one comes out of
//   link        a portal whose exit lies elsewhere; its passage carries points there. A mirror is a link to itself
//   passage     the motion from one space into another: a turn, a shift, a rise, for mirrors a flip (math/vec.h)
//   way back    a wall that is a portal only for who just came out of it, by a one-way portal
//   panel       a wall without thickness that stands free in a sector, as a fence does
//   thing       a picture that stands or hangs in a sector; lamps and other things have places, too
//   place       a point and the sector it is in, because sectors may overlap (space/trace.h)
//   flat        a floor or a ceiling
//   surface     how a picture lies on a wall or flat
//   group       sectors that move as one; what happens to them is told of the first, their leader
//   trigger     an action (`do`), what sets it off (its activation, `on`), and what sectors it is about (its targets)
//   track       how one height or light goes on in time, once a trigger went off (world/history.h)
//   bob         a floor's or ceiling's own way up and down, for ever (world/instant.h)
//   history     all that happened; what is, at any moment, is a function of it (world/history.h)
//   instant     a map, its history and a time: what heights and lights are asked of (world/instant.h)
//   snapshot    heights, lights and pictures of one moment (world/snapshot.h)
//   tick        the 1/60 s, or 1/35 or 1/140, in which the player moves (world/step.h)
//   path        a straight way through sectors; its segment is the part in one of them (space/trace.h)
//   tie rule    who is said to be first where a path meets a vertex or runs along a wall (math/predicates.h)
//   beam        what is seen of a room from one corner, as sound goes round it (space/hearing.h)
//   view        the eye, where it looks and how wide (render/view.h)
//   pose        that eye in the space behind a chain of links
//   look        what one line of sight goes through, and may cost (render/openings.h)
//   viewport    a sector seen through one chain of portals: its columns, and their open rows
//   run         pixels of one surface down one column (render/column/kernels.h)
//   pane        a picture with holes in a room: a panel, a thing, what hangs in a portal (render/stencil/plan.h)
//   facts       of a pixel: which surface it shows, how deep, which texel (render/frame.h)
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/containers.h"
#include "base/id.h"
#include "formats/effect_records.h"
#include "formats/map_file.h"
#include "math/angle.h"
#include "math/vec.h"

namespace enfilade {

/// Some of Map::triggers: [first, first + count).
struct TriggerRange {
    std::uint32_t first = 0, count = 0;
};

/// How a picture lies on a wall, flat or sky. Texel coordinates are tiles * picture size, wrapped.
///   wall:  u = distance along the wall from a / tile_m.x,  v = (peg height - z) / tile_m.y
///   flat:  u = (x - origin) / tile_m.x,                    v = (y - origin) / tile_m.y
///   sky:   u = turns * tile_m.x,                           v = 1 - tan(elevation) / tile_m.y, clamped to the picture
/// and then minus offset.
/// Few are different, and many walls and flats show each: a map keeps each once (Map::surfaces).
struct Surface {
    TextureId texture;       ///< none: no texture ("-" or not given)
    Vec2 tile_m{1, 1};       ///< metres per tile (sky: wraps per turn, tangent of the height)
    Vec2 offset_tiles;       ///< subtracted; in [0, 1) but for a portal's middle, which does not repeat upwards [tiles]
    Peg peg = Peg::ceiling;  ///< walls only
    Vec2 scroll;             ///< how fast the picture moves: along walls and panels and up; flat: along x and y [m/s]

    bool operator==(const Surface&) const = default;
};

inline constexpr Surface kNoSurface{};

enum class WallKind : std::uint8_t {
    solid,
    portal,
    mirror,
    way_back,  ///< what a one-way portal leads to: itself a portal back while it stands open (world/history.h), else
               ///< solid
};

/// Least and greatest factor of light by direction [1].
inline constexpr double kLeastContrast = 0.8, kMostContrast = 1.2;

/// A directed edge a -> b of a sector, the sector on its right.
struct Wall {
    Vec2 a;         ///< on the vertex grid
    Vec2 b;         ///< equals the next wall's a
    double length;  ///< |b - a| [m]
    SectorId sector;
    WallId next;      ///< the wall that starts at b
    WallId previous;  ///< the wall that ends at a
    WallKind kind = WallKind::solid;
    SectorId behind;      ///< portal, way back: the sector it leads into; else none
    WallId exit;          ///< portal, way back: the wall of `behind` one comes out of; equals -edge for plain adjacency
    bool blocks = false;  ///< portal: looks pass, bodies do not
    bool one_way_exit = false;     ///< bodies come out of it by a portal to which it does not, or not always, lead back
    std::uint32_t link = kNoLink;  ///< index into Map::links, or kNoLink where nothing is transformed
    /// Light by direction, so that corners can be seen. Smooth light: a factor, from 0.8 along x to 1 along y. Classic
    /// light: 0.8 exactly along x (one step darker), 1.2 exactly along y (one step brighter), else 1. Tutorial: 1.
    double contrast = 1;
    SurfaceId texture;               ///< solid, way back
    SurfaceId upper, lower, middle;  ///< portal; the first two: way back, too
    TriggerRange triggers;           ///< use, cross and start
    static constexpr std::uint32_t kNoLink = 0xFFFFFFFFu;

    /// Whether it stands, for who is before it, in front of what the same room has behind it: what is there is another
    /// place than what one gets to, or comes from, through the wall.
    bool is_screen() const { return one_way_exit || (kind == WallKind::portal && link != kNoLink); }
};

/// A wall without thickness that stands free inside a sector and is seen from both sides; from b's side as from a's, so
/// that its picture is mirrored from behind. It may touch walls and other panels, and lie along them, but crosses none.
struct Panel {
    Vec2 a;         ///< on the vertex grid
    Vec2 b;         ///< on the vertex grid, not a
    double length;  ///< |b - a| [m]
    SectorId sector;
    double bottom = 0, top = 0;  ///< absolute; what is below the floor or above the ceiling is hidden [m]
    double contrast = 1;         ///< as a wall's
    Surface surface;             ///< hangs from `top`, whatever its peg; no texture: nothing to be seen
    bool one_sided = false;      ///< only seen by an eye for which a wall a -> b would face (math/predicates.h)
    bool blocks = false;         ///< looks pass, bodies do not, at whatever height
    TriggerRange triggers;       ///< use, cross and start

    /// Whether it is there for those who move, and not only to be looked at.
    bool is_active() const { return blocks || triggers.count > 0; }
};

struct Flat {
    double z = 0;  ///< at rest [m]
    Vec2 origin;   ///< of the texture, in the plane [m]
    SurfaceId surface;
    bool sky = false;
    bool carries = false;           ///< floor: moves who stands on it with the picture
    std::uint32_t first_layer = 0;  ///< what is laid over it, the farthest first, is
    std::uint32_t layer_count = 0;  ///< [first_layer, first_layer + layer_count) of Map::flat_layers
};

struct Sector {
    std::string name;
    std::uint32_t first_wall = 0;  ///< its walls are [first_wall, first_wall + wall_count) of Map::walls
    std::uint32_t wall_count = 0;
    bool has_screens = false;  ///< one of them is_screen()
    double light = 1;          ///< at rest, 0..1
    bool unlit = false;        ///< neither depth nor direction changes its light
    SunId sun;                 ///< that shines on it, or none
    Flat floor, ceiling;
    Boxed<BobRecord> floor_bob, ceiling_bob;  ///< up and down around their z
    Vec2 min, max;                            ///< bounding box of its walls [m]
    std::uint32_t first_solid = 0;            ///< its solid things are [first_solid, first_solid + solid_count) of
    std::uint32_t solid_count = 0;            ///< Map::solid_things
    std::uint32_t first_panel = 0;  ///< its panels are [first_panel, first_panel + panel_count) of Map::panels
    std::uint32_t panel_count = 0;
    std::uint32_t active_panels = 0;    ///< how many of them block or have triggers
    std::uint32_t first_touchable = 0;  ///< the things in it that do something when touched are
    std::uint32_t touchable_count = 0;  ///< [first_touchable, first_touchable + touchable_count) of Map::touchables
    TriggerRange triggers;              ///< use, enter and start
    Boxed<LightEffectRecord> light_effect;
    int damage = 0;  ///< of a second on its floor [points of health]
    bool secret = false;
    SectorId leader;               ///< the first of its group, the sectors that move as one; itself where it has none
    SectorId next_of_group;        ///< the next one of its group, after the last the first; itself where it has none
    SoundId up_sound, down_sound;  ///< of its floor and ceiling when they set off, or none
    SoundId stop_sound;            ///< when they arrive, or none
};

// What can happen in a map: triggers with the sectors they are about, pictures that change with time, and sounds.
// Nothing of it moves here; world/ says when and how.

/// Keys in one map [1]: who carries which is kept in 64 bits.
inline constexpr std::size_t kMostKeys = 64;

/// Some of Map::targets: [first, first + count). Triggers with the same targets share them.
struct TargetRange {
    std::uint32_t first = 0, count = 0;
};

/// What happens, to whom, and what sets it off. The fields mean what they mean in TriggerRecord.
struct Trigger {
    Activation on = Activation::use;
    TriggerAction action = TriggerAction::door;
    bool once = false, one_way = false, reverses = true, crushes = false, heals = false;
    std::uint32_t key = kNoKey;  ///< index into Map::keys, or kNoKey: works for everybody
    TargetRange targets;         ///< in the order of the file, each once; of a group its leader
    ThingId destination;         ///< teleport: where to
    std::string leads_to;        ///< exit: the map named, may be empty
    double after_s = 0;          ///< [s]
    std::optional<double> z;     ///< [m]
    HeightLevel to = HeightLevel::here;
    SectorId like;                      ///< none: `to` counts
    double by = 0;                      ///< [m]
    double speed = 0;                   ///< > 0 [m/s]
    double wait_s = 0;                  ///< [s]
    double step = 0;                    ///< [m]
    std::optional<double> crush_speed;  ///< [m/s]
    TextureId texture;                  ///< none: as it was
    std::optional<double> light;        ///< 0..1
    LightLevel light_of = LightLevel::given;
    std::optional<LightEffectRecord> effect;
    SoundId sound;  ///< none: silent
    /// Where it is heard from, what it is on: one of the four, where it has a sound.
    SectorId on_sector;
    WallId on_wall;
    PanelId on_panel;
    ThingId on_thing;
    static constexpr std::uint32_t kNoKey = 0xFFFFFFFFu;
};

/// Something that can be heard. The fields mean what they mean in SoundRecord.
struct Sound {
    std::string name, file;
    double volume = 1;   ///< 0..1
    double reach_m = 0;  ///< > 0 [m]
    bool loops = false;
};

/// Pictures that follow one another.
struct Animation {
    std::vector<TextureId> frames;  ///< at least one
    double seconds = 0;             ///< each, > 0 [s]
};

/// How pictures of surfaces change, by TextureId; empty where the map has none of its kind.
struct PictureChanges {
    std::vector<Animation> animations;
    std::vector<std::uint32_t> animation_of;  ///< index into animations, or kNone
    std::vector<TextureId> other_face;        ///< of a switch; none: it is no switch
    static constexpr std::uint32_t kNone = 0xFFFFFFFFu;
};

// Things, lamps and the player.

/// One picture of an animation, from each direction.
struct SpriteFrame {
    /// By the eighth of a turn from which it is seen: 0 from the front, then going round to the thing's own left. One
    /// picture for all directions is there eight times; none: nothing is shown.
    std::array<TextureId, 8> views;
    /// From each picture's upper left corner to the place of the thing, right and down [m].
    std::array<Vec2, 8> origins_m;
    double until_s = 0;  ///< when the next frame follows, counted from the start of the first; the last one's may be
                         ///< infinity: it stays
};

/// What a thing looks like. Things that look alike share it.
struct Sprite {
    std::vector<SpriteFrame> frames;  ///< at least one
    double texels_per_m = 32;         ///< > 0
    double reach_m = 0;               ///< how far any of its pictures reaches to either side [m]
};

/// What a thing's height follows.
enum class Footing : std::uint8_t { floor, ceiling, fixed };

/// Something that stands or hangs in a room: an upright cylinder, shown as a picture that faces whoever looks.
struct Thing {
    std::string name, kind;        ///< both may be empty
    SectorId sector;               ///< contains its position
    Vec2 position;                 ///< on the point grid
    Angle yaw;                     ///< at the start
    double turn = 0;               ///< how fast it turns right [degrees/s]
    std::optional<BobRecord> bob;  ///< its picture goes up and down; its body does not
    Footing footing = Footing::floor;
    double z = 0;                               ///< of its foot, at rest [m]
    double radius = 0;                          ///< of its body, on the point grid [m]
    double height = 0;                          ///< of its body [m]
    bool solid = false;                         ///< bodies do not pass
    HoldsUp holds_up = HoldsUp::all;            ///< solid: which floors and ceilings stop short of it
    std::optional<double> light;                ///< its own, 0..1, instead of the sector's
    SpriteId sprite;                            ///< none: nothing to be seen
    TriggerRange triggers;                      ///< touch and start
    std::uint32_t gives_key = Trigger::kNoKey;  ///< index into Map::keys
    int gives_health = 0;                       ///< [points]
    SoundId sound;                              ///< heard from it for ever; none: silent

    /// Taken by whoever touches it.
    bool is_pickup() const { return gives_key != Trigger::kNoKey || gives_health > 0; }
};

/// No body is wider [m]: what may touch one is known before anybody moves.
inline constexpr double kWidestBody = 0.5;

/// A solid thing that a body whose middle is in some sector may touch, because the thing is that near, on a way through
/// portals, whatever the heights there. It need not be: only that it is told for no sector proves that it is not.
struct NearThing {
    ThingId thing;
    Rigid passage;  ///< from the space of the sector into that of the thing's own
};

/// A lamp. What it throws on the surfaces around it is worked out by render/lighting.h.
struct PointLight {
    SectorId sector;                          ///< contains its position
    Vec2 position;                            ///< on the point grid
    double z = 0;                             ///< absolute: it stays where it is when the floor moves [m]
    std::uint32_t color = 0xFFFFFF;           ///< 0xRRGGBB
    double brightness = 1;                    ///< at the lamp itself; 1 adds as much as full light
    double reach = 0;                         ///< on the point grid, > 0 [m]
    std::optional<LightEffectRecord> effect;  ///< none: it is steady
};

/// Light from one direction that falls on every surface that faces it, of the sectors that name it. It throws no
/// shadows.
struct Sun {
    Vec2 level;                      ///< towards it, its part in the plane: as long as the cosine of its elevation
    double up = 0;                   ///< the sine of its elevation, 0..1
    std::uint32_t color = 0xFFFFFF;  ///< 0xRRGGBB
    double brightness = 1;           ///< on what faces it; 1 adds as much as full light
};

/// Where the player starts.
struct PlayerStart {
    SectorId sector;
    Vec2 position;     ///< on the point grid
    double eye_z = 0;  ///< [m]
    Angle yaw;
};

struct Map {
    std::string name;
    std::vector<Sector> sectors;
    std::vector<Wall> walls;
    std::vector<Surface> surfaces;     ///< of walls and flats, each different one once
    std::vector<Rigid> links;          ///< what each linked portal or mirror does to what is seen through it
    std::vector<GridMap> grid_links;   ///< portals: the same for what moves through it; index as in links
    std::vector<Surface> flat_layers;  ///< they scroll as the flats that they are laid over
    std::vector<Panel> panels;         ///< by sector, each sector's in the order of the file
    std::vector<Thing> things;
    std::vector<Sprite> sprites;
    std::vector<PointLight> lights;
    std::vector<Sun> suns;
    std::vector<ThingId> solid_things;      ///< by sector, each sector's in the order of their numbers
    std::vector<NearThing> near_things;     ///< solid things that bodies in a sector may touch, by sector
    std::vector<std::uint32_t> first_near;  ///< those of sector i are near_things[first_near[i]] to, not with,
                                            ///< near_things[first_near[i + 1]]; empty: there are no solid things
    std::vector<ThingId> touchables;        ///< by sector, each sector's in the order of their numbers
    std::vector<Trigger> triggers;          ///< first those of sectors, then of walls, of panels and of things
    std::vector<SectorId> targets;          ///< of triggers, list after list
    std::vector<TriggerId> at_start;        ///< those that the start of the map sets off
    std::vector<Sound> sounds;
    std::vector<ThingId> sounding_things;  ///< by sector, each sector's in the order of their numbers
    bool has_ways_back = false;            ///< some walls are one
    double farthest_sound_m = 0;           ///< largest reach among the sounds; 0: there are none
    bool has_bobs = false;                 ///< a floor or ceiling bobs
    std::vector<std::string> keys;         ///< names of the keys that triggers ask for or things give
    PictureChanges pictures;
    std::optional<PlayerStart> player;
    RenderRecord render;

    // Ids are of this map and not none, which is not checked; of a surface it may be none.
    const Sector& operator[](SectorId id) const { return sectors[id.index]; }
    const Wall& operator[](WallId id) const { return walls[id.index]; }
    /// None: what has no texture.
    const Surface& operator[](SurfaceId id) const { return id ? surfaces[id.index] : kNoSurface; }
    const Panel& operator[](PanelId id) const { return panels[id.index]; }
    const Thing& operator[](ThingId id) const { return things[id.index]; }
    const Sprite& operator[](SpriteId id) const { return sprites[id.index]; }
    const Sun& operator[](SunId id) const { return suns[id.index]; }
    const Trigger& operator[](TriggerId id) const { return triggers[id.index]; }
    const Sound& operator[](SoundId id) const { return sounds[id.index]; }
    /// The solid things that a body may touch whose middle is in the sector.
    std::span<const NearThing> near(SectorId sector) const {
        if (first_near.empty()) return {};
        const std::uint32_t first = first_near[sector.index];
        return std::span(near_things).subspan(first, first_near[sector.index + 1] - first);
    }
    /// The sectors that the trigger is about.
    std::span<const SectorId> targets_of(const Trigger& trigger) const {
        return std::span(targets).subspan(trigger.targets.first, trigger.targets.count);
    }
    /// The link's transform, or the identity.
    Rigid passage(const Wall& wall) const { return wall.link == Wall::kNoLink ? Rigid{} : links[wall.link]; }
    /// Where a point on the point grid comes to lie behind the portal: on the grid, and carried back exactly by the
    /// way back.
    Vec2 carried(const Wall& portal, Vec2 point) const {
        return portal.link == Wall::kNoLink ? point : grid_links[portal.link].apply(point);
    }
};

/// Calls visit(id) for each sector of its group, itself first: for itself alone where it has none.
/// visit leaves the map as it is.
template <class Visit>
void each_of_group(const Map& map, SectorId sector, Visit visit) {
    SectorId member = sector;
    do {
        visit(member);
        member = map[member].next_of_group;
    } while (member != sector);
}

}  // namespace enfilade
