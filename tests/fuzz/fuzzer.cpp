// One target for libFuzzer. With --words, the words of the formats instead, one a line, as its -dict wants them.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "app/play/settings.h"
#include "formats/map_keys.h"
#include "formats/map_toml.h"
#include "formats/script.h"
#include "fuzz/targets.h"

namespace {

using enfilade::KeyInfo;

void print_words(const std::vector<KeyInfo>& keys) {
    for (const KeyInfo& key : keys) std::printf("\"%s\"\n", key.path.substr(key.path.rfind('.') + 1).c_str());
}

void print_words_of_settings() {
    using namespace enfilade;
    const auto print = [](std::string_view word) {
        if (word == "\\") word = "\\\\";  // as a dictionary has it
        if (!word.empty()) std::printf("\"%.*s\"\n", static_cast<int>(word.size()), word.data());
    };
    for (const Setting& setting : all_settings()) print(setting.name);
    for (std::size_t i = 0; i < Bindings().size(); ++i) print(info_of(static_cast<Control>(i)).name);
    for (int i = 0; i < kKeyCount; ++i) print(name_of(static_cast<KeyCode>(i)));
}

/// The target that this program is for.
const enfilade::test::FuzzTarget& target() {
    for (const auto& candidate : enfilade::test::fuzz_targets())
        if (candidate.name == ENFILADE_FUZZ_TARGET) return candidate;
    std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* count, char*** arguments) {
    if (*count < 2 || std::strcmp((*arguments)[1], "--words") != 0) return 0;
    print_words(enfilade::map_keys());
    print_words(enfilade::script_keys());
    print_words_of_settings();
    std::exit(0);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    target().run({reinterpret_cast<const std::byte*>(bytes), size});
    return 0;
}
