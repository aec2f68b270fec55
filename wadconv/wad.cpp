#include "wadconv/wad.h"

#include <algorithm>
#include <array>
#include <optional>

#include "base/files.h"
#include "formats/text_parts.h"

namespace enfilade::wadconv {
namespace {

constexpr std::size_t kHeaderBytes = 12;
constexpr std::size_t kEntryBytes = 16;
constexpr std::size_t kNameBytes = 8;

/// A directory entry as it is on disk; nothing in it is to be trusted.
struct DirectoryEntry {
    std::int32_t offset;
    std::int32_t size;
    std::string name;
};

DirectoryEntry read_entry(ByteReader& reader) {
    DirectoryEntry entry;
    entry.offset = reader.i32();
    entry.size = reader.i32();
    entry.name = lump_name(reader.take(kNameBytes));
    return entry;
}

/// True where [offset, offset + size) lies within a file of `total` bytes.
bool fits(std::int64_t offset, std::int64_t size, std::size_t total) {
    return offset >= 0 && size >= 0 && offset + size <= static_cast<std::int64_t>(total);
}

Error outside_file(const std::string& file, std::size_t index, const DirectoryEntry& entry, std::size_t total) {
    return {file, "lump " + std::to_string(index) + " " + in_quotes(entry.name) + " is said to take " +
                      std::to_string(entry.size) + " bytes from byte " + std::to_string(entry.offset) +
                      ", but the file has " + std::to_string(total)};
}

enum class Section { none, flats, sprites };

/// Which section a marker such as F_START or SS_START opens; nothing where the name is no such marker.
std::optional<Section> section_opened(std::string_view name) {
    if (name == "F_START" || name == "FF_START") return Section::flats;
    if (name == "S_START" || name == "SS_START") return Section::sprites;
    if (name == "F_END" || name == "FF_END" || name == "S_END" || name == "SS_END") return Section::none;
    return {};
}

}  // namespace

std::string lump_name(std::span<const std::byte> field) {
    std::string name;
    for (std::byte b : field.first(std::min(field.size(), kNameBytes))) {
        char c = static_cast<char>(b);
        if (c == 0) break;
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
        name += c > ' ' && c <= '~' ? c : '?';
    }
    return name;
}

Result<Wad> Wad::read(std::string file, Bytes bytes) {
    Wad wad(std::move(file), std::move(bytes));
    ByteReader header(wad.bytes_);
    const std::string magic = lump_name(header.take(4));
    const std::int32_t count = header.i32(), directory = header.i32();
    if (wad.bytes_.size() < kHeaderBytes || (magic != "IWAD" && magic != "PWAD"))
        return Error{wad.file_, "expected a WAD, which starts with IWAD or PWAD"};
    if (!fits(directory, std::int64_t{count} * static_cast<std::int64_t>(kEntryBytes), wad.bytes_.size()))
        return Error{wad.file_, "the directory is said to have " + std::to_string(count) + " entries from byte " +
                                    std::to_string(directory) + ", but the file has " +
                                    std::to_string(wad.bytes_.size()) + " bytes"};
    if (static_cast<std::size_t>(count) > kMaxLumps)
        return Error{wad.file_, "the directory has " + std::to_string(count) + " entries; at most " +
                                    std::to_string(kMaxLumps) + " are read"};
    ByteReader entries(std::span(wad.bytes_).subspan(static_cast<std::size_t>(directory)));
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        const DirectoryEntry entry = read_entry(entries);
        // Markers have no bytes, and many tools leave a meaningless offset in them.
        if (entry.size != 0 && !fits(entry.offset, entry.size, wad.bytes_.size()))
            return outside_file(wad.file_, i, entry, wad.bytes_.size());
        const auto all = std::span<const std::byte>(wad.bytes_);
        wad.lumps_.push_back({entry.name, entry.size == 0 ? std::span<const std::byte>{}
                                                          : all.subspan(static_cast<std::size_t>(entry.offset),
                                                                        static_cast<std::size_t>(entry.size))});
    }
    return wad;
}

WadPile::WadPile(std::vector<Wad> wads) : wads_(std::move(wads)) {
    for (const Wad& wad : wads_) {
        Section section = Section::none;
        for (const Lump& lump : wad.lumps()) {
            if (const auto opened = section_opened(lump.name))
                section = *opened;
            else if (section == Section::none)
                lumps_[lump.name] = &lump;
            else if (!lump.bytes.empty())
                (section == Section::flats ? flats_ : sprites_)[lump.name] = &lump;
        }
    }
}

