// Doom's lines as triggers.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "formats/map_file.h"
#include "wadconv/line_actions.h"
#include "wadconv/map_lumps.h"
#include "wadconv/neighbours.h"
#include "wadconv/parts.h"
#include "wadconv/pictures.h"
#include "wadconv/report.h"

namespace enfilade::wadconv {

/// What triggers call the sectors of a tag, and the exit of a teleport.
std::string tag_name(int tag);
std::string exit_name(std::uint32_t sector);

/// Damage for every 32 tics on a floor, by the sector's special; 0: none [points of health].
int damage_of(int special);

/// What floors cost a second [points of health], where Doom takes so much every 32 tics.
int damage_a_second(int damage);

/// By sector: whether a thing to teleport to stands in it.
using Exits = std::vector<bool>;

/// Makes triggers of lines. Everything it is given must outlive it.
class TriggerMaker {
public:
    TriggerMaker(const DoomMap& doom, const Parts& parts, const Pictures& pictures, const Neighbours& neighbours,
                 const Exits& exits, Report& report);

    /// What the wall in front of the line does, front side and all; none where the line's type is not known or can do
    /// nothing here (Report says why). `is_open`: one may pass.
    std::vector<TriggerRecord> triggers_of(std::uint32_t line, bool is_open) const;

private:
    struct LineJob {
        std::uint32_t line;
        const LineAction& line_action;
        TriggerRecord base;                  ///< without targets
        std::vector<std::uint32_t> sectors;  ///< of the line's tag
    };
    std::vector<TriggerRecord> remote(LineJob& job) const;
    std::vector<TriggerRecord> teleport(const LineJob& job) const;
    TriggerRecord leave_map(const LineJob& job) const;
    std::vector<TriggerRecord> one_by_one(const LineJob& job) const;
    std::vector<TriggerRecord> staircase(const LineJob& job, std::uint32_t sector) const;
    std::vector<TriggerRecord> donut(const LineJob& job, std::uint32_t pillar) const;
    std::vector<std::uint32_t> stairs_from(std::uint32_t sector) const;
    std::uint32_t beside_of_height(std::uint32_t sector, std::int16_t floor) const;
    void change_as(std::uint32_t model, bool takes_nature, TriggerRecord& trigger) const;
    void strobe(const LineJob& job, TriggerRecord& trigger) const;
    double shortest_lower(std::uint32_t sector) const;
    std::uint32_t front_of(std::uint32_t line) const;
    std::vector<std::string> targets_of(std::uint32_t sector) const;
    const DoomSector& sector(std::uint32_t number) const { return doom_.sectors[number]; }

    const DoomMap& doom_;
    const Parts& parts_;
    const Pictures& pictures_;
    const Neighbours& neighbours_;
    const Exits& exits_;
    Report& report_;
    std::map<int, std::vector<std::uint32_t>> by_tag_;  ///< sectors that became parts
    std::vector<std::string> names_;                    ///< of each sector's first part; empty: it has none
};

}  // namespace enfilade::wadconv
