#include "wadconv/doom_records.h"

#include "base/bytes.h"
#include "wadconv/wad.h"

namespace enfilade::wadconv {
namespace {

std::string read_name(ByteReader& reader) { return lump_name(reader.take(8)); }

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
Status decode(const char* lump, std::span<const std::byte> bytes, std::size_t record_bytes,
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
    for (const Status& failed :
         {decode("VERTEXES", lumps.vertices, 4, map.vertices, map), decode("LINEDEFS", lumps.lines, 14, map.lines, map),
          decode("SIDEDEFS", lumps.sides, 30, map.sides, map), decode("SECTORS", lumps.sectors, 26, map.sectors, map),
          decode("THINGS", lumps.things, 10, map.things, map)})
        if (failed) return *failed;
    return map;
}

}  // namespace enfilade::wadconv
