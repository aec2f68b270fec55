// soak MINUTES [--seed N] [--rounds N]: random players in generated, authored, linked and FreeDoom's worlds, until the
// time is over or something is wrong. Memory has to stay flat. Through ./run soak.
#include <malloc.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "base/files.h"
#include "formats/map_toml.h"
#include "support/temp_dir.h"
#include "wadconv/convert.h"
#include "wild/saved_fault.h"
#include "wild/soak_round.h"
#include "wild/worlds.h"

namespace enfilade::test {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr const char* kFreeDoom[] = {"/usr/share/games/doom/freedoom1.wad", "/usr/share/games/doom/freedoom2.wad"};

struct SoakPlan {
    double minutes = 0;
    std::uint64_t seed = 1;
    std::uint64_t rounds = UINT64_MAX;
};

std::optional<SoakPlan> plan_of(int count, char** words) {
    SoakPlan plan;
    for (int i = 1; i < count; ++i) {
        const bool has_value = i + 1 < count;
        if (std::strcmp(words[i], "--seed") == 0 && has_value)
            plan.seed = std::strtoull(words[++i], nullptr, 10);
        else if (std::strcmp(words[i], "--rounds") == 0 && has_value)
            plan.rounds = std::strtoull(words[++i], nullptr, 10);
        else
            plan.minutes = std::strtod(words[i], nullptr);
    }
    return plan.minutes > 0 ? std::optional(plan) : std::nullopt;
}

/// The maps that come with the engine, and FreeDoom's where that is installed.
std::vector<std::string> maps_on_disk(const std::string& folder) {
    std::vector<std::string> maps;
    const auto add = [&](const std::string& from) {
        for (const std::string& name : list_folder(from))
            if (name.ends_with(".toml") && !name.starts_with(".")) maps.push_back(from + "/" + name);
    };
    add(ENFILADE_SOURCE_DIR "/maps");
    for (const char* wad : kFreeDoom) {
        if (!fs::exists(wad)) continue;
        std::printf("converting %s\n", wad);
        std::fflush(stdout);
        const std::string out = folder + "/" + fs::path(wad).stem().string();
        wadconv::RunOptions options;
        options.wads = {wad};
        options.out = out;
        if (wadconv::convert_wads(options, [](std::size_t, std::size_t, std::size_t) {}).ok()) add(out);
    }
    return maps;
}

/// Memory that was asked for and not given back [bytes].
std::size_t in_use() {
    const struct mallinfo2 memory = ::mallinfo2();
    return memory.uordblks + memory.hblkhd;
}

class Soak {
public:
    explicit Soak(const SoakPlan& plan) : plan_(plan), maps_(maps_on_disk(converted_.path())) {}

    /// Exit status.
    int run() {
        const auto limit = std::chrono::duration<double>(60 * plan_.minutes);
        for (std::uint64_t seed = plan_.seed; Clock::now() - begin_ < limit && seed - plan_.seed < plan_.rounds;
             ++seed) {
            if (!is_round_sound(seed)) return 1;
            show_progress(limit.count());
        }
        std::printf("\n%s; hash %016llx\n", counts_text().c_str(), static_cast<unsigned long long>(all_.value()));
        return 0;
    }

private:
    /// One world for each seed: half of them made up, half from disk.
    std::string map_of_round(std::uint64_t seed) {
        Random random(seed);
        if (random.below(2) == 0) return maps_[random.below(maps_.size())];
        std::string path = folder_.path("wild.toml");
        (void)write_file(path, write_map(wild_world(seed)));
        return path;
    }

    bool is_round_sound(std::uint64_t seed) {
        const std::string map = map_of_round(seed);
        SoakResult result = soak_round(map, folder_.path(), seed);
        counts_ += result.counts;
        all_.add(result.hash);
        if (!result.fault) result.fault = memory_fault();
        if (!result.fault) return true;
        leave_behind(map, seed, std::move(result));
        return false;
    }

    /// After the first rounds, which fill what is kept for good, each has to give back what it took.
    std::optional<Fault> memory_fault() {
        constexpr std::size_t kKept = std::size_t{4} << 20;  // by the C library and others [bytes]
        constexpr std::uint64_t kFirstRounds = 16;
        const std::size_t in_use_now = in_use();
        if (counts_.rounds <= kFirstRounds) in_use_at_first_ = std::max(in_use_at_first_, in_use_now);
        if (in_use_now <= in_use_at_first_ + kKept) return {};
        return Fault{"memory grows: " + std::to_string(in_use_now) + " bytes in use after the round, " +
                         std::to_string(in_use_at_first_) + " after the first ones",
                     {},
                     {}};
    }

    void leave_behind(const std::string& map, std::uint64_t seed, SoakResult result) const {
        const auto text = read_file(map);
        FaultyWorld world{text.ok() ? read_map(as_text(text.value())).map : MapFile{},
                          std::move(*result.fault),
                          result.sector,
                          {.seed = seed}};
        if (is_faulty(world)) world = shrunk(std::move(world));
        const std::string folder = fs::absolute("fault-" + std::to_string(seed)).string();
        const Result<void> saved = save(world, folder);
        std::printf("\n%s: %s\n", map.c_str(), world.fault.what.c_str());
        std::printf("map, pose and input: %s\n", saved.ok() ? folder.c_str() : saved.error().text().c_str());
        std::printf("to see it again: ./run soak 60 --seed %llu --rounds 1\n", static_cast<unsigned long long>(seed));
    }

    std::string counts_text() const {
        char text[300];
        std::snprintf(text, sizeof text,
                      "%llu rounds, %llu ticks, %llu pixels compared, %llu loads, %llu rewinds, %llu reloads, %zu KiB",
                      static_cast<unsigned long long>(counts_.rounds), static_cast<unsigned long long>(counts_.ticks),
                      static_cast<unsigned long long>(counts_.pixels), static_cast<unsigned long long>(counts_.loads),
                      static_cast<unsigned long long>(counts_.rewinds),
                      static_cast<unsigned long long>(counts_.reloads), in_use() / 1024);
        return text;
    }

    /// In place on a terminal, else a line now and then.
    void show_progress(double seconds) {
        constexpr double kBetweenLines = 30;
        const double passed = std::chrono::duration<double>(Clock::now() - begin_).count();
        const bool is_terminal = ::isatty(1);
        if (!is_terminal && passed < next_line_) return;
        next_line_ = passed + kBetweenLines;
        std::printf("%s%.1f min left: %s%s", is_terminal ? "\r" : "", std::max(0.0, seconds - passed) / 60,
                    counts_text().c_str(), is_terminal ? "" : "\n");
        std::fflush(stdout);
    }

    SoakPlan plan_;
    test::TempDir folder_, converted_;
    std::vector<std::string> maps_;
    Clock::time_point begin_ = Clock::now();
    double next_line_ = 0;
    SoakCounts counts_;
    Hash all_;
    std::size_t in_use_at_first_ = 0;
};

}  // namespace
}  // namespace enfilade::test

int main(int count, char** words) {
    const auto plan = enfilade::test::plan_of(count, words);
    if (!plan) {
        std::fputs("usage: soak MINUTES [--seed N] [--rounds N]\n", stderr);
        return 2;
    }
    ::setenv("ENFILADE_MAP_CACHE", "off", 1);
    return enfilade::test::Soak(*plan).run();
}
