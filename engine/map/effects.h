// What can happen in a map, resolved: triggers with the sectors they are about, pictures that change with time,
// and sounds.
// Nothing of it moves here; world/ says when and how.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/id.h"
#include "formats/effect_records.h"

namespace enfilade {

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
    std::optional<double> light;
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

/// Some of Map::triggers: [first, first + count).
struct TriggerRange {
    std::uint32_t first = 0, count = 0;
};

/// Something that can be heard. The fields mean what they mean in SoundRecord.
struct Sound {
    std::string name, file;
    double volume = 1;
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

}  // namespace enfilade
