// The worlds in which ties are looked for: made of random bytes, by hand for hard cases, and those that ship.
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "map/load.h"
#include "world/snapshot.h"

namespace enfilade::test {

/// A map at rest, and all its pictures.
struct TieWorld {
    std::string name;
    Map map;
    TextureSet textures;
    Snapshot snapshot;
};

/// Without what the exact judge does not know: things, panels and pictures in portals.
TieWorld laid_bare(TieWorld world);

/// What there is to look at in each round of a search.
class TieWorlds {
public:
    /// Reads all maps that ship.
    TieWorlds();

    /// The same number gives the same world: a wild one, one of the hard cases, or one that ships; every second one
    /// laid bare.
    void visit(std::uint64_t round, const std::function<void(const TieWorld&, bool is_bare)>& look) const;

    const std::vector<TieWorld>& shipped() const { return shipped_; }

private:
    std::vector<TieWorld> shipped_, shipped_bare_;
};

}  // namespace enfilade::test
