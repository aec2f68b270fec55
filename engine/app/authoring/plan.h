// A map as a drawing on squared paper, and what it is made of.
#pragma once
#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "formats/map_file.h"
#include "math/vec.h"

namespace enfilade {

/// The plan of a map as an SVG picture: outlines, names, heights, the numbers of walls, links, triggers, things, lamps,
/// the player, and a legend. Rooms that hang together by plain portals, or lie on one another, are one drawing; others
/// stand beside it, each with its own corner. What points at a part tells its line in the file.
/// map : as the reader leaves it; it may have errors
std::string plan_svg(const MapFile& map);

// Where drawings lie. Included by the files of the plan only, as all that follows.

/// A rectangle along the axes; at first empty.
struct Box {
    Vec2 low{1e9, 1e9}, high{-1e9, -1e9};

    void add(Vec2 p) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    void add(const Box& other) {
        add(other.low);
        add(other.high);
    }
    bool is_empty() const { return low.x > high.x; }
    bool meets(const Box& other) const {
        return low.x <= other.high.x && other.low.x <= high.x && low.y <= other.high.y && other.low.y <= high.y;
    }
    double area() const { return (high.x - low.x) * (high.y - low.y); }
    Vec2 middle() const { return (low + high) * 0.5; }
};

/// Around all corners of a sector.
Box box_of(const SectorRecord& sector);

/// Which drawing each sector is in.
class Drawings {
public:
    explicit Drawings(const MapFile& map);

    std::size_t of(std::size_t sector) const {
        while (parent_[sector] != sector) sector = parent_[sector];
        return sector;
    }
    /// The box of a drawing, by the sector that stands for it.
    const Box& box(std::size_t drawing) const { return boxes_[drawing]; }

private:
    void join(std::size_t a, std::size_t b);
    bool join_those_that_meet();

    std::vector<std::size_t> parent_;
    std::vector<Box> boxes_;
};

// Words that hide no others.

/// A text as SVG takes it, on one line.
std::string escaped(std::string_view text);

/// What is written on a drawing, the most important first.
enum class Importance : std::uint8_t { name, trigger, link, small_name, number };

/// How words look, as SVG says it.
inline constexpr const char *kBold = "font-weight=\"bold\"", *kGrey = "fill=\"#606060\"", *kOrange = "fill=\"#c05000\"",
                            *kViolet = "fill=\"#c000c0\"";

struct Label {
    Importance importance;
    Vec2 at;           ///< the middle of its line of writing [px]
    double size = 11;  ///< of the letters [px]
    const char* look;
    std::string text;
    std::string second{};  ///< a grey line below it; empty: none
};

/// Puts labels where they hide no others: what is important first, near the place it is about, or nowhere.
class Labels {
public:
    void add(Label label);

    /// All that were added and have a place, as SVG; those that are added later go beside them.
    std::string placed();

private:
    bool find_place(Label& label);
    bool take(const Box& box);

    std::vector<Label> waiting_;
    std::map<std::pair<double, double>, std::vector<Box>> cells_;  ///< of the sheet: the labels that touch them
};

}  // namespace enfilade
