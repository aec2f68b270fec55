#include "wadconv/convert.h"

#include <array>
#include <filesystem>
#include <set>

#include "base/files.h"
#include "wadconv/workbench.h"

namespace enfilade::wadconv {
namespace {

constexpr std::array<std::string_view, 11> kSoundNames = {"doropn", "dorcls", "bdopn",  "bdcls",  "pstart", "pstop",
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

// What doors, lifts, floors, switches, teleports and pick-ups sound like.

/// How far a sound of Doom is heard [map units].
constexpr double kClippingDistance = 1200;

/// Doors that move at least so fast have sounds of their own: Doom's fast ones are four times as fast as the others
/// [m/s].
constexpr double kFastDoorSpeed = 4;

/// Names of sounds; empty: silent.
struct MoverSounds {
    std::string_view up, down, stop;
};

MoverSounds sounds_of(const TriggerRecord& trigger) {
    switch (trigger.action) {
        case TriggerAction::door:
        case TriggerAction::open:
        case TriggerAction::close:
        case TriggerAction::close_then_open:
            if (trigger.speed >= kFastDoorSpeed) return {"bdopn", "bdcls", ""};
            return {"doropn", "dorcls", ""};
        case TriggerAction::lift:
        case TriggerAction::shuttle: return {"pstart", "pstart", "pstop"};
        case TriggerAction::floor:
        case TriggerAction::stairs: return {"stnmov", "stnmov", "pstop"};
        case TriggerAction::ceiling:
        case TriggerAction::crush: return {"stnmov", "stnmov", ""};
        default: return {};
    }
}

/// Grinding stone goes on for as long as it moves.
bool is_looped(std::string_view sound) { return sound == "stnmov"; }

class SoundMaker {
public:
    explicit SoundMaker(Workbench& bench) : bench_(bench) {
        std::map<std::string_view, std::vector<std::size_t>> groups;
        for (std::size_t i = 0; i < bench.file.sectors.size(); ++i) groups[bench.file.sectors[i].group].push_back(i);
        for (std::size_t i = 0; i < bench.file.sectors.size(); ++i) {
            const SectorRecord& sector = bench.file.sectors[i];
            called_[sector.name] = sector.group.empty() ? std::vector{i} : groups[sector.group];
            for (const std::string& tag : sector.tags) called_[tag].push_back(i);
        }
        for (const SwitchRecord& pair : bench.pictures.switches()) switches_.insert({pair.off, pair.on});
    }

    void run() {
        for (SectorRecord& sector : bench_.file.sectors) {
            for (LoopRecord& loop : sector.loops)
                for (WallRecord& wall : loop.walls) give_sounds(wall.triggers, shows_switch(wall), wall.next);
            for (PanelRecord& panel : sector.panels)
                give_sounds(panel.triggers, switches_.contains(panel.texture.name), sector.name);
        }
        for (ThingRecord& thing : bench_.file.things) give_sound(thing);
        for (const std::string_view sound : used_)
            bench_.file.sounds.push_back(
                {std::string(sound), Sounds::file_of(sound), 1, metres(kClippingDistance), is_looped(sound), {}});
    }

private:
    /// `usual`: the sector that a trigger without a target is about.
    void give_sounds(std::vector<TriggerRecord>& triggers, bool is_switch, const std::string& usual) {
        for (TriggerRecord& trigger : triggers) {
            if (trigger.action == TriggerAction::teleport)
                trigger.sound = use("telept");
            else if (is_switch && trigger.on == Activation::use)
                trigger.sound = use(trigger.action == TriggerAction::leave_map ? "swtchx" : "swtchn");
            give_movers(trigger, usual);
        }
    }

    bool shows_switch(const WallRecord& wall) const {
        const auto is_one = [this](const std::optional<TextureSpec>& spec) {
            return spec && switches_.contains(spec->name);
        };
        return is_one(wall.texture) || is_one(wall.upper) || is_one(wall.lower) || is_one(wall.middle);
    }

    /// Whatever first moves a sector decides.
    void give_movers(const TriggerRecord& trigger, const std::string& usual) {
        const MoverSounds sounds = sounds_of(trigger);
        if (sounds.up.empty()) return;
        if (trigger.targets.empty()) return give_movers(sounds, usual);
        for (const std::string& target : trigger.targets) give_movers(sounds, target);
    }

    void give_movers(const MoverSounds& sounds, const std::string& name) {
        const auto found = called_.find(name);
        if (found == called_.end()) return;
        for (const std::size_t i : found->second) {
            SectorRecord& sector = bench_.file.sectors[i];
            if (!sector.move_sound.empty()) continue;
            sector.move_sound = use(sounds.up);
            if (sounds.down != sounds.up) sector.down_sound = use(sounds.down);
            sector.stop_sound = use(sounds.stop);
        }
    }

    void give_sound(ThingRecord& thing) {
        if (thing.gives_key.empty() && thing.gives_health == 0) return;
        TriggerRecord trigger;
        trigger.on = Activation::touch;
        trigger.action = TriggerAction::sound;
        trigger.sound = use("itemup");
        if (!trigger.sound.empty()) thing.triggers.push_back(std::move(trigger));
    }

    /// Its name, if the archives have it.
    std::string use(std::string_view sound) {
        if (!bench_.sounds.has(sound)) return "";
        used_.insert(sound);
        return std::string(sound);
    }

    Workbench& bench_;
    std::map<std::string, std::vector<std::size_t>, std::less<>> called_;  ///< what moves, by name and tag
    std::set<std::string> switches_;                                       ///< pictures of switches
    std::set<std::string_view> used_;
};

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
    for (const std::string_view name : kSoundNames) {
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

Result<void> Sounds::write(const std::string& folder) const {
    if (files_.empty()) return {};
    const std::string path = folder + "/" + std::string(kSoundFolder);
    std::error_code failed;
    std::filesystem::create_directories(path, failed);
    if (failed) return Error{path, "cannot make the folder: " + failed.message()};
    for (const auto& [name, bytes] : files_)
        if (const Result<void> done = write_one_of_many(folder + "/" + file_of(name), bytes); !done.ok())
            return done.error();
    return flush_folder(path);
}

void convert_sounds(Workbench& bench) { SoundMaker(bench).run(); }

}  // namespace enfilade::wadconv
