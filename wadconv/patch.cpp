#include "wadconv/patch.h"

#include <algorithm>

#include "base/bytes.h"

namespace enfilade::wadconv {
namespace {

constexpr std::size_t kHeaderBytes = 8;
constexpr std::uint8_t kEndOfColumn = 255;

Error bad_column(std::uint32_t x, const std::string& what) { return {"", "column " + std::to_string(x) + " " + what}; }

/// Posts may repeat rows, but one that paints several times its height is there to keep us busy [rows].
std::uint32_t max_painted_rows(std::uint32_t height) { return 2 * height + 255; }

/// Reads one column's posts from the reader into column x.
Status read_column(ByteReader reader, std::uint32_t x, Picture& picture) {
    std::uint32_t top = 0, painted = 0;
    bool is_first = true;
    for (;;) {
        const std::uint8_t row = reader.u8();
        if (reader.failed()) return bad_column(x, "has no end");
        if (row == kEndOfColumn) return {};
        top = is_first || row > top ? row : top + row;
        is_first = false;
        const std::uint8_t length = reader.u8();
        reader.u8();  // a copy of the first texel, for a renderer that rounds
        const auto texels = reader.take(length);
        reader.u8();  // and of the last
        if (reader.failed()) return bad_column(x, "leads out of the lump");
        painted += length + 1u;
        if (painted > max_painted_rows(picture.height)) return bad_column(x, "paints more rows than the picture has");
        for (std::uint32_t i = 0; i < length && top + i < picture.height; ++i)
            picture.at(x, top + i) = std::to_integer<std::int16_t>(texels[i]);
    }
}

}  // namespace

Result<PatchHeader> read_patch_header(std::span<const std::byte> lump) {
    ByteReader reader(lump);
    PatchHeader header;
    header.width = reader.u16();
    header.height = reader.u16();
    header.left = reader.i16();
    header.top = reader.i16();
    if (reader.failed()) return Error{"", "the picture has only " + std::to_string(lump.size()) + " bytes"};
    if (header.width < 1 || header.height < 1 || header.width > kMaxPictureSide || header.height > kMaxPictureSide)
        return Error{"", "expected a picture of 1 to " + std::to_string(kMaxPictureSide) + " texels a side, found " +
                             std::to_string(header.width) + " x " + std::to_string(header.height)};
    if (reader.remaining() / 4 < header.width)
        return Error{"", "the table of " + std::to_string(header.width) + " columns does not fit the picture's " +
                             std::to_string(lump.size()) + " bytes"};
    return header;
}

Result<Picture> read_patch(std::span<const std::byte> lump) {
    const Result<PatchHeader> header = read_patch_header(lump);
    if (!header) return header.error();
    Picture picture(header.value().width, header.value().height);
    ByteReader offsets(lump.subspan(kHeaderBytes));
    for (std::uint32_t x = 0; x < picture.width; ++x) {
        const std::uint32_t offset = offsets.u32();
        if (offset >= lump.size())
            return bad_column(x, "starts at byte " + std::to_string(offset) + " of " + std::to_string(lump.size()));
        if (Status failed = read_column(ByteReader(lump.subspan(offset)), x, picture)) return *failed;
    }
    return picture;
}

}  // namespace enfilade::wadconv
