#include "map/target_names.h"

#include <algorithm>

namespace enfilade {
namespace {

std::vector<ScopedName> scoped_names(const MapFile& file) {
    std::vector<ScopedName> names;
    for (std::uint32_t i = 0; i < file.sectors.size(); ++i) {
        names.push_back({0, file.sectors[i].name, i});
        for (const std::string& tag : file.sectors[i].tags) names.push_back({0, tag, i});
    }
    return names;
}

}  // namespace

TargetNames::TargetNames(const MapFile& file) : index_(scoped_names(file)) {
    for (const ScopedName& name : scoped_names(file)) all_.push_back({name.name, SectorId(name.id)});
    std::sort(all_.begin(), all_.end());
    all_.erase(std::unique(all_.begin(), all_.end()), all_.end());
}

bool TargetNames::add_sectors(std::string_view name, std::vector<SectorId>& sectors) const {
    const auto found = std::equal_range(all_.begin(), all_.end(), Called{name, {}},
                                        [](const Called& a, const Called& b) { return a.name < b.name; });
    const auto before = sectors.size();
    for (auto it = found.first; it != found.second; ++it)
        if (std::find(sectors.begin(), sectors.begin() + static_cast<std::ptrdiff_t>(before), it->sector) ==
            sectors.begin() + static_cast<std::ptrdiff_t>(before))
            sectors.push_back(it->sector);
    return found.first != found.second;
}

}  // namespace enfilade
