// What the box is for: a settings file that people write, and that may be wrong.
#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "appliance/programs/boot/profile.h"
#include "appliance/programs/boot/root_hash.h"

namespace kaori::boot {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(Profile, IsTheOneThatTheFileNames) {
  EXPECT_EQ(ReadProfile("profile = \"kiosk\"").name, "kiosk");
  EXPECT_EQ(ReadProfile("# tonight\n\n  profile=\"bench\"  # of the workshop\r\n").name, "bench");
  EXPECT_EQ(ReadProfile("profile = \"stage\"\n[desk]\nport = 1\n").name, "stage");
  EXPECT_THAT(ReadProfile("profile = \"stage\"\n[desk]\nport = 1\n").fault, IsEmpty());
}

TEST(Profile, WithoutAWordIsTheStage) {
  EXPECT_EQ(ReadProfile("").name, "stage");
  EXPECT_THAT(ReadProfile("").fault, IsEmpty());
}

TEST(Profile, AFaultIsNamedWithItsLine) {
  EXPECT_EQ(ReadProfile("\nprofile = \"disco\"").fault,
            "line 2: there is no profile \"disco\": stage, kiosk or bench");
  EXPECT_EQ(ReadProfile("profile = kiosk").fault, "line 1: expected a value in quotes");
  EXPECT_EQ(ReadProfile("profil = \"kiosk\"").fault, "line 1: there is no setting profil");
  EXPECT_EQ(ReadProfile("kiosk").fault, "line 1: expected a name, = and a value");
  EXPECT_EQ(ReadProfile("profile = \"").fault, "line 1: expected a value in quotes");
  EXPECT_EQ(ReadProfile("profile = \"kiosk\"\nx").name, "stage") << "half a file is not believed";
}

TEST(Profile, TheLinesAreWiredAsTheirSectionSays) {
  const auto usual = ReadProfile("profile = \"kiosk\"").wiring;
  EXPECT_EQ(EnvironmentOf(usual),
            "KAORI_CHIP=cp2112_gpio\nKAORI_LINES=go=0,blackout=1,service=2,presence=3,tally=4\n");
  const auto read = ReadProfile(
      "[desk]\nport = x\n[lines] # ours\nchip = \"mcp2221_gpio\"\ngo = 1\nblackout = 0\ntally = "
      "\"none\"\n[x]\ny\n");
  EXPECT_THAT(read.fault, IsEmpty());
  EXPECT_EQ(EnvironmentOf(read.wiring),
            "KAORI_CHIP=mcp2221_gpio\nKAORI_LINES=go=1,blackout=0,service=2,presence=3\n");
}

TEST(Profile, ABoxWithoutLinesLooksForNoChip) {
  std::string none = "[lines]\n";
  for (const auto name : kLineNames) none += std::string(name) + " = \"none\"\n";
  EXPECT_EQ(EnvironmentOf(ReadProfile(none).wiring), "KAORI_CHIP=\nKAORI_LINES=\n");
}

TEST(Profile, AFaultInTheLinesIsNamedWithItsLine) {
  EXPECT_EQ(ReadProfile("[lines]\nstop = 1").fault, "line 2: there is no line stop");
  for (const char* wrong : {"x", "-1", "64", "1.5", "\"1\"", ""})
    EXPECT_EQ(ReadProfile(std::string("[lines]\ngo = ") + wrong).fault,
              "line 2: expected a number of 0 to 63, or \"none\"")
        << wrong;
  for (const char* wrong : {"cp2112_gpio", "\"\"", "\"a b\"", "\"a\nKAORI_LINES=\""})
    EXPECT_EQ(ReadProfile(std::string("[lines]\nchip = ") + wrong).fault,
              "line 2: expected a chip's label in quotes")
        << wrong;
  const Profile twice = ReadProfile("profile = \"kiosk\"\n[lines]\ngo = 1\n\n[other]\n");
  EXPECT_EQ(twice.fault, "line 3: go and blackout are one line");
  EXPECT_EQ(twice.wiring, Wiring());
  EXPECT_EQ(twice.name, "stage");
}

TEST(Profile, ADialBoxOnASerialLineIsNamedWithItsKind) {
  const auto read = ReadProfile("dial_box = \"/dev/serial/by-path/pci-0000:00:14.0-usb-0:2:1.0-port0=sgi\"");
  EXPECT_THAT(read.fault, IsEmpty());
  EXPECT_EQ(DialsEnvironmentOf(read),
            "KAORI_DIALS=--serial /dev/serial/by-path/pci-0000:00:14.0-usb-0:2:1.0-port0=sgi\n");
  EXPECT_EQ(DialsEnvironmentOf(ReadProfile("")), "KAORI_DIALS=\n");
  EXPECT_EQ(DialsEnvironmentOf(ReadProfile("dial_box = \"/dev/ttyUSB0=dls80\"\ndial_box_counts = 200")),
            "KAORI_DIALS=--serial /dev/ttyUSB0=dls80 --counts-per-turn 200\n");
  EXPECT_EQ(DialsEnvironmentOf(ReadProfile("dial_lines = \"gpiochip0:4,5,16,17\"\ndial_box_counts = 96")),
            "KAORI_DIALS=--dials gpiochip0:4,5,16,17 --counts-per-turn 96\n");
  for (const char* wrong :
       {"gpiochip0", "gpiochip0:4", "gpiochip0:4,5,6", "gpiochip0:4,,5", "gpiochip0:,4,5", ":4,5",
        "gpiochip0:4,x", "gpio chip:4,5", "$HOME:4,5", "g:1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18"})
    EXPECT_THAT(ReadProfile("dial_lines = \"" + std::string(wrong) + "\"").fault,
                HasSubstr("line 1: expected a GPIO chip and two lines for each dial"))
        << wrong;
  for (const char* wrong : {"0", "1048577", "\"200\"", "200.5", ""})
    EXPECT_THAT(ReadProfile("dial_box_counts = " + std::string(wrong)).fault,
                HasSubstr("line 1: expected how many counts a turn has, a whole number from 1 to 1048576"));
  for (const char* wrong :
       {"/dev/ttyUSB0", "/dev/ttyUSB0=sn921", "ttyUSB0=sgi", "/dev/tty USB0=sgi", "/dev/$HOME=sgi"})
    EXPECT_THAT(ReadProfile("dial_box = \"" + std::string(wrong) + "\"").fault,
                HasSubstr("line 1: expected a serial line and its kind of box"));
}

TEST(Profile, NamesTheScreenThatSaysHowTheBoxDoes) {
  EXPECT_THAT(ReadProfile("profile = \"stage\"\n").status_screen, IsEmpty());
  EXPECT_EQ(ReadProfile("status_screen = \"HDMI-A-2\"").status_screen, "HDMI-A-2");
  EXPECT_EQ(ReadProfile("status_screen = 2  # the small one").status_screen, "2");
  EXPECT_THAT(ReadProfile("status_screen = \"\"").status_screen, IsEmpty()) << "none, in so many words";
  for (const char* wrong : {"HDMI-A-2", "0", "-1", "200", "\"a b\"", "\"../x\"", ""})
    EXPECT_THAT(ReadProfile(std::string("status_screen = ") + wrong).fault,
                HasSubstr("line 1: expected a screen's name"))
        << wrong;
}

TEST(Profile, NamesTheScreenOfTheOperatorsMonitor) {
  EXPECT_THAT(ReadProfile("status_screen = 2\n").monitor_screen, IsEmpty()) << "none unless it is asked for";
  EXPECT_EQ(ReadProfile("monitor_screen = \"DP-1\"\nstatus_screen = 2").monitor_screen, "DP-1");
  EXPECT_THAT(ReadProfile("monitor_screen = DP-1").fault, HasSubstr("line 1: expected a screen's name"));
}

TEST(Profile, NamesTheBox) {
  EXPECT_THAT(ReadProfile("profile = \"stage\"\n").box_name, IsEmpty());
  EXPECT_EQ(ReadProfile("name = \"left-lobby\"  # the one by the door\nprofile = \"kiosk\"").box_name,
            "left-lobby");
  for (const std::string& wrong :
       {std::string("left"), std::string("\"\""), std::string("\"left lobby\""), std::string("\"-left\""),
        std::string("\"left.example\""), "\"" + std::string(33, 'a') + "\""})
    EXPECT_THAT(ReadProfile("name = " + wrong).fault, HasSubstr("line 1: expected a name for the box"))
        << wrong;
}

TEST(Profile, NamesTheTimeZoneOfTheHouse) {
  EXPECT_THAT(ClockEnvironmentOf(ReadProfile("profile = \"kiosk\"")), IsEmpty());
  const auto read = ReadProfile("[clock]\nzone = \"Asia/Tokyo\"  # here\n[lines]\ngo = 7\n");
  EXPECT_THAT(read.fault, IsEmpty());
  EXPECT_EQ(ClockEnvironmentOf(read), "TZ=Asia/Tokyo\n");
  EXPECT_EQ(ReadProfile("[clock]\nzone = \"Etc/GMT+9\"").zone, "Etc/GMT+9");
  for (const char* wrong :
       {"Asia/Tokyo", "\"\"", "\"../passwd\"", "\"/etc/passwd\"", "\"Asia/\"", "\"a b\"", ""})
    EXPECT_THAT(ReadProfile(std::string("[clock]\nzone = ") + wrong).fault,
                HasSubstr("line 2: expected the name of a time zone, as in \"Asia/Tokyo\""))
        << wrong;
  EXPECT_EQ(ReadProfile("[clock]\nzones = \"Asia/Tokyo\"").fault,
            "line 2: there is no setting zones of [clock]");
}

TEST(RootHash, IsTheOneOfTheVerityTable) {
  const std::string hash(128, 'a');
  const std::string table =
      "dm-mod.create=\"root,,,ro,0 8 verity 1 PARTUUID=1 PARTUUID=2 4096 4096 1 1 blake2b-512 ";
  EXPECT_EQ(RootHashOf("quiet " + table + hash + " 00\" ro"), hash);
  EXPECT_THAT(RootHashOf(""), IsEmpty());
  EXPECT_THAT(RootHashOf("root=/dev/vda blake2b-512 " + hash), IsEmpty());
  EXPECT_THAT(RootHashOf(table + hash.substr(1)), IsEmpty());
  EXPECT_THAT(RootHashOf(table + "X" + hash.substr(1)), IsEmpty());
}

TEST(Slot, IsTheOneThatTheCommandLineNames) {
  EXPECT_EQ(SlotOf("quiet panic=5 rauc.slot=A\n"), "A");
  EXPECT_EQ(SlotOf("rauc.slot=B quiet"), "B");
  for (const char* other : {"", "quiet", "rauc.slot=", "rauc.slot=C", "rauc.slot=AB", "my.rauc.slot=A"})
    EXPECT_THAT(SlotOf(other), IsEmpty()) << other;
}

TEST(Slot, IsTriedWhereTheNoteOfAnUpdateIsOfIt) {
  EXPECT_TRUE(IsTried("12 B 1\n", "B"));
  EXPECT_TRUE(IsTried("12 A 1\n", "A"));
  EXPECT_FALSE(IsTried("12 B 1\n", "A"));
  for (const char* note : {"", "12 B", "B", "noise \x01"}) EXPECT_FALSE(IsTried(note, "B")) << note;
  EXPECT_FALSE(IsTried("12 B 1\n", ""));
}

class SettingsFolder : public ::testing::Test {
 protected:
  SettingsFolder()
      : folder_(fs::path(::testing::TempDir()) / ("settings-folder-" + std::to_string(::getpid()))) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~SettingsFolder() override { fs::remove_all(folder_); }

