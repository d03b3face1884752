// Why the disk's other system is tried: what the stage says, what it shows, and how often it ended.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "appliance/programs/update/other_fault.h"
#include "tests/appliance/core/board_file.h"

namespace kaori::update {
namespace {

// Seconds since the machine started.
constexpr Time kNow = Time{} + std::chrono::seconds(200);

class OtherFault : public ::testing::Test {
 protected:
  OtherFault() { Restarted("0"); }
  // What the service manager says of the stage.
  void Restarted(const std::string& times) {
    std::ofstream(places_.systemctl) << "#!/bin/sh\n[ \"$3\" = kaori-stage.service ] && echo NRestarts="
                                     << times << "\n";
    ::chmod(places_.systemctl.c_str(), 0755);
  }
  // What it says of one of the operators' programs, which runs since so long, and the kernel of the disk.
  void Ends(const std::string& unit, const std::string& times, const std::string& kernel_says,
            Duration runs = std::chrono::seconds(1)) {
    std::ofstream(places_.systemctl)
        << "#!/bin/sh\n[ \"$3\" = " << unit << " ] && echo NRestarts=" << times
        << " && echo ActiveEnterTimestampMonotonic="
        << std::chrono::floor<std::chrono::microseconds>((kNow - runs).time_since_epoch()).count()
        << "\nexit 0\n";
    std::ofstream(places_.journalctl) << "#!/bin/sh\necho '" << kernel_says << "'\n";
    ::chmod(places_.journalctl.c_str(), 0755);
  }
  void Show(std::uint32_t frames) {
    board_.AcquireWriter<board::StageStatus>().value().Write({.frames = frames}, Time{},
                                                             board::SourceState::kLive);
  }

  board::BoardFile file_;
  board::Board board_ = file_.Open();
  FaultPlaces places_{.no_show = file_.folder() / "no-show",
                      .board = file_.path(),
                      .systemctl = (file_.folder() / "systemctl").string(),
                      .journalctl = (file_.folder() / "journalctl").string()};
};

TEST_F(OtherFault, IsAShowThatCannotBeReadWithItsReason) {
  Show(100);
  EXPECT_EQ(FaultOfSystem(places_, kNow), "");
  std::ofstream(places_.no_show) << "kaori.kaori: byte 12 is torn\nand more\n";
  EXPECT_EQ(FaultOfSystem(places_, kNow), "no show can be played: kaori.kaori: byte 12 is torn");
}

TEST_F(OtherFault, IsAStageThatEndsAgainAndAgainAndHasShownNothing) {
  Restarted("2");
  EXPECT_EQ(FaultOfSystem(places_, kNow), "the stage ends again and again, and has shown no face");
  Show(1);
  EXPECT_EQ(FaultOfSystem(places_, kNow), "") << "it has shown one in this start";
}

TEST_F(OtherFault, IsNoStageThatWaitsForAScreenOrIsSlow) {
  EXPECT_EQ(FaultOfSystem(places_, kNow), "");
  Restarted("1");
  EXPECT_EQ(FaultOfSystem(places_, kNow), "") << "once is not again and again";
}

TEST_F(OtherFault, IsNothingThatTheServiceManagerDoesNotSay) {
  Restarted("");
  EXPECT_EQ(FaultOfSystem(places_, kNow), "");
  std::filesystem::remove(places_.systemctl);
  EXPECT_EQ(FaultOfSystem(places_, kNow), "");
}

TEST_F(OtherFault, IsAProgramOfTheOperatorsThatEndsAgainAndAgainBesideASpoiltBlock) {
  Show(100);
  for (const char* unit : {"kaori-input.service", "kaori-lips.service"}) {
    Ends(unit, "2", "device-mapper: verity: 253:0: data block 12 is corrupted");
    EXPECT_EQ(FaultOfSystem(places_, kNow),
              std::string(unit) +
                  " ends again and again, and the disk does not hold what was written: "
                  "device-mapper: verity: 253:0: data block 12 is corrupted");
    Ends(unit, "1", "device-mapper: verity: 253:0: data block 12 is corrupted");
    EXPECT_EQ(FaultOfSystem(places_, kNow), "") << "once is not again and again";
    Ends(unit, "40", "usb 1-1: device descriptor read/64, error -71");
    EXPECT_EQ(FaultOfSystem(places_, kNow), "") << "a device of which no other system would do better";
  }
}

// As where kaori-lips ended by the root's show until the stage had found it spoilt, and plays the copy's sounds since.
TEST_F(OtherFault, IsNoProgramThatRunsOnByNow) {
  Show(100);
  const std::string spoilt = "device-mapper: verity: 253:0: data block 12 is corrupted";
  Ends("kaori-lips.service", "7", spoilt, std::chrono::seconds(9));
  EXPECT_NE(FaultOfSystem(places_, kNow), "");
  Ends("kaori-lips.service", "7", spoilt, std::chrono::seconds(10));
  EXPECT_EQ(FaultOfSystem(places_, kNow), "");
}

TEST_F(OtherFault, IsAStageThatCouldNotEvenMakeABoard) {
  Restarted("40");
  std::filesystem::remove(file_.path());
  EXPECT_NE(FaultOfSystem(places_, kNow), "");
}

}  // namespace
}  // namespace kaori::update
