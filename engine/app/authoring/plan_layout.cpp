#include "app/authoring/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/text.h"
#include "formats/text_parts.h"

namespace enfilade {

Box box_of(const SectorRecord& sector) {
    Box box;
    for (const LoopRecord& loop : sector.loops)
        for (const Vec2& v : loop.vertices) box.add(v);
    return box;
}

Drawings::Drawings(const MapFile& map) : parent_(map.sectors.size()) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    std::map<std::string, std::size_t> sectors;
    for (std::size_t i = 0; i < map.sectors.size(); ++i) {
        sectors.try_emplace(map.sectors[i].name, i);
        boxes_.push_back(box_of(map.sectors[i]));
    }
    for (std::size_t i = 0; i < map.sectors.size(); ++i)
        for (const LoopRecord& loop : map.sectors[i].loops)
            for (const WallRecord& wall : loop.walls)
                if (const auto next = sectors.find(wall.next); wall.via.empty() && next != sectors.end())
                    join(i, next->second);
    while (join_those_that_meet()) {
    }
}

void Drawings::join(std::size_t a, std::size_t b) {
    a = of(a);
    b = of(b);
    if (a == b) return;
    if (b < a) std::swap(a, b);
    parent_[b] = a;
    if (!boxes_[b].is_empty()) boxes_[a].add(boxes_[b]);
}

/// Drawings, from the left to the right: those whose boxes meet share one.
bool Drawings::join_those_that_meet() {
    std::vector<std::size_t> roots;
    for (std::size_t i = 0; i < parent_.size(); ++i)
        if (parent_[i] == i && !boxes_[i].is_empty()) roots.push_back(i);
    std::ranges::sort(roots, {}, [&](std::size_t root) { return boxes_[root].low.x; });
    bool any = false;
    for (std::size_t i = 0; i < roots.size(); ++i)
        for (std::size_t k = i + 1; k < roots.size() && boxes_[roots[k]].low.x <= boxes_[of(roots[i])].high.x; ++k)
            if (of(roots[i]) != of(roots[k]) && boxes_[of(roots[i])].meets(boxes_[of(roots[k])])) {
                join(roots[i], roots[k]);
                any = true;
            }
    return any;
}

namespace {

constexpr double kCell = 64;     ///< side of a cell of the sheet [px]
constexpr double kLetter = 0.6;  ///< the mean width of a letter in sizes of it

auto letters_in(const std::string& text) {
    return std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; });
}

Box box_of(const Label& label) {
    const auto letters = std::max(letters_in(label.text), letters_in(label.second));
    const double half = static_cast<double>(letters) * label.size * kLetter / 2;
    const double below = (label.second.empty() ? 0.2 : 1.2) * label.size;
    return {{label.at.x - half, label.at.y - 0.8 * label.size}, {label.at.x + half, label.at.y + below}};
}

/// Lines under a word would make it hard to read.
std::string ground_of(const Label& label) {
    const Box box = box_of(label);
    const Vec2 size = box.high - box.low;
    return fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" rx=\"2\" fill=\"#ffffff\" "
        "fill-opacity=\"0.75\"/>\n",
        box.low.x, box.low.y, size.x, size.y);
}

std::string line_of(const Label& label, double below, const char* look, const std::string& text) {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{}\" text-anchor=\"middle\" {}>{}</text>\n",
                       label.at.x, label.at.y + below, label.size, look, escaped(text));
}

/// Numbers stand beside their walls or nowhere, and names of small rooms in them or beside them.
int most_lines_aside(Importance importance) {
    if (importance == Importance::number) return 0;
    return importance == Importance::small_name ? 1 : 3;
}

}  // namespace

std::string escaped(std::string_view text) { return xml_escaped(printable_line(text)); }

void Labels::add(Label label) {
    if (!label.text.empty()) waiting_.push_back(std::move(label));
}

std::string Labels::placed() {
    std::ranges::stable_sort(waiting_, {}, &Label::importance);
    std::string svg;
    for (Label& label : waiting_) {
        if (!find_place(label)) continue;
        if (label.importance != Importance::number) svg += ground_of(label);
        svg += line_of(label, 0, label.look, label.text);
        if (!label.second.empty()) svg += line_of(label, label.size, kGrey, label.second);
    }
    waiting_.clear();
    return svg;
}

/// Moves the label up and down by whole lines until it hides nothing.
bool Labels::find_place(Label& label) {
    const Vec2 wanted = label.at;
    for (int lines = 0; lines <= most_lines_aside(label.importance); ++lines)
        for (const double way : {1.0, -1.0}) {
            label.at = wanted + Vec2{0, way * lines * label.size * 1.1};
            if (take(box_of(label))) return true;
        }
    return false;
}

/// Whether no label was there; then one is.
bool Labels::take(const Box& box) {
    std::vector<std::vector<Box>*> touched;
    for (double y = std::floor(box.low.y / kCell); y <= box.high.y / kCell; ++y)
        for (double x = std::floor(box.low.x / kCell); x <= box.high.x / kCell; ++x) touched.push_back(&cells_[{x, y}]);
    for (const std::vector<Box>* cell : touched)
        if (std::ranges::any_of(*cell, [&](const Box& other) { return other.meets(box); })) return false;
    for (std::vector<Box>* cell : touched) cell->push_back(box);
    return true;
}

}  // namespace enfilade
