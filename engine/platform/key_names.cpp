#include "platform/input_event.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace enfilade {
namespace {

/// By KeyCode.
constexpr std::array<std::string_view, kKeyCount> kNames{
    // clang-format off
    "", "A", "B", "C", "D", "E", "F", "G", "H", "I", "J", "K", "L", "M", "N", "O", "P", "Q", "R", "S", "T", "U",
    "V", "W", "X", "Y", "Z", "0", "1", "2", "3", "4", "5", "6", "7", "8", "9", "Up", "Down", "Left", "Right",
    "Page Up", "Page Down", "Home", "End", "Insert", "Delete", "Backspace", "Left Shift", "Right Shift",
    "Left Ctrl", "Right Ctrl", "Left Alt", "Right Alt", "Space", "Tab", "Enter", "Esc", "+", "-", ",", ".", "/",
    ";", "'", "[", "]", "\\", "`", "F1", "F2", "F3", "F4", "F5", "F6", "F7", "F8", "F9", "F10", "F11", "F12",
    "Mouse Left", "Mouse Middle", "Mouse Right"
    // clang-format on
};

char lower(char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; }

bool is_same_word(std::string_view a, std::string_view b) { return std::ranges::equal(a, b, {}, lower, lower); }

}  // namespace

std::string_view name_of(KeyCode key) { return kNames[static_cast<std::size_t>(key)]; }

KeyCode key_named(std::string_view name) {
    const auto found = std::ranges::find_if(kNames, [&](std::string_view known) { return is_same_word(known, name); });
    return found == kNames.end() ? KeyCode::unknown : static_cast<KeyCode>(found - kNames.begin());
}

}  // namespace enfilade
