// Maps as bytes and back: the same map, and nothing from bytes that are not whole.
#include "map/load.h"

#include <gmock/gmock.h>

#include <concepts>
#include <limits>
#include <utility>

#include "base/hash.h"
#include "formats/map_toml.h"
#include "formats/png.h"
#include "map/map_fields.h"
#include "support/generate_map.h"

namespace enfilade {
namespace {

using namespace test;

constexpr std::uint64_t kSource = 42;

CompiledMap compiled(Map map, std::size_t pictures = 64) {
    CompiledMap whole;
    whole.map = std::move(map);
    for (std::size_t i = 0; i < pictures; ++i) {
        whole.needs.pictures.push_back({"picture" + std::to_string(i), "Picture", {1, 2}});
        whole.sizes.push_back({64, 64});
    }
    whole.findings.push_back({{3, 4}, Severity::warning, "unlit", "a room is dark"});
    return whole;
}

CompiledMap shipped(const std::string& name) {
    LoadedMap loaded = load_map(ENFILADE_SOURCE_DIR "/maps/" + name + ".toml", {}, read_file);
    return compiled(std::move(*loaded.map), loaded.textures.textures.size());
}

/// The bytes with another checksum, that of what they are now.
void vouch_for(Bytes& bytes) {
    const std::uint64_t sum = hash_of_bytes(std::span(bytes).first(bytes.size() - sizeof(sum)));
    for (std::size_t i = 0; i < sizeof(sum); ++i)
        bytes[bytes.size() - sizeof(sum) + i] = static_cast<std::byte>(sum >> (8 * i));
}

class Compiled : public testing::TestWithParam<const char*> {};

TEST_P(Compiled, IsReadBackAsItWas) {
    const CompiledMap whole = shipped(GetParam());
    const Bytes bytes = compile(whole, kSource);
    const auto again = read_compiled(bytes, kSource);
    ASSERT_TRUE(again);
    EXPECT_EQ(compile(*again, kSource), bytes);
    ASSERT_EQ(again->map.walls.size(), whole.map.walls.size());
    for (std::size_t i = 0; i < whole.map.walls.size(); ++i) {
        const Wall &wall = whole.map.walls[i], &read = again->map.walls[i];
        ASSERT_EQ(read.b, wall.b);
        ASSERT_EQ(read.length, wall.length);
        ASSERT_EQ(read.sector, wall.sector);
        ASSERT_EQ(read.previous, wall.previous);
    }
    for (std::size_t i = 0; i < whole.map.sectors.size(); ++i) {
        ASSERT_EQ(again->map.sectors[i].min, whole.map.sectors[i].min);
        ASSERT_EQ(again->map.sectors[i].max, whole.map.sectors[i].max);
    }
}

INSTANTIATE_TEST_SUITE_P(Maps, Compiled, testing::Values("enfilade", "effects", "tutorial"));

TEST(CompiledMap, OfAnotherSourceIsNotRead) {
    const Bytes bytes = compile(compiled(built(grid_of_rooms(4))), kSource);
    EXPECT_TRUE(read_compiled(bytes, kSource));
    EXPECT_FALSE(read_compiled(bytes, kSource + 1));
}

TEST(CompiledMap, CutOffAnywhereIsNotRead) {
    const Bytes bytes = compile(compiled(built(grid_of_rooms(4))), kSource);
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        Bytes part(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
        ASSERT_FALSE(read_compiled(part, kSource)) << size;
        if (size < 24) continue;
        vouch_for(part);
        ASSERT_FALSE(read_compiled(part, kSource)) << size;
    }
}

TEST(CompiledMap, WithAnyByteChangedIsNotRead) {
    Bytes bytes = compile(compiled(built(grid_of_rooms(4))), kSource);
    for (std::byte& byte : bytes) {
        byte ^= std::byte{0x10};
        ASSERT_FALSE(read_compiled(bytes, kSource));
        byte ^= std::byte{0x10};
    }
}

/// Somebody may have made the checksum fit. What is read then still holds together: all of it is looked at, and written
/// again.
TEST(CompiledMap, ThatWasChangedOnPurposeLeadsNowhereItShouldNot) {
    const Bytes bytes = compile(shipped("effects"), kSource);
    Random random(1);
    std::size_t refused = 0;
    constexpr std::size_t kTries = 3000;
    for (std::size_t i = 0; i < kTries; ++i) {
        Bytes changed = bytes;
        for (std::uint64_t changes = random.below(3) + 1; changes > 0; --changes)
            changed[16 + random.below(changed.size() - 24)] = static_cast<std::byte>(random.below(256));
        vouch_for(changed);
        const auto read = read_compiled(changed, kSource);
        refused += !read;
        if (!read) continue;
        const Map& map = read->map;
        for (const Wall& wall : map.walls) {
            ASSERT_EQ(map[wall.next].a, wall.b);
            ASSERT_TRUE(wall.kind != WallKind::portal || map[wall.exit].sector == wall.behind);
            (void)map[wall.texture].texture;
            (void)map.passage(wall);
        }
        for (std::size_t s = 0; s < map.sectors.size(); ++s)
            each_of_group(map, SectorId(s), [&](SectorId member) { ASSERT_LT(member.index, map.sectors.size()); });
        for (const Trigger& trigger : map.triggers)
            for (const SectorId target : map.targets_of(trigger)) ASSERT_LT(target.index, map.sectors.size());
        ASSERT_EQ(compile(*read, kSource).size() > 0, true);
    }
    EXPECT_GT(refused, kTries / 10);
    EXPECT_LT(refused, kTries);
}

/// Shows its visitor each number of a value, wherever it is.
template <class Visit>
struct EachNumber {
    Visit visit;

