// What old and new ways to find texels along a row are worth today: how far off they are, and what they cost.
//
// A wall that goes away from the eye, 50 to 1000 texels ahead, on 1088 columns of 720 rows, is drawn row by row, as
// engines of polygons did: there a position is a quotient that is another one in every pixel. The last method draws it
// column by column, as this engine does: there it is a quotient once for each column. Prints a page in Markdown.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "platform/clock.h"

namespace {

using enfilade::now_ns;

constexpr int kFirst = 128, kEnd = 1216, kColumns = kEnd - kFirst, kRows = 720;
constexpr double kFocal = 640, kMiddle = 640, kHeight = 64;
constexpr double kLeftX = -40, kLeftZ = 50, kRightX = 900, kRightZ = 1000;
constexpr int kSide = 128;  // of the picture [texels]
constexpr std::size_t kRounds = 41;

/// u = u_over_z / one_over_z and v = rise / one_over_z of a column, where both are straight lines over the columns.
struct Line {
    double at_first, per_column;
    double at(double column) const { return at_first + column * per_column; }
};

struct Wall {
    Line one_over_z, u_over_z;
};

Wall make_wall() {
    const double along_x = kRightX - kLeftX, along_z = kRightZ - kLeftZ, length = std::hypot(along_x, along_z);
    const double cross = kLeftX * along_z - kLeftZ * along_x;
    const auto line = [&](auto of_slope) {
        const double first = of_slope((kFirst + 0.5 - kMiddle) / kFocal),
                     last = of_slope((kEnd + 0.5 - kMiddle) / kFocal);
        return Line{first, (last - first) / kColumns};
    };
    // With t along the wall, (left + t * along) = z * (slope, 1).
    return {line([&](double slope) { return (slope * along_z - along_x) / cross; }),
            line([&](double slope) { return (kLeftX - slope * kLeftZ) / cross * length; })};
}

/// Rows from the eye's height down; above it, what is below is mirrored.
double rise_of(int row) { return (row + 0.5 - kRows / 2) / kFocal; }

struct Place {
    double u, v;
};

Place exact_place(const Wall& wall, int column, int row) {
    const double z = 1 / wall.one_over_z.at(column);
    return {wall.u_over_z.at(column) * z, rise_of(row) * z};
}

/// The columns that see the wall in a row: all up to one.
int end_of_row(const Wall& wall, int row) {
    int end = 0;
    while (end < kColumns && std::fabs(rise_of(row)) <= kHeight * wall.one_over_z.at(end)) ++end;
    return end;
}

/// Where a method puts what it finds: pixels, or places to be judged.
class Pixels {
public:
    explicit Pixels(const std::vector<std::uint32_t>& picture)
        : picture_(picture), pixels_(std::size_t{kColumns} * kRows) {}
    void put(int column, int row, double u, double v) { put_texel(column, row, whole(u), whole(v)); }
    void put_texel(int column, int row, int u, int v) {
        pixels_[static_cast<std::size_t>(row * kColumns + column)] =
            picture_[static_cast<std::size_t>((v & (kSide - 1)) * kSide + (u & (kSide - 1)))];
    }
    std::uint32_t sum() const {
        std::uint32_t all = 0;
        for (const std::uint32_t pixel : pixels_) all = all * 31 + pixel;
        return all;
    }

private:
    static int whole(double x) { return static_cast<int>(x + 65536.0) - 65536; }
    const std::vector<std::uint32_t>& picture_;
    std::vector<std::uint32_t> pixels_;
};

class Judge {
public:
    explicit Judge(const Wall& wall) : wall_(wall) {}
    void put(int column, int row, double u, double v) {
        const Place exact = exact_place(wall_, column, row);
        errors.push_back(std::max(std::fabs(u - exact.u), std::fabs(v - exact.v)));
        wrong += std::floor(u) != std::floor(exact.u) || std::floor(v) != std::floor(exact.v);
    }
    /// Of a texel alone it can only be said how far the true place is outside of it.
    void put_texel(int column, int row, int u, int v) {
        const Place exact = exact_place(wall_, column, row);
        const auto outside = [](double x, int texel) { return std::max({0.0, texel - x, x - texel - 1}); };
        errors.push_back(std::max(outside(exact.u, u), outside(exact.v, v)));
        wrong += errors.back() > 0;
    }
    std::vector<double> errors;
    std::size_t wrong = 0;

private:
    const Wall& wall_;
};

// The methods: draw(wall, row, end, to, divisions).

template <class Number>
struct DivideEach {
    template <class To>
    static void draw(const Wall& wall, int row, int end, To& to, std::uint64_t& divisions) {
        const auto first = static_cast<Number>(wall.one_over_z.at_first),
                   step = static_cast<Number>(wall.one_over_z.per_column);
        const auto u_first = static_cast<Number>(wall.u_over_z.at_first),
                   u_step = static_cast<Number>(wall.u_over_z.per_column);
        const auto rise = static_cast<Number>(rise_of(row));
        for (int x = 0; x < end; ++x) {
            const Number z = 1 / (first + static_cast<Number>(x) * step);
            to.put(x, row, double((u_first + static_cast<Number>(x) * u_step) * z), double(rise * z));
        }
        divisions += static_cast<std::uint64_t>(end);
    }
};

/// Exact at both ends of `count` columns, straight between them.
template <class To>
void draw_straight(int x, int row, int count, Place a, Place b, To& to) {
    const double u_step = (b.u - a.u) / count, v_step = (b.v - a.v) / count;
    for (int i = 0; i < count; ++i) to.put(x + i, row, a.u + i * u_step, a.v + i * v_step);
}

template <int span>
struct DivideSometimes {
    template <class To>
    static void draw(const Wall& wall, int row, int end, To& to, std::uint64_t& divisions) {
        Place a = exact_place(wall, 0, row);
        for (int x = 0; x < end; x += span, ++divisions) {
            const int count = std::min(span, end - x);
            const Place b = exact_place(wall, x + count, row);
            draw_straight(x, row, count, a, b, to);
            a = b;
        }
    }
};

/// Spans as long as a closed bound of what they are off by allows: |du| * tanh(|ln r| / 4), r the ratio of depths.
struct DivideByBound {
    static constexpr double kBound = 0.25;  // [texels]
    template <class To>
    static void draw(const Wall& wall, int row, int end, To& to, std::uint64_t& divisions) {
        Place a = exact_place(wall, 0, row);
        for (int x = 0, length = 16; x < end;) {
            length = std::min(2 * length, end - x);
            Place b = exact_place(wall, x + length, row);
            for (++divisions; length > 1 && bound(wall, x, length, a, b) > kBound; ++divisions)
                b = exact_place(wall, x + (length /= 2), row);
            draw_straight(x, row, length, a, b, to);
            x += length;
            a = b;
        }
    }
    static double bound(const Wall& wall, int x, int length, Place a, Place b) {
        const double ratio = std::sqrt(wall.one_over_z.at(x) / wall.one_over_z.at(x + length));
        return std::max(std::fabs(b.u - a.u), std::fabs(b.v - a.v)) * std::fabs((ratio - 1) / (ratio + 1));
    }
};

/// A texel of a quotient of two straight lines, by additions: what is left of the division is brought back into
/// [0, divisor) after each step.
class MidpointTexel {
public:
    MidpointTexel(std::int64_t over, std::int64_t over_step, std::int64_t under, std::int64_t under_step)
        : texel_(over / under - (over % under < 0)),
          rest_(over - texel_ * under),
          rest_step_(over_step - texel_ * under_step),
          under_(under),
          under_step_(under_step) {}
    int texel() const { return static_cast<int>(texel_); }
    void step() {
        under_ += under_step_;
        rest_ += rest_step_;
        while (rest_ >= under_) ++texel_, rest_ -= under_, rest_step_ -= under_step_;
        while (rest_ < 0) --texel_, rest_ += under_, rest_step_ += under_step_;
    }

private:
    std::int64_t texel_, rest_, rest_step_, under_, under_step_;
};

struct NoDivision {
    template <class To>
    static void draw(const Wall& wall, int row, int end, To& to, std::uint64_t& divisions) {
        const auto fixed = [](double x) { return static_cast<std::int64_t>(std::llround(x * 0x1p44)); };
        const std::int64_t under = fixed(wall.one_over_z.at_first), under_step = fixed(wall.one_over_z.per_column);
        MidpointTexel u(fixed(wall.u_over_z.at_first), fixed(wall.u_over_z.per_column), under, under_step);
        MidpointTexel v(fixed(rise_of(row)), 0, under, under_step);
        divisions += 2;
        for (int x = 0; x < end; ++x, u.step(), v.step()) to.put_texel(x, row, u.texel(), v.texel());
    }
};

template <class Method, class To>
std::uint64_t draw_rows(const Wall& wall, const std::vector<int>& ends, To& to) {
    std::uint64_t divisions = 0;
    for (int row = 0; row < kRows; ++row) Method::draw(wall, row, ends[static_cast<std::size_t>(row)], to, divisions);
    return divisions;
}

/// One division for each column, and 2^-32 of a picture down it.
template <class To>
std::uint64_t draw_columns(const Wall& wall, const std::vector<int>&, To& to) {
    constexpr double kShift = 0x1p32;
    for (int x = 0; x < kColumns; ++x) {
        const double z = 1 / wall.one_over_z.at(x), u = wall.u_over_z.at(x) * z;
        const double reach = kHeight * wall.one_over_z.at(x) * kFocal;
        const int top = std::max(0, static_cast<int>(std::ceil(kRows / 2 - 0.5 - reach)));
        const int bottom = std::min(kRows, static_cast<int>(std::floor(kRows / 2 - 0.5 + reach)) + 1);
        const auto step = static_cast<std::int64_t>(z / kFocal * kShift);
        std::int64_t v = static_cast<std::int64_t>(rise_of(top) * z * kShift);
        for (int y = top; y < bottom; ++y, v += step) to.put(x, y, u, static_cast<double>(v) / kShift);
    }
    return kColumns;
}

struct Method {
    const char* name;
    std::uint64_t (*measure)(const Wall&, const std::vector<int>&, Pixels&);
    std::uint64_t (*judge)(const Wall&, const std::vector<int>&, Judge&);
};

template <class M>
constexpr Method rows(const char* name) {
    return {name, draw_rows<M, Pixels>, draw_rows<M, Judge>};
}

constexpr std::array kMethods{
    rows<DivideEach<double>>("a division for each pixel, double"),
    rows<DivideEach<float>>("a division for each pixel, float"),
    rows<DivideSometimes<16>>("a division every 16 pixels (Abrash 1997)"),
    rows<DivideByBound>("as few as keep within 0.25 texel (Kamen, Shirman 1998)"),
    rows<NoDivision>("additions alone (Barenbrug, Peters, van Overveld 2000)"),
    Method{"a division for each column, 32.32 down it (here)", draw_columns<Pixels>, draw_columns<Judge>},
};

std::vector<std::uint32_t> make_picture() {
    std::vector<std::uint32_t> picture(std::size_t{kSide} * kSide);
    std::uint32_t seed = 1;
    for (std::uint32_t& texel : picture) texel = seed = seed * 1664525 + 1013904223;
    return picture;
}

struct Times {
    std::array<std::vector<double>, kMethods.size()> ns;
};

Times measure(const Wall& wall, const std::vector<int>& ends, Pixels& pixels) {
    Times times;
    for (std::size_t round = 0; round <= kRounds; ++round)
        for (std::size_t turn = 0; turn < kMethods.size(); ++turn) {
            const std::size_t m = (turn + round) % kMethods.size();
            const std::int64_t began = now_ns();
            kMethods[m].measure(wall, ends, pixels);
            if (round > 0) times.ns[m].push_back(static_cast<double>(now_ns() - began));
        }
    return times;
}

/// The middle one, and those between which half of them lie.
struct Quarters {
    double low, middle, high;
};
Quarters quarters(std::vector<double> values) {
    std::ranges::sort(values);
    return {values[values.size() / 4], values[values.size() / 2], values[values.size() * 3 / 4]};
}

void print_line(const Wall& wall, const std::vector<int>& ends, const Times& times, std::size_t m) {
    Judge judge(wall);
    const auto divisions = static_cast<double>(kMethods[m].judge(wall, ends, judge));
    std::ranges::sort(judge.errors);
    const auto pixels = static_cast<double>(judge.errors.size());
    double mean = 0;
    for (const double error : judge.errors) mean += error / pixels;
    std::vector<double> ratios;
    for (std::size_t round = 0; round < kRounds; ++round) ratios.push_back(times.ns[m][round] / times.ns[0][round]);
    const Quarters ratio = quarters(ratios);
    std::printf("| %s | %.4f | %.1e | %.1e | %.1e | %.3f | %.2f | %.2f (%.2f to %.2f) |\n", kMethods[m].name,
                divisions / pixels, mean, judge.errors[judge.errors.size() * 999 / 1000], judge.errors.back(),
                100 * static_cast<double>(judge.wrong) / pixels, *std::ranges::min_element(times.ns[m]) / pixels,
                ratio.middle, ratio.low, ratio.high);
}

}  // namespace

int main() {
    const Wall wall = make_wall();
    std::vector<int> ends;
    for (int row = 0; row < kRows; ++row) ends.push_back(end_of_row(wall, row));
    const std::vector<std::uint32_t> picture = make_picture();
    Pixels pixels(picture);
    const Times times = measure(wall, ends, pixels);
    std::printf(
        "| method | divisions a pixel | mean [texels] | 99.9 %% | largest | other texels [%%] | ns a pixel | time, "
        "a division for each = 1 |\n|---|---|---|---|---|---|---|---|\n");
    for (std::size_t m = 0; m < kMethods.size(); ++m) print_line(wall, ends, times, m);
    return pixels.sum() == 0 ? 1 : 0;
}
