// The support file: what stands in it, what does not, and how it comes onto a stick.
#include <gmock/gmock.h>
#include <sched.h>
#include <sys/mount.h>
#include <unistd.h>

#include <fstream>

#include "appliance/programs/shows/settings_text.h"
#include "appliance/programs/shows/support_file.h"
#include "appliance/programs/shows/support_report.h"
#include "drivers/base/read_file.h"
#include "tests/appliance/core/board_file.h"
#include "tests/appliance/core/pack_fixture.h"

namespace kaori::shows {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

class SupportTest : public tests::PackTest {
 protected:
  SupportTest() {
    for (const char* each : {"shows", "settings/keys", "stick", "usb/1-4", "profile"})
      fs::create_directories(folder_ / each);
    places_ = {.settings = folder_ / "settings/box.toml",
               .plays = folder_ / "plays",
               .release = folder_ / "os-release",
               .machine_id = folder_ / "machine-id",
               .usb = folder_ / "usb",
               .reports = folder_ / "reports",
               .status = {.settings = folder_ / "profile",
                          .screens = folder_ / "screens",
                          .notices = folder_ / "notices",
                          .shows = folder_ / "lines",
                          .usb = folder_ / "refused"}};
  }
  void Put(const std::string& file, const std::string& text) { std::ofstream(folder_ / file) << text; }
  std::string Report() {
    const auto journal = [this](JournalPart part, std::size_t most_bytes) -> Result<std::string> {
      most_bytes_ += most_bytes;
      return journal_(part, most_bytes);
    };
    return SupportReport(places_, *OpenFolder(folder_ / "shows"), &board_, journal, kWall);
  }
  static std::string FilesIn(const fs::path& folder) {
    std::string names;
    for (const auto& entry : fs::directory_iterator(folder)) names += entry.path().filename().string() + " ";
    return names;
  }

