// When the list of shows is open, what it offers without a stick, and what becomes of it.
#include "tests/appliance/programs/shows_service_fixture.h"

namespace kaori::shows {
namespace {

using namespace std::chrono_literals;  // NOLINT: tests speak in seconds.
namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

class ServiceMenuTest : public ServiceTest {
 protected:
  // Two shows were installed, the second one plays, and the stick is out.
  void Install() {
    PutOnStick("evening", &company_);
    PutOnStick("matinee", &company_);
    plugged_ = true;
    Play(1s);
    Strike(board::key::k1);
    Play(2s);
    first_ = store::ReadChoice(folder_ / "shows").current;
    Strike(board::key::k1 + 1);
    Play(2s);
    plugged_ = false;
    Play(1s);
  }

  std::string first_;
};

TEST_F(ServiceMenuTest, IsOpenOnTheBoardFromTheStickOnUntilNobodyPressesAnything) {
  PutOnStick("evening", &company_);
  Play(1s);
  EXPECT_FALSE(IsOpen());
  EXPECT_EQ(board_.Read<board::ShowsMenu>().source, board::SourceState::kLive);
  plugged_ = true;
  Play(1s);
  EXPECT_TRUE(IsOpen());
  const std::string said = Play(2min);
  EXPECT_FALSE(IsOpen());
  EXPECT_THAT(said, HasSubstr("Page Up opens the list of shows"));
  EXPECT_THAT(said, HasSubstr(Words(Message::kShut, Language::kJapanese)));
  EXPECT_THAT(said, Not(HasSubstr("1. evening")));
  Strike(board::key::kEnter);
  Play(1s);
  EXPECT_EQ(store::ReadChoice(folder_ / "shows"), store::Choice()) << "that was the show's";
  Strike(board::key::kPageUp);
  EXPECT_THAT(Play(1s), HasSubstr("> 1. evening"));
  EXPECT_TRUE(IsOpen());
}

TEST_F(ServiceMenuTest, IsShutWithTheStick) {
  PutOnStick("evening", &company_);
  plugged_ = true;
  Play(1s);
  plugged_ = false;
  Play(1s);
  EXPECT_FALSE(IsOpen());
}

TEST_F(ServiceMenuTest, OffersTheWaysBackWithoutAStickOnceItIsOpened) {
  EXPECT_EQ(Play(1s), "") << "there is nothing to go back to";
  Install();
  Strike(board::key::k1);
  const std::string said = Play(1s);
  EXPECT_THAT(said, Not(HasSubstr("back to")));
  EXPECT_NE(store::ReadChoice(folder_ / "shows").current, first_) << "a key is the show's";
  Strike(board::key::kPageUp);
  EXPECT_THAT(Play(1s), HasSubstr("> 1. back to the show before\n  2. back to the box's own show\n"));
  Strike(board::key::k1);
  EXPECT_THAT(Play(1s), HasSubstr("back to the show before: it is on the box"));
  EXPECT_EQ(store::ReadChoice(folder_ / "shows").current, first_);
  EXPECT_FALSE(IsOpen()) << "the next GO is the show's";
}

TEST_F(ServiceMenuTest, SaysHowItIsOpenedWhenTheKeyIsTurnedAndThereIsAShowToGoBackTo) {
  Install();
  fs::remove(folder_ / "report" / "lines");
  InstallService again{{folder_ / "root-keys", folder_ / "settings/keys", folder_ / "report"},
                       *shows_,
                       board_,
                       []() -> Result<std::optional<fs::path>> { return std::optional<fs::path>(); },
                       [](const fs::path&) -> Result<void> { return {}; }};
  again.Step(now_);
  EXPECT_THAT(ReadFile(folder_ / "report" / "lines").value_or(""),
              ::testing::StartsWith("Page Up opens the list of shows\n"));
}

TEST_F(ServiceMenuTest, IsShutWhileSomebodyChecksLinesOrTeaches) {
  PutOnStick("evening", &company_);
  plugged_ = true;
  Play(1s);
  auto check = board_.AcquireWriter<board::LineCheck>().value();
  check.Write({.phase = board::LineCheckPhase::kRunning}, now_, board::SourceState::kLive);
  Play(100ms);
  EXPECT_FALSE(IsOpen());
  Strike(board::key::kEnter);
  Play(1s);
  EXPECT_EQ(store::ReadChoice(folder_ / "shows"), store::Choice()) << "Enter says that all lamps were lit";
}

// What was shown last must not be taken by a foot that only wants to see the new show.
TEST_F(ServiceMenuTest, IsShutWhereTheStickWentWhileItsShowWasTried) {
  PutOnStick("evening", &company_);
  plugged_ = true;
  Play(1s);
  Strike(board::key::k1);
  service_.Step(now_);
  plugged_ = false;
  EXPECT_THAT(Play(2s), HasSubstr("evening: it is on the box"));
  EXPECT_FALSE(IsOpen());
}

TEST_F(ServiceMenuTest, LeavesTheBoardWithItsProgram) {
  {
    auto other = board::Board::Create((folder_ / "other").string()).value();
    const InstallService gone{{},
                              *shows_,
                              other,
                              []() -> Result<std::optional<fs::path>> { return std::optional<fs::path>(); },
                              [](const fs::path&) -> Result<void> { return {}; }};
  }
  const auto other = board::Board::Open((folder_ / "other").string()).value();
  EXPECT_EQ(other.Read<board::ShowsMenu>().source, board::SourceState::kAbsent);
}

TEST_F(ServiceMenuTest, KeepsTheStageFollowingWhereTheDiskHasLostBothFilesOfTheChoice) {
  PutOnStick("evening", &company_);
  NoteThatTold(7);
  plugged_ = true;
  Play(1s);
  Strike(board::key::k1);
  Play(2s);
  EXPECT_EQ(ReadFile(folder_ / "report" / "chosen").value_or(""), "8\n") << "newer than what the stage plays";
  EXPECT_EQ(store::ReadChoice(folder_ / "shows").generation, 8U);
  for (const char* file : store::kChoiceFiles) fs::remove(folder_ / "shows" / file);
  Strike(board::key::k1);
  Play(2s);
  EXPECT_EQ(ReadFile(folder_ / "report" / "chosen").value_or(""), "9\n");
}

TEST_F(ServiceMenuTest, WritesASupportFileOntoAStickEvenAnEmptyOne) {
  plugged_ = true;
  const std::string said = Play(1s);
  EXPECT_THAT(said, HasSubstr("there is no show on the stick"));
  EXPECT_THAT(said, HasSubstr("> 1. support file for a technician"));
  Strike(board::key::kEnter);
  service_.Step(now_);
  EXPECT_THAT(ReadFile(folder_ / "report" / "lines").value_or(""),
              HasSubstr("is being written; leave the stick"));
  const std::string written = Play(1s);
  EXPECT_THAT(written, HasSubstr("kaori-1a2b3c4d-20261123-221005.txt: it is on the stick"));
  EXPECT_THAT(written, HasSubstr(Words(Message::kWritten, Language::kJapanese)));
}

TEST_F(ServiceMenuTest, ASupportFileThatCouldNotBeWrittenIsOneLineAndWhatPlaysGoesOn) {
  PutOnStick("evening", &company_);
  plugged_ = true;
  support_ = Fail(std::errc::no_space_on_device, "write kaori.txt");
  Play(1s);
  Strike(board::key::k1 + 1);
  EXPECT_THAT(Play(1s), ::testing::StartsWith("! support file: there is no room on the stick"));
  support_ = Fail(std::errc::io_error, "write kaori.txt");
  Strike(board::key::k1 + 1);
  EXPECT_THAT(Play(1s),
              ::testing::StartsWith("! support file: the stick was pulled out before it was written"));
  EXPECT_EQ(store::ReadChoice(folder_ / "shows"), store::Choice());
  Strike(board::key::k1);
  EXPECT_THAT(Play(1s), HasSubstr("evening: it is on the box"));
}

TEST_F(ServiceMenuTest, OffersNoSupportFileWithoutAStick) {
  Install();
  Strike(board::key::kPageUp);
  EXPECT_THAT(Play(1s), Not(HasSubstr("support file")));
}

// A folder in place of the stick that is gone before it is listed.
TEST_F(ServiceMenuTest, ThatAStickWasPulledWhileItWasListedIsForgottenWhenItIsOut) {
  fs::remove_all(folder_ / "stick");
  plugged_ = true;
  EXPECT_THAT(Play(1s), HasSubstr("the stick was pulled out or cannot be read"));
  plugged_ = false;
  EXPECT_THAT(Play(1s), HasSubstr("plug a stick in"));
}

// That one is about a show, and is to be read.
TEST_F(ServiceMenuTest, ThatAShowWasNotInstalledStaysOnTheScreenWhenTheStickIsOut) {
  PutOnStick("evening", &theatre_);
  plugged_ = true;
  Play(1s);
  Strike(board::key::k1);
  Play(1s);
  plugged_ = false;
  EXPECT_THAT(Play(1s), HasSubstr("evening: this box does not trust its signer"));
}

}  // namespace
}  // namespace kaori::shows
