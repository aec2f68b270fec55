// Every setting: its text, its ends, its steps; and the file in which all are kept.
#include "app/play/settings.h"

#include <gmock/gmock.h>

#include <set>

#include "base/files.h"
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
    EXPECT_THAT(again.unknown, HasSubstr("[1, \"two\", { \"a\" = true }]"));
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
    EXPECT_EQ(as_text(read_file(path_ + ".damaged").value()), "fov = = 3\n\xFF");
    EXPECT_TRUE(SettingsStore(path_).notes().empty());
}

}  // namespace
}  // namespace enfilade
