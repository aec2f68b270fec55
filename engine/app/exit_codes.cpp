#include "app/exit_codes.h"

#include "base/terminal.h"

namespace enfilade {

int fail(const Error& error) {
    print_text(stderr, "enfilade: " + error.text() + "\n");
    return kFailed;
}

int refuse_usage(const Error& error) {
    fail(error);
    return kUsage;
}

}  // namespace enfilade
