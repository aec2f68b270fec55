#include "app/messages.h"

#include <fmt/format.h>

#include "base/terminal.h"
#include "formats/text_parts.h"

namespace enfilade {
int fail(const Error& error) { return fail("enfilade", error); }

int refuse_usage(const Error& error) {
    fail(error);
    return kUsage;
}

CutShortNote::~CutShortNote() {
    if (count_ == 0 || talk_ == Talk::errors_only) return;
    print_text(stderr, fmt::format("{}: note: in {} {}\n", out_, counted(count_, "picture"), kCutShort));
}

}  // namespace enfilade
