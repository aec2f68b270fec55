// How long pictures take to draw: many of them, over and over and in turn, so that what else the machine does troubles
// all of them alike. And what of it each effect of a map costs.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/open_map.h"
#include "base/result.h"
#include "formats/map_file.h"
#include "map/map.h"
#include "map/textures.h"
#include "render/frame.h"

namespace enfilade {

// What `enfilade bench` measures: a map, a walk through one, or a flythrough.

/// A map with what its player sees at the start, a map with a list of views, or a flythrough. Open until it goes.
class BenchSubject {
public:
    /// name : MAP, SCRIPT or MAP:WALK.csv, the views of which formats/views_csv.h reads. None where a file has errors,
    /// which then are on stderr.
    static std::optional<BenchSubject> open(const std::string& name, const std::vector<std::string>& texture_folders,
                                            Talk talk = Talk::usual);

    const Map& map() const { return flight_ ? flight_->map.map : map_->map; }
    const TextureSet& textures() const { return flight_ ? flight_->map.textures : map_->textures; }
    /// How many pictures there are, >= 1.
    int frames() const { return flight_ ? flight_->flight.frames() : static_cast<int>(views_.size()); }
    /// number : in [0, frames()). Of a map and a walk the world is that of the start.
    FlightFrame frame(int number) const;

private:
    std::optional<OpenFlight> flight_;
    std::optional<OpenMap> map_;
    std::vector<View> views_;
    Snapshot snapshot_;
};

/// The map and the list of a subject's name MAP:WALK.csv; none where it is another one.
struct WalkName {
    std::string map, views;
};
std::optional<WalkName> walk_name(const std::string& name);

/// What a picture shows, and how much of it there is to draw.
struct BenchCounts {
    std::uint64_t hash = 0;     ///< of the picture (render/frame.h)
    std::size_t pixels = 0;     ///< drawn by the opaque pass
    std::size_t walls = 0;      ///< seen, each once, however many parts of it
    std::size_t runs = 0;       ///< of one surface down one column of the finished picture
    std::size_t viewports = 0;  ///< 0 where the renderer has none
};

/// Of a picture that was drawn with facts: all but `viewports`, which its renderer knows.
BenchCounts counts_of(const Map& map, const Frame& frame, const FrameFacts& facts);

/// One picture of a map, walk or script.
struct BenchFrame {
    std::size_t subject = 0;  ///< which of those that are measured
    int number = 0;           ///< of the frame; a map has one
    std::int64_t minimum_ns = 0, median_ns = 0;
    BenchCounts counts{};
};

/// Draws one frame of a subject and says how long that alone took [ns]. is_counted: false the first time.
using TimedDrawing = std::function<Result<std::int64_t>(std::size_t subject, int number, bool is_counted)>;

/// The frames of subjects that have so many, in the order in which they are drawn: one of each in turn.
std::vector<BenchFrame> frames_in_turn(const std::vector<int>& counts);

/// Draws all frames `rounds` times, >= 1, and once before, uncounted, so that no frame pays for memory that grows.
/// Shows on a terminal how far it is. The first error ends it.
Result<void> measure(std::vector<BenchFrame>& frames, std::size_t rounds, const TimedDrawing& draw,
                     Talk talk = Talk::usual);

/// The middle of the times, of an even number the lower one. times: at least one; their order is lost.
std::int64_t median_of(std::vector<std::int64_t>& times);

/// `subject,frame,minimum_ns,median_ns,walls,runs,viewports,pixels,hash`, a line for each frame. Subjects with a comma,
/// quote or line end are quoted.
std::string bench_csv(const std::vector<std::string>& subjects, const std::vector<BenchFrame>& frames);

/// A line for each subject: how many frames, the means of their minimum and median, the slowest, nanoseconds for each
/// pixel (of the minima), the means of their counts, and one hash of all its pictures.
std::string bench_table(const std::vector<std::string>& subjects, const std::vector<BenchFrame>& frames);

// What `enfilade bench` lets other processes measure: another program beside this one, and instructions.

// Two programs that take turns: what each says of one pass over all frames, and how they compare.

/// One frame of one pass.
struct PassFrame {
    std::string subject;
    int number = 0;
    std::int64_t ns = 0;
    std::optional<std::string> hash;  ///< of the picture; none where the program is too old to tell
    bool is_same_frame(const PassFrame& other) const { return subject == other.subject && number == other.number; }
};

/// The rows of bench_csv() in what a program said, which may hold other lines: words for people. An error where there
/// is no such row. program : for the message. Any bytes are safe.
Result<std::vector<PassFrame>> read_pass(const std::string& program, std::string_view said);

/// What two programs said in turn; all passes are of the same frames.
using Passes = std::vector<std::vector<PassFrame>>;

/// An error where the programs, or two passes of one, did not draw the same frames.
Result<void> compare_frames(const std::array<std::string, 2>& programs, const std::array<Passes, 2>& passes);

/// A line for each subject: the means over its frames of each program's minimum and median, the ratios of the first
/// program's to the second's, and how many pictures differ; last, the means over the subjects.
/// passes : as compare_frames() wants them, each with at least one.
std::string comparison_table(const std::array<Passes, 2>& passes);

/// What the children are told to measure.
struct ChildBench {
    std::vector<std::string> subjects;  ///< at least one
    std::vector<std::string> options;   ///< of `bench`, but for --rounds and --csv
    std::size_t rounds = 1;             ///< >= 1
    std::size_t pixels = 1;             ///< of one picture
};

/// This program and the other one measure the same in turn, pass by pass, each as a process of its own, this one
/// first in every other pass. The comparison as a table, or an error where the other one cannot: too old, perhaps.
Result<std::string> compare_with(const std::string& other, const ChildBench& bench);

/// The function whose instructions count_instructions() counts; see bench_command.cpp.
inline constexpr const char* kMeasuredFunction = "*draw_measured*";

/// Instructions that the renderer takes for a pixel of one subject; see below.
Result<double> instructions_per_pixel(const std::string& subject, const ChildBench& bench);

/// Instructions that the renderer takes for a pixel of each subject, counted by valgrind on one thread, as a table.
/// Counted is drawing alone, of frames that were drawn before, uncounted: memory for them does not grow any more. Two
/// counts agree within 0.1 %. Takes about fifty times as long as drawing.
/// An error where valgrind is not installed.
Result<std::string> count_instructions(const ChildBench& bench);

// What a map calls for beyond plain rooms, and what each of it costs, measured: the same views drawn with each effect
// and without it.

/// One kind of effect.
struct Effect {
    const char* name;     ///< "linked portals"
    const char* counted;  ///< what is counted, one of it: "wall"
    const char* cost;     ///< in words: what is paid, and when
    /// How many of them the map has.
    std::size_t (*count)(const MapFile&);
    /// Takes it out of the map, so that the map can be drawn without it; null: then it would be another map.
    void (*take_out)(MapFile&);
};

/// All kinds, in a fixed order.
const std::vector<Effect>& all_effects();

/// One kind of effect that a map uses.
struct EffectUse {
    const Effect* effect;
    std::size_t count;  ///< > 0
};

/// In the order of all_effects(); what the map does not use is not in the list.
std::vector<EffectUse> effects_in(const MapFile& map);

/// What one effect costs. A look shows it where its picture is another one without it.
struct Price {
    std::size_t looks = 0;         ///< that show it
    std::optional<double> seen;    ///< of a frame that shows it; none where none does [ms]
    std::optional<double> unseen;  ///< of a frame that does not; none where all do [ms]
};

struct EffectPrice {
    EffectUse use;
    std::optional<Price> price;  ///< none where it cannot be taken out
};

struct Prices {
    int width = 0, height = 0;  ///< of the pictures [px]
    std::size_t looks = 0;      ///< how many were drawn
    double frame_ms = 0;        ///< of a frame with everything [ms]
    std::vector<EffectPrice> effects;
};

/// How prices are measured.
struct PriceChoices {
    int width = 640, height = 400;  ///< of the pictures [px]
    /// How often each look is drawn with the effect and without it, in each of two builds; even, >= 2, because the two
    /// take turns in being drawn first.
    std::size_t rounds = 10;
};

/// Draws eight looks around from the player's start and from some other places of the map, by the column renderer on
/// one thread, in turn with and without each effect, and takes each look's middle difference of processor time. Shows
/// on a terminal how far it is. file: sound, with a player; else there are no prices.
/// Cost: as it is chosen by default, some seconds for each effect that can be taken out.
Prices effect_prices(const MapFile& file, const TextureSet& textures, const PriceChoices& choices = {});

/// The prices as aligned lines for a terminal.
std::string to_text(const Prices& prices);

/// The prices as a table in Markdown, for a README.
std::string to_markdown(const Prices& prices);

}  // namespace enfilade
