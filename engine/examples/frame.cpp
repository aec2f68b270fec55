// A frame into a buffer: example_frame MAP.toml OUT.png draws what the player sees at the start.
#include <cstdio>

#include "enfilade.h"

using namespace enfilade;

int main(int argc, char** argv) {
    if (argc != 3) return 2;
    const LoadedMap loaded = load_map(argv[1], {}, read_file);
    for (const Finding& finding : loaded.findings) std::puts(to_text(argv[1], finding).c_str());
    if (!loaded.map) return 1;
    const auto renderer = make_renderer({}, *loaded.map, loaded.textures);
    const auto view = view_at_start(*loaded.map, lens_for(loaded.map->render));
    if (!renderer.ok() || !view.ok()) return 1;
    Frame frame;
    frame.resize(640, 400);
    if (!renderer.value()->render(frame, nullptr, snapshot_at(*loaded.map, 0), view.value()).ok()) return 1;
    return write_file(argv[2], write_png(image_of(frame))).ok() ? 0 : 1;  // frame.pixels is the buffer
}
