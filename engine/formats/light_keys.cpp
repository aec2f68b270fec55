// The keys of point lights and suns.
#include <array>

#include "formats/color_key.h"
#include "formats/map_keys.h"

namespace enfilade {
namespace {

constexpr auto kNew = Dialect::enfilade;

/// How far a light may reach [m]: all surfaces it reaches hold a few thousand numbers each.
constexpr Range kLightReaches{0x1p-4, 64};

/// Twice as bright as painted is as bright as anything gets.
constexpr Range kBrightnesses{0, 2};

constexpr std::array kPointLightKeys{
    key<&PointLightRecord::sector>("sector", kNew),
    key<&PointLightRecord::position, &Vec2::x>("x", kNew, Need::required, kPositions),
    key<&PointLightRecord::position, &Vec2::y>("y", kNew, Need::required, kPositions),
    key<&PointLightRecord::z>("z", kNew, Need::required, kHeights),
    color_key<&PointLightRecord::color>("color", kNew),
    key<&PointLightRecord::brightness>("brightness", kNew, Need::optional, kBrightnesses),
    key<&PointLightRecord::reach>("reach", kNew, Need::optional, kLightReaches),
    key<&PointLightRecord::effect>("effect", kNew),
};

constexpr std::array kSunKeys{
    key<&SunRecord::name>("name", kNew, Need::required),
    key<&SunRecord::yaw_degrees>("yaw", kNew, Need::optional, kAngles),
    key<&SunRecord::elevation_degrees>("elevation", kNew, Need::optional, {0, 90}),
    color_key<&SunRecord::color>("color", kNew),
    key<&SunRecord::brightness>("brightness", kNew, Need::optional, kBrightnesses),
};

constexpr KeyList<PointLightRecord> kPointLightList{"a light", kPointLightKeys};
constexpr KeyList<SunRecord> kSunList{"a sun", kSunKeys};

}  // namespace

template <>
const KeyList<PointLightRecord>& keys_of() {
    return kPointLightList;
}

template <>
const KeyList<SunRecord>& keys_of() {
    return kSunList;
}

}  // namespace enfilade
