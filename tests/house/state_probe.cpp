// Prints the hashes of state_hashes.h, to compare builds with other compilers, flags and machines by eye or by diff.
#include <cstdio>

#include "house/state_hashes.h"

int main() {
    for (const auto& hash : enfilade::house::state_hashes()) std::puts(to_text(hash).c_str());
}
