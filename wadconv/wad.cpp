#include "wadconv/wad.h"

#include <algorithm>
#include <optional>

#include "base/bytes.h"
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

}  // namespace enfilade::wadconv