const Lump* WadPile::find(std::string_view name) const {
    for (const Names* names : {&lumps_, &sprites_})
        if (const auto found = names->find(name); found != names->end()) return found->second;
    return nullptr;
}

// The maps.

namespace {

std::string read_name(ByteReader& reader) { return lump_name(reader.take(kNameBytes)); }

// Fields are read in the order they have on disk; braces keep that order.
void read(ByteReader& in, Vertex& v) { v = {in.i16(), in.i16()}; }

void read(ByteReader& in, Linedef& l) { l = {in.u16(), in.u16(), in.u16(), in.u16(), in.u16(), in.u16(), in.u16()}; }

void read(ByteReader& in, Sidedef& s) {
    s.x_offset = in.i16();
    s.y_offset = in.i16();
    s.upper = read_name(in);
    s.lower = read_name(in);
    s.middle = read_name(in);
    s.sector = in.u16();
}

void read(ByteReader& in, DoomSector& s) {
    s.floor = in.i16();
    s.ceiling = in.i16();
    s.floor_flat = read_name(in);
    s.ceiling_flat = read_name(in);
    s.light = in.i16();
    s.special = in.u16();
    s.tag = in.u16();
}

void read(ByteReader& in, DoomThing& t) { t = {in.i16(), in.i16(), in.u16(), in.u16(), in.u16()}; }

/// Decodes whole records of `record_bytes` each; adds what is left over to trailing_bytes.
template <class Record>
Result<void> decode(const char* lump, std::span<const std::byte> bytes, std::size_t record_bytes,
                    std::vector<Record>& records, DoomMap& map) {
    const std::size_t count = bytes.size() / record_bytes;
    if (count > kMaxRecords)
        return Error{map.name, std::string(lump) + " has " + std::to_string(count) +
                                   " records; numbers of 16 bits reach " + std::to_string(kMaxRecords)};
    map.trailing_bytes += bytes.size() % record_bytes;
    ByteReader reader(bytes);
    records.resize(count);
    for (Record& record : records) read(reader, record);
    return {};
}

}  // namespace

Result<DoomMap> decode_map(const MapLumps& lumps) {
    DoomMap map;
    map.name = lumps.name;
    for (const Result<void>& decoded :
         {decode("VERTEXES", lumps.vertices, 4, map.vertices, map), decode("LINEDEFS", lumps.lines, 14, map.lines, map),
          decode("SIDEDEFS", lumps.sides, 30, map.sides, map), decode("SECTORS", lumps.sectors, 26, map.sectors, map),
          decode("THINGS", lumps.things, 10, map.things, map)})
        if (!decoded.ok()) return decoded.error();
    return map;
}

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Lumps that may follow a map's name and belong to it.
constexpr std::array<std::string_view, 13> kMapLumps = {"THINGS",   "LINEDEFS", "SIDEDEFS", "VERTEXES", "SEGS",
                                                        "SSECTORS", "NODES",    "SECTORS",  "REJECT",   "BLOCKMAP",
                                                        "BEHAVIOR", "SCRIPTS",  "TEXTMAP"};

bool belongs_to_map(std::string_view name) { return std::ranges::find(kMapLumps, name) != kMapLumps.end(); }

/// The lumps after a map's name that belong to it.
std::span<const Lump> lumps_after(const std::vector<Lump>& lumps, std::size_t marker) {
    std::size_t end = marker + 1;
    while (end < lumps.size() && belongs_to_map(lumps[end].name)) ++end;
    return std::span(lumps).subspan(marker + 1, end - marker - 1);
}

bool has(std::span<const Lump> lumps, std::string_view name) {
    return std::ranges::any_of(lumps, [&](const Lump& lump) { return lump.name == name; });
}

Result<MapLumps> take_lumps(const std::string& file, std::string_view map, std::span<const Lump> lumps) {
    const std::string where = file + ": " + std::string(map);
    if (has(lumps, "TEXTMAP"))
        return Error{where, "the map is in UDMF (it has a TEXTMAP lump); expected Doom's format"};
    if (has(lumps, "BEHAVIOR"))
        return Error{where, "the map is in Hexen's format (it has a BEHAVIOR lump); expected Doom's format"};
    MapLumps found;
    found.name = map;
    struct Wanted {
        std::string_view name;
        std::span<const std::byte>* bytes;
    };
    for (const Wanted& wanted :
         {Wanted{"THINGS", &found.things}, Wanted{"LINEDEFS", &found.lines}, Wanted{"SIDEDEFS", &found.sides},
          Wanted{"VERTEXES", &found.vertices}, Wanted{"SECTORS", &found.sectors}}) {
        const auto lump = std::ranges::find(lumps, wanted.name, &Lump::name);
        if (lump == lumps.end()) return Error{where, "the map has no " + std::string(wanted.name) + " lump"};
        *wanted.bytes = lump->bytes;
    }
    return found;
}

}  // namespace

