// Names of sectors and walls: finding one, and the nearest one where there is none.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "math/vec.h"

namespace enfilade {

/// A name within a scope (walls are named within their sector; sectors all have scope 0).
struct ScopedName {
    std::uint32_t scope;
    std::string_view name;
    std::uint32_t id;
};

/// Looks names up. The texts must outlive it.
class NameIndex {
public:
    explicit NameIndex(std::vector<ScopedName> names);

    /// The lowest id of that name. Cost: log of the number of names.
    std::optional<std::uint32_t> find(std::uint32_t scope, std::string_view name) const;

    /// "; did you mean 'X'?" with the nearest name of the scope, or nothing. Gives up after a fixed number of
    /// comparisons in the index's life, so that a file full of unknown names cannot cost more than linear time.
    std::string suggestion(std::uint32_t scope, std::string_view name) const;

    /// Every name after the first that is equal to another of its scope: (the first, the further one).
    std::vector<std::pair<std::uint32_t, std::uint32_t>> duplicates() const;

private:
    std::vector<ScopedName> names_;  ///< by scope, name, id
    mutable std::size_t comparisons_left_;
};

/// "(x, y)-(x, y)", as an edge appears in findings.
std::string edge_text(Vec2 a, Vec2 b);

}  // namespace enfilade
