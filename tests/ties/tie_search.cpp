#include "ties/tie_search.h"

#include <cstdio>
#include <sstream>

#include "base/parallel.h"
#include "render/view.h"
#include "ties/exact_column.h"

namespace enfilade::test {
namespace {

constexpr std::size_t kThreads = 2;

/// All numbers of a view to the last bit.
std::string exact_text(const Map& map, const TiedView& tied) {
    const View& v = tied.view;
    char text[600];
    std::snprintf(text, sizeof text,
                  "sector '%s' (%u), eye {%a, %a}, eye_z %a, forward {%a, %a}, pitch_tangent %a, fov_degrees %a, "
                  "stretch %a, ray_offset {%g, %g}, size %dx%d, aimed column %d",
                  map[v.sector].name.c_str(), v.sector.index, v.eye.x, v.eye.y, v.eye_z, v.forward.x, v.forward.y,
                  v.pitch_tangent, v.fov_degrees, v.stretch, v.ray_offset.x, v.ray_offset.y, tied.size.width,
                  tied.size.height, tied.column);
    return text;
}

/// One view while it is searched.
struct Search {
    const TieWorld& world;
    const TiedView& tied;
    const BothPictures& both;
    const std::string& where;
    TieCounts& counts;

    void tell(std::size_t pixel, const std::string& verdict) const {
        if (counts.faults.size() >= TieCounts::kMostTold) return;
        const std::size_t width = static_cast<std::size_t>(tied.size.width);
        counts.faults.push_back(where + ", " + world.name + ", pixel (" + std::to_string(pixel % width) + ", " +
                                std::to_string(pixel / width) + "): " + verdict + "\n    column shows " +
                                seen(pixel, both.column, both.column_facts) + "\n    reference shows " +
                                seen(pixel, both.reference, both.reference_facts) + "\n    " +
                                exact_text(world.map, tied) + "\n    " +
                                command_line(world.name, world.map, tied.view, tied.size));
    }

    std::string seen(std::size_t pixel, const Frame& frame, const FrameFacts& facts) const {
        const TexelPosition texel = facts.texels[pixel];
        char text[160];
        std::snprintf(text, sizeof text, ", depth %.17g, texel %.17g %.17g, color %08x", facts.depths[pixel], texel.u,
                      texel.v, frame.pixels[pixel]);
        return surface_text(world.map, facts.ids[pixel]) + text;
    }
};

std::vector<Heights> heights_of(const TieWorld& world) {
    std::vector<Heights> heights;
    for (std::size_t i = 0; i < world.map.sectors.size(); ++i)
        heights.push_back(heights_at(world.snapshot, SectorId(i)));
    return heights;
}

void judge_ray(const Search& search, std::size_t pixel, const std::optional<PixelSurface>& truth, bool& is_told) {
    TieCounts& counts = search.counts;
    if (!truth) {
        ++counts.lost;
        return;
    }
    const PixelSurface column = search.both.column_facts.ids[pixel], reference = search.both.reference_facts.ids[pixel];
    ++counts.rays;
    counts.wrong_column += column != *truth;
    counts.wrong_reference += reference != *truth;
    if ((column == *truth && reference == *truth) || is_told) return;
    search.tell(pixel, "whole numbers say " + surface_text(search.world.map, *truth));
    is_told = true;
}

void judge_column(const Search& search, const std::vector<Heights>& heights, int x, bool& is_told) {
    const Projection projection(search.tied.view, search.tied.size.width, search.tied.size.height);
    ExactColumn column(search.world.map, heights, search.tied.view, projection.slope(x));
    for (int y = 0; y < search.tied.size.height; ++y) {
        const double rise = projection.row_from_horizon(y) + kTieClimb * projection.focal_y();
        const std::size_t pixel = std::size_t(y) * std::size_t(search.tied.size.width) + std::size_t(x);
        judge_ray(search, pixel, column.surface(rise, projection.focal_y()), is_told);
    }
}

void judge(const Search& search, bool& is_told) {
    const std::vector<Heights> heights = heights_of(search.world);
    judge_column(search, heights, search.tied.column, is_told);
    const int other = (search.tied.column * 7 + 3) % search.tied.size.width;
    if (other != search.tied.column) judge_column(search, heights, other, is_told);
}

void tell_first_difference(const Search& search, const Subject& subject) {
    std::size_t pixel = 0;
    while (difference_at(subject, search.both, pixel).is_faultless()) ++pixel;
    const bool is_color = search.both.column_facts.ids[pixel] == search.both.reference_facts.ids[pixel];
    search.tell(pixel, is_color ? "the colors differ" : "the surfaces differ");
}

}  // namespace

TieCounts& TieCounts::operator+=(const TieCounts& other) {
    views += other.views;
    faulty_views += other.faulty_views;
    pictures += other.pictures;
    rays += other.rays;
    lost += other.lost;
    wrong_column += other.wrong_column;
    wrong_reference += other.wrong_reference;
    for (const std::string& fault : other.faults)
        if (faults.size() < kMostTold) faults.push_back(fault);
    return *this;
}

bool TieCounts::is_faultless() const { return pictures.is_faultless() && wrong_column + wrong_reference == 0; }

std::string describe(const TieCounts& c) {
    std::ostringstream text;
    text << c.views << " views aimed at ties, " << c.faulty_views << " of them faulty\n"
         << c.pictures.pixels << " pixels, " << c.pictures.wrong << " of another surface, " << c.pictures.wrong_color
         << " of another color, " << c.pictures.other_texel << " of a neighbouring texel, " << c.pictures.unwritten
         << " unwritten, " << c.pictures.written_twice << " written twice\n"
         << c.rays << " rays judged; column is wrong in " << c.wrong_column << ", the reference in "
         << c.wrong_reference << "; " << c.lost << " more are lost behind links\n";
    for (const std::string& fault : c.faults) text << "  " << fault << "\n";
    return text.str();
}

void search_view(const TieWorld& world, bool is_bare, const TiedView& tied, const std::string& where,
                 TieCounts& counts) {
    const Subject subject{world.name, world.map, world.textures};
    const BothPictures both = draw_by_both(subject, world.snapshot, tied.view, tied.size);
    const Search search{world, tied, both, where, counts};
    TieCounts found;
    found.pictures = differences(subject, both);
    bool is_told = false;
    if (is_bare) judge(search, is_told);
    if (!found.is_faultless() && !is_told) tell_first_difference(search, subject);
    counts.pictures += found.pictures;
    ++counts.views;
    counts.faulty_views += is_told || !found.is_faultless();
}

TieCounts search_ties(const TieWorlds& worlds, std::uint64_t seed, std::uint64_t views) {
    const std::uint64_t rounds = (views + kViewsPerRound - 1) / kViewsPerRound;
    std::vector<TieCounts> found(rounds);
    parallel_for(rounds, kThreads, [&](std::size_t i, std::size_t) {
        const std::uint64_t round = seed + i;
        worlds.visit(round, [&](const TieWorld& world, bool is_bare) {
            Random random(round);
            for (int view = 0; view < kViewsPerRound; ++view) {
                const TiedView tied = tied_view(world.map, random);
                const std::string where = "ENFILADE_SEED=" + std::to_string(round) + " ENFILADE_VIEWS=1, view " +
                                          std::to_string(view) + (is_bare ? ", laid bare" : "");
                search_view(world, is_bare, tied, where, found[i]);
            }
        });
    });
    TieCounts sum;
    for (const TieCounts& counts : found) sum += counts;
    return sum;
}

}  // namespace enfilade::test
