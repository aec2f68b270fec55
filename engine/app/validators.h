// Checks of single arguments while the command line is read.
#pragma once
#include <fmt/format.h>

#include <CLI/Validators.hpp>
#include <string>

#include "formats/number_text.h"

namespace enfilade {

/// A finite number from low to high. CLI11's own Range lets NaN through.
inline CLI::Validator number_within(double low, double high) {
    return CLI::Validator(
        [=](std::string& text) -> std::string {
            const auto number = parse_number(text);
            if (number && *number >= low && *number <= high) return {};
            return fmt::format("expected a number from {} to {}; found '{}'", low, high, text);
        },
        "");
}

}  // namespace enfilade
