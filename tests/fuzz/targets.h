// What hostile bytes are thrown at: each target takes any bytes, and stops the program where a promise is broken.
#pragma once
#include <cstddef>
#include <span>
#include <string_view>

namespace enfilade::test {

struct FuzzTarget {
    std::string_view name;  ///< of its folder below tests/fuzz/corpus, too
    void (*run)(std::span<const std::byte> bytes);
};

/// All of them, by name.
std::span<const FuzzTarget> fuzz_targets();

// Text: formats/.
void fuzz_toml(std::span<const std::byte> bytes);      ///< whatever the guard lets pass, the library reads or refuses
void fuzz_map(std::span<const std::byte> bytes);       ///< read, built, written, drawn and walked in; both dialects
void fuzz_compiled(std::span<const std::byte> bytes);  ///< changes of a compiled map; read, drawn and walked in
void fuzz_world(std::span<const std::byte> bytes);     ///< choices of which a legal world is made
void fuzz_script(std::span<const std::byte> bytes);    ///< read, planned and flown
void fuzz_views(std::span<const std::byte> bytes);
void fuzz_hashes(std::span<const std::byte> bytes);
void fuzz_texture(std::span<const std::byte> bytes);  ///< a texture's specification

// What is no text.
void fuzz_png(std::span<const std::byte> bytes);  ///< as it is, and with the sums of its chunks put right
void fuzz_wav(std::span<const std::byte> bytes);
void fuzz_wad(std::span<const std::byte> bytes);   ///< alone and as a patch: pictures, sounds, and maps that are drawn
void fuzz_tape(std::span<const std::byte> bytes);  ///< read, written, played and flown
void fuzz_save(std::span<const std::byte> bytes);  ///< loaded into a game, played on, saved and loaded again

// What the program keeps for its player, and its command line.
void fuzz_settings(std::span<const std::byte> bytes);  ///< read, shown, turned, written and read again
void fuzz_parts(std::span<const std::byte> bytes);     ///< parts of a recording, merged
void fuzz_list(std::span<const std::byte> bytes);      ///< names and contents of files that the title lists
void fuzz_options(std::span<const std::byte> bytes);   ///< values of options
void fuzz_report(std::span<const std::byte> bytes);    ///< accuracy and speed that was measured

}  // namespace enfilade::test
