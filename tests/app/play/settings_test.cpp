// Every setting: its text, its ends, its steps; and the file in which all are kept.
#include "app/play/settings.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <bit>
#include <cmath>
#include <filesystem>
#include <set>

#include "base/files.h"
#include "base/hash.h"
#include "formats/text_parts.h"
#include "support/temp_dir.h"

namespace enfilade {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A value that is not the usual one, as it is written.
std::string other_value(const Setting& setting) {
    Settings settings;
    setting.turn(setting, 1, settings);
    if (setting.text(setting, settings) == setting.text(setting, Settings())) setting.turn(setting, -1, settings);
    return setting.text(setting, settings);
}

TEST(DialsOfSettings, AreTheColumnRenderersButForSamples) {
    Settings settings;
    settings.samples = 3;
    settings.accuracy = NamedAccuracy::fast;
    settings.sampling = TextureFilter::mip;
    EXPECT_EQ(to_text(dials_of(settings, RendererKind::column, Map())), "accuracy=1 sampling=mip samples=3");
    EXPECT_EQ(to_text(dials_of(settings, RendererKind::stencil, Map())), "samples=3");
}

TEST(DialsOfSettings, DoNotGlitterButInMapsOfDoomsLight) {
    Map map;
    EXPECT_EQ(to_text(dials_of(Settings(), RendererKind::column, map)), "sampling=mip");
    map.render.light = LightModel::classic;
    EXPECT_EQ(to_text(dials_of(Settings(), RendererKind::column, map)), "exact");
    Settings settings;
    settings.sampling = TextureFilter::bilinear;
    EXPECT_EQ(to_text(dials_of(settings, RendererKind::column, map)), "sampling=bilinear");
}

class EverySetting : public ::testing::TestWithParam<const Setting*> {
protected:
    const Setting& row_ = *GetParam();
    Settings settings_;
};

TEST_P(EverySetting, ReadsWhatItWrites) {
    const std::string other = other_value(row_);
    EXPECT_NE(other, row_.text(row_, Settings()));
    EXPECT_TRUE(row_.read(row_, other, settings_).ok());
    EXPECT_EQ(row_.text(row_, settings_), other);
}

TEST_P(EverySetting, ComesBackFromTheFile) {
    ASSERT_TRUE(row_.read(row_, other_value(row_), settings_).ok());
    const SettingsReading reading = read_settings(write_settings(settings_));
    EXPECT_THAT(reading.findings, IsEmpty());
    for (const Setting& row : all_settings()) EXPECT_EQ(row.text(row, reading.settings), row.text(row, settings_));
}

TEST_P(EverySetting, RefusesWhatItCannotBe) {
    for (const char* wrong : {"", "nonsense", "nan", "1e99", "-1"}) {
        const Result<void> result = row_.read(row_, wrong, settings_);
        ASSERT_FALSE(result.ok()) << wrong;
        EXPECT_THAT(result.error().what, HasSubstr("expected"));
    }
    EXPECT_EQ(row_.text(row_, settings_), row_.text(row_, Settings()));
}

TEST_P(EverySetting, StaysWithinItsEndsOrComesRound) {
    std::set<std::string> seen;
    for (int i = 0; i < 500; ++i) {
        row_.turn(row_, i < 250 ? 1 : -1, settings_);
        const std::string text = row_.text(row_, settings_);
        Settings again;
        EXPECT_TRUE(row_.read(row_, text, again).ok()) << text;
        seen.insert(text);
    }
    EXPECT_GE(seen.size(), 2u);
    EXPECT_LE(seen.size(), 101u);
}

TEST_P(EverySetting, SaysWhatItIs) {
    EXPECT_FALSE(row_.label.empty());
    EXPECT_FALSE(row_.help.empty());
    EXPECT_EQ(&setting_named(row_.name), &row_);
}

std::vector<const Setting*> rows() {
    std::vector<const Setting*> all;
    for (const Setting& row : all_settings()) all.push_back(&row);
    return all;
}

INSTANTIATE_TEST_SUITE_P(Table, EverySetting, ::testing::ValuesIn(rows()),
                         [](const auto& row) { return std::string(row.param->name); });

TEST(Settings, CountTenthsExactly) {
    Settings settings;
    const Setting& volume = setting_named("volume");
    for (int i = 0; i < 10; ++i) volume.turn(volume, -1, settings);
    EXPECT_EQ(settings.volume, 0);
    for (int i = 0; i < 7; ++i) volume.turn(volume, 1, settings);
    EXPECT_EQ(volume.text(volume, settings), "0.7");
}

TEST(Settings, NameOptionsAsOthersDo) { EXPECT_EQ(option_of(setting_named("mouse_speed")), "--mouse-speed"); }

TEST(Settings, TakeAKeyAwayFromWhatItDidBefore) {
    Bindings bindings = usual_bindings();
    bind(bindings, Control::crouch, KeyCode::e);
    EXPECT_EQ(keys_for(bindings, Control::crouch), (ControlKeys{KeyCode::e, KeyCode::c}));
    EXPECT_EQ(keys_for(bindings, Control::use), (ControlKeys{KeyCode::unknown, KeyCode::space}));
    EXPECT_EQ(keys_text(keys_for(bindings, Control::use)), "Space");
}

TEST(Settings, GiveEveryControlKeysOfItsOwn) {
    std::set<KeyCode> keys;
    std::size_t count = 0;
    for (const ControlKeys& both : usual_bindings())
        for (const KeyCode key : both)
            if (key != KeyCode::unknown) keys.insert(key), ++count;
    EXPECT_EQ(keys.size(), count);
}

TEST(SettingsText, TellsWhereAndWhatIsWrong) {
    const SettingsReading reading = read_settings("fov = 90\nvolume = 3\n");
    ASSERT_EQ(reading.findings.size(), 1u);
    EXPECT_EQ(reading.findings[0].place, (TextPlace{2, 10}));
    EXPECT_THAT(reading.findings[0].sentence, HasSubstr("expected a number from 0 to 1; found '3'"));
    EXPECT_EQ(reading.settings.volume, 1);
}

TEST(SettingsText, KeepsWhatItDoesNotKnowAndSaysSo) {
    const SettingsReading reading = read_settings("accuracy_of_tomorrow = [1, \"two\", { a = true }]\nfow = 100\n");
    ASSERT_EQ(reading.findings.size(), 2u);
    EXPECT_FALSE(has_errors(reading.findings));
    EXPECT_THAT(reading.findings[1].sentence, HasSubstr("did you mean 'fov'"));
    const SettingsReading again = read_settings(write_settings({}, reading.unknown));
    EXPECT_EQ(again.unknown, reading.unknown);
    EXPECT_THAT(again.unknown.settings, HasSubstr("[1, \"two\", { \"a\" = true }]"));
}

TEST(SettingsText, KeepsKeysForWhatItDoesNotKnow) {
    const SettingsReading reading = read_settings("[keys]\nhop = [\"W\", nan]\n");
    EXPECT_FALSE(has_errors(reading.findings));
    EXPECT_EQ(read_settings(write_settings({}, reading.unknown)).unknown, reading.unknown);
    EXPECT_EQ(reading.unknown.keys, "\"hop\" = [\"W\", nan]\n");
}

TEST(SettingsText, SurvivesEveryKindOfValueUnderEveryKindOfKey) {
    const char* const values[] = {"nan",
                                  "-nan",
                                  "inf",
                                  "-inf",
                                  "9223372036854775807",
                                  "-9223372036854775808",
                                  "1e308",
                                  "1.0",
                                  "-0.0",
                                  "5e-324",
                                  "0xFF",
                                  "true",
                                  "\"a\\u0000b\"",
                                  "'\"'",
                                  "[]",
                                  "{}",
                                  "[[nan], { a.b = inf }]",
                                  "1979-05-27",
                                  "07:32:00.5",
                                  "1979-05-27T07:32:00.999-07:30",
                                  "\"\"\"two\nlines\"\"\""};
    for (const char* value : values)
        for (const char* key :
             {"zz", "'a b'", "fov", "size", "vsync", "renderer", "keys", "[keys]\nuse", "[keys]\nhop"}) {
            const SettingsReading reading = read_settings(std::string(key) + " = " + value + "\n");
            const SettingsReading again = read_settings(write_settings(reading.settings, reading.unknown));
            EXPECT_FALSE(has_errors(again.findings)) << key << " = " << value << ": " << to_text("", again.findings[0]);
            EXPECT_EQ(again.unknown, reading.unknown) << key << " = " << value;
            EXPECT_EQ(again.settings.bindings, reading.settings.bindings);
        }
}

/// Any TOML that is not too deep.
class RandomSettings {
public:
    explicit RandomSettings(std::uint64_t seed) : random_(seed) {}