  void Write(const std::string& text) const { std::ofstream(folder_ / "box.toml") << text; }
  const fs::path& folder() const { return folder_; }

 private:
  fs::path folder_;
};

TEST_F(SettingsFolder, ATimeZoneThatTheBoxDoesNotKnowIsNamedAndItsClockIsUtc) {
  fs::create_directories(folder() / "Asia");
  std::ofstream(folder() / "Asia" / "Tokyo") << "TZif2";
  Profile known = ReadProfile("[clock]\nzone = \"Asia/Tokyo\"");
  EXPECT_THAT(DropUnknownZone(known, folder()), IsEmpty());
  EXPECT_EQ(known.zone, "Asia/Tokyo");
  for (const std::string wrong : {"Asia/Tokio", "Asia"}) {
    Profile unknown = ReadProfile("[clock]\nzone = \"" + wrong + "\"");
    EXPECT_EQ(DropUnknownZone(unknown, folder()),
              "box.toml: the box knows no time zone \"" + wrong + "\"; its clock is UTC");
    EXPECT_THAT(ClockEnvironmentOf(unknown), IsEmpty());
  }
}

TEST_F(SettingsFolder, WithoutAFileTheStageIsMeant) {
  EXPECT_EQ(ChooseProfile(folder()).name, "stage");
  EXPECT_EQ(ChooseProfile(folder() / "nowhere").name, "stage");
  EXPECT_TRUE(fs::is_empty(folder()));
}

TEST_F(SettingsFolder, AFaultyFileLeavesTheLastGoodOneInForce) {
  Write("profile = \"kiosk\"\n");
  EXPECT_EQ(ChooseProfile(folder()).name, "kiosk");
  Write("profile = \"kioks\"\n");
  for (int start = 0; start < 3; ++start) {
    const Profile chosen = ChooseProfile(folder());
    EXPECT_EQ(chosen.name, "kiosk");
    EXPECT_THAT(chosen.fault, HasSubstr("box.toml, line 1: there is no profile \"kioks\""));
  }
  Write("profile = \"bench\"\n");
  EXPECT_EQ(ChooseProfile(folder()).name, "bench");
  EXPECT_THAT(ChooseProfile(folder()).fault, IsEmpty());
}

TEST_F(SettingsFolder, AFaultInTheLinesLeavesTheLastGoodOnesInForce) {
  Write("[lines]\ngo = 7\n");
  ASSERT_THAT(ChooseProfile(folder()).fault, IsEmpty());
  Write("profile = \"kiosk\"\n[lines]\ngo = 77\n");
  EXPECT_EQ(ChooseProfile(folder()).wiring.lines[0], 7);
  EXPECT_EQ(ChooseProfile(folder()).name, "stage");
  EXPECT_THAT(ChooseProfile(folder()).fault, HasSubstr("line 3: expected a number"));
}

TEST_F(SettingsFolder, AFaultyFileAtTheFirstStartMeansTheStage) {
  Write(std::string(100, '\0'));
  EXPECT_EQ(ChooseProfile(folder()).name, "stage");
  EXPECT_THAT(ChooseProfile(folder()).fault, HasSubstr("the profile is stage"));
}

TEST_F(SettingsFolder, WhatIsNoFileIsNamedAndTheStageIsMeant) {
  fs::create_directories(folder() / "box.toml");
  EXPECT_EQ(ChooseProfile(folder()).name, "stage");
  EXPECT_THAT(ChooseProfile(folder()).fault, HasSubstr("box.toml: Is a directory; the profile is stage"));
  fs::remove(folder() / "box.toml");
  fs::create_symlink("/dev/zero", folder() / "box.toml");
  EXPECT_THAT(ChooseProfile(folder()).fault, HasSubstr("it is a device, not a file; the profile is stage"));
}

TEST_F(SettingsFolder, ADraftThatWasCutShortIsNotLookedAt) {
  Write("profile = \"kiosk\"\n");
  ChooseProfile(folder());
  std::ofstream(folder() / "box.last-good.toml.draft") << "profile = \"ben";
  Write("nonsense");
  EXPECT_EQ(ChooseProfile(folder()).name, "kiosk");
}

}  // namespace
}  // namespace kaori::boot
