#include "formats/tape.h"

#include <algorithm>

#include "base/files.h"
#include "base/result.h"
#include "base/text.h"

// All numbers little-endian:
//
//   8   "ENFTAPE" and the version, 2
//   4   rate; 2^31 more where rooms were found by the place alone
//   2   length of the map's name, then the name in UTF-8
//   8   map_hash
//  11   for each tick: forward, strafe, yaw_steps, pitch_steps, buttons
//   1   0x80, which no tick begins with
//   8   final_hash
//
// So a tape can be written tick by tick, and is one wherever it was stopped. Version 1 had the number of ticks, 4
// bytes, before them, and no 0x80.

namespace enfilade {
namespace {

constexpr std::string_view kMagic = "ENFTAPE";
constexpr std::uint8_t kVersion = 2, kVersionWithCount = 1;
constexpr std::byte kEndMark{0x80};
constexpr std::size_t kEndBytes = 9;  // the mark and the hash
constexpr std::uint32_t kMaxRate = 1000, kNaiveBit = 1u << 31;
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

/// Its version, after the tape has all but its ticks.
Result<std::uint8_t> read_header(ByteReader& reader, Tape& tape) {
    if (as_text(reader.take(kMagic.size())) != kMagic)
        return bad_tape(reader, "not a tape: it does not start with ENFTAPE");
    const std::uint8_t version = reader.u8();
    if (reader.failed()) return ends_early(reader);
    if (version != kVersion && version != kVersionWithCount)
        return bad_tape(reader, "the tape has version " + std::to_string(version) + "; 1 and 2 can be read");
    const std::uint32_t rate = reader.u32();
    tape.rate = rate & ~kNaiveBit;
    tape.is_naive = (rate & kNaiveBit) != 0;
    const std::size_t name_length = reader.u16();
    if (reader.failed()) return ends_early(reader);
    if (tape.rate < 1 || tape.rate > kMaxRate)
        return bad_tape(reader, "expected 1 to 1000 ticks a second, found " + std::to_string(tape.rate));
    if (name_length > kMaxTapeMapName) return bad_tape(reader, "the map's name is longer than 4096 bytes");
    tape.map = as_text(reader.take(name_length));
    tape.map_hash = reader.u64();
    if (reader.failed()) return ends_early(reader);
    if (!is_valid_name(tape.map)) return bad_tape(reader, "the map's name is not UTF-8 text");
    return version;
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

Result<void> wrong_tick(const ByteReader& reader, const InputRecord& tick) {
    if (tick.forward == -128 || tick.strafe == -128)
        return bad_tape(reader, "the tick before this byte moves by -128; at most 127 is the full pace");
    if ((tick.buttons & ~kAllButtons) != 0)
        return bad_tape(reader, "the tick before this byte presses a button that is not known");
    return {};
}

Result<void> read_ticks(ByteReader& reader, std::size_t count, Tape& tape) {
    tape.ticks.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        tape.ticks.push_back(read_tick(reader));
        if (const Result<void> valid = wrong_tick(reader, tape.ticks.back()); !valid.ok()) return valid.error();
    }
    return {};
}

Result<void> read_counted_ticks(ByteReader& reader, Tape& tape) {
    const std::uint32_t count = reader.u32();
    if (reader.failed() || count > reader.remaining() / kTapeTickBytes) return ends_early(reader);
    return read_ticks(reader, count, tape);
}

/// How many whole ticks stand before the end mark, or before the end of the bytes.
std::size_t count_ticks(std::span<const std::byte> bytes) {
    std::size_t count = 0;
    while ((count + 1) * kTapeTickBytes <= bytes.size() && bytes[count * kTapeTickBytes] != kEndMark) ++count;
    return count;
}

/// False where the tape stops before its end is whole.
Result<bool> read_ticks_to_the_end(ByteReader& reader, std::span<const std::byte> bytes, Tape& tape) {
    const auto rest = bytes.subspan(reader.position());
    const std::size_t count = count_ticks(rest);
    if (const Result<void> valid = read_ticks(reader, count, tape); !valid.ok()) return valid.error();
    if (reader.remaining() < kEndBytes || rest[count * kTapeTickBytes] != kEndMark) return false;
    reader.u8();
    return true;
}

}  // namespace

Result<Tape> read_tape(std::span<const std::byte> bytes) {
    ByteReader reader(bytes);
    Tape tape;
    const Result<std::uint8_t> version = read_header(reader, tape);
    if (!version) return version.error();
    if (version.value() == kVersionWithCount) {
        if (const Result<void> done = read_counted_ticks(reader, tape); !done.ok()) return done.error();
    } else {
        const Result<bool> ended = read_ticks_to_the_end(reader, bytes, tape);
        if (!ended) return ended.error();
        tape.final_hash.reset();
        if (!ended.value()) return tape;
    }
    tape.final_hash = reader.u64();
    if (reader.failed()) return ends_early(reader);
    if (reader.remaining() > 0)
        return bad_tape(reader,
                        "the tape should end here, found " + std::to_string(reader.remaining()) + " more bytes");
    return tape;
}

Bytes tape_beginning(const Tape& tape) {
    ENFILADE_CHECK(tape.map.size() <= kMaxTapeMapName);
    ENFILADE_CHECK(tape.rate >= 1 && tape.rate <= kMaxRate);
    ByteWriter writer;
    writer.text(kMagic);
    writer.u8(kVersion);
    writer.u32(tape.rate | (tape.is_naive ? kNaiveBit : 0));
    writer.u16(static_cast<std::uint16_t>(tape.map.size()));
    writer.text(tape.map);
    writer.u64(tape.map_hash);
    return {writer.bytes().begin(), writer.bytes().end()};
}

Bytes tape_tick(const InputRecord& tick) {
    ByteWriter writer;
    writer.u8(static_cast<std::uint8_t>(tick.forward));
    writer.u8(static_cast<std::uint8_t>(tick.strafe));
    writer.u32(static_cast<std::uint32_t>(tick.yaw_steps));
    writer.u32(static_cast<std::uint32_t>(tick.pitch_steps));
    writer.u8(tick.buttons);
    return {writer.bytes().begin(), writer.bytes().end()};
}

Bytes tape_end(std::uint64_t final_hash) {
    ByteWriter writer;
    writer.u8(std::to_integer<std::uint8_t>(kEndMark));
    writer.u64(final_hash);
    return {writer.bytes().begin(), writer.bytes().end()};
}

Bytes write_tape(const Tape& tape) {
    Bytes bytes = tape_beginning(tape);
    const auto add = [&](const Bytes& piece) { bytes.insert(bytes.end(), piece.begin(), piece.end()); };
    for (const InputRecord& tick : tape.ticks) add(tape_tick(tick));
    if (tape.final_hash) add(tape_end(*tape.final_hash));
    return bytes;
}

}  // namespace enfilade
