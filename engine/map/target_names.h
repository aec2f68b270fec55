// What triggers call sectors: their names, and the tags that several of them may share.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "map/map.h"
#include "map/names.h"

namespace enfilade {

/// All names and tags of a file's sectors. The file must outlive it.
class TargetNames {
public:
    explicit TargetNames(const MapFile& file);

    /// Adds the sectors of that name or tag, in the order of the file, without those that are in `sectors` already.
    /// False where there is none. Cost: log of the number of names, and the sectors found times those in `sectors`.
    bool add_sectors(std::string_view name, std::vector<SectorId>& sectors) const;

    /// "; did you mean 'X'?" or nothing.
    std::string suggestion(std::string_view name) const { return index_.suggestion(0, name); }

private:
    struct Called {
        std::string_view name;
        SectorId sector;
        auto operator<=>(const Called&) const = default;
    };
    std::vector<Called> all_;  ///< sorted
    NameIndex index_;
};

}  // namespace enfilade
