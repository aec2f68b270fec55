#include "wadconv/wad_builder.h"

#include <algorithm>

namespace enfilade::wadconv::test {
namespace {

constexpr std::size_t kHeaderBytes = 12, kEntryBytes = 16;

Bytes encode(const std::vector<Vertex>& vertices) {
    ByteWriter out;
    for (const Vertex& v : vertices) {
        out.u16(static_cast<std::uint16_t>(v.x));
        out.u16(static_cast<std::uint16_t>(v.y));
    }
    return bytes_of(out);
}

Bytes encode(const std::vector<Linedef>& lines) {
    ByteWriter out;
    for (const Linedef& l : lines)
        for (std::uint16_t field : {l.start, l.end, l.flags, l.special, l.tag, l.right, l.left}) out.u16(field);
    return bytes_of(out);
}

Bytes encode(const std::vector<Sidedef>& sides) {
    ByteWriter out;
    for (const Sidedef& s : sides) {
        out.u16(static_cast<std::uint16_t>(s.x_offset));
        out.u16(static_cast<std::uint16_t>(s.y_offset));
        for (const std::string* name : {&s.upper, &s.lower, &s.middle}) put_name(out, *name);
        out.u16(s.sector);
    }
    return bytes_of(out);
}

Bytes encode(const std::vector<DoomSector>& sectors) {
    ByteWriter out;
    for (const DoomSector& s : sectors) {
        out.u16(static_cast<std::uint16_t>(s.floor));
        out.u16(static_cast<std::uint16_t>(s.ceiling));
        put_name(out, s.floor_flat);
        put_name(out, s.ceiling_flat);
        for (std::uint16_t field : {static_cast<std::uint16_t>(s.light), s.special, s.tag}) out.u16(field);
    }
    return bytes_of(out);
}

Bytes encode(const std::vector<DoomThing>& things) {
    ByteWriter out;
    for (const DoomThing& t : things)
        for (std::uint16_t field :
             {static_cast<std::uint16_t>(t.x), static_cast<std::uint16_t>(t.y), t.angle, t.type, t.flags})
            out.u16(field);
    return bytes_of(out);
}

/// One column's posts: runs of texels that are no holes.
void put_column(ByteWriter& out, const std::vector<std::string>& rows, std::size_t x) {
    for (std::size_t y = 0; y < rows.size(); ++y) {
        if (rows[y][x] == '.') continue;
        std::size_t end = y;
        while (end < rows.size() && rows[end][x] != '.') ++end;
        out.u8(static_cast<std::uint8_t>(y));
        out.u8(static_cast<std::uint8_t>(end - y));
        out.u8(0);
        for (; y < end; ++y) out.u8(static_cast<std::uint8_t>(rows[y][x] - 'a'));
        out.u8(0);
    }
    out.u8(255);
}

}  // namespace

void put_name(ByteWriter& out, std::string_view name) {
    for (std::size_t i = 0; i < 8; ++i) out.u8(i < name.size() ? static_cast<std::uint8_t>(name[i]) : 0);
}

void WadBuilder::add_map(const std::string& name, const DoomMap& map) {
    add(name);
    add("THINGS", encode(map.things));
    add("LINEDEFS", encode(map.lines));
    add("SIDEDEFS", encode(map.sides));
    add("VERTEXES", encode(map.vertices));
    add("SECTORS", encode(map.sectors));
}

std::vector<std::size_t> WadBuilder::boundaries() const {
    std::vector<std::size_t> starts;
    std::size_t at = kHeaderBytes;
    for (const Entry& lump : lumps_) {
        starts.push_back(at);
        at += lump.bytes.size();
    }
    starts.push_back(at);
    return starts;
}

void WadBuilder::put_directory(ByteWriter& out, std::size_t first_lump_at) const {
    for (const Entry& lump : lumps_) {
        out.u32(static_cast<std::uint32_t>(first_lump_at));
        out.u32(static_cast<std::uint32_t>(lump.bytes.size()));
        put_name(out, lump.name);
        first_lump_at += lump.bytes.size();
    }
}

Bytes WadBuilder::finish(std::string_view magic) const {
    ByteWriter out;
    out.text(magic);
    out.u32(static_cast<std::uint32_t>(lumps_.size()));
    out.u32(static_cast<std::uint32_t>(boundaries().back()));
    Bytes bytes = bytes_of(out);
    for (const Entry& lump : lumps_) bytes.insert(bytes.end(), lump.bytes.begin(), lump.bytes.end());
    ByteWriter directory;
    put_directory(directory, kHeaderBytes);
    bytes.insert(bytes.end(), directory.bytes().begin(), directory.bytes().end());
    return bytes;
}

Bytes WadBuilder::finish_directory_first() const {
    ByteWriter out;
    out.text("IWAD");
    out.u32(static_cast<std::uint32_t>(lumps_.size()));
    out.u32(static_cast<std::uint32_t>(kHeaderBytes));
    put_directory(out, kHeaderBytes + kEntryBytes * lumps_.size());
    Bytes bytes = bytes_of(out);
    for (const Entry& lump : lumps_) bytes.insert(bytes.end(), lump.bytes.begin(), lump.bytes.end());
    return bytes;
}

WadPile pile_of(std::vector<Bytes> archives) {
    std::vector<Wad> wads;
    for (Bytes& bytes : archives) {
        Result<Wad> wad = Wad::read("test.wad", std::move(bytes));
        ENFILADE_CHECK(wad.ok());
        wads.push_back(std::move(wad).value());
    }
    return WadPile(std::move(wads));
}

int Level::sector(int floor, int ceiling, std::string floor_flat, std::string ceiling_flat) {
    map.sectors.push_back(
        {std::int16_t(floor), std::int16_t(ceiling), std::move(floor_flat), std::move(ceiling_flat), 160, 0, 0});
    return static_cast<int>(map.sectors.size()) - 1;
}

int Level::side(int sector_number) {
    map.sides.push_back({0, 0, "-", "-", "WALL", static_cast<std::uint16_t>(sector_number)});
    return static_cast<int>(map.sides.size()) - 1;
}

std::uint16_t Level::vertex(Vertex v) {
    const auto same = [&](const Vertex& w) { return w.x == v.x && w.y == v.y; };
    const auto found = std::ranges::find_if(map.vertices, same);
    if (found != map.vertices.end()) return static_cast<std::uint16_t>(found - map.vertices.begin());
    map.vertices.push_back(v);
    return static_cast<std::uint16_t>(map.vertices.size() - 1);
}

int Level::line(Vertex a, Vertex b, int right, int left) {
    Linedef line{vertex(a), vertex(b), kBlocking, 0, 0, kNoSide, kNoSide};
    if (right >= 0) line.right = static_cast<std::uint16_t>(side(right));
    if (left >= 0) line.left = static_cast<std::uint16_t>(side(left));
    if (right >= 0 && left >= 0) {
        line.flags = kTwoSided;
        map.sides[line.right].middle = map.sides[line.left].middle = "-";
    }
    map.lines.push_back(line);
    return static_cast<int>(map.lines.size()) - 1;
}

void Level::ring(const std::vector<Vertex>& points, int right, int left) {
    for (std::size_t i = 0; i < points.size(); ++i) line(points[i], points[(i + 1) % points.size()], right, left);
}

void Level::box(int x0, int y0, int x1, int y1, int inside, int outside) {
    const auto at = [](int x, int y) { return Vertex{std::int16_t(x), std::int16_t(y)}; };
    ring({at(x0, y0), at(x0, y1), at(x1, y1), at(x1, y0)}, inside, outside);
}

void Level::thing(int x, int y, int type, int angle, int flags) {
    map.things.push_back(
        {std::int16_t(x), std::int16_t(y), std::uint16_t(angle), std::uint16_t(type), std::uint16_t(flags)});
}

Level small_level() {
    Level level;
    const int hall = level.sector(0, 128), niche = level.sector(16, 96, "FLOOR0_1", "F_SKY1");
    level.line({0, 0}, {0, 256}, hall);
    level.line({0, 256}, {256, 256}, hall);
    level.line({256, 256}, {256, 0}, hall, niche);
    level.line({256, 0}, {0, 0}, hall);
    level.line({256, 256}, {320, 256}, niche);
    level.line({320, 256}, {320, 0}, niche);
    level.line({320, 0}, {256, 0}, niche);
    level.ring({{64, 64}, {96, 64}, {96, 96}, {64, 96}}, hall);
    const int fence = level.line({128, 128}, {192, 128}, hall, hall);
    level.map.sides[level.map.lines[static_cast<std::size_t>(fence)].right].middle = "FENCE";
    level.map.lines[static_cast<std::size_t>(level.line({128, 192}, {192, 192}, hall, hall))].special = 97;
    level.thing(32, 32, 1, 90);
    level.thing(200, 40, 3004);
    level.thing(280, 40, 2035);
    return level;
}

Bytes patch(const std::vector<std::string>& rows, int left, int top) {
    const std::size_t width = rows[0].size();
    ByteWriter out, posts;
    for (int field : {int(width), int(rows.size()), left, top}) out.u16(static_cast<std::uint16_t>(field));
    for (std::size_t x = 0; x < width; ++x) {
        out.u32(static_cast<std::uint32_t>(8 + 4 * width + posts.bytes().size()));
        put_column(posts, rows, x);
    }
    Bytes bytes = bytes_of(out);
    bytes.insert(bytes.end(), posts.bytes().begin(), posts.bytes().end());
    return bytes;
}

Bytes pnames(const std::vector<std::string>& names) {
    ByteWriter out;
    out.u32(static_cast<std::uint32_t>(names.size()));
    for (const std::string& name : names) put_name(out, name);
    return bytes_of(out);
}

Bytes texture_lump(const std::vector<TextureText>& textures) {
    ByteWriter head, body;
    head.u32(static_cast<std::uint32_t>(textures.size()));
    for (const TextureText& t : textures) {
        head.u32(static_cast<std::uint32_t>(4 + 4 * textures.size() + body.bytes().size()));
        put_name(body, t.name);
        body.u32(0);
        body.u16(static_cast<std::uint16_t>(t.width));
        body.u16(static_cast<std::uint16_t>(t.height));
        body.u32(0);
        body.u16(static_cast<std::uint16_t>(t.patches.size()));
        for (const PatchPlace& p : t.patches)
            for (int field : {p.x, p.y, p.patch, 0, 0}) body.u16(static_cast<std::uint16_t>(field));
    }
    Bytes bytes = bytes_of(head);
    bytes.insert(bytes.end(), body.bytes().begin(), body.bytes().end());
    return bytes;
}

Bytes grey_palette() {
    ByteWriter out;
    for (int i = 0; i < 768; ++i) out.u8(static_cast<std::uint8_t>(i / 3));
    return bytes_of(out);
}

Bytes even_colormap() {
    ByteWriter out;
    for (int level = 0; level < 34; ++level)
        for (int i = 0; i < 256; ++i) out.u8(static_cast<std::uint8_t>(level < 32 ? i * (32 - level) / 32 : 0));
    return bytes_of(out);
}

Bytes sound(int rate, const std::vector<int>& samples) {
    ByteWriter out;
    out.u16(3);
    out.u16(static_cast<std::uint16_t>(rate));
    out.u32(static_cast<std::uint32_t>(samples.size()));
    for (const int sample : samples) out.u8(static_cast<std::uint8_t>(sample));
    return bytes_of(out);
}

WadBuilder picture_wad() {
    WadBuilder wad;
    wad.add("PLAYPAL", grey_palette());
    wad.add("COLORMAP", even_colormap());
    wad.add("PNAMES", pnames({"BRICK", "BARS", "CLOUD"}));
    wad.add("TEXTURE1", texture_lump({{"AANULL", 4, 4, {{0, 0, 0}}},
                                      {"WALL", 4, 4, {{0, 0, 0}}},
                                      {"SW1WALL", 4, 4, {{0, 0, 0}}},
                                      {"SW2WALL", 4, 4, {{0, 0, 0}}},
                                      {"FENCE", 4, 4, {{0, 0, 1}}},
                                      {"SKY1", 4, 128, {{0, 0, 2}}}}));
    wad.add("BRICK", patch({"abcd", "efgh", "ijkl", "mnop"}));
    wad.add("BARS", patch({"a.a.", "a.a.", "aaaa", "a.a."}));
    wad.add("CLOUD", patch({"abcd", "abcd"}));
    wad.add("S_START");
    for (const char* name : {"POSSA1", "POSSA2A8", "POSSA3A7", "POSSA4A6", "POSSA5", "POSSB1", "POSSB2B8", "POSSB3B7",
                             "POSSB4B6", "POSSB5"})
        wad.add(name, patch({"ab", "cd", "ef"}, 1, 3));
    for (const char* name : {"BAR1A0", "BAR1B0"}) wad.add(name, patch({"aa", "bb"}, 1, 2));
    wad.add("S_END");
    wad.add("F_START");
    for (const char* name : {"FLOOR0_1", "CEIL1_1", "F_SKY1"}) wad.add(name, Bytes(4096, std::byte{7}));
    wad.add("F_END");
    for (const char* name : {"DSDOROPN", "DSDORCLS", "DSBDOPN", "DSBDCLS", "DSPSTART", "DSPSTOP", "DSSTNMOV",
                             "DSSWTCHN", "DSSWTCHX", "DSTELEPT", "DSITEMUP"})
        wad.add(name, sound(11025, {127, 255, 0}));
    return wad;
}

}  // namespace enfilade::wadconv::test
