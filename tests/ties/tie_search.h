// A search for pixels that two renderers decide differently, where all is aimed at ties, and for rays that either of
// them decides otherwise than whole numbers do.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "hard_cases/comparison.h"
#include "ties/tie_worlds.h"
#include "ties/tied_view.h"

namespace enfilade::test {

/// What was found.
struct TieCounts {
    std::uint64_t views = 0, faulty_views = 0;
    Comparison pictures;     ///< column against reference
    std::uint64_t rays = 0;  ///< judged: all of the aimed column and of another one, in worlds laid bare
    std::uint64_t lost = 0;  ///< rays that rounding behind a link left no wall; not judged
    std::uint64_t wrong_column = 0, wrong_reference = 0;  ///< rays of which they say something else
    std::vector<std::string> faults;                      ///< the first kMostTold, with all that shows them again

    static constexpr std::size_t kMostTold = 20;

    TieCounts& operator+=(const TieCounts& other);
    bool is_faultless() const;
};

/// The counts, one a line, and the faults.
std::string describe(const TieCounts& counts);

/// Adds what both renderers and the judge say of one view. where: which round and view, for the report.
void search_view(const TieWorld& world, bool is_bare, const TiedView& tied, const std::string& where,
                 TieCounts& counts);

/// Views of one world.
inline constexpr int kViewsPerRound = 32;

/// `views` of them, rounded up to whole rounds, from the world of round `seed` on, on two threads.
TieCounts search_ties(const TieWorlds& worlds, std::uint64_t seed, std::uint64_t views);

}  // namespace enfilade::test
