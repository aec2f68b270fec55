// Ways to spoil a sound file.
#pragma once
#include <cstring>
#include <memory>
#include <span>
#include <string_view>

namespace enfilade {

/// Calls check with the bytes cut at every length short of the whole, each in memory of exactly that size, so that
/// the address sanitizer sees a read of one byte too many.
template <class Check>
void for_each_cut(std::span<const std::byte> bytes, const Check& check) {
    for (std::size_t length = 0; length < bytes.size(); ++length) {
        const auto cut = std::make_unique<std::byte[]>(length);
        if (length > 0) std::memcpy(cut.get(), bytes.data(), length);
        check(std::span<const std::byte>(cut.get(), length));
    }
}

/// The same for text.
template <class Check>
void for_each_cut(std::string_view text, const Check& check) {
    for_each_cut(std::as_bytes(std::span(text.data(), text.size())), [&](std::span<const std::byte> cut) {
        check(std::string_view(reinterpret_cast<const char*>(cut.data()), cut.size()));
    });
}

}  // namespace enfilade