bool is_map_name(std::string_view name) {
    if (name.size() == 4) return name[0] == 'E' && is_digit(name[1]) && name[2] == 'M' && is_digit(name[3]);
    return name.size() == 5 && name.starts_with("MAP") && is_digit(name[3]) && is_digit(name[4]);
}

std::vector<std::string> map_names(const WadPile& pile) {
    std::vector<std::string> names;
    for (const Wad& wad : pile.wads())
        for (const Lump& lump : wad.lumps())
            if (is_map_name(lump.name) && std::ranges::find(names, lump.name) == names.end())
                names.push_back(lump.name);
    return names;
}

Result<MapLumps> find_map(const WadPile& pile, std::string_view name) {
    for (auto wad = pile.wads().rbegin(); wad != pile.wads().rend(); ++wad) {
        const auto& lumps = wad->lumps();
        for (std::size_t i = lumps.size(); i-- > 0;)
            if (lumps[i].name == name && is_map_name(name)) return take_lumps(wad->file(), name, lumps_after(lumps, i));
    }
    return Error{pile.wads().empty() ? "" : pile.wads().back().file(), "there is no map " + in_quotes(name)};
}

namespace {

/// Where one comes back to from an episode's ninth level, by episode; later ones as the fourth.
constexpr std::array kAfterNinth = {'4', '6', '7', '3'};

std::string next_of_episode(std::string_view map, bool by_secret_exit) {
    std::string next(map);
    if (map[3] == '9')
        next[3] = kAfterNinth[map[1] >= '1' && map[1] <= '4' ? static_cast<std::size_t>(map[1] - '1') : 3];
    else if (by_secret_exit)
        next[3] = '9';
    else if (map[3] == '8')
        return {};
    else
        ++next[3];
    return next;
}

std::string numbered(int number) {
    return std::string("MAP") + static_cast<char>('0' + number / 10) + static_cast<char>('0' + number % 10);
}

}  // namespace

std::string next_map(std::string_view map, bool by_secret_exit) {
    if (map.starts_with('E')) return next_of_episode(map, by_secret_exit);
    const int number = (map[3] - '0') * 10 + (map[4] - '0');
    if (by_secret_exit && number == 15) return numbered(31);
    if (by_secret_exit && number == 31) return numbered(32);
    if (number == 31 || number == 32) return numbered(16);
    if (number == 30 || number == 99) return {};
    return numbered(number + 1);
}

Neighbours::Neighbours(const DoomMap& doom) : doom_(doom) {
    struct Beside {
        std::uint32_t sector;
        Neighbour neighbour;
    };
    std::vector<Beside> found;
    for (std::uint32_t i = 0; i < doom.lines.size(); ++i) {
        const Linedef& line = doom.lines[i];
        const Sidedef *right = doom.side_of(line.right), *left = doom.side_of(line.left);
        if (!(line.flags & kTwoSided) || !right || !left) continue;
        found.push_back({right->sector, {i, left->sector, true}});
        found.push_back({left->sector, {i, right->sector, false}});
    }
    std::ranges::stable_sort(found, {}, &Beside::sector);
    first_.resize(doom.sectors.size() + 1);
    for (const Beside& beside : found) {
        ++first_[beside.sector + 1];
        all_.push_back(beside.neighbour);
    }
    for (std::size_t s = 0; s < doom.sectors.size(); ++s) first_[s + 1] += first_[s];
}

std::span<const Neighbour> Neighbours::of(std::uint32_t sector) const {
    return std::span(all_).subspan(first_[sector], first_[sector + 1] - first_[sector]);
}

std::int16_t Neighbours::darkest(std::uint32_t sector) const {
    std::int16_t darkest = doom_.sectors[sector].light;
    for (const Neighbour& n : of(sector)) darkest = std::min(darkest, doom_.sectors[n.sector].light);
    return darkest;
}

std::int16_t Neighbours::lowest_floor(std::uint32_t sector) const {
    std::int16_t lowest = doom_.sectors[sector].floor;
    for (const Neighbour& n : of(sector)) lowest = std::min(lowest, doom_.sectors[n.sector].floor);
    return lowest;
}

}  // namespace enfilade::wadconv
