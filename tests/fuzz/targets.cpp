#include "fuzz/targets.h"

namespace enfilade::test {

std::span<const FuzzTarget> fuzz_targets() {
    static constexpr FuzzTarget kTargets[] = {
        {"hashes", fuzz_hashes}, {"map", fuzz_map},   {"png", fuzz_png},         {"save", fuzz_save},
        {"script", fuzz_script}, {"tape", fuzz_tape}, {"texture", fuzz_texture}, {"toml", fuzz_toml},
        {"views", fuzz_views},   {"wad", fuzz_wad},   {"wav", fuzz_wav},         {"world", fuzz_world},
    };
    return kTargets;
}

}  // namespace enfilade::test
