#include "formats/tape.h"

#include <algorithm>

#include "base/bytes.h"
#include "base/check.h"
#include "formats/utf8.h"

// All numbers little-endian:
//
//   8   "ENFTAPE" and the version, 1
//   4   rate
//   2   length of the map's name, then the name in UTF-8
//   8   map_hash
//   4   number of ticks, then 11 bytes for each: forward, strafe, yaw_steps, pitch_steps, buttons
//   8   final_hash

namespace enfilade {
namespace {

constexpr std::string_view kMagic = "ENFTAPE";
constexpr std::uint8_t kVersion = 1;
constexpr std::size_t kTickBytes = 11;
constexpr std::uint32_t kMaxRate = 1000;
constexpr std::uint8_t kAllButtons = kButtonRun | kButtonCrouch | kButtonUse | kButtonJump;

Error bad_tape(const ByteReader& reader, std::string what) {
    return {"byte " + std::to_string(reader.position()), std::move(what)};
}

Error ends_early(const ByteReader& reader) { return bad_tape(reader, "the tape ends in the middle; it was cut off"); }

bool is_valid_name(std::string_view name) {
    while (!name.empty()) {
        const std::size_t length = utf8_length(name);
        if (length == 0 || static_cast<unsigned char>(name[0]) < 0x20) return false;
        name.remove_prefix(length);
    }
    return true;
}

Status read_header(ByteReader& reader, Tape& tape) {
    if (as_text(reader.take(kMagic.size())) != kMagic)
        return bad_tape(reader, "not a tape: it does not start with ENFTAPE");
    const std::uint8_t version = reader.u8();
    if (reader.failed()) return ends_early(reader);
    if (version != kVersion)
        return bad_tape(reader, "the tape has version " + std::to_string(version) + "; only 1 can be read");
    tape.rate = reader.u32();
    const std::size_t name_length = reader.u16();
    if (reader.failed()) return ends_early(reader);
    if (tape.rate < 1 || tape.rate > kMaxRate)
        return bad_tape(reader, "expected 1 to 1000 ticks a second, found " + std::to_string(tape.rate));
    if (name_length > kMaxTapeMapName) return bad_tape(reader, "the map's name is longer than 4096 bytes");
    tape.map = as_text(reader.take(name_length));
    tape.map_hash = reader.u64();
    if (reader.failed()) return ends_early(reader);
    if (!is_valid_name(tape.map)) return bad_tape(reader, "the map's name is not UTF-8 text");
    return {};
}

InputRecord read_tick(ByteReader& reader) {
    InputRecord tick;
    tick.forward = static_cast<std::int8_t>(reader.u8());
    tick.strafe = static_cast<std::int8_t>(reader.u8());
    tick.yaw_steps = reader.i32();
    tick.pitch_steps = reader.i32();
    tick.buttons = reader.u8();
    return tick;
}

Status wrong_tick(const ByteReader& reader, const InputRecord& tick) {
    if (tick.forward == -128 || tick.strafe == -128)
        return bad_tape(reader, "the tick before this byte moves by -128; at most 127 is the full pace");
    if ((tick.buttons & ~kAllButtons) != 0)
        return bad_tape(reader, "the tick before this byte presses a button that is not known");
    return {};
}

Status read_ticks(ByteReader& reader, Tape& tape) {
    const std::uint32_t count = reader.u32();
    if (reader.failed() || count > reader.remaining() / kTickBytes) return ends_early(reader);
    tape.ticks.reserve(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        tape.ticks.push_back(read_tick(reader));
        if (Status wrong = wrong_tick(reader, tape.ticks.back())) return wrong;
    }
    return {};
}

}  // namespace

Result<Tape> read_tape(std::span<const std::byte> bytes) {
    ByteReader reader(bytes);
    Tape tape;
    if (Status failed = read_header(reader, tape)) return *failed;
    if (Status failed = read_ticks(reader, tape)) return *failed;
    tape.final_hash = reader.u64();
    if (reader.failed()) return ends_early(reader);
    if (reader.remaining() > 0)
        return bad_tape(reader,
                        "the tape should end here, found " + std::to_string(reader.remaining()) + " more bytes");
    return tape;
}

Bytes write_tape(const Tape& tape) {
    ENFILADE_CHECK(tape.map.size() <= kMaxTapeMapName);
    ENFILADE_CHECK(tape.rate >= 1 && tape.rate <= kMaxRate);
    ByteWriter writer;
    writer.text(kMagic);
    writer.u8(kVersion);
    writer.u32(tape.rate);
    writer.u16(static_cast<std::uint16_t>(tape.map.size()));
    writer.text(tape.map);
    writer.u64(tape.map_hash);
    writer.u32(static_cast<std::uint32_t>(tape.ticks.size()));
    for (const InputRecord& tick : tape.ticks) {
        writer.u8(static_cast<std::uint8_t>(tick.forward));
        writer.u8(static_cast<std::uint8_t>(tick.strafe));
        writer.u32(static_cast<std::uint32_t>(tick.yaw_steps));
        writer.u32(static_cast<std::uint32_t>(tick.pitch_steps));
        writer.u8(tick.buttons);
    }
    writer.u64(tape.final_hash);
    return {writer.bytes().begin(), writer.bytes().end()};
}

}  // namespace enfilade
