#include "app/exit_codes.h"

#include <fmt/format.h>

namespace enfilade {

int fail(const Error& error) {
    fmt::print(stderr, "enfilade: {}\n", error.text());
    return kFailed;
}

int refuse_usage(const Error& error) {
    fail(error);
    return kUsage;
}

}  // namespace enfilade
