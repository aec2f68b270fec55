// Signs over doors: gilt letters on an enamelled plate in a brass frame.
#include <array>
#include <string>
#include <string_view>

#include "album.h"

namespace draw_textures {
namespace {

// A letter is drawn with a round pen on a grid 4 wide and 6 high, y down: "0006" goes from (0, 0) to (0, 6), and a
// space lifts the pen.
constexpr std::array<std::string_view, 26> kLetters = {
    "062046 1434",                // A
    "06003041423303 3344453606",  // B
    "4130100105163645",           // C
    "00062645412000",             // D
    "40000646 0333",              // E
    "400006 0333",                // F
    "41301001051636454323",       // G
    "0006 4046 0343",             // H
    "2026 1030 1636",             // I
    "4045361605",                 // J
    "0006 4003 0346",             // K
    "000646",                     // L
    "0600234046",                 // M
    "06004640",                   // N
    "103041453616050110",         // O
    "06003041423303",             // P
    "103041453616050110 2446",    // Q
    "06003041423303 2346",        // R
    "413010010213334445361605",   // S
    "0040 2026",                  // T
    "000516364540",               // U
    "002640",                     // V
    "0016233640",                 // W
    "0046 4006",                  // X
    "002340 2326",                // Y
    "00400646",                   // Z
};

constexpr int kWidth = 384, kHeight = 96;                 // 2 m x 0.5 m
constexpr double kAdvance = 5.7, kTall = 6, kPen = 0.42;  // in units of a letter's grid
constexpr double kLargest = 8.5, kTextWidth = 336;        // unit of the grid and room for the text, in texels

double distance_to_stroke(double x, double y, double ax, double ay, double bx, double by) {
    const double dx = bx - ax, dy = by - ay, length = dx * dx + dy * dy;
    const double t = length > 0 ? clamp01(((x - ax) * dx + (y - ay) * dy) / length) : 0;
    const double ex = x - ax - t * dx, ey = y - ay - t * dy;
    return std::sqrt(ex * ex + ey * ey);
}

double distance_to_letter(char letter, double x, double y) {
    const std::string_view path = letter == ' ' ? "" : kLetters[static_cast<std::size_t>(letter - 'A')];
    double nearest = 1e9;
    for (std::size_t i = 0; i + 3 < path.size(); i += 2) {
        if (path[i + 2] == ' ') {  // two on to the space, one more over it
            ++i;
            continue;
        }
        nearest = std::min(
            nearest, distance_to_stroke(x, y, path[i] - '0', path[i + 1] - '0', path[i + 2] - '0', path[i + 3] - '0'));
    }
    return nearest;
}

// How far (x, y) lies from the pen's way, in texels; the text stands in the middle of the plate.
double distance_to_text(const std::string& text, double x, double y) {
    const double count = static_cast<double>(text.size());
    const double unit = std::min(kLargest, kTextWidth / (count * kAdvance));
    const double gx = (x - kWidth / 2.0) / unit + (count * kAdvance - (kAdvance - 4)) / 2,
                 gy = (y - kHeight / 2.0) / unit + kTall / 2;
    double nearest = 1e9;
    for (std::size_t i = 0; i < text.size(); ++i)
        nearest = std::min(nearest, distance_to_letter(text[i], gx - static_cast<double>(i) * kAdvance, gy));
    return (nearest - kPen) * unit;
}

Painter sign(const std::string& text, Color enamel) {
    return [=](double x, double y, double u, double v) {
        const double edge = std::min({x, kWidth - x, y, kHeight - y});
        const double tone = cloud(u, v, 8, 2, 4, 811), grain = cloud(u, v, 64, 16, 2, 812);
        const double frame = ramp(11, 9.5, edge), groove = ramp(2, 1, std::abs(edge - 10.5));
        const double line = ramp(1.4, 0.6, std::abs(edge - 16)), ink = ramp(0.8, -0.8, distance_to_text(text, x, y));
        const Color brass = rgb(0xc9a24e) * (1 + 0.08 * tone + 0.05 * grain);
        Color c = mix(enamel * (1 + 0.10 * tone + 0.03 * grain), brass, std::max(frame, 0.9 * line));
        c = mix(c, rgb(0xf2d88c) * (1 + 0.05 * tone), ink);
        return Surface{c * (1 - 0.35 * groove), 2.5 * frame - 1.5 * groove + 1.8 * ink + 0.6 * ramp(0, 8, edge)};
    };
}

struct Sign {
    const char *name, *text;
};

constexpr Sign kWonders[] = {
    {"sign_four_doors", "FOUR DOORS"},
    {"sign_tunnels", "TUNNELS"},
    {"sign_hut", "THE HUT"},
    {"sign_facing_doors", "FACING DOORS"},
    {"sign_quarter", "QUARTER TURN"},
    {"sign_no_return", "NO RETURN"},
    {"sign_ascent", "THE ASCENT"},
    {"sign_mirrors", "MIRRORS"},
    {"sign_into_itself", "INTO ITSELF"},
    {"sign_cells", "THE CELLS"},
    {"sign_three_corners", "THREE CORNERS"},
    {"sign_hall", "THE HALL"},
};
constexpr Sign kPlaces[] = {
    {"sign_court", "COURT"},       {"sign_desert", "DESERT"}, {"sign_winter", "WINTER"},
    {"sign_cavern", "CAVERN"},     {"sign_garden", "GARDEN"}, {"sign_thirty", "THIRTY METRES"},
    {"sign_one_step", "ONE STEP"}, {"sign_mirror", "MIRROR"}, {"sign_twin", "TWIN"},
    {"sign_onward", "ONWARD"},     {"sign_home", "HOME"},     {"sign_works", "WATER WORKS"},
    {"sign_exit", "EXIT"},
};

}  // namespace

void draw_signs(const Album& album) {
    for (const Sign& s : kWonders) album.add(s.name, kWidth, kHeight, sign(s.text, rgb(0x1b2f57)));
    for (const Sign& s : kPlaces) album.add(s.name, kWidth, kHeight, sign(s.text, rgb(0x1d4436)));
}

}  // namespace draw_textures
