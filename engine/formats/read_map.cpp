#include "formats/map_keys.h"
#include "formats/map_toml.h"

namespace enfilade {
namespace {

Dialect dialect_of(TomlNode root) {
    const auto entries = root.entries();
    return find_entry(entries, "format") ? Dialect::enfilade : Dialect::tutorial;
}

}  // namespace

MapReading read_map(std::string_view text) {
    MapReading result;
    const auto document = TomlDocument::parse(text, {kMaxMapBytes, kMaxMapValues}, result.findings);
    if (!document) return result;
    Reading reading{result.findings, dialect_of(document->root())};
    read_record(reading, document->root(), result.map);
    sort_by_place(result.findings);
    return result;
}

}  // namespace enfilade
