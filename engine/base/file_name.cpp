#include "base/file_name.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>

#include "base/hash.h"
#include "base/text.h"

namespace enfilade {
namespace {

constexpr std::string_view kHexDigits = "0123456789abcdef";

/// Of systems that are not case-sensitive and have devices of these names in every folder, whatever their ending.
constexpr std::array<std::string_view, 22> kReserved{"con",  "prn",  "aux",  "nul",  "com1", "com2", "com3", "com4",
                                                     "com5", "com6", "com7", "com8", "com9", "lpt1", "lpt2", "lpt3",
                                                     "lpt4", "lpt5", "lpt6", "lpt7", "lpt8", "lpt9"};

std::string percent(char c) {
    const auto byte = static_cast<unsigned char>(c);
    return {'%', kHexDigits[byte >> 4], kHexDigits[byte & 15]};
}

bool is_reserved(std::string_view name) {
    std::string word(name.substr(0, name.find('.')));
    for (char& c : word)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return std::ranges::find(kReserved, word) != kReserved.end();
}

/// The character, or its bytes by their numbers.
std::string safe_character(std::string_view character) {
    constexpr std::string_view kUnsafe = "/\\:*?\"<>|%";  // '%': what it begins would be taken for one of ours
    if (is_printable_line(character) && kUnsafe.find(character) == std::string_view::npos)
        return std::string(character);
    std::string bytes;
    for (const char c : character) bytes += percent(c);
    return bytes;
}

std::string safe_characters(std::string_view name) {
    std::string safe;
    while (!name.empty()) {
        const std::size_t length = std::max<std::size_t>(utf8_length(name), 1);
        safe += safe_character(name.substr(0, length));
        name.remove_prefix(length);
    }
    return safe;
}

/// Cut between characters. "%-" and the hash end no other name.
std::string shortened(std::string_view safe, std::uint64_t hash) {
    constexpr int kHashBits = 64;
    constexpr std::size_t kEndBytes = 2 + kHashBits / 4;
    std::size_t length = kMostNameBytes - kEndBytes;
    while ((static_cast<unsigned char>(safe[length]) & 0xC0) == 0x80) --length;
    std::string name(safe.substr(0, length));
    name += "%-";
    for (int shift = kHashBits - 4; shift >= 0; shift -= 4) name += kHexDigits[hash >> shift & 15];
    return name;
}

}  // namespace

std::string file_name_of(const std::string& path) { return std::filesystem::path(path).filename().string(); }

std::string file_stem_of(const std::string& path) { return std::filesystem::path(path).stem().string(); }

std::string safe_file_name(std::string_view foreign) {
    if (foreign.empty()) return "%";
    std::string safe = safe_characters(foreign);
    const char last = safe.back();
    if (last == '.' || last == ' ') safe.replace(safe.size() - 1, 1, percent(last));
    const char first = safe.front();
    if (first == '.' || first == '-' || first == ' ' || first == '~' || is_reserved(safe))
        safe.replace(0, 1, percent(first));
    return safe.size() > kMostNameBytes ? shortened(safe, hash_of_text(foreign)) : safe;
}

}  // namespace enfilade
