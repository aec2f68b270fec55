#include "wadconv/sounds.h"

#include <array>
#include <filesystem>

#include "base/bytes.h"
#include "base/output_file.h"

namespace enfilade::wadconv {
namespace {

constexpr std::array<std::string_view, 11> kNames = {"doropn", "dorcls", "bdopn",  "bdcls",  "pstart", "pstop",
                                                     "stnmov", "swtchn", "swtchx", "telept", "itemup"};

/// How a sound lump begins; other numbers stand for the PC speaker and for instruments.
constexpr std::uint16_t kSampled = 3;

/// Lumps are named so.
std::string lump_name_of(std::string_view name) {
    std::string lump = "DS";
    for (const char c : name) lump += static_cast<char>(c - 'a' + 'A');
    return lump;
}

/// One channel, unsigned bytes, as RIFF wants them.
Bytes wav(std::uint32_t rate, std::span<const std::byte> samples) {
    constexpr std::uint32_t kFormatBytes = 16, kHeaderBytes = 36;
    constexpr std::uint16_t kPcm = 1, kChannels = 1, kBytesAFrame = 1, kBits = 8;
    const auto size = static_cast<std::uint32_t>(samples.size()), padding = size % 2;
    ByteWriter out;
    out.text("RIFF");
    out.u32(kHeaderBytes + size + padding);
    out.text("WAVEfmt ");
    out.u32(kFormatBytes);
    out.u16(kPcm);
    out.u16(kChannels);
    out.u32(rate);
    out.u32(rate * kBytesAFrame);
    out.u16(kBytesAFrame);
    out.u16(kBits);
    out.text("data");
    out.u32(size);
    for (const std::byte sample : samples) out.u8(static_cast<std::uint8_t>(sample));
    if (padding != 0) out.u8(0);
    return {out.bytes().begin(), out.bytes().end()};
}

}  // namespace

Result<Bytes> wav_of(const Lump& lump) {
    ByteReader in(lump.bytes);
    const std::uint16_t kind = in.u16(), rate = in.u16();
    const std::span<const std::byte> samples = in.take(in.u32());
    if (in.failed()) return Error{lump.name, "the sound is cut off"};
    if (kind != kSampled)
        return Error{lump.name, "expected a sampled sound, which begins with 3, found " + std::to_string(kind)};
    if (rate == 0 || samples.empty()) return Error{lump.name, "the sound is empty"};
    return wav(rate, samples);
}

Sounds Sounds::list(const WadPile& pile) {
    Sounds sounds;
    for (const std::string_view name : kNames) {
        const Lump* lump = pile.find(lump_name_of(name));
        if (!lump) continue;
        Result<Bytes> file = wav_of(*lump);
        if (file)
            sounds.files_.emplace(name, std::move(file).value());
        else
            sounds.problems_.push_back(file.error());
    }
    return sounds;
}

std::string Sounds::file_of(std::string_view name) { return std::string(kSoundFolder) + std::string(name) + ".wav"; }

Status Sounds::write(const std::string& folder) const {
    if (files_.empty()) return {};
    const std::string path = folder + "/" + std::string(kSoundFolder);
    std::error_code failed;
    std::filesystem::create_directories(path, failed);
    if (failed) return Error{path, "cannot make the folder: " + failed.message()};
    for (const auto& [name, bytes] : files_)
        if (Status unwritten = write_one_of_many(folder + "/" + file_of(name), bytes)) return unwritten;
    return flush_folder(path);
}

}  // namespace enfilade::wadconv
