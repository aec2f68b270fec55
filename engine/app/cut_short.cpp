#include "app/cut_short.h"

#include <fmt/format.h>

#include "formats/number_text.h"

namespace enfilade {

CutShortNote::~CutShortNote() {
    if (count_ > 0) fmt::print(stderr, "{}: note: in {} {}\n", out_, counted(count_, "picture"), kCutShort);
}

}  // namespace enfilade
