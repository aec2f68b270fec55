// A walk: example_walk MAP.toml lets the player run forward for two seconds, draws a frame after every tick, and tells
// twice a second where the player is and which frame that gave.
#include <cstdio>

#include "enfilade.h"

using namespace enfilade;

int main(int argc, char** argv) {
    if (argc != 2) return 2;
    const LoadedMap loaded = load_map(argv[1], {}, read_file, kUsualSkill);
    if (!loaded.map) return 1;
    const Map& map = *loaded.map;
    std::optional<World> world = start_of(map);
    const auto renderer = make_renderer({}, map, loaded.textures);
    if (!world || !renderer.ok()) return 1;
    Snapshot snapshot = at_rest(map);
    Frame frame;
    frame.resize(320, 200);
    const TickInput running{.forward = 127, .buttons = kButtonRun};
    for (int tick = 1; tick <= 120; ++tick) {
        step(map, *world, running);
        show(now(map, *world), snapshot);
        const View view = view_from(eye_between_ticks(map, *world, 1), lens_for(map.render));
        if (!renderer.value()->render(frame, nullptr, snapshot, view).ok()) return 1;
        if (tick % 30 == 0)
            std::printf("%3d: %s (%.3f, %.3f), frame %016llx\n", tick, map[view.sector].name.c_str(), view.eye.x,
                        view.eye.y, static_cast<unsigned long long>(hash_of(frame)));
    }
    return 0;
}
