// Why the last start ended, told from a note on the data partition and from the machine's watchdogs.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "appliance/programs/power/last_start.h"

namespace kaori::power {
namespace {

using ::testing::HasSubstr;

class LastStartTest : public ::testing::Test {
 protected:
  LastStartTest() { std::filesystem::create_directories(folder_ / "watchdogs" / "watchdog0"); }
  ~LastStartTest() override { std::filesystem::remove_all(folder_); }

  // The machine is switched on, and the program begins; bits are those of its watchdog.
  std::string SwitchOn(int watchdog_bits = 0) {
    Put("boot_id", fmt::format("0000-start-{}", ++starts_));
    Put("watchdogs/watchdog0/bootstatus", fmt::format("{}", watchdog_bits));
    return BeginProgram();
  }
  std::string BeginProgram() {
    const auto said = Program().Begin();
    EXPECT_TRUE(said) << said.error().message();
    return said.value_or("");
  }
  LastStart Program() const { return {folder_ / "start", {folder_ / "boot_id", folder_ / "watchdogs"}}; }
  void Put(const std::string& file, const std::string& line) const {
    std::ofstream(folder_ / file) << line << '\n';
  }

  const std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / fmt::format("kaori-start-{}", ::getpid());
  int starts_ = 0;
};

TEST_F(LastStartTest, BeforeTheFirstOneIsUnknown) {
  EXPECT_EQ(SwitchOn(), "nothing is known of a start before this one");
}

TEST_F(LastStartTest, EndedByACleanStop) {
  SwitchOn();
  EXPECT_TRUE(Program().NoteStop());
  EXPECT_EQ(SwitchOn(), "the last start ended by a clean stop");
}

TEST_F(LastStartTest, EndedWithoutAWordWhereThePowerWasCut) {
  SwitchOn();
  EXPECT_THAT(SwitchOn(), HasSubstr("power cut"));
  EXPECT_TRUE(Program().NoteStop());
  EXPECT_THAT(SwitchOn(), HasSubstr("clean stop"));
  EXPECT_THAT(SwitchOn(), HasSubstr("power cut")) << "a stop counts for its own start alone";
}

TEST_F(LastStartTest, EndedByTheWatchdogThatSaysSo) {
  SwitchOn();
  EXPECT_THAT(SwitchOn(32), HasSubstr("watchdog"));  // WDIOF_CARDRESET.
  EXPECT_THAT(SwitchOn(1), HasSubstr("power cut"));  // WDIOF_OVERHEAT.
}

// Some watchdogs keep their bit over a clean restart.
TEST_F(LastStartTest, EndedByAStopWhateverAWatchdogSaysOfOneBefore) {
  SwitchOn();
  EXPECT_TRUE(Program().NoteStop());
  EXPECT_THAT(SwitchOn(32), HasSubstr("clean stop"));
}

TEST_F(LastStartTest, IsToldOnceAStart) {
  SwitchOn();
  EXPECT_EQ(BeginProgram(), "") << "the program was started anew, the machine was not";
}

TEST_F(LastStartTest, WithADamagedNoteIsUnknown) {
  SwitchOn();
  Put("start", "rubbish");
  EXPECT_THAT(SwitchOn(), HasSubstr("nothing is known"));
}

TEST_F(LastStartTest, ThatCannotBeNotedIsAnErrorThatNamesTheFile) {
  Put("boot_id", "0000");
  LastStart program(folder_ / "none" / "start", {folder_ / "boot_id", folder_ / "watchdogs"});
  const auto said = program.Begin();
  ASSERT_FALSE(said);
  EXPECT_THAT(said.error().message(), HasSubstr((folder_ / "none" / "start").string()));
}

}  // namespace
}  // namespace kaori::power