  static constexpr std::time_t kWall = 1'795'000'000;
  board::Board board_ = board::Board::Create((folder_ / "board").string()).value();
  SupportPlaces places_;
  Journal journal_ = [](JournalPart, std::size_t) { return std::string(); };
  std::size_t most_bytes_ = 0;
};

TEST_F(SupportTest, HasTheNewestShowReport) {
  EXPECT_THAT(Report(), HasSubstr("== Show report of the last evening ==\n\nthere is none yet\n"));
  fs::create_directories(folder_ / "reports");
  Put("reports/0007-20261122-190000.report.txt", "Kaori, the seventh\n");
  Put("reports/0008-20261123-190000.report.txt", "Kaori, the eighth\n");
  Put("reports/0008-20261123-190000.report.html", "<html>\n");
  Put("reports/0009-20261124-190000.kaorilog", "\n");
  const std::string report = Report();
  EXPECT_THAT(report, HasSubstr("evening ==\n\n0008-20261123-190000.report.txt\n\nKaori, the eighth\n"));
  EXPECT_THAT(report, ::testing::Not(HasSubstr("the seventh")));
}

TEST_F(SupportTest, FollowsNoLinkToAnotherFileOfTheBox) {
  fs::create_directories(folder_ / "reports");
  Put("secret", "hunter2\n");
  Put("reports/0007-20261122-190000.report.txt", "Kaori, the seventh\n");
  fs::create_symlink(folder_ / "secret", folder_ / "reports/0008-20261123-190000.report.txt");
  const std::string report = Report();
  EXPECT_THAT(report, HasSubstr("Kaori, the seventh\n"));
  EXPECT_THAT(report, ::testing::Not(HasSubstr("hunter2")));
}

TEST_F(SupportTest, SaysWhyTheLastStartsEndedAndWhatCrashedBeforeAllElse) {
  Put("os-release", "PRETTY_NAME=\"Kaori box\"\n");
  Put("profile/root_hash", "0123456789abcdef\n");
  Put("usb/1-4/idVendor", "046d\n");
  Put("usb/1-4/idProduct", "c215\n");
  Put("usb/1-4/authorized", "0\n");
  Put("usb/1-4/product", "Extreme 3D\n");
  Put("usb/1-4/serial", "4711\n");
  journal_ = [](JournalPart part, std::size_t) -> Result<std::string> {
    if (part == JournalPart::kPower)
      return std::string(
          "2026 kaori-power: the last start ended by a clean stop\n2026 kaori-power: no button\n");
    if (part == JournalPart::kWarnings)
      return std::string("2026 kaori-lips: crash: signal 11\n2026 dim light\n");
    return std::string("2026 everything that was said\n");
  };
  const std::string report = Report();
  EXPECT_THAT(report,
              HasSubstr("ended ==\n\n2026 kaori-power: the last start ended by a clean stop\n\n== Status"));
  EXPECT_THAT(report, HasSubstr("Crash reports ==\n\n2026 kaori-lips: crash: signal 11\n\n=="));
  EXPECT_THAT(report, HasSubstr("2026 dim light"));
  EXPECT_THAT(report, HasSubstr("PRETTY_NAME"));
  EXPECT_THAT(report, HasSubstr("0123456789abcdef"));
  EXPECT_THAT(report, HasSubstr("046d:c215 unauthorised"));
  EXPECT_THAT(report, HasSubstr("Extreme 3D"));
  EXPECT_THAT(report, Not(HasSubstr("4711"))) << "no serial numbers";
  EXPECT_THAT(report, HasSubstr("MB are free"));
  EXPECT_THAT(report, ::testing::EndsWith("== Journal ==\n\n2026 everything that was said\n"));
}

TEST_F(SupportTest, SaysWhyADeviceStaysUnauthorised) {
  Put("usb/1-4/idVendor", "1209\n");
  Put("usb/1-4/idProduct", "0f01\n");
  Put("usb/1-4/authorized", "0\n");
  fs::create_directories(folder_ / "refused");
  Put("refused/1-4", "quiet\nUSB port 1-4: a printer stays out\nプリンター\n");
  EXPECT_THAT(Report(),
              HasSubstr("1209:0f01 unauthorised  \n             USB port 1-4: a printer stays out\n"));
  fs::remove(folder_ / "refused/1-4");
  EXPECT_THAT(Report(), Not(HasSubstr("a printer")));
}

TEST_F(SupportTest, OfABoxThatHasNothingIsAReportAllTheSame) {
  journal_ = [](JournalPart, std::size_t) -> Result<std::string> { return FailInput("no journal"); };
  places_.usb = folder_ / "nowhere";
  const std::string report =
      SupportReport(places_, *OpenFolder(folder_ / "nowhere"), nullptr, journal_, kWall);
  EXPECT_THAT(report, HasSubstr("the journal cannot be read: no journal"));
  EXPECT_THAT(report, HasSubstr("the box's programs do not run"));
}

TEST_F(SupportTest, IsBoundedHoweverMuchTheJournalHolds) {
  journal_ = [](JournalPart, std::size_t most_bytes) { return std::string(most_bytes, 'x'); };
  Put("plays", std::string(1 << 20, 'p'));
  Put("os-release", std::string(1 << 20, 'o'));
  Put("screens", std::string(1 << 20, 's'));
  EXPECT_LT(Report().size(), kMostSupport_bytes);
  EXPECT_GT(most_bytes_, std::size_t{4} << 20U);
}

TEST_F(SupportTest, HoldsNoKeyAndNoControlCharacter) {
  Put("settings/keys/theatre.pub", "kaori-public-key 0123456789\n");
  Put("settings/box.toml", "profile = \"stage\"\n[network]\npassword = \"hunter2\"\n");
  journal_ = [](JournalPart, std::size_t) { return std::string("a device is called \x1b[2J\x07\n"); };
  const std::string report = Report();
  EXPECT_THAT(report, Not(HasSubstr("0123456789")));
  EXPECT_THAT(report, Not(HasSubstr("hunter2")));
  EXPECT_THAT(report, HasSubstr("is called ?[2J?\n"));
}

TEST_F(SupportTest, ShowsSettingsWithoutTheirSecretsAndComments) {
  Put("settings/box.toml",
      "# Aya's telephone is 555\nprofile = \"stage\"\n[stick.left]\ncurve = 0.25\n[keyboard]\nport = "
      "\"1-4\"\n"
      "[network]\naddress = \"10.0.0.2/24\"\nWifiPassword = \"hunter2\"\naccess_keys = [\"hunter3\", "
      "\"hunter4\"]\n"
      "[desk.token]\nvalue = \"hunter5\"\n[[peers]]\nname = \"spare\"\npin = 4711\n");
  EXPECT_EQ(SettingsText(places_.settings),
            "desk.token = (left out)\n"
            "keyboard.port = \"1-4\"\n"
            "network.WifiPassword = (left out)\n"
            "network.access_keys = (left out)\n"
            "network.address = \"10.0.0.2/24\"\n"
            "peers[0].name = \"spare\"\n"
            "peers[0].pin = (left out)\n"
            "profile = \"stage\"\n"
            "stick.left.curve = 0.25\n");
}

TEST_F(SupportTest, OfFaultySettingsShowsTheFaultAlone) {
  Put("settings/box.toml", "password = \"hunter2\nprofile = 3\n");
  const std::string text = SettingsText(places_.settings);
  EXPECT_THAT(text, HasSubstr("box.toml:1: "));
  EXPECT_THAT(text, Not(HasSubstr("hunter2")));
}

TEST_F(SupportTest, IsNamedAfterTheBoxAndTheDate) {
  Put("machine-id", "1a2b3c4d5e6f00112233445566778899\n");
  EXPECT_THAT(BoxName(places_), ::testing::EndsWith("-1a2b3c4d"));
  EXPECT_EQ(NameForFiles("left lobby", "1a2b3c4d"), "left-lobby-1a2b3c4d");
  EXPECT_EQ(NameForFiles("kaori-1a2b3c4d", "1a2b3c4d"), "kaori-1a2b3c4d") << "the number stands there once";
  EXPECT_EQ(NameForFiles("left-lobby", ""), "left-lobby");
  EXPECT_THAT(BoxName(places_), ::testing::MatchesRegex("[A-Za-z0-9-]+"));
  EXPECT_THAT(SupportFileName("kaori-1a2b3c4d", kWall),
              ::testing::MatchesRegex("kaori-1a2b3c4d-2026[0-9]{4}-[0-9]{6}\\.txt"));
}

TEST_F(SupportTest, IsWrittenBesideWhatIsOnTheStick) {
  Put("stick/evening.kaori", "a show");
  ASSERT_TRUE(WriteSupportFile(folder_ / "stick", "box.txt", "all of it"));
  EXPECT_EQ(ReadFile(folder_ / "stick/box.txt").value_or(""), "all of it");
  EXPECT_EQ(ReadFile(folder_ / "stick/evening.kaori").value_or(""), "a show");
  const auto again = WriteSupportFile(folder_ / "stick", "evening.kaori", "all of it");
  ASSERT_FALSE(again);
  EXPECT_EQ(SupportMessageOf(again.error()), Message::kStickUnwritable);
  EXPECT_EQ(ReadFile(folder_ / "stick/evening.kaori").value_or(""), "a show") << "it is not ours";
}

TEST_F(SupportTest, OnAStickThatIsOutOrLockedOrFullIsNamedSo) {
  const auto out = WriteSupportFile(folder_ / "nowhere", "box.txt", "x");
  ASSERT_FALSE(out);
  EXPECT_EQ(SupportMessageOf(out.error()), Message::kSupportPulled);
  EXPECT_EQ(SupportMessageOf(Error{std::errc::io_error, "write"}), Message::kSupportPulled);
  EXPECT_EQ(SupportMessageOf(Error{std::errc::no_space_on_device, "write"}), Message::kStickFull);
  EXPECT_EQ(SupportMessageOf(Error{std::errc::read_only_file_system, "write"}), Message::kStickUnwritable);
  for (const Message each : {Message::kSupportPulled, Message::kStickFull, Message::kStickUnwritable})
    EXPECT_TRUE(IsRefusal(each));
  EXPECT_FALSE(IsRefusal(Message::kWritten));
}

// A small file system in memory in place of the stick, in a process of its own, whose mounts end with it.
[[noreturn]] void WriteMoreThanFits(const fs::path& stick) {
  const bool mounted = ::unshare(CLONE_NEWNS) == 0 &&
                       ::mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
                       ::mount("none", stick.c_str(), "tmpfs", 0, "size=64k") == 0;
  if (!mounted) std::exit(77);
  std::ofstream(stick / "evening.kaori") << "a show";
  const auto full = WriteSupportFile(stick, "box.txt", std::string(1 << 20, 'x'));
  const bool refused = !full && SupportMessageOf(full.error()) == Message::kStickFull;
  const bool harmless =
      !fs::exists(stick / "box.txt") && ReadFile(stick / "evening.kaori").value_or("") == "a show";
  std::exit(refused && harmless && WriteSupportFile(stick, "box.txt", "x") ? 0 : 1);
}

TEST_F(SupportTest, ThatDoesNotFitLeavesTheStickAsItWas) {
  if (::geteuid() != 0) GTEST_SKIP() << "this process cannot mount anything";
  EXPECT_EXIT(WriteMoreThanFits(folder_ / "stick"), ::testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace kaori::shows
