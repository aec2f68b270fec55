// The words that stand for enumerated values in files: one for each value, for reading and for writing. A value without
// a word does not compile, because a switch has to name all of them.
#pragma once
#include <array>
#include <string_view>
#include <type_traits>

#include "formats/dials.h"
#include "formats/map_file.h"
#include "formats/script.h"

namespace enfilade {

constexpr std::string_view to_word(Peg value) {
    switch (value) {
        case Peg::ceiling: return "ceiling";
        case Peg::floor: return "floor";
        case Peg::opening_top: return "opening_top";
        case Peg::opening_bottom: return "opening_bottom";
    }
    return {};
}

constexpr std::string_view to_word(LightModel value) {
    switch (value) {
        case LightModel::smooth: return "smooth";
        case LightModel::classic: return "classic";
    }
    return {};
}

constexpr std::string_view to_word(SkyRows value) {
    switch (value) {
        case SkyRows::round: return "round";
        case SkyRows::straight: return "straight";
    }
    return {};
}

constexpr std::string_view to_word(RayPoint value) {
    switch (value) {
        case RayPoint::middle: return "middle";
        case RayPoint::corner: return "corner";
    }
    return {};
}

constexpr std::string_view to_word(ThingEdges value) {
    switch (value) {
        case ThingEdges::cut: return "cut";
        case ThingEdges::whole: return "whole";
    }
    return {};
}

constexpr std::string_view to_word(Ease value) {
    switch (value) {
        case Ease::smooth: return "smooth";
        case Ease::linear: return "linear";
    }
    return {};
}

constexpr std::string_view to_word(Press value) {
    switch (value) {
        case Press::none: return "none";
        case Press::use: return "use";
    }
    return {};
}

constexpr std::string_view to_word(RendererKind value) {
    switch (value) {
        case RendererKind::column: return "column";
        case RendererKind::stencil: return "stencil";
        case RendererKind::reference: return "reference";
    }
    return {};
}

constexpr std::string_view to_word(Activation value) {
    switch (value) {
        case Activation::use: return "use";
        case Activation::cross: return "cross";
        case Activation::enter: return "enter";
        case Activation::touch: return "touch";
        case Activation::start: return "start";
    }
    return {};
}

constexpr std::string_view to_word(TriggerAction value) {
    switch (value) {
        case TriggerAction::door: return "door";
        case TriggerAction::open: return "open";
        case TriggerAction::close: return "close";
        case TriggerAction::close_then_open: return "close_then_open";
        case TriggerAction::lift: return "lift";
        case TriggerAction::shuttle: return "shuttle";
        case TriggerAction::floor: return "floor";
        case TriggerAction::ceiling: return "ceiling";
        case TriggerAction::crush: return "crush";
        case TriggerAction::stairs: return "stairs";
        case TriggerAction::stop: return "stop";
        case TriggerAction::light: return "light";
        case TriggerAction::teleport: return "teleport";
        case TriggerAction::leave_map: return "exit";
        case TriggerAction::sound: return "sound";
    }
    return {};
}

constexpr std::string_view to_word(HeightLevel value) {
    switch (value) {
        case HeightLevel::here: return "here";
        case HeightLevel::lowest_floor: return "lowest_floor";
        case HeightLevel::highest_floor: return "highest_floor";
        case HeightLevel::next_floor_up: return "next_floor_up";
        case HeightLevel::next_floor_down: return "next_floor_down";
        case HeightLevel::lowest_ceiling: return "lowest_ceiling";
        case HeightLevel::highest_ceiling: return "highest_ceiling";
        case HeightLevel::floor: return "floor";
        case HeightLevel::ceiling: return "ceiling";
        case HeightLevel::lowest_ceiling_or_own: return "lowest_ceiling_or_own";
    }
    return {};
}

constexpr std::string_view to_word(LightLevel value) {
    switch (value) {
        case LightLevel::given: return "given";
        case LightLevel::brightest: return "brightest";
        case LightLevel::darkest: return "darkest";
    }
    return {};
}

constexpr std::string_view to_word(LightKind value) {
    switch (value) {
        case LightKind::flicker: return "flicker";
        case LightKind::strobe: return "strobe";
        case LightKind::glow: return "glow";
        case LightKind::fire: return "fire";
    }
    return {};
}

constexpr std::string_view to_word(BobShape value) {
    switch (value) {
        case BobShape::sine: return "sine";
        case BobShape::triangle: return "triangle";
    }
    return {};
}

constexpr std::string_view to_word(HoldsUp value) {
    switch (value) {
        case HoldsUp::all: return "all";
        case HoldsUp::all_but_crushers: return "all_but_crushers";
        case HoldsUp::nothing: return "nothing";
    }
    return {};
}

constexpr std::string_view to_word(NumberKind value) {
    switch (value) {
        case NumberKind::real64: return "double";
        case NumberKind::real32: return "float";
        case NumberKind::fixed16: return "fixed";
        case NumberKind::vanilla: return "vanilla";
    }
    return {};
}

constexpr std::string_view to_word(Sampling value) {
    switch (value) {
        case Sampling::nearest: return "nearest";
        case Sampling::mip: return "mip";
        case Sampling::bilinear: return "bilinear";
        case Sampling::trilinear: return "trilinear";
    }
    return {};
}

constexpr std::string_view to_word(LightSteps value) {
    switch (value) {
        case LightSteps::as_map: return "map";
        case LightSteps::smooth: return "smooth";
        case LightSteps::bands: return "bands";
    }
    return {};
}

constexpr std::string_view to_word(FogSteps value) {
    switch (value) {
        case FogSteps::smooth: return "smooth";
        case FogSteps::bands: return "bands";
    }
    return {};
}

constexpr std::string_view to_word(TickRate value) {
    switch (value) {
        case TickRate::hz60: return "60";
        case TickRate::hz35: return "35";
        case TickRate::hz140: return "140";
    }
    return {};
}

constexpr std::string_view to_word(CrossingMethod value) {
    switch (value) {
        case CrossingMethod::exact: return "exact";
        case CrossingMethod::naive: return "naive";
    }
    return {};
}

constexpr std::string_view to_word(PortalMethod value) {
    switch (value) {
        case PortalMethod::exact: return "exact";
        case PortalMethod::plane24: return "plane24";
        case PortalMethod::plane32: return "plane32";
        case PortalMethod::oblique24: return "oblique24";
        case PortalMethod::oblique32: return "oblique32";
    }
    return {};
}

/// A type whose values are words in files.
template <class T>
concept Word = std::is_enum_v<T> && requires(T value) { to_word(value); };

/// How many values it has: 0, 1, 2 and so on, as long as they have a word.
template <Word W>
constexpr std::size_t count_of_words() {
    std::size_t count = 0;
    while (!to_word(static_cast<W>(count)).empty()) ++count;
    return count;
}

/// The words of all values, in their order.
template <Word W>
inline constexpr auto kWords = [] {
    std::array<std::string_view, count_of_words<W>()> words;
    for (std::size_t i = 0; i < words.size(); ++i) words[i] = to_word(static_cast<W>(i));
    return words;
}();

}  // namespace enfilade
