// Compares what the column renderer draws of FreeDoom with pictures that another engine drew of the same views.
//
//   peer_views FOLDER     FOLDER/paths/E1M1_walk.csv  lists of views
//                         FOLDER/frames/E1M1_0120.png the picture of row 120, counted from 0
//
// Prints for each picture which share of its blocks is alike; exits with 1 where one is below the bound. Fields of view
// are 90 degrees, the picture is not stretched, things are left out: pictures called …_things.png are passed over.
// Lights have not begun to change, as when a level has just been entered.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <optional>

#include "formats/png.h"
#include "formats/views_csv.h"
#include "math/grid.h"
#include "render/column/column_renderer.h"
#include "space/locate.h"
#include "wadconv/freedoom/wads.h"
#include "world/snapshot.h"

namespace {

using namespace enfilade;

constexpr int kBlock = 8;             ///< side of the squares whose means are compared [px]
constexpr double kAlike = 12;         ///< largest difference of means in any channel [of 255]
constexpr double kBound = 97;         ///< least share of blocks that are alike [%]
constexpr std::size_t kNumberAt = 5;  ///< from the end of "E1M1_0120", where its number begins, with the '_'

/// Means of a block's red, green and blue.
struct Mean {
    double channels[3] = {0, 0, 0};
};

Mean mean_of(const std::vector<std::uint32_t>& pixels, int width, int x0, int y0) {
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
double likeness(const Frame& ours, const Image& theirs) {
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
    return view;
}

/// One of FreeDoom's maps, without things, and the views of its walk.
struct Walk {
    LoadedMap loaded;
    std::vector<ViewRow> views;
};

std::optional<Walk> load_walk(const std::string& folder, const std::string& map) {
    const test::FreeDoomWad wad{map.starts_with('E') ? "freedoom1" : "freedoom2", 0};
    const auto csv = read_file(folder + "/paths/" + map + "_walk.csv");
    if (!csv) return {};
    Walk walk{test::ConvertedWad(wad, test::Doors::as_they_are, {map}).load(test::lower(map)),
              read_views(as_text(csv.value())).views};
    if (!walk.loaded.map) return {};
    walk.loaded.map->things.clear();
    for (Sector& sector : walk.loaded.map->sectors) sector.light_effect.reset();
    return walk;
}

std::optional<double> compare_picture(const Walk& walk, const std::string& path, std::size_t row) {
    const auto bytes = read_file(path);
    if (!bytes || row >= walk.views.size()) return {};
    const auto theirs = read_png(bytes.value());
    if (!theirs) return {};
    const View view = view_of(*walk.loaded.map, walk.views[row]);
    if (!view.sector) return {};
    Frame frame;
    frame.resize(static_cast<int>(theirs.value().width), static_cast<int>(theirs.value().height));
    ColumnRenderer().render(frame, nullptr, *walk.loaded.map, walk.loaded.textures, at_rest(*walk.loaded.map), view);
    return likeness(frame, theirs.value());
}

/// True where every picture is alike enough.
bool compare_folder(const std::string& folder) {
    std::vector<std::string> stems;
    for (const auto& entry : std::filesystem::directory_iterator(folder + "/frames"))
        if (!entry.path().stem().string().ends_with("_things")) stems.push_back(entry.path().stem().string());
    std::ranges::sort(stems);
    std::map<std::string, std::optional<Walk>> walks;
    bool all_alike = true;
    for (const std::string& stem : stems) {
        if (stem.size() <= kNumberAt) continue;
        const std::string map = stem.substr(0, stem.size() - kNumberAt);
        if (!walks.contains(map)) walks[map] = load_walk(folder, map);
        const auto row = static_cast<std::size_t>(std::atoi(stem.c_str() + stem.size() - kNumberAt + 1));
        const auto share =
            walks[map] ? compare_picture(*walks[map], folder + "/frames/" + stem + ".png", row) : std::nullopt;
        std::printf("%s: %s\n", stem.c_str(), share ? (std::to_string(*share) + " %").c_str() : "cannot be compared");
        all_alike = all_alike && share && *share >= kBound;
    }
    return all_alike;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2 || !std::filesystem::is_directory(std::string(argv[1]) + "/frames")) {
        std::fprintf(stderr, "peer_views: expected one folder that holds frames/ and paths/\n");
        return 2;
    }
    return compare_folder(argv[1]) ? 0 : 1;
}
