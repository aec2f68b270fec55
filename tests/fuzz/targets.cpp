#include "fuzz/targets.h"

namespace enfilade::test {

std::span<const FuzzTarget> fuzz_targets() {
    static constexpr FuzzTarget kTargets[] = {
        {"compiled", fuzz_compiled}, {"hashes", fuzz_hashes}, {"list", fuzz_list},         {"map", fuzz_map},
        {"options", fuzz_options},   {"parts", fuzz_parts},   {"png", fuzz_png},           {"report", fuzz_report},
        {"save", fuzz_save},         {"script", fuzz_script}, {"settings", fuzz_settings}, {"tape", fuzz_tape},
        {"texture", fuzz_texture},   {"toml", fuzz_toml},     {"views", fuzz_views},       {"wad", fuzz_wad},
        {"wav", fuzz_wav},           {"world", fuzz_world},
    };
    return kTargets;
}

}  // namespace enfilade::test
