#include "app/play/settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "formats/script.h"
#include "formats/text_parts.h"
#include "formats/words.h"

namespace enfilade {
namespace {

constexpr std::array<std::string_view, 2> kSwitch{"off", "on"};
constexpr std::array<std::string_view, 2> kPlayRenderers{"column", "stencil"};
constexpr std::array<std::string_view, 2> kAutomapWords{"usual", "safe"};
constexpr std::array<std::string_view, 3> kAccuracies{"exact", "fine", "fast"};
constexpr std::array<std::string_view, 5> kTextureFilters{"map", "nearest", "mip", "bilinear", "trilinear"};
constexpr std::string_view kAsWindow = "window";

/// What the menu goes through; a file or an option may name any other.
constexpr PictureSize kSizes[] = {{320, 200}, {640, 400}, {960, 600}, {1280, 800}, {1920, 1200}};

Result<void> not_one_of(std::span<const std::string_view> words, std::string_view found) {
    return Error{"", fmt::format("expected {}; found {}", fmt::join(words, " or "), in_quotes(found))};
}

std::optional<std::size_t> index_of(std::span<const std::string_view> words, std::string_view word) {
    const auto found = std::ranges::find(words, word);
    if (found == words.end()) return {};
    return std::size_t(found - words.begin());
}

std::optional<bool> truth_of(std::string_view text) {
    if (text == "on" || text == "true" || text == "yes") return true;
    if (text == "off" || text == "false" || text == "no") return false;
    return {};
}

template <auto Field>
constexpr Setting flag(std::string_view name, std::string_view label, std::string_view help) {
    Setting row{name, label, help};
    row.is_flag = true;
    row.text = [](const Setting&, const Settings& all) { return std::string(kSwitch[all.*Field]); };
    row.read = [](const Setting&, std::string_view text, Settings& all) -> Result<void> {
        const auto truth = truth_of(text);
        if (!truth) return not_one_of(kSwitch, text);
        all.*Field = *truth;
        return {};
    };
    row.turn = [](const Setting&, int, Settings& all) { all.*Field = !(all.*Field); };
    return row;
}

/// On whole steps, so that ten of a tenth are one.
double on_steps(const Setting& row, double value) {
    return std::clamp(std::round(value / row.step) * row.step, row.low, row.high);
}

template <auto Field>
constexpr Setting number(std::string_view name, std::string_view label, std::string_view help, double low, double high,
                         double step) {
    Setting row{name, label, help, low, high, step};
    row.text = [](const Setting&, const Settings& all) { return fmt::format("{:.6g}", all.*Field); };
    row.read = [](const Setting& of, std::string_view text, Settings& all) -> Result<void> {
        const auto value = parse_number(text);
        const bool is_whole = of.step < 1 || (value && *value == std::floor(*value));
        if (!value || *value < of.low || *value > of.high || !is_whole)
            return Error{"", fmt::format("expected a {} from {:g} to {:g}; found {}",
                                         of.step < 1 ? "number" : "whole number", of.low, of.high, in_quotes(text))};
        all.*Field = *value;
        return {};
    };
    row.turn = [](const Setting& of, int steps, Settings& all) {
        all.*Field = on_steps(of, all.*Field + steps * of.step);
    };
    return row;
}

template <auto Field, const auto& Words>
constexpr Setting choice(std::string_view name, std::string_view label, std::string_view help) {
    using Value = std::remove_cvref_t<decltype(Settings{}.*Field)>;
    Setting row{name, label, help};
    row.is_word = true;
    row.text = [](const Setting&, const Settings& all) {
        return std::string(Words[static_cast<std::size_t>(all.*Field)]);
    };
    row.read = [](const Setting&, std::string_view text, Settings& all) -> Result<void> {
        const auto index = index_of(Words, text);
        if (!index) return not_one_of(Words, text);
        all.*Field = static_cast<Value>(*index);
        return {};
    };
    row.turn = [](const Setting&, int steps, Settings& all) {
        const int count = static_cast<int>(Words.size());
        all.*Field = static_cast<Value>(((static_cast<int>(all.*Field) + steps) % count + count) % count);
    };
    return row;
}

std::string size_text(const Setting&, const Settings& all) {
    return all.size ? fmt::format("{}x{}", all.size->width, all.size->height) : std::string(kAsWindow);
}

Result<void> read_size(const Setting&, std::string_view text, Settings& all) {
    if (text == kAsWindow) {
        all.size.reset();
        return {};
    }
    const auto size = parse_size(std::string(text));
    if (!size.ok()) return Error{"", size.error().what + ", or \"window\""};
    all.size = size.value();
    return {};
}

/// The window's own comes before the first.
void turn_size(const Setting&, int steps, Settings& all) {
    const auto count = static_cast<int>(std::size(kSizes)) + 1;
    const auto* const found = all.size ? std::ranges::find(kSizes, *all.size) : nullptr;
    const int now = all.size ? static_cast<int>(found - kSizes) % (count - 1) + 1 : 0;
    const int next = ((now + steps) % count + count) % count;
    all.size.reset();
    if (next > 0) all.size = kSizes[next - 1];
}

constexpr Setting size_row() {
    Setting row{"size", "Picture size",
                "WIDTHxHEIGHT of the picture in pixels, scaled to the window; \"window\": as large as the window"};
    row.text = size_text;
    row.read = read_size;
    row.turn = turn_size;
    row.is_word = true;
    return row;
}

constexpr Setting kSettings[] = {
    choice<&Settings::renderer, kPlayRenderers>("renderer", "Renderer", "column (by the CPU) or stencil (by OpenGL)"),
    number<&Settings::samples>("samples", "Samples",
                               "Each pixel shows the mean of N x N rays: smooth edges, in N x N times the time", 1,
                               kMostSamples, 1),
    choice<&Settings::accuracy, kAccuracies>(
        "accuracy", "Accuracy",
        "How far texels may be off, by the column renderer: exact, fine (a quarter of a texel) or fast (one)"),
    choice<&Settings::sampling, kTextureFilters>(
        "sampling", "Texture filter",
        "map (mip, but nearest in maps of Doom's light), nearest (as painted), mip (distant pictures made "
        "smaller, so that floors do not glitter), bilinear (texels "
        "blended with their neighbours) or trilinear (both, without steps), by the column renderer"),
    size_row(),
    number<&Settings::scale>(
        "scale", "Pixel size",
        "Where the size is \"window\": so many of its pixels along each side of one of the picture", 1, 8, 1),
    flag<&Settings::fullscreen>("fullscreen", "Full screen", "Fill the screen"),
    flag<&Settings::vsync>("vsync", "Wait for display",
                           "Show pictures through the graphics card, where there is one, when the display is ready"),
    number<&Settings::frame_limit>("frame_limit", "Frame limit",
                                   "At most so many pictures in a second; 0: as often as the display shows", 0, 1000,
                                   10),
    number<&Settings::fov_degrees>("fov", "Field of view", "Horizontal field of view in degrees", kSmallestFov,
                                   kLargestFov, 5),
    flag<&Settings::true_pitch>("true_pitch", "True pitch",
                                "Looking up and down turns the picture, as a head turns, instead of shifting the "
                                "horizon: upright lines converge. Drawn by stencil"),
    number<&Settings::brightness>("brightness", "Brightness", "Above 1 lifts what is dark, below 1 deepens it", 0.5, 2,
                                  0.1),
    number<&Settings::view_bob>("view_bob", "View bob", "How far the view goes up and down as one walks; 0: not at all",
                                0, 1, 0.25),
    number<&Settings::mouse_speed>("mouse_speed", "Mouse speed", "How far the mouse turns the head", 0.2, 5, 0.2),
    flag<&Settings::invert_mouse>("invert_mouse", "Invert mouse",
                                  "Pulling the mouse or the right stick towards oneself looks up"),
    number<&Settings::volume>("volume", "Volume", "Of all sounds; 0: silent", 0, 1, 0.1),
    choice<&Settings::automap_colors, kAutomapWords>("automap_colors", "Automap colors",
                                                     "usual, or safe: colors that color-blind eyes tell apart, too"),
    flag<&Settings::pause_when_away>("pause_when_away", "Pause when away",
                                     "The game stands still while another window has the focus"),
};

using enum KeyCode;

constexpr ControlInfo kControlInfos[kControls] = {
    {"forward", "Walk forward", {w, up}},
    {"back", "Walk back", {s, down}},
    {"step_left", "Step left", {a, unknown}},
    {"step_right", "Step right", {d, unknown}},
    {"turn_left", "Turn left", {left, unknown}},
    {"turn_right", "Turn right", {right, unknown}},
    {"look_up", "Look up", {page_up, unknown}},
    {"look_down", "Look down", {page_down, unknown}},
    {"look_ahead", "Look ahead", {home, unknown}},
    {"run", "Run", {left_shift, right_shift}},
    {"slowly", "Walk slowly", {left_alt, right_alt}},
    {"crouch", "Crouch", {c, left_control}},
    {"use", "Use", {e, space}},
    {"rewind", "Back in time, held", {r, unknown}},
    {"automap", "Map", {tab, unknown}},
    {"zoom_in", "Zoom in", {plus, unknown}},
    {"zoom_out", "Zoom out", {minus, unknown}},
    {"save", "Save", {f5, unknown}},
    {"load", "Load", {f9, unknown}},
    {"show_keys", "Show keys", {f1, unknown}},
    {"change_renderer", "Change renderer", {f2, unknown}},
    {"readout", "Times and place", {f3, unknown}},
    {"outside", "View from outside", {f4, unknown}},
    {"outside_side", "From above, behind", {f6, unknown}},
    {"pixel", "What a pixel shows", {f7, unknown}},
    {"fly", "Fly through walls", {f8, unknown}},
    {"fullscreen", "Full screen", {f11, unknown}},
    {"screenshot", "Save a picture", {f12, unknown}},
};

}  // namespace

const ControlInfo& info_of(Control control) { return kControlInfos[static_cast<std::size_t>(control)]; }

std::optional<Control> control_named(std::string_view name) {
    const auto* const found = std::ranges::find(kControlInfos, name, &ControlInfo::name);
    if (found == std::end(kControlInfos)) return {};
    return static_cast<Control>(found - kControlInfos);
}

Bindings usual_bindings() {
    Bindings bindings{};
    std::ranges::transform(kControlInfos, bindings.begin(), &ControlInfo::usual);
    return bindings;
}

std::string keys_text(const ControlKeys& keys) {
    std::string text;
    for (const KeyCode key : keys)
        if (key != unknown) text += (text.empty() ? "" : ", ") + std::string(name_of(key));
    return text.empty() ? "none" : text;
}

void bind(Bindings& bindings, Control control, KeyCode key) {
    for (ControlKeys& keys : bindings) std::ranges::replace(keys, key, unknown);
    ControlKeys& keys = bindings[static_cast<std::size_t>(control)];
    keys = {key, keys[0] == unknown ? keys[1] : keys[0]};
}

std::span<const Setting> all_settings() { return kSettings; }

const Setting& setting_named(std::string_view name) {
    const auto* const found = std::ranges::find(kSettings, name, &Setting::name);
    ENFILADE_CHECK(found != std::end(kSettings));
    return *found;
}

Sampling sampling_of(TextureFilter filter, const Map& map) {
    switch (filter) {
        case TextureFilter::as_map: break;
        case TextureFilter::nearest: return Sampling::nearest;
        case TextureFilter::mip: return Sampling::mip;
        case TextureFilter::bilinear: return Sampling::bilinear;
        case TextureFilter::trilinear: return Sampling::trilinear;
    }
    return map.render.light == LightModel::classic ? Sampling::nearest : Sampling::mip;
}

Dials dials_of(const Settings& settings, RendererKind kind, const Map& map) {
    Dials dials;
    dials.samples = static_cast<int>(settings.samples);
    if (kind != RendererKind::column) return dials;
    ENFILADE_CHECK(set_accuracy(dials, kAccuracies[static_cast<std::size_t>(settings.accuracy)]).ok());
    dials.sampling = sampling_of(settings.sampling, map);
    return dials;
}

std::string option_of(const Setting& setting) {
    std::string name = "--" + std::string(setting.name);
    std::ranges::replace(name, '_', '-');
    return name;
}

void keep_changes(const Settings& before, const Settings& now, Settings& kept) {
    for (const Setting& row : kSettings)
        if (row.text(row, now) != row.text(row, before)) static_cast<void>(row.read(row, row.text(row, now), kept));
    for (std::size_t i = 0; i < now.bindings.size(); ++i)
        if (now.bindings[i] != before.bindings[i]) kept.bindings[i] = now.bindings[i];
}

}  // namespace enfilade
