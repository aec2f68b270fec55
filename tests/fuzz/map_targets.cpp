// Maps: as text in both dialects, compiled, and legal ones made of bytes.
#include <algorithm>
#include <array>
#include <bit>
#include <limits>

#include "app/authoring/plan.h"
#include "base/files.h"
#include "base/hash.h"
#include "formats/map_toml.h"
#include "formats/toml.h"
#include "fuzz/targets.h"
#include "render/choice/renderer.h"
#include "support/furnish.h"
#include "support/map_builder.h"
#include "wild/choices.h"
#include "wild/trial.h"
#include "wild/worlds.h"
#include "world/step.h"

namespace enfilade::test {
namespace {

/// What is written is read again as the same, and so is what is written then.
void check_writing(const MapFile& file) {
    const std::string text = write_map(file);
    const MapReading again = read_map(text);
    ENFILADE_CHECK(!has_errors(again.findings));
    ENFILADE_CHECK(write_map(again.map) == text);
}

void expect_no_fault(const TrialMap& on, const TrialPlan& plan) {
    const std::optional<Fault> fault = first_fault(on, plan);
    if (fault) contract_broken(__FILE__, __LINE__, fault->what.c_str());
}

/// What prefabs of a map find: the map itself under the name "self", otherwise a room.
Result<Bytes> prefab_of(std::span<const std::byte> map, const std::string& name) {
    constexpr std::string_view kRoom = "format = 1\n[[sectors]]\nname = 'room'\nrect = [0, 0, 2, 1]\nwall = {}\n";
    const auto room = std::as_bytes(std::span(kRoom));
    return name == "self" ? Bytes(map.begin(), map.end()) : Bytes(room.begin(), room.end());
}

/// Laid out anew it says the same, and is laid out already.
void check_layout(std::string_view text) {
    const auto once = lay_out_toml(text);
    if (!once.ok()) return ENFILADE_CHECK(once.error().what.find("please report") == std::string::npos);
    const auto twice = lay_out_toml(once.value());
    ENFILADE_CHECK(twice.ok() && twice.value() == once.value());
}

}  // namespace

void fuzz_map(std::span<const std::byte> bytes) {
    const std::string_view text = as_text(bytes);
    check_layout(text);
    MapReading reading = read_map(text, [&](const std::string& name) { return prefab_of(bytes, name); });
    is_map(text);
    if (!has_errors(reading.findings)) {
        check_writing(reading.map);
        plan_svg(reading.map);
    }
    const TextureSet textures = textures_for(reading.map);
    const std::optional<Map> map = build_map(reading.map, textures, reading.findings);
    ENFILADE_CHECK(map.has_value() == !has_errors(reading.findings));
    if (map) expect_no_fault({*map, textures}, {.seed = text.size(), .poses = 1, .largest = {16, 12}, .ticks = 60});
}

void fuzz_world(std::span<const std::byte> bytes) {
    Choices choices(bytes);
    const MapFile file = wild_world(choices);
    check_writing(file);
    const TextureSet textures = textures_for(file);
    Findings findings;
    const std::optional<Map> map = build_map(file, textures, findings);
    if (!map) contract_broken(__FILE__, __LINE__, text_of(findings).c_str());
    expect_no_fault({*map, textures}, {.seed = bytes.size(), .poses = 1, .largest = {12, 8}, .ticks = 30});
}

// Compiled maps.

namespace {

/// Of a map with something of everything: what bytes make another one of.
struct Compilation {
    MapFile file;
    TextureSet textures;
    Bytes bytes;
};

constexpr std::uint64_t kSource = 42;

MapFile furnished_file() {
    MapFile file = map_of({box_room("left", 0, 0, 8, 4, 0, 3), box_room("door", 8, 1, 8.5, 3, 0, 0),
                           box_room("right", 8.5, 0, 16, 4, 0.5, 3)});
    split_and_join(file);
    link(file, "left", {0, 4}, {0, 0}, "right", {16, 0}, {16, 4});
    wall(file, "left", {0, 0}, {8, 0}).mirror = true;
    sector(file, "door").triggers.emplace_back();  // a door that opens when it is used
    SoundRecord& hum = file.sounds.emplace_back();
    hum.name = "hum";
    hum.file = "hum.wav";
    sector(file, "door").move_sound = "hum";
    scatter_panels(file, 20, 1);
    scatter_things(file, 6, 2);
    scatter_lights(file, 3, 3);
    enliven(file);
    file.things.front().sound = "hum";
    file.things.front().solid = true;
    place_player(file, "left", {2, 2}, 1.5);
    return file;
}

Compilation compiled_of(MapFile file) {
    Compilation made{std::move(file), {}, {}};
    made.textures = textures_for(made.file);
    CompiledMap whole;
    Findings findings;
    whole.map = *build_map(made.file, made.textures, findings);
    whole.needs = pictures_needed(made.file);
    for (const Texture& picture : made.textures.textures) whole.sizes.push_back({picture.width, picture.height});
    made.bytes = compile(whole, kSource);
    return made;
}

constexpr std::array kWildNumbers{std::numeric_limits<double>::quiet_NaN(),
                                  std::numeric_limits<double>::infinity(),
                                  -std::numeric_limits<double>::infinity(),
                                  5e278,
                                  -1e300,
                                  0.0,
                                  -0.0,
                                  1.0,
                                  -1.0,
                                  std::numeric_limits<double>::denorm_min(),
                                  kWorldLimit,
                                  -kWorldLimit,
                                  kVertexGrid,
                                  1024.0,
                                  0x1p30,
                                  0x1p-16};

void put(std::span<std::byte> place, std::uint64_t bits) {
    for (std::byte& byte : place.first(std::min<std::size_t>(place.size(), 8))) {
        byte = static_cast<std::byte>(bits);
        bits >>= 8;
    }
}

/// One change: a byte, a number, or a number from elsewhere.
void change(Choices& choices, Bytes& bytes) {
    const auto place = [&] { return std::span(bytes).subspan(choices.below(bytes.size())); };
    switch (choices.below(4)) {
        case 0: return put(place().first(1), choices.below(256));
        case 1: return put(place(), std::bit_cast<std::uint64_t>(kWildNumbers[choices.below(kWildNumbers.size())]));
        case 2: return put(place(), std::bit_cast<std::uint64_t>(choices.between(-4, 4)));
        default: {
            const auto from = place(), onto = place();
            const std::size_t length = std::min({std::size_t{8}, from.size(), onto.size()});
            std::copy_n(Bytes(from.begin(), from.begin() + std::ptrdiff_t(length)).begin(), length, onto.begin());
        }
    }
}

/// As load_map() would take it: drawn and walked in, whatever is in it.
void visit(const Map& map, const TextureSet& textures) {
    const auto renderer = make_renderer({RendererKind::column, {}, 1, {}}, map, textures);
    ENFILADE_CHECK(renderer.ok());
    const std::optional<World> start = start_of(map);
    if (!start) return;
    Timeline walk(*start);
    Snapshot snapshot = at_rest(map);
    Frame frame;
    frame.resize(24, 16);
    for (int tick = 0; tick < 32; ++tick) {
        walk.play(map, {.forward = 127, .yaw_steps = 1 << 27, .buttons = kButtonUse});
        if (tick % 16 > 0) continue;
        show({map, walk.world().history, static_cast<double>(walk.world().tick)}, snapshot);
        const View view = view_from(eye_between_ticks(map, walk.world(), 1), lens_for(map.render));
        ENFILADE_CHECK(renderer.value()->render(frame, nullptr, snapshot, view).ok());
    }
}

}  // namespace

void fuzz_compiled(std::span<const std::byte> bytes) {
    static const Compilation whole = compiled_of(furnished_file());
    Choices choices(bytes);
    Bytes changed = whole.bytes;
    while (!choices.is_at_end()) change(choices, changed);
    constexpr std::size_t kHead = 16, kTail = 8;
    std::copy_n(whole.bytes.begin(), kHead, changed.begin());
    put(std::span(changed).last(kTail), hash_of_bytes(std::span(changed).first(changed.size() - kTail)));
    const auto read = read_compiled(changed, kSource);
    if (!read || read->needs.pictures.size() != whole.textures.textures.size()) return;
    ENFILADE_CHECK(read_compiled(compile(*read, kSource), kSource).has_value());
    visit(read->map, whole.textures);
}

}  // namespace enfilade::test