    std::string text() {
        std::string text;
        for (const Setting& setting : all_settings())
            if (random_.below(3) == 0) text += std::string(setting.name) + " = " + value(0) + "\n";
        for (std::uint64_t i = random_.below(6); i > 0; --i) text += "k" + std::to_string(i) + " = " + value(0) + "\n";
        if (random_.below(2) == 0) text += "[keys]\n" + bindings();
        if (random_.below(3) == 0) text += "[tomorrow.more]\n\"a b\" = " + value(0) + "\n";
        return text;
    }

private:
    std::string bindings() {
        constexpr const char* kKeys[] = {"\"W\"", "\"mouse left\"", "\"nothing\"", "nan", "3"};
        std::string text;
        for (int i = 0; i < kControls; ++i) {
            if (random_.below(3) > 0) continue;
            const std::string name(info_of(static_cast<Control>(i)).name);
            text += name + " = [" + kKeys[random_.below(5)] + ", " + kKeys[random_.below(5)] + "]\n";
        }
        return text + "hop = " + value(0) + "\n";
    }
    std::string value(int depth) {
        switch (random_.below(depth < 4 ? 12 : 9)) {
            case 0: return "nan";
            case 1: return random_.below(2) == 0 ? "inf" : "-inf";
            case 2: return std::to_string(static_cast<std::int64_t>(random_.bits()));
            case 3: return real();
            case 4: return random_.below(2) == 0 ? "true" : "false";
            case 5: return string_text(any_text());
            case 6: return "1979-05-27 07:32:00Z";
            case 7: return "\"column\"";
            case 8: return std::to_string(random_.below(100));
            case 9: return "{ a = " + value(depth + 1) + ", \"b c\" = " + value(depth + 1) + " }";
            default: return "[" + value(depth + 1) + ", " + value(depth + 1) + "]";
        }
    }
    std::string real() {
        const double number = std::bit_cast<double>(random_.bits());
        return std::isfinite(number) ? fmt::format("{:e}", number) : "1.5";
    }
    std::string any_text() {
        std::string text;
        for (std::uint64_t i = random_.below(8); i > 0; --i) text += static_cast<char>(random_.below(256));
        return text;
    }

