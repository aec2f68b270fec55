// Compares what the column renderer draws of FreeDoom with pictures that another engine drew of the same views.
//
//   peer_views FOLDER     FOLDER/paths/E1M1_walk.csv  lists of views
//                         FOLDER/frames/E1M1_0120.png the picture of row 120, counted from 0, without things
//                         FOLDER/frames/E1M1_0120_things.png the same with those of skill 4
//
// Prints a table in Markdown: for each picture which share of its blocks is alike, and how far theirs and ours are from
// 64 rays for each pixel, mixed in linear light. Exits with 1 where a share, or their mean, is below its bound. Fields
// of view are 90 degrees, the picture is not stretched. Lights have not begun to change, as when a level has just been
// entered.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <optional>

#include "app/accuracy/errors.h"
#include "formats/png.h"
#include "formats/views_csv.h"
#include "math/vec.h"
#include "render/choice/renderer.h"
#include "space/trace.h"
#include "wadconv/freedoom/wads.h"
#include "world/snapshot.h"

namespace {

using namespace enfilade;

constexpr int kBlock = 8;             ///< side of the squares whose means are compared [px]
constexpr double kAlike = 12;         ///< largest difference of means in any channel [of 255]
constexpr double kBound = 98;         ///< least share of blocks that are alike [%]
constexpr double kMeanBound = 99.5;   ///< least mean of these shares [%]
constexpr std::size_t kNumberAt = 5;  ///< from the end of "E1M1_0120", where its number begins, with the '_'
constexpr std::string_view kThings = "_things";
constexpr int kSkill = 4;  ///< whose things are shown

/// Means of a block's red, green and blue.
struct Mean {
    double channels[3] = {0, 0, 0};
};

Mean mean_of(const Pixels& pixels, int width, int x0, int y0) {
    Mean mean;
    for (int y = y0; y < y0 + kBlock; ++y)
        for (int x = x0; x < x0 + kBlock; ++x)
            for (int c = 0; c < 3; ++c)
                mean.channels[c] += pixels[static_cast<std::size_t>(y * width + x)] >> (8 * c) & 0xFF;
    for (double& channel : mean.channels) channel /= kBlock * kBlock;
    return mean;
}

bool are_alike(const Mean& a, const Mean& b) {
    return std::ranges::equal(a.channels, b.channels, [](double x, double y) { return std::fabs(x - y) <= kAlike; });
}

/// The share of blocks that are alike [%].
double alike_share(const Frame& ours, const Frame& theirs) {
    int alike = 0, blocks = 0;
    for (int y = 0; y + kBlock <= ours.height; y += kBlock)
        for (int x = 0; x + kBlock <= ours.width; x += kBlock, ++blocks)
            alike += are_alike(mean_of(ours.pixels, ours.width, x, y), mean_of(theirs.pixels, ours.width, x, y));
    return 100.0 * alike / blocks;
}

View view_of(const Map& map, const ViewRow& row) {
    View view;
    view.eye = snap_to_point_grid(Vec2{row.x, row.y});
    view.sector = locate(map, view.eye);
    view.eye_z = row.z;
    view.forward = direction(Angle::from_degrees(row.yaw_degrees));
    view.ray_offset = ray_offset(map.render.rays);
    return view;
}

/// One of FreeDoom's maps, and the views of its walk.
struct Walk {
    LoadedMap loaded;
    std::vector<ViewRow> views;
};

std::optional<Walk> load_walk(const std::string& folder, const std::string& map) {
    const test::FreeDoomWad wad{map.starts_with('E') ? "freedoom1" : "freedoom2", 0};
    const auto csv = read_file(folder + "/paths/" + map + "_walk.csv");
    if (!csv) return {};
    Walk walk{test::ConvertedWad(wad, test::Doors::as_they_are, {map}).load(test::lower(map), kSkill),
              read_views(as_text(csv.value())).views};
    if (!walk.loaded.map) return {};
    return walk;
}

/// How near a picture comes to what is truly seen there.
struct Nearness {
    double noise = 0, likeness = 0;  ///< peak signal to noise [dB]; structural similarity, at most 1
};

Nearness nearness(const Frame& truth, const Frame& picture) {
    return {signal_to_noise(squared_change(truth, picture), truth.pixels.size()),
            structural_similarity(truth, picture)};
}

struct Comparison {
    double alike = 0;  ///< blocks [%]
    Nearness theirs, ours;
};

std::optional<Frame> drawn(const Walk& walk, const Snapshot& snapshot, const View& view, int samples, Frame frame) {
    RendererChoice choice;
    choice.dials.samples = samples;
    const auto renderer = make_renderer(choice, *walk.loaded.map, walk.loaded.textures);
    if (!renderer.ok() || !renderer.value()->render(frame, nullptr, snapshot, view).ok()) return {};
    return frame;
}

std::optional<Comparison> compare_picture(const Walk& walk, const std::string& path, std::size_t row,
                                          bool with_things) {
    const auto bytes = read_file(path);
    if (!bytes || row >= walk.views.size()) return {};
    const auto image = read_png(bytes.value());
    if (!image) return {};
    const View view = view_of(*walk.loaded.map, walk.views[row]);
    if (!view.sector) return {};
    Snapshot snapshot = at_rest(*walk.loaded.map);
    leave_out({!with_things, true}, snapshot);
    const Frame theirs = frame_of(image.value());
    const auto ours = drawn(walk, snapshot, view, 1, theirs), truth = drawn(walk, snapshot, view, kMostSamples, theirs);
    if (!ours || !truth) return {};
    return Comparison{alike_share(*ours, theirs), nearness(*truth, theirs), nearness(*truth, *ours)};
}

/// What a picture's file is called says what it shows.
struct Shown {
    std::string stem;  ///< without ".png"
    std::string map;
    std::size_t row = 0;
    bool with_things = false;
};

std::optional<Shown> shown_in(const std::filesystem::path& file) {
    Shown shown{file.stem().string(), {}, 0, false};
    std::string view = shown.stem;
    shown.with_things = view.ends_with(kThings);
    if (shown.with_things) view.resize(view.size() - kThings.size());
    if (view.size() <= kNumberAt) return {};
    shown.map = view.substr(0, view.size() - kNumberAt);
    shown.row = static_cast<std::size_t>(std::atoi(view.c_str() + view.size() - kNumberAt + 1));
    return shown;
}

std::vector<Shown> pictures_in(const std::string& folder) {
    std::vector<Shown> pictures;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (const auto shown = shown_in(entry.path())) pictures.push_back(*shown);
    std::ranges::sort(pictures, {}, &Shown::stem);
    return pictures;
}

void print_row(const char* name, const Comparison& compared) {
    std::printf("| %s | %.2f | %.2f | %.4f | %.2f | %.4f |\n", name, compared.alike, compared.theirs.noise,
                compared.theirs.likeness, compared.ours.noise, compared.ours.likeness);
}

void add(Comparison& sum, const Comparison& one, double part) {
    sum.alike += one.alike * part;
    for (auto [to, from] : {std::pair{&sum.theirs, &one.theirs}, std::pair{&sum.ours, &one.ours}}) {
        to->noise += from->noise * part;
        to->likeness += from->likeness * part;
    }
}

/// True where every picture, and their mean, is alike enough.
bool compare_folder(const std::string& folder) {
    std::map<std::string, std::optional<Walk>> walks;
    bool all_alike = true;
    Comparison mean;
    const std::vector<Shown> pictures = pictures_in(folder + "/frames");
    std::printf(
        "| picture | alike [%%] | their noise [dB] | likeness | our noise [dB] | likeness "
        "|\n|---|---|---|---|---|---|\n");
    for (const auto& [stem, map, row, with_things] : pictures) {
        if (!walks.contains(map)) walks[map] = load_walk(folder, map);
        const std::string path = folder + "/frames/" + stem + ".png";
        const auto compared = walks[map] ? compare_picture(*walks[map], path, row, with_things) : std::nullopt;
        all_alike = all_alike && compared && compared->alike >= kBound;
        if (!compared) std::printf("| %s | cannot be compared | | | | |\n", stem.c_str());
        if (!compared) continue;
        print_row(stem.c_str(), *compared);
        add(mean, *compared, 1 / static_cast<double>(pictures.size()));
    }
    print_row("mean", mean);
    return all_alike && mean.alike >= kMeanBound;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2 || !std::filesystem::is_directory(std::string(argv[1]) + "/frames")) {
        std::fprintf(stderr, "peer_views: expected one folder that holds frames/ and paths/\n");
        return 2;
    }
    return compare_folder(argv[1]) ? 0 : 1;
}
