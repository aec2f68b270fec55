// F3: how long pictures take, where the player is, and the outlines of the picture's viewports. F7: what a pixel shows.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/draw/overlay.h"
#include "app/play/settings.h"
#include "map/map.h"
#include "render/choice/renderer.h"
#include "world/world.h"

namespace enfilade {

// What the player is told while playing: messages, health, keys.

/// The message as a sentence; empty where it is shown otherwise.
std::string message_text(const Map& map, const PlayerMessage& message);

/// At the left, above the row `bottom`: health, once it is less than full, and the keys one has. Nothing in a map
/// without either.
void draw_status(Overlay& overlay, const Map& map, const World& world, int bottom);

/// Above the middle, not above the row `top`: where one flies.
void draw_flight(Overlay& overlay, const std::string& text, int top);

/// A red shade over everything. strength : 0..1
void draw_hurt(Overlay& overlay, double strength);

/// Across the middle: that one is dead, and which keys help; or how far back one has gone [s].
void draw_death(Overlay& overlay, const Bindings& bindings);
void draw_rewind(Overlay& overlay, double seconds_back);

/// F1: what all keys do, in the middle, on a panel. lines : keys, and what they do
void draw_keys(Overlay& overlay, const std::vector<std::pair<std::string, std::string>>& lines);
/// The scale at which so many lines fit into a picture of this height.
int scale_for_lines(std::size_t lines, int height_px);

/// The last second or so of frame times.
class FrameTimes {
public:
    /// draw_ns: the renderer alone. shown_ns: when the picture was presented.
    void add(std::int64_t draw_ns, std::int64_t shown_ns);

    struct Summary {
        double mean_draw_ms = 0, worst_draw_ms = 0;
        double per_second = 0;  ///< pictures presented
    };
    Summary summary() const;

private:
    static constexpr std::size_t kKept = 60;  ///< frames: about a second
    std::array<std::int64_t, kKept> draw_ns_{}, shown_ns_{};
    std::size_t count_ = 0;
};

/// What the read-out tells besides times.
struct ReadoutFacts {
    std::string sector, renderer;
    double x = 0, y = 0, eye_z = 0, yaw_degrees = 0, pitch_degrees = 0;
};

/// The row at which it begins, from the lower edge.
int draw_readout(Overlay& overlay, const FrameTimes& times, const ReadoutFacts& facts,
                 const std::vector<ViewportShape>& viewports);

/// A small cross around a pixel, and above the row `bottom` what is there, wrapped; the row at which that begins.
int draw_pointed(Overlay& overlay, int x, int y, const std::string& text, int bottom);

// Short messages on the screen: "saved enfilade-0003.png", or what is wrong with a map that was just saved.

class Notices {
public:
    /// Shown at the top until `seconds` after now [s].
    void say(std::string text, double now_s, double seconds = 3);

    /// The same, instead of the one before about the same: of something that changes step by step.
    void update(std::string_view about, std::string text, double now_s, double seconds = 3);

    /// A panel that stays until it is replaced; empty lines take it away.
    void pin(std::vector<std::string> lines) { pinned_ = std::move(lines), is_new_ = true; }

    /// Whether they look different from when they were drawn last.
    bool have_changed(double now_s) const;

    /// The row below them. with_panel: false where something else covers it
    int draw(Overlay& overlay, double now_s, bool with_panel = true);

private:
    struct Notice {
        std::string text;
        double until_s;
        std::string about{};  ///< may be empty
    };
    std::vector<Notice> notices_;
    std::vector<std::string> pinned_;
    bool is_new_ = false;
};

// What one sees when a map lies behind one.

/// How a map went, and where it goes on.
struct MapEnd {
    std::string left, next;  ///< names; next: as the exit says it, may be empty
    std::string next_path;   ///< empty: it is not there
    double seconds = 0;
    std::size_t found = 0, secrets = 0;
};

/// How many secrets there are to find: sectors that move as one are one.
std::size_t count_of_secrets(const Map& map);

/// Time, secrets, the next map, and what to press.
void draw_end(Overlay& overlay, const MapEnd& end);

}  // namespace enfilade
