// The sectors that triggers are about: by their names, and by the tags that several of them may share. Private to map/.
#pragma once
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "map/draft.h"
#include "map/names.h"

namespace enfilade {

/// Makes the lists in Map::targets, each only once: ten thousand triggers about one tag share one.
class TargetLists {
public:
    explicit TargetLists(Draft& draft);

    /// The first sector of that name or tag, or none. Cost: log of the number of names.
    SectorId first_of(std::string_view name) const;

    /// The sectors that the trigger names, in the order of its names and then of the file, each once; of a group its
    /// leader; without the names that no sector has. Empty, with a finding, where the lists together get too long.
    /// Cost: log of the number of names for each; and for a list that is new, its sectors.
    TargetRange list_of(const TriggerRecord& record);

    /// The list of this sector alone.
    TargetRange list_of(SectorId sector);

    /// "; did you mean 'X'?" or nothing.
    std::string suggestion(std::string_view name) const { return index_.suggestion(0, name); }

private:
    std::span<const SectorId> sectors_of(std::string_view name) const;
    bool has_room_for(const TriggerRecord& record, std::span<const std::span<const SectorId>> parts);
    TargetRange new_list(std::span<const std::span<const SectorId>> parts);

    Draft& draft_;
    std::vector<std::string_view> names_;  ///< sorted
    std::vector<SectorId> named_;  ///< who has the name of that index; in the order of the file where several have
    std::map<std::vector<const SectorId*>, TargetRange> known_;  ///< by where the sectors of each name begin in named_
    std::map<SectorId, TargetRange> alone_;
    std::size_t listed_ = 0;                ///< sectors in all lists, counted before those that are there twice go
    std::vector<std::uint32_t> last_list_;  ///< the last list a sector was put in, counted from 1; by SectorId
    std::uint32_t list_count_ = 0;
    NameIndex index_;
};

}  // namespace enfilade
