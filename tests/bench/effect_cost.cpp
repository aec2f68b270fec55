// What effects cost where nothing uses them: `effect_cost ROUNDS` draws rooms without any effect all around, so many
// times, and prints the pixels of a round and the hash of what was drawn. `effect_cost names` prints the effects that
// can be left out of a build. Meant to be counted by effect_cost.sh, not timed.
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "base/hash.h"
#include "render/built_in.h"
#include "render/column/column_renderer.h"
#include "support/generate_map.h"
#include "world/snapshot.h"
#include "world/world.h"

using namespace enfilade;

namespace {

constexpr int kWidth = 640, kHeight = 400;  ///< [px]
constexpr int kLooks = 8;                   ///< all around
constexpr std::size_t kSectors = 200;

void print_names() {
    for (const std::string_view name : built_in::kNames) std::printf("%.*s\n", int(name.size()), name.data());
}

View view_of(const World& world) {
    View view;
    view.sector = world.player.place.sector;
    view.eye = world.player.place.point;
    view.eye_z = world.player.eye_z;
    return view;
}

/// Draws `rounds` times all around: what is counted, not inlined, so that callgrind finds it by its name. The hash of
/// all that was drawn in the last round.
[[gnu::noinline]] std::uint64_t draw_rounds(const Map& map, const TextureSet& textures, long rounds) {
    const World world = *start_of(map);
    Snapshot snapshot = at_rest(map);
    ColumnRenderer renderer(map, textures);
    Frame frame;
    frame.resize(kWidth, kHeight);
    View view = view_of(world);
    Hash hash;
    for (long round = 0; round < rounds; ++round)
        for (int look = 0; look < kLooks; ++look) {
            view.forward = direction(Angle::from_degrees(360.0 / kLooks * look));
            show(now(map, world), snapshot);
            renderer.render(frame, nullptr, snapshot, view);
            if (round + 1 == rounds) hash.add(hash_of(frame));
        }
    return hash.value();
}

}  // namespace

int main(int count, char** words) {
    if (count != 2) {
        std::fprintf(stderr, "usage: effect_cost ROUNDS | names\n");
        return 2;
    }
    if (std::string_view(words[1]) == "names") {
        print_names();
        return 0;
    }
    const MapFile file = test::grid_of_rooms(kSectors);
    const std::uint64_t drawn = draw_rounds(test::built(file), test::textures_for(file), std::atol(words[1]));
    std::printf("%d %016llx\n", kWidth * kHeight * kLooks, static_cast<unsigned long long>(drawn));
    return 0;
}
