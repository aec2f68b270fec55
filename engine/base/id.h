// Indices that cannot be mixed up: a sector's number is not a wall's number.
#pragma once
#include <compare>
#include <cstdint>

namespace enfilade {

/// A 32-bit index into one kind of vector, with a "none" value.
template <class Tag>
struct Id {
    static constexpr std::uint32_t kNone = 0xFFFFFFFFu;

    std::uint32_t index = kNone;

    constexpr Id() = default;
    constexpr explicit Id(std::uint32_t i) : index(i) {}
    /// i < kNone; of a larger one the upper bits are lost.
    constexpr explicit Id(std::size_t i) : index(static_cast<std::uint32_t>(i)) {}

    constexpr bool is_none() const { return index == kNone; }
    constexpr explicit operator bool() const { return index != kNone; }
    constexpr auto operator<=>(const Id&) const = default;
};

using SectorId = Id<struct SectorTag>;
using WallId = Id<struct WallTag>;
using TextureId = Id<struct TextureTag>;
using ThingId = Id<struct ThingTag>;
using SpriteId = Id<struct SpriteTag>;
using PanelId = Id<struct PanelTag>;
using SoundId = Id<struct SoundTag>;
using SunId = Id<struct SunTag>;
using TriggerId = Id<struct TriggerTag>;
using SurfaceId = Id<struct SurfaceTag>;  ///< of a Surface: how a picture lies

}  // namespace enfilade