    void of(double& number) const { visit(number); }
    void of(std::string&) const {}
    template <Scalar T>
    void of(T&) const {}
    template <class T>
    void of(std::optional<T>& value) const {
        if (value) of(*value);
    }
    template <class T>
    void of(Boxed<T>& value) const {
        if (value) of(*value);
    }
    template <class T>
    void of(std::vector<T>& list) const {
        for (T& item : list) of(item);
    }
    template <class T, std::size_t count>
    void of(std::array<T, count>& list) const {
        for (T& item : list) of(item);
    }
    template <class T>
        requires std::is_class_v<T>
    void of(T& whole) const {
        fields(whole, [&](auto&... part) {
            (of(part), ...);
            return 0;
        });
    }
};

TEST(CompiledMap, HoldsTogetherOnlyWhereEveryNumberIsInItsRange) {
    CompiledMap whole = shipped("effects");
    Map& map = whole.map;
    ASSERT_TRUE(is_consistent(map, whole.sizes.size()));
    constexpr std::array kWild{std::numeric_limits<double>::quiet_NaN(), 5e278, -1e300,
                               -std::numeric_limits<double>::infinity()};
    std::size_t tried = 0, taken = 0;
    EachNumber{[&](double& number) {
        const double before = std::exchange(number, kWild[tried++ % kWild.size()]);
        taken += is_consistent(map, whole.sizes.size());
        number = before;
    }}.of(map);
    EXPECT_GT(tried, 1000u);
    EXPECT_EQ(taken, 0u);
}

TEST(CompiledMap, WhoseListSaysItIsLongerThanTheFileTakesNoMemory) {
    Bytes bytes = compile(compiled(built(grid_of_rooms(4))), kSource);
    for (std::size_t i = 16; i < 24; ++i) bytes[i] = std::byte{0xFF};  // the length of its name
    vouch_for(bytes);
    EXPECT_FALSE(read_compiled(bytes, kSource));
}

/// A map text as large as those that are kept, a store in memory, and how often it was asked.
class KeptMap : public testing::Test {
protected:
    KeptMap() {
        text_ = write_map(grid_of_rooms(9));
        text_.append(kLeastKeptBytes - text_.size(), '\n');
        store_.edition = 7;
        store_.find = [this]() -> Result<Bytes> {
            if (kept_.empty()) return Error{"", "nothing"};
            return kept_;
        };
        store_.keep = [this](const Bytes& bytes) {
            kept_ = bytes;
            ++times_kept_;
        };
    }

    LoadedMap load(std::optional<int> skill = {}) {
        const FileReader read = [this](const std::string& path) -> Result<Bytes> {
            if (path.ends_with(".png")) return write_png({width_, 1, std::vector<std::uint32_t>(width_, 0xFFFFFFFFu)});
            const auto bytes = std::as_bytes(std::span(text_));
            return Bytes(bytes.begin(), bytes.end());
        };
        return load_map("grid.toml", {}, read, skill, {}, &store_);
    }

    std::string text_;
    std::uint32_t width_ = 2;
    MapStore store_;
    Bytes kept_;
    int times_kept_ = 0;
};

TEST_F(KeptMap, IsNotReadFromItsTextAgain) {
    const LoadedMap first = load(), second = load();
    ASSERT_TRUE(first.map && second.map);
    EXPECT_EQ(times_kept_, 1);
    EXPECT_EQ(second.map->walls.size(), first.map->walls.size());
    EXPECT_EQ(second.textures.textures.size(), first.textures.textures.size());
    EXPECT_EQ(second.findings.size(), first.findings.size());
}

TEST_F(KeptMap, IsStaleOnceItsTextIsAnother) {
    load();
    text_.back() = ' ';
    EXPECT_TRUE(load().map);
    EXPECT_EQ(times_kept_, 2);
}

TEST_F(KeptMap, IsStaleOnceAPictureHasAnotherSize) {
    load();
    width_ = 3;
    EXPECT_TRUE(load().map);
    EXPECT_EQ(times_kept_, 2);
}

TEST_F(KeptMap, IsStaleForAnotherSkillAndAnotherProgram) {
    load();
    load(2);
    EXPECT_EQ(times_kept_, 2);
    store_.edition = 8;
    load(2);
    EXPECT_EQ(times_kept_, 3);
}

TEST_F(KeptMap, IsReadFromItsTextWhereItWasDamaged) {
    load();
    kept_[kept_.size() / 2] ^= std::byte{1};
    EXPECT_TRUE(load().map);
    EXPECT_EQ(times_kept_, 2);
}

TEST_F(KeptMap, IsNoneThatIsSmall) {
    text_.resize(kLeastKeptBytes - 1);
    EXPECT_TRUE(load().map);
    EXPECT_EQ(times_kept_, 0);
}

TEST_F(KeptMap, IsNoneThatIsRefused) {
    text_.replace(text_.find("[["), 2, "[?");
    EXPECT_FALSE(load().map);
    EXPECT_EQ(times_kept_, 0);
}

}  // namespace
}  // namespace enfilade
