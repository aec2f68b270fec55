#include "base/check.h"

#include <cstdio>
#include <cstdlib>

namespace enfilade {

void contract_broken(const char* file, int line, const char* text) {
    std::fprintf(stderr, "%s:%d: broken contract: %s\n", file, line, text);
    std::abort();
}

}  // namespace enfilade
