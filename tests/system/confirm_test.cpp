// A version that is tried and that nobody can judge gives way: whoever looks at it hangs, is ended, and is started again.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "appliance/core/update/pending.h"
#include "drivers/base/read_file.h"
#include "tests/drivers/fat_fixture.h"
#include "tests/system/program_runner.h"

namespace kaori::test {
namespace {

namespace fs = std::filesystem;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;

// A box whose slot B is being tried, and a service manager that notes what it is asked for.
class TriedVersion : public ::testing::Test {
 protected:
  TriedVersion() {
    for (const char* folder : {"disk", "notes", "variables"}) fs::create_directory(programs_.File(folder));
    Write("version", "version 12\nleast 10\n");
    Write("slot", "B");
    Write("notes/pending", update::Format(update::Pending{12, ports::Slot::kB, 1}));
    std::vector<std::uint8_t> boot(tests::FatFixture::kBytes);
    const tests::FatFixture fat(boot);
    Write("disk/boot", {boot.begin(), boot.end()});
    Write("systemctl", "#!/bin/sh\necho \"$@\" >> " + programs_.File("asked") + "\n[ ! -e " +
                           programs_.File("refuses") + " ]\n");
    fs::permissions(programs_.File("systemctl"), fs::perms::owner_all);
  }
  void Write(const std::string& name, const std::string& text) {
    std::ofstream(programs_.File(name), std::ios::binary) << text;
  }
  std::string Read(const std::string& name) const { return ReadFile(programs_.File(name)).value_or(""); }
  std::vector<std::string> Words() const {
    const auto file = [this](const char* name) { return programs_.File(name); };
    return {"--confirm",      "--notes",     file("notes"), "--version",   file("version"),   "--slot",
            file("slot"),     "--disk",      file("disk"),  "--variables", file("variables"), "--argument",
            file("argument"), "--said",      file(""),      "--picture",   file("none"),      "--still",
            file("none"),     "--last-face", file("none"),  "--systemctl", file("systemctl")};
  }
  // Until it looks.
  void StartLook() {
    programs_.Start("kaori-update", Words());
    ASSERT_TRUE(Await([&] { return !Read("looking").empty() && !Read("notes/last-try").empty(); }))
        << programs_.LogOf("kaori-update");
  }
  bool AsksForARestart() const { return Read("asked").find("reboot") != std::string::npos; }

  ProgramRunner programs_;
};

TEST_F(TriedVersion, GivesWayWhereTheFirstLookHung) {
  StartLook();
  EXPECT_THAT(Read("notes/last-try"), HasSubstr("it started"));
  programs_.Kill("kaori-update");
  EXPECT_FALSE(AsksForARestart());
  EXPECT_EQ(programs_.RunToEnd("kaori-update", Words()), 0);
  EXPECT_TRUE(AsksForARestart()) << programs_.LogOf("kaori-update");
  EXPECT_THAT(Read("notes/last-try"), StartsWith("what looks at a new version hung"));
}

TEST_F(TriedVersion, GivesWayWithoutAWordWhereThatHungTooAndTouchesNoDisk) {
  Write("looking", "2");
  fs::remove_all(programs_.File("notes"));
  fs::remove_all(programs_.File("disk"));
  EXPECT_EQ(programs_.RunToEnd("kaori-update", Words()), 0);
  EXPECT_EQ(Read("asked"), "reboot --force\n");
}

TEST_F(TriedVersion, WhoseRestartIsRefusedAsksAgainAndThenForOneAtOnce) {
  StartLook();
  programs_.Kill("kaori-update");
  Write("refuses", "");
  EXPECT_NE(programs_.RunToEnd("kaori-update", Words()), 0) << "so that the service manager starts it again";
  EXPECT_NE(programs_.RunToEnd("kaori-update", Words()), 0);
  EXPECT_THAT(Read("asked"), EndsWith("reboot\nreboot --force\n"));
}

TEST_F(TriedVersion, WhoseLoaderCannotBeReadComesToAnEndAllTheSame) {
  fs::remove_all(programs_.File("disk"));
  EXPECT_NE(programs_.RunToEnd("kaori-update", Words()), 0);
  EXPECT_NE(programs_.RunToEnd("kaori-update", Words()), 0);
  EXPECT_FALSE(AsksForARestart());
  EXPECT_EQ(programs_.RunToEnd("kaori-update", Words()), 0);
  EXPECT_EQ(Read("asked"), "reboot --force\n");
}

TEST_F(TriedVersion, OfWhichTheRootDoesNotSayItsNumberIsLookedAt) {
  fs::remove(programs_.File("version"));
  StartLook();
  EXPECT_THAT(Read("notes/last-try"), HasSubstr("it started"));
}

TEST_F(TriedVersion, ThatIsNoTrialIsNotRestartedWhereTheLoaderCannotBeRead) {
  Write("slot", "A");
  fs::remove_all(programs_.File("disk"));
  for (int start = 0; start < 4; ++start) EXPECT_NE(programs_.RunToEnd("kaori-update", Words()), 0);
  EXPECT_FALSE(AsksForARestart());
}

TEST_F(TriedVersion, IsSettledOnlyWithItsVerdict) {
  StartLook();
  EXPECT_FALSE(fs::exists(programs_.File("settled"))) << "kaori-trial.timer may still have to end it";
  programs_.Kill("kaori-update");
  fs::remove(programs_.File("looking"));
  Write("slot", "A");
  EXPECT_EQ(programs_.RunToEnd("kaori-update", Words()), 0);
  EXPECT_TRUE(fs::exists(programs_.File("settled"))) << "this start is no trial";
}

TEST_F(TriedVersion, ThatIsLookedAtForTheFirstTimeDoesNotGiveWayAtOnce) {
  StartLook();
  EXPECT_FALSE(AsksForARestart());
  EXPECT_TRUE(programs_.Runs("kaori-update"));
}

TEST_F(TriedVersion, ThatIsNoTrialIsNeverRestartedHoweverOftenItsProgramEnds) {
  Write("slot", "A");
  for (int start = 0; start < 4; ++start) EXPECT_EQ(programs_.RunToEnd("kaori-update", Words()), 0);
  EXPECT_FALSE(AsksForARestart());
}

}  // namespace
}  // namespace kaori::test
