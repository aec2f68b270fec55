// Suns: from angles to directions, and which sector each shines on.
#include <vector>

#include "formats/quoted.h"
#include "map/draft.h"
#include "map/names.h"

namespace enfilade {
namespace {

Sun sun_from(const SunRecord& record) {
    const Vec2 climb = direction(Angle::from_degrees(record.elevation_degrees));  // along the ground, and up
    return {direction(Angle::from_degrees(record.yaw_degrees)) * climb.x, climb.y, record.color, record.brightness};
}

NameIndex sun_names(const Draft& draft) {
    std::vector<ScopedName> names;
    for (std::uint32_t i = 0; i < draft.file.suns.size(); ++i)
        if (!draft.file.suns[i].name.empty()) names.push_back({0, draft.file.suns[i].name, i});
    return NameIndex(std::move(names));
}

void check_names(Draft& draft, const NameIndex& names) {
    for (const auto& [first, again] : names.duplicates())
        draft.error(draft.file.suns[again], "name", "duplicate-sun",
                    "expected a name no other sun has, found " + quoted(draft.file.suns[again].name) + " again");
}

}  // namespace

void place_suns(Draft& draft) {
    const NameIndex names = sun_names(draft);
    check_names(draft, names);
    for (const SunRecord& record : draft.file.suns) draft.map.suns.push_back(sun_from(record));
    for (std::size_t i = 0; i < draft.map.sectors.size(); ++i) {
        const SectorRecord& record = *draft.sectors[i].record;
        if (record.sun.empty()) continue;
        if (const auto found = names.find(0, record.sun)) {
            draft.map.sectors[i].sun = SunId(*found);
            continue;
        }
        const std::string alike = names.suggestion(0, record.sun);
        draft.error(record, "sun", "unknown-sun",
                    "expected the name of a sun, found " + quoted(record.sun) +
                        (alike.empty() ? "; add [[suns]] with that name" : alike));
    }
}

}  // namespace enfilade
