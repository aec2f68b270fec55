#include "app/cut_short.h"

#include <fmt/format.h>

#include "base/terminal.h"
#include "formats/table_text.h"

namespace enfilade {

CutShortNote::~CutShortNote() {
    if (count_ == 0) return;
    print_text(stderr, fmt::format("{}: note: in {} {}\n", out_, counted(count_, "picture"), kCutShort));
}

}  // namespace enfilade