    Random random_;
};

TEST(SettingsText, IsTheSameWhenItIsReadAndWrittenAgainWhateverItWas) {
    for (std::uint64_t seed = 0; seed < 3000; ++seed) {
        const std::string text = RandomSettings(seed).text();
        const SettingsReading reading = read_settings(text);
        const std::string written = write_settings(reading.settings, reading.unknown);
        const SettingsReading again = read_settings(written);
        ASSERT_FALSE(has_errors(again.findings)) << text << to_text("", again.findings[0]) << "\n" << written;
        ASSERT_EQ(write_settings(again.settings, again.unknown), written) << text;
        ASSERT_EQ(again.unknown, reading.unknown) << text;
    }
}

TEST(SettingsText, DoesNotKeepMoreThanCanBeReadAgain) {
    std::string text;
    for (int i = 0; i < 20'000; ++i) text += "k" + std::to_string(i) + " = [1]\n";
    const SettingsReading reading = read_settings(text);
    EXPECT_TRUE(has_errors(reading.findings)) << "so that the file is set aside";
    EXPECT_FALSE(has_errors(read_settings(write_settings({}, reading.unknown)).findings));
}

TEST(SettingsText, ReadsAndWritesKeys) {
    const SettingsReading reading = read_settings("[keys]\nuse = [\"mouse left\"]\nrun = []\n");
    EXPECT_THAT(reading.findings, IsEmpty());
    EXPECT_EQ(keys_for(reading.settings.bindings, Control::use)[0], KeyCode::mouse_left);
    EXPECT_EQ(keys_text(keys_for(reading.settings.bindings, Control::run)), "none");
    EXPECT_EQ(read_settings(write_settings(reading.settings)).settings.bindings, reading.settings.bindings);
}

TEST(SettingsText, RefusesKeysThatThereAreNot) {
    const SettingsReading reading = read_settings("[keys]\nuse = [\"Any\"]\nhop = [\"W\"]\nrun = \"W\"\n");
    EXPECT_EQ(reading.findings.size(), 3u);
    EXPECT_EQ(reading.settings.bindings, usual_bindings());
}

class StoredSettings : public ::testing::Test {
protected:
    std::string text() const {
        const auto bytes = read_file(path_);
        return bytes.ok() ? std::string(as_text(bytes.value())) : "";
    }
    void write(std::string_view text) const { EXPECT_TRUE(write_file(path_, text).ok()); }

    test::TempDir dir_;
    std::string path_ = dir_.path("settings.toml");
};

TEST_F(StoredSettings, AreThereAgainAtTheNextStart) {
    SettingsStore store(dir_.path("new/folder/settings.toml"));
    Settings settings;
    settings.fov_degrees = 105;
    store.change(settings);
    EXPECT_TRUE(store.save().ok());
    EXPECT_EQ(SettingsStore(dir_.path("new/folder/settings.toml")).now().fov_degrees, 105);
}

TEST_F(StoredSettings, LeaveTheFileAloneWhereNothingChanged) {
    write("# mine\nfov = 100\n");
    SettingsStore store(path_);
    EXPECT_TRUE(store.save().ok());
    EXPECT_EQ(text(), "# mine\nfov = 100\n");
}

TEST_F(StoredSettings, DoNotKeepWhatAnOptionSaidForOneTime) {
    SettingsStore store(path_);
    Settings settings;
    settings.volume = 0;
    store.change_for_now(settings);
    settings.fov_degrees = 105;
    store.change(settings);
    EXPECT_TRUE(store.save().ok());
    EXPECT_EQ(SettingsStore(path_).now().volume, 1);
    EXPECT_EQ(SettingsStore(path_).now().fov_degrees, 105);
}

TEST_F(StoredSettings, AreTheUsualOnesWhereTheFileIsDamagedAndSetItAside) {
    write("fov = = 3\n\xFF");
    SettingsStore store(path_);
    EXPECT_EQ(store.now().fov_degrees, 90);
    EXPECT_FALSE(store.notes().empty());
    EXPECT_EQ(text(), "fov = = 3\n\xFF") << "looking changes nothing";
    store.change(store.now());
    EXPECT_TRUE(store.save().ok());
    EXPECT_EQ(as_text(read_file(path_ + ".unreadable").value()), "fov = = 3\n\xFF");
    EXPECT_TRUE(SettingsStore(path_).notes().empty());
}

TEST_F(StoredSettings, AreSetAsideWithoutOverwritingThoseThatWere) {
    for (const char* text : {"first = =", "second = ="}) {
        write(text);
        SettingsStore store(path_);
        store.change(store.now());
        EXPECT_TRUE(store.save().ok());
    }
    EXPECT_EQ(test::content(path_ + ".unreadable"), "first = =");
    EXPECT_EQ(test::content(path_ + ".unreadable-2"), "second = =");
}

TEST_F(StoredSettings, AreWrittenWhereThereWasNoFileButAFolderOrAPipe) {
    std::filesystem::create_directories(path_ + "/mine");
    ASSERT_EQ(mkfifo((path_ + ".pipe").c_str(), 0600), 0);
    for (const std::string& path : {path_, path_ + ".pipe"}) {
        SettingsStore store(path);
        EXPECT_FALSE(store.notes().empty());
        store.change(store.now());
        const Result<void> done = store.save();
        EXPECT_TRUE(done.ok()) << done.error().text();
        EXPECT_TRUE(SettingsStore(path).notes().empty());
    }
    EXPECT_TRUE(std::filesystem::is_directory(path_ + ".unreadable/mine"));
}

}  // namespace
}  // namespace enfilade
