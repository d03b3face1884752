// Settings at the box: those of a stick, and single ones from the list; what is refused, and what is kept.
#include "appliance/core/restore/plan.h"
#include "appliance/programs/shows/box_settings.h"
#include "appliance/programs/shows/settings_check.h"
#include "appliance/programs/shows/settings_line.h"
#include "appliance/programs/shows/settings_text.h"
#include "tests/appliance/programs/shows_service_fixture.h"

namespace kaori::shows {
namespace {

using namespace std::chrono_literals;  // NOLINT: tests speak in seconds.
namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

class SettingsTest : public ServiceTest {
 protected:
  SettingsTest() : ServiceTest(Offers::kSettings) {
    for (const char* each : {"settings", "zones/Asia"}) fs::create_directories(folder_ / each);
    Put("zones/Asia/Tokyo", "TZif");
    Put("settings/box.toml", kOld);
    Put("screens", "HDMI-A-1 1920x1080 60.00 wanted picture\nDP-2 1280x720 60.00 wanted picture\n");
  }
  static constexpr const char* kFile = "settings/box.toml";
  static constexpr const char* kOld = "# ours\nprofile = \"stage\"\n[lines]\ngo = 0\n";
  static constexpr const char* kNew =
      "profile = \"kiosk\"\n[lines]\ngo = 3\nblackout = \"none\"\npresence = "
      "\"none\"\n[stick.left]\ndead_zone = 0.1\n";
};

TEST_F(SettingsTest, OfAStickAreShownAsWhatTheyChangeAndCountFromTheNextStartOn) {
  Put("stick/box.toml", kNew);
  plugged_ = true;
  const std::string asked = Choose("settings box");
  EXPECT_THAT(asked, HasSubstr(Words(Message::kAskChange, Language::kEnglish)));
  EXPECT_THAT(asked, HasSubstr("> 1. leave the settings as they are"));
  EXPECT_THAT(asked, HasSubstr("changed profile  \"stage\" -> \"kiosk\""));
  EXPECT_THAT(asked, HasSubstr("changed lines.go  0 -> 3"));
  EXPECT_THAT(asked, HasSubstr("new     stick.left.dead_zone  0.1"));
  EXPECT_EQ(Text(kFile), kOld);
  EXPECT_THAT(Choose("yes, change them"), HasSubstr("switch the box off and on"));
  EXPECT_EQ(Text(kFile), kNew);
  EXPECT_EQ(Text("settings/box.before.toml"), kOld);
}

TEST_F(SettingsTest, OfAStickThatNobodyAgreesToChangeNothing) {
  Put("stick/box.toml", kNew);
  plugged_ = true;
  Choose("settings box");
  EXPECT_THAT(Choose("leave the settings"), HasSubstr("the box stays as it is"));
  EXPECT_EQ(Text(kFile), kOld);
  EXPECT_FALSE(fs::exists(folder_ / "settings/box.before.toml"));
}

TEST_F(SettingsTest, OfAStickThatIsPulledAreForgotten) {
  Put("stick/box.toml", kNew);
  plugged_ = true;
  Choose("settings box");
  plugged_ = false;
  Play(1s);
  Strike(board::key::kPageUp);
  EXPECT_THAT(Play(1s), Not(HasSubstr("yes, change them")));
  EXPECT_EQ(Text(kFile), kOld);
}

TEST_F(SettingsTest, WithAMistakeAreRefusedWithItsPlace) {
  Put("stick/box.toml", "profile = \"stage\"\n[stick.left]\ndead_zone = 7\n");
  plugged_ = true;
  const std::string said = Choose("settings box");
  EXPECT_THAT(said, HasSubstr("! box: these settings have a mistake"));
  EXPECT_THAT(said, HasSubstr("box.toml:3:13: stick.left.dead_zone is not between 0 and 0.9"));
  EXPECT_THAT(said, HasSubstr(Words(Message::kFaultySettings, Language::kJapanese)));
  EXPECT_EQ(Text(kFile), kOld);
}

// Two boxes that are set up from one stick are told apart by the names that they had.
TEST_F(SettingsTest, OfAStickLeaveABoxTheNameThatItHas) {
  Put("settings/box.toml", std::string("name = \"right\"\n") + kOld);
  Put("stick/box.toml", std::string("name = \"left\"\n") + kNew);
  plugged_ = true;
  const std::string asked = Choose("settings box");
  EXPECT_THAT(asked, HasSubstr("changed profile  \"stage\" -> \"kiosk\""));
  EXPECT_THAT(asked, Not(HasSubstr("name  ")));
  Choose("yes, change them");
  EXPECT_EQ(Text(kFile), std::string("name = \"right\"\n") + kNew);
}

TEST_F(SettingsTest, OfAStickThatNamesNoBoxLeaveTheNameToo) {
  Put("settings/box.toml", std::string("name = \"right\"\n") + kOld);
  Put("stick/box.toml", kNew);
  plugged_ = true;
  EXPECT_THAT(Choose("settings box"), Not(HasSubstr("gone    name")));
}

TEST_F(SettingsTest, OfAStickWithAMistakeAreRefusedWithItsPlaceByABoxWithANameToo) {
  Put("settings/box.toml", std::string("name = \"right\"\n") + kOld);
  Put("stick/box.toml", "[stick.left]\ndead_zone = 7\n");
  plugged_ = true;
  EXPECT_THAT(Choose("settings box"), HasSubstr("box.toml:2:13: stick.left.dead_zone"));
}

TEST_F(SettingsTest, OfAStickNameABoxThatHasNoName) {
  Put("stick/box.toml", std::string("name = \"left\"\n") + kNew);
  plugged_ = true;
  EXPECT_THAT(Choose("settings box"), HasSubstr("new     name  \"left\""));
  Choose("yes, change them");
  EXPECT_EQ(Text(kFile), std::string("name = \"left\"\n") + kNew);
}

// Whoever writes a name on the desk's page means this box.
TEST_F(SettingsTest, OfTheDeskMayGiveABoxAnotherName) {
  Put("settings/box.toml", std::string("name = \"right\"\n") + kOld);
  EXPECT_EQ(settings_.BeginText("desk", std::string("name = \"left\"\n") + kOld).message,
            Message::kAskChange);
  EXPECT_THAT(settings_.Differences(), ElementsAre("changed name  \"right\" -> \"left\""));
}

TEST_F(SettingsTest, ThatTheBoxHasAlreadyAreSaidToBeThere) {
  Put("stick/box.toml", std::string("# another comment\n") + kOld);
  plugged_ = true;
  EXPECT_THAT(Choose("settings box"), HasSubstr("the box has all of it already"));
}

TEST_F(SettingsTest, CanBeChosenFromTheListWithoutAStickAndCommentsStay) {
  Play(1s);
  Strike(board::key::kPageUp);
  const std::string list = Choose("settings of this box");
  EXPECT_THAT(list, HasSubstr("2. profile  stage"));
  EXPECT_THAT(list, HasSubstr("4. operators' monitor  none"));
  const std::string values = Choose("operators' monitor");
  EXPECT_THAT(values, HasSubstr("2. none  as it is\n  3. HDMI-A-1\n  4. DP-2\n"));
  EXPECT_THAT(Choose("DP-2"), HasSubstr("new     monitor_screen  \"DP-2\""));
  EXPECT_THAT(Choose("yes, change them"), HasSubstr("monitor_screen: switch the box off and on"));
  EXPECT_EQ(Text(kFile), std::string("monitor_screen = \"DP-2\"\n") + kOld);
}

TEST_F(SettingsTest, OfBeforeTheLastChangeComeBack) {
  Put("stick/box.toml", kNew);
  plugged_ = true;
  Choose("settings box");
  Choose("yes, change them");
  Choose("settings of this box");
  EXPECT_THAT(Choose("back to the settings before"), HasSubstr("changed profile  \"kiosk\" -> \"stage\""));
  Choose("yes, change them");
  EXPECT_EQ(Text(kFile), kOld);
  EXPECT_EQ(Text("settings/box.before.toml"), kNew);
}

// The restore would put its own settings at the next start, and nobody would know why.
TEST_F(SettingsTest, AreNotChangedWhileARestoreWaits) {
  fs::create_directories(folder_ / restore::kNext);
  Put(std::string(restore::kNext) + "/" + restore::kPlan, "a plan");
  Put("stick/box.toml", kNew);
  plugged_ = true;
  EXPECT_THAT(Choose("settings box"), HasSubstr(Words(Message::kRestoreWaits, Language::kEnglish)));
  EXPECT_EQ(Text(kFile), kOld);
}

TEST_F(SettingsTest, AreJudgedAsAWhole) {
  const auto fault = [&](const std::string& text) { return FaultOfSettings(text, folder_ / "zones"); };
  EXPECT_EQ(fault(kOld), "");
  EXPECT_EQ(fault(kNew), "");
  EXPECT_EQ(fault(""), "");
  EXPECT_THAT(fault("profile = \"stag\"\n"), HasSubstr("line 1: there is no profile \"stag\""));
  EXPECT_THAT(fault("[lines]\ngo = 1\n"), HasSubstr("line 2"));  // Line 1 is that of blackout.
  EXPECT_THAT(fault("[clock]\nzone = \"Asia/Kyoto\"\n"), HasSubstr("no time zone \"Asia/Kyoto\""));
  EXPECT_EQ(fault("[clock]\nzone = \"Asia/Tokyo\"\n"), "");
  EXPECT_THAT(fault("[stik.left]\ncurve = 0.3\n"), HasSubstr("no section [stik]; did you mean \"stick\"?"));
  EXPECT_THAT(fault("[lines.more]\ngo = 1\n"), HasSubstr("no section [lines.more]"));
  EXPECT_THAT(fault("[[dials]]\nport = \"1\"\n"), HasSubstr("dials"));
  EXPECT_THAT(fault("profile = stage\n"), HasSubstr("1"));
  EXPECT_NE(fault(std::string(kMostSettings_bytes + 1, '#')), "");
}

TEST(SettingsDifferencesTest, NameEachSettingWithBothOfItsValues) {
  EXPECT_THAT(SettingsDifferences("a = 1\nb = \"x\"\n", "b = \"y\"\n[c]\nd = true\n"),
              ElementsAre("changed b  \"x\" -> \"y\"", "new     c.d  true", "gone    a  1"));
  EXPECT_THAT(SettingsDifferences("a = 1 # one\n", "# one\na=1"), ElementsAre());
  EXPECT_THAT(SettingsDifferences("no settings", "key = \"k\"\n"), ElementsAre("new     key  \"k\""));
}

TEST(SettingsLineTest, StandsAboveTheFirstSectionAlone) {
  EXPECT_EQ(WithLineOf("name = \"a\"\n[x]\nname = \"b\"\n", "  name=\"mine\"\nprofile = \"kiosk\"\n", "name"),
            "  name=\"mine\"\n[x]\nname = \"b\"\n");
  EXPECT_EQ(WithLineOf("names = 1\nname = \"a\"", "", "name"), "names = 1\n");
  EXPECT_EQ(WithLineOf("", "[x]\nname = \"b\"\n", "name"), "");
  EXPECT_EQ(WithSetting("profile = \"stage\"\n[x]\n", "profile", "bench"), "profile = \"bench\"\n[x]\n");
  EXPECT_EQ(WithSetting("# a\nstatus_screen = 2\n", "status_screen", ""), "# a\n");
}

}  // namespace
}  // namespace kaori::shows
