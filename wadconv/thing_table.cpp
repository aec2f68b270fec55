#include "wadconv/workbench.h"

#include <algorithm>
#include <array>

namespace enfilade::wadconv {
namespace {

constexpr bool kSolid = true, kOpen = false, kHangs = true, kStands = false;

constexpr std::array kTypes = {
    ThingType{1, "PlayerStart1", 16, 56, kOpen, kStands, "", ""},
    ThingType{2, "PlayerStart2", 16, 56, kOpen, kStands, "", ""},
    ThingType{3, "PlayerStart3", 16, 56, kOpen, kStands, "", ""},
    ThingType{4, "PlayerStart4", 16, 56, kOpen, kStands, "", ""},
    ThingType{5, "BlueKeycard", 20, 16, kOpen, kStands, "BKEY", "A10 B10*"},
    ThingType{6, "YellowKeycard", 20, 16, kOpen, kStands, "YKEY", "A10 B10*"},
    ThingType{7, "SpiderMastermind", 128, 100, kSolid, kStands, "SPID", "A10 B10"},
    ThingType{8, "Backpack", 20, 16, kOpen, kStands, "BPAK", "A"},
    ThingType{9, "ShotgunGuy", 20, 56, kSolid, kStands, "SPOS", "A10 B10"},
    ThingType{10, "BloodyMess", 20, 16, kOpen, kStands, "PLAY", "W"},
    ThingType{11, "DeathmatchStart", 16, 56, kOpen, kStands, "", ""},
    ThingType{12, "BloodyMessAgain", 20, 16, kOpen, kStands, "PLAY", "W"},
    ThingType{13, "RedKeycard", 20, 16, kOpen, kStands, "RKEY", "A10 B10*"},
    ThingType{14, "TeleportExit", 20, 16, kOpen, kStands, "", ""},
    ThingType{15, "DeadPlayer", 20, 16, kOpen, kStands, "PLAY", "N"},
    ThingType{16, "Cyberdemon", 40, 110, kSolid, kStands, "CYBR", "A10 B10"},
    ThingType{17, "CellPack", 20, 16, kOpen, kStands, "CELP", "A"},
    ThingType{18, "DeadZombieman", 20, 16, kOpen, kStands, "POSS", "L"},
    ThingType{19, "DeadShotgunGuy", 20, 16, kOpen, kStands, "SPOS", "L"},
    ThingType{20, "DeadImp", 20, 16, kOpen, kStands, "TROO", "M"},
    ThingType{21, "DeadDemon", 20, 16, kOpen, kStands, "SARG", "N"},
    ThingType{22, "DeadCacodemon", 20, 16, kOpen, kStands, "HEAD", "L"},
    ThingType{23, "DeadLostSoul", 20, 16, kOpen, kStands, "SKUL", "K"},
    ThingType{24, "PoolOfBloodAndFlesh", 20, 16, kOpen, kStands, "POL5", "A"},
    ThingType{25, "ImpaledHuman", 16, 16, kSolid, kStands, "POL1", "A"},
    ThingType{26, "ImpaledHumanTwitching", 16, 16, kSolid, kStands, "POL6", "A6 B8"},
    ThingType{27, "SkullOnStick", 16, 16, kSolid, kStands, "POL4", "A"},
    ThingType{28, "FiveSkullsOnStick", 16, 16, kSolid, kStands, "POL2", "A"},
    ThingType{29, "SkullsAndCandles", 16, 16, kSolid, kStands, "POL3", "A6* B6*"},
    ThingType{30, "TallGreenColumn", 16, 16, kSolid, kStands, "COL1", "A"},
    ThingType{31, "ShortGreenColumn", 16, 16, kSolid, kStands, "COL2", "A"},
    ThingType{32, "TallRedColumn", 16, 16, kSolid, kStands, "COL3", "A"},
    ThingType{33, "ShortRedColumn", 16, 16, kSolid, kStands, "COL4", "A"},
    ThingType{34, "Candle", 20, 16, kOpen, kStands, "CAND", "A*"},
    ThingType{35, "Candelabra", 16, 16, kSolid, kStands, "CBRA", "A*"},
    ThingType{36, "HeartColumn", 16, 16, kSolid, kStands, "COL5", "A14 B14"},
    ThingType{37, "SkullColumn", 16, 16, kSolid, kStands, "COL6", "A"},
    ThingType{38, "RedSkullKey", 20, 16, kOpen, kStands, "RSKU", "A10 B10*"},
    ThingType{39, "YellowSkullKey", 20, 16, kOpen, kStands, "YSKU", "A10 B10*"},
    ThingType{40, "BlueSkullKey", 20, 16, kOpen, kStands, "BSKU", "A10 B10*"},
    ThingType{41, "EvilEye", 16, 16, kSolid, kStands, "CEYE", "A6* B6* C6* B6*"},
    ThingType{42, "FloatingSkulls", 16, 16, kSolid, kStands, "FSKU", "A6* B6* C6*"},
    ThingType{43, "BurntTree", 16, 16, kSolid, kStands, "TRE1", "A"},
    ThingType{44, "TallBlueTorch", 16, 16, kSolid, kStands, "TBLU", "A4* B4* C4* D4*"},
    ThingType{45, "TallGreenTorch", 16, 16, kSolid, kStands, "TGRN", "A4* B4* C4* D4*"},
    ThingType{46, "TallRedTorch", 16, 16, kSolid, kStands, "TRED", "A4* B4* C4* D4*"},
    ThingType{47, "Stalagmite", 16, 16, kSolid, kStands, "SMIT", "A"},
    ThingType{48, "TechPillar", 16, 16, kSolid, kStands, "ELEC", "A"},
    ThingType{49, "HangingVictimTwitching", 16, 68, kSolid, kHangs, "GOR1", "A10 B15 C8 B6"},
    ThingType{50, "HangingVictimArmsOut", 16, 84, kSolid, kHangs, "GOR2", "A"},
    ThingType{51, "HangingVictimOneLegged", 16, 84, kSolid, kHangs, "GOR3", "A"},
    ThingType{52, "HangingPairOfLegs", 16, 68, kSolid, kHangs, "GOR4", "A"},
    ThingType{53, "HangingLeg", 16, 52, kSolid, kHangs, "GOR5", "A"},
    ThingType{54, "LargeTree", 32, 16, kSolid, kStands, "TRE2", "A"},
    ThingType{55, "ShortBlueTorch", 16, 16, kSolid, kStands, "SMBT", "A4* B4* C4* D4*"},
    ThingType{56, "ShortGreenTorch", 16, 16, kSolid, kStands, "SMGT", "A4* B4* C4* D4*"},
    ThingType{57, "ShortRedTorch", 16, 16, kSolid, kStands, "SMRT", "A4* B4* C4* D4*"},
    ThingType{58, "Spectre", 30, 56, kSolid, kStands, "SARG", "A10 B10"},
    ThingType{59, "HangingVictimArmsOutPassable", 20, 84, kOpen, kHangs, "GOR2", "A"},
    ThingType{60, "HangingPairOfLegsPassable", 20, 68, kOpen, kHangs, "GOR4", "A"},
    ThingType{61, "HangingVictimOneLeggedPassable", 20, 52, kOpen, kHangs, "GOR3", "A"},
    ThingType{62, "HangingLegPassable", 20, 52, kOpen, kHangs, "GOR5", "A"},
    ThingType{63, "HangingVictimTwitchingPassable", 20, 68, kOpen, kHangs, "GOR1", "A10 B15 C8 B6"},
    ThingType{64, "ArchVile", 20, 56, kSolid, kStands, "VILE", "A10 B10"},
    ThingType{65, "ChaingunGuy", 20, 56, kSolid, kStands, "CPOS", "A10 B10"},
    ThingType{66, "Revenant", 20, 56, kSolid, kStands, "SKEL", "A10 B10"},
    ThingType{67, "Mancubus", 48, 64, kSolid, kStands, "FATT", "A15 B15"},
    ThingType{68, "Arachnotron", 64, 64, kSolid, kStands, "BSPI", "A10 B10"},
    ThingType{69, "HellKnight", 24, 64, kSolid, kStands, "BOS2", "A10 B10"},
    ThingType{70, "BurningBarrel", 16, 16, kSolid, kStands, "FCAN", "A4* B4* C4*"},
    ThingType{71, "PainElemental", 31, 56, kSolid, kStands, "PAIN", "A"},
    ThingType{72, "CommanderKeen", 16, 72, kSolid, kHangs, "KEEN", "A"},
    ThingType{73, "HangingVictimGutsRemoved", 16, 88, kSolid, kHangs, "HDB1", "A"},
    ThingType{74, "HangingVictimGutsAndBrainRemoved", 16, 88, kSolid, kHangs, "HDB2", "A"},
    ThingType{75, "HangingTorsoLookingDown", 16, 64, kSolid, kHangs, "HDB3", "A"},
    ThingType{76, "HangingTorsoOpenSkull", 16, 64, kSolid, kHangs, "HDB4", "A"},
    ThingType{77, "HangingTorsoLookingUp", 16, 64, kSolid, kHangs, "HDB5", "A"},
    ThingType{78, "HangingTorsoBrainRemoved", 16, 64, kSolid, kHangs, "HDB6", "A"},
    ThingType{79, "PoolOfBlood", 20, 16, kOpen, kStands, "POB1", "A"},
    ThingType{80, "PoolOfBloodAgain", 20, 16, kOpen, kStands, "POB2", "A"},
    ThingType{81, "PoolOfBrains", 20, 16, kOpen, kStands, "BRS1", "A"},
    ThingType{82, "SuperShotgun", 20, 16, kOpen, kStands, "SGN2", "A"},
    ThingType{83, "Megasphere", 20, 16, kOpen, kStands, "MEGA", "A6* B6* C6* D6*"},
    ThingType{84, "WolfensteinSS", 20, 56, kSolid, kStands, "SSWV", "A10 B10"},
    ThingType{85, "TechLamp", 16, 16, kSolid, kStands, "TLMP", "A4* B4* C4* D4*"},
    ThingType{86, "ShortTechLamp", 16, 16, kSolid, kStands, "TLP2", "A4* B4* C4* D4*"},
    ThingType{87, "BossTarget", 20, 32, kOpen, kStands, "", ""},
    ThingType{88, "BossBrain", 16, 16, kSolid, kStands, "BBRN", "A"},
    ThingType{89, "BossShooter", 20, 32, kOpen, kStands, "", ""},
    ThingType{2001, "Shotgun", 20, 16, kOpen, kStands, "SHOT", "A"},
    ThingType{2002, "Chaingun", 20, 16, kOpen, kStands, "MGUN", "A"},
    ThingType{2003, "RocketLauncher", 20, 16, kOpen, kStands, "LAUN", "A"},
    ThingType{2004, "PlasmaRifle", 20, 16, kOpen, kStands, "PLAS", "A"},
    ThingType{2005, "Chainsaw", 20, 16, kOpen, kStands, "CSAW", "A"},
    ThingType{2006, "BFG9000", 20, 16, kOpen, kStands, "BFUG", "A"},
    ThingType{2007, "Clip", 20, 16, kOpen, kStands, "CLIP", "A"},
    ThingType{2008, "Shells", 20, 16, kOpen, kStands, "SHEL", "A"},
    ThingType{2010, "Rocket", 20, 16, kOpen, kStands, "ROCK", "A"},
    ThingType{2011, "Stimpack", 20, 16, kOpen, kStands, "STIM", "A"},
    ThingType{2012, "Medikit", 20, 16, kOpen, kStands, "MEDI", "A"},
    ThingType{2013, "Soulsphere", 20, 16, kOpen, kStands, "SOUL", "A6* B6* C6* D6* C6* B6*"},
    ThingType{2014, "HealthBonus", 20, 16, kOpen, kStands, "BON1", "A6 B6 C6 D6 C6 B6"},
    ThingType{2015, "ArmorBonus", 20, 16, kOpen, kStands, "BON2", "A6 B6 C6 D6 C6 B6"},
    ThingType{2018, "GreenArmor", 20, 16, kOpen, kStands, "ARM1", "A6 B7*"},
    ThingType{2019, "BlueArmor", 20, 16, kOpen, kStands, "ARM2", "A6 B6*"},
    ThingType{2022, "Invulnerability", 20, 16, kOpen, kStands, "PINV", "A6* B6* C6* D6*"},
    ThingType{2023, "Berserk", 20, 16, kOpen, kStands, "PSTR", "A*"},
    ThingType{2024, "PartialInvisibility", 20, 16, kOpen, kStands, "PINS", "A6* B6* C6* D6*"},
    ThingType{2025, "RadiationSuit", 20, 16, kOpen, kStands, "SUIT", "A*"},
    ThingType{2026, "ComputerMap", 20, 16, kOpen, kStands, "PMAP", "A6* B6* C6* D6* C6* B6*"},
    ThingType{2028, "FloorLamp", 16, 16, kSolid, kStands, "COLU", "A*"},
    ThingType{2035, "ExplosiveBarrel", 10, 42, kSolid, kStands, "BAR1", "A6 B6"},
    ThingType{2045, "LightVisor", 20, 16, kOpen, kStands, "PVIS", "A6* B6"},
    ThingType{2046, "RocketBox", 20, 16, kOpen, kStands, "BROK", "A"},
    ThingType{2047, "Cell", 20, 16, kOpen, kStands, "CELL", "A"},
    ThingType{2048, "BulletBox", 20, 16, kOpen, kStands, "AMMO", "A"},
    ThingType{2049, "ShellBox", 20, 16, kOpen, kStands, "SBOX", "A"},
    ThingType{3001, "Imp", 20, 56, kSolid, kStands, "TROO", "A10 B10"},
    ThingType{3002, "Demon", 30, 56, kSolid, kStands, "SARG", "A10 B10"},
    ThingType{3003, "BaronOfHell", 24, 64, kSolid, kStands, "BOSS", "A10 B10"},
    ThingType{3004, "Zombieman", 20, 56, kSolid, kStands, "POSS", "A10 B10"},
    ThingType{3005, "Cacodemon", 31, 56, kSolid, kStands, "HEAD", "A"},
    ThingType{3006, "LostSoul", 16, 56, kSolid, kStands, "SKUL", "A10* B10*"},
};

static_assert(std::ranges::is_sorted(kTypes, {}, &ThingType::number));

/// Monsters, the boss's brain and barrels.
constexpr std::array kTargets = {7,  9,  16, 58,   64,   65,   66,   67,   68,   69,  71,
                                 72, 84, 88, 2035, 3001, 3002, 3003, 3004, 3005, 3006};

static_assert(std::ranges::is_sorted(kTargets));

}  // namespace

std::span<const ThingType> thing_types() { return kTypes; }

const ThingType* find_thing_type(int number) {
    const auto found = std::ranges::lower_bound(kTypes, number, {}, &ThingType::number);
    return found == kTypes.end() || found->number != number ? nullptr : &*found;
}

bool can_be_shot(int number) { return std::ranges::binary_search(kTargets, number); }

std::vector<std::string> idle_frames() {
    std::vector<std::string> frames;
    for (const ThingType& type : thing_types())
        for (std::string_view rest = type.frames; !rest.empty();)
            frames.push_back(std::string(type.sprite) + take_frame(rest).letter);
    return frames;
}

IdleFrame take_frame(std::string_view& frames) {
    IdleFrame frame{0, 0, false};
    while (!frames.empty() && frames.front() == ' ') frames.remove_prefix(1);
    if (frames.empty()) return frame;
    frame.letter = frames.front();
    frames.remove_prefix(1);
    for (; !frames.empty() && frames.front() != ' '; frames.remove_prefix(1)) {
        if (frames.front() == '*')
            frame.is_bright = true;
        else
            frame.tics = static_cast<std::uint8_t>(frame.tics * 10 + (frames.front() - '0'));
    }
    return frame;
}

}  // namespace enfilade::wadconv
