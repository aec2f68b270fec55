// Recorded input: tapes, and saved games, which are tapes as well.
#include <cstdlib>

#include "app/play/game.h"
#include "flight/flight.h"
#include "formats/map_toml.h"
#include "fuzz/targets.h"
#include "support/map_builder.h"
#include "support/temp_dir.h"

namespace enfilade::test {
namespace {

/// Longer tapes are good, but one is not to be waited for.
constexpr std::size_t kMostTicks = 2000;

/// Two rooms with a door between them and a link round to the start.
MapFile played_file() {
    MapFile file = map_of({box_room("left", 0, 0, 8, 4, 0, 3), box_room("door", 8, 1, 8.5, 3, 0, 0),
                           box_room("right", 8.5, 0, 16, 4, 0.5, 3)});
    split_and_join(file);
    link(file, "left", {0, 4}, {0, 0}, "right", {16, 0}, {16, 4});
    sector(file, "door").triggers.emplace_back();  // a door that opens when it is used
    place_player(file, "left", {2, 2}, 1.5);
    return file;
}

void check_player(const Map& map, const World& world) {
    ENFILADE_CHECK(contains(map, world.player.place.sector, world.player.place.point));
}

/// A game of the map above, in a folder of its own.
struct SavedGames {
    test::TempDir folder;
    std::string map = folder.path("map.toml"), save = folder.path("game.save");
    std::unique_ptr<Game> game;

    SavedGames() {
        ENFILADE_CHECK(write_file(map, write_map(played_file())).ok());
        game = std::move(Game::start(map, {})).value();
    }
};

/// Loads the tape's bytes where a saved game would be, plays on, saves and loads again.
void load_and_go_on(SavedGames& disk, const Bytes& bytes) {
    Game& game = *disk.game;
    ENFILADE_CHECK(write_file(disk.save, std::span<const std::byte>(bytes)).ok());
    if (!game.load_saved(disk.save).ok()) return;
    for (int i = 0; i < 100; ++i) game.tick({.forward = 127, .yaw_steps = 1 << 27, .buttons = kButtonUse});
    game.rewind(2);
    const std::uint64_t hash_before = hash(game.world());
    ENFILADE_CHECK(game.save(disk.save).ok() && game.load_saved(disk.save).ok());
    ENFILADE_CHECK(hash(game.world()) == hash_before);
    check_player(game.map(), game.world());
}

}  // namespace

void fuzz_tape(std::span<const std::byte> bytes) {
    static const Map map = built(played_file());
    const auto tape = read_tape(bytes);
    if (!tape.ok()) return;
    const auto again = read_tape(write_tape(tape.value()));
    ENFILADE_CHECK(again.ok() && again.value() == tape.value());
    if (tape.value().ticks.size() > kMostTicks) return;
    Tape ended = tape.value();
    if (!motion_of(ended)) ended.rate = kTickRate;
    World world = *start_of(map, *motion_of(ended));
    for (const TickInput& input : ended.ticks) {
        step(map, world, input);
        check_player(map, world);
    }
    ended.final_hash = hash(world);
    const auto path = TapePath::plan(map, ended);
    ENFILADE_CHECK(path.ok());
    path.value().pose_at(map, {static_cast<std::int64_t>(ended.ticks.size() / 2), static_cast<int>(ended.rate)});
}

void fuzz_save(std::span<const std::byte> bytes) {
    static SavedGames disk;
    const Bytes as_it_is(bytes.begin(), bytes.end());
    const auto tape = read_tape(bytes);
    if (tape.ok() && tape.value().ticks.size() > kMostTicks) return;
    load_and_go_on(disk, as_it_is);
    if (!tape.ok()) return;
    disk.game->restart();
    Tape own = tape.value();  // as if it were of the map that is played, and had been stopped
    own.map_hash = disk.game->tape().map_hash;
    own.final_hash.reset();
    load_and_go_on(disk, write_tape(own));
}

}  // namespace enfilade::test
