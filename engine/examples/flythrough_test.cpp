// A flythrough as a test of one's own: example_flythrough_test SCRIPT.toml fails where a frame is not as it was
// recorded (`enfilade fly SCRIPT.toml --record`). CMakeLists.txt shows the same without a line of C++.
#include "testing/flythrough.h"

#include <cstdio>

int main(int argc, char** argv) {
    if (argc != 2) return 2;
    const auto differing = enfilade::check_flythrough(argv[1]);
    if (!differing.ok()) {
        std::puts(differing.error().text().c_str());
        return 1;
    }
    for (const enfilade::Mismatch& mismatch : differing.value()) std::printf("frame %d differs\n", mismatch.frame);
    return differing.value().empty() ? 0 : 1;
}
