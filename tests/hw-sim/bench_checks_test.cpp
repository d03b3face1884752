// What makes a check of the bench fail beside what it looks for itself: programs that ended, and controls that show nothing.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "hw-sim/hil/box_programs.h"
#include "hw-sim/hil/check.h"
#include "hw-sim/hil/check_runner.h"

namespace kaori::hil {
namespace {

using ::testing::HasSubstr;

// As systemctl(1) shows two units, in an order of its own.
constexpr const char* kTwoUnits =
    "MainPID=217\nNRestarts=0\nId=kaori-stage.service\n\nMainPID=0\nNRestarts=12\nId=kaori-lips.service\n";

TEST(BoxPrograms, AreReadFromWhatTheServiceManagerShows) {
  const std::vector<BoxProgram> two{{"kaori-stage", 217, 0}, {"kaori-lips", 0, 12}};
  EXPECT_EQ(ReadPrograms(kTwoUnits), two);
  EXPECT_TRUE(ReadPrograms("").empty());
  EXPECT_TRUE(ReadPrograms("Unit kaori-stage.service could not be found.\n").empty());
}

// Says the same to every question.
class SayingAgent final : public AgentProtocol {
 public:
  explicit SayingAgent(Result<std::string> answer) : answer_(std::move(answer)) {}
  Result<std::string> Ask(const std::string& question, Duration) override {
    asked_ = question;
    return answer_;
  }
  const std::string& asked() const { return asked_; }

 private:
  Result<std::string> answer_;
  std::string asked_;
};

TEST(BoxPrograms, AreAskedForAllTogetherAndNoneMayBeMissing) {
  SayingAgent whole(std::string(kTwoUnits) + "\n" + kTwoUnits), half{kTwoUnits},
      dead(Fail(std::errc::timed_out, "ask"));
  EXPECT_EQ(LookAtPrograms(whole)->size(), 4U);
  EXPECT_THAT(whole.asked(), HasSubstr("kaori-stage.service kaori-fdkeeper.service kaori-input.service"));
  EXPECT_FALSE(LookAtPrograms(half));
  EXPECT_FALSE(LookAtPrograms(dead));
}

TEST(BoxPrograms, HaveEndedWhereTheirProcessIsAnother) {
  const std::vector<BoxProgram> before{{"kaori-stage", 217, 0}, {"kaori-input", 230, 3}};
  EXPECT_EQ(EndedSince(before, before), "") << "what was before counts for nothing";
  EXPECT_EQ(EndedSince(before, {{"kaori-stage", 217, 0}, {"kaori-input", 501, 4}}),
            "kaori-input has ended meanwhile and was started again");
  EXPECT_EQ(EndedSince(before, {{"kaori-stage", 0, 0}, {"kaori-input", 230, 3}}),
            "kaori-stage has ended meanwhile");
  EXPECT_EQ(EndedSince(before, {{"kaori-stage", 217, 0}}), "kaori-input has ended meanwhile");
}

TEST(BoxPrograms, ThatHadNoProcessBeforeHaveOnlyBeenStartedUnlessTheyAreCounted) {
  EXPECT_EQ(EndedSince({{"kaori-fdkeeper", 0, 0}}, {{"kaori-fdkeeper", 240, 0}}), "");
  EXPECT_EQ(EndedSince({{"kaori-lips", 0, 7}}, {{"kaori-lips", 240, 8}}),
            "kaori-lips has ended meanwhile and was started again");
}

TEST(WantFoundWrong, PassesOnlyWhereSomethingWasFoundWrong) {
  EXPECT_TRUE(WantFoundWrong(FailInput("the picture is black"), "black passes"));
  const auto passed = WantFoundWrong({}, "black passes");
  ASSERT_FALSE(passed);
  EXPECT_EQ(passed.error().message(), "black passes");
  const auto dead = WantFoundWrong(Fail(std::errc::timed_out, "ask hello"), "black passes");
  ASSERT_FALSE(dead) << "a machine that does not answer shows nothing";
  EXPECT_THAT(dead.error().message(), HasSubstr("ask hello"));
}

// Checks that would switch a machine on by themselves, and do not.
class Runner : public ::testing::Test {
 protected:
  Runner() {
    std::string pattern = (std::filesystem::temp_directory_path() / "kaori-runner-XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
    target_ = Target::Open({.image = folder_, .sticks = folder_, .folder = folder_}, clock_).value();
  }
  ~Runner() override {
    target_.reset();
    std::filesystem::remove_all(folder_);
  }
  Finding Run(std::function<Result<void>(Scene&)> control) {
    const auto passes = [](Scene&) { return Result<void>{}; };
    return Run({.name = "check",
                .sentence = "A check passes",
                .run = passes,
                .control = std::move(control),
                .powers = true});
  }
  Finding Run(const Check& check, int round = 0) {
    CheckRunner runner({.report = folder_, .play = {}, .controls = true}, *target_);
    return runner.Run(check, round).finding;
  }

  SteadyClock clock_;
  std::string folder_;
  std::unique_ptr<Target> target_;
};

TEST_F(Runner, PassesACheckWhoseControlFindsSomethingWrong) {
  EXPECT_EQ(Run([](Scene&) { return Result<void>{}; }).verdict, Verdict::kPassed);
}

TEST_F(Runner, SkipsACheckWhoseStickIsNotThereAndNamesIt) {
  const Check check{.name = "check",
                    .sentence = "A stick is read",
                    .run = [](Scene&) { return FailInput("there is no stick to plug in"); },
                    .powers = true,
                    .stick = "evening"};
  const Finding skipped = Run(check);
  EXPECT_EQ(skipped.verdict, Verdict::kSkipped);
  EXPECT_THAT(skipped.said, HasSubstr("/evening.stick (--sticks names the folder)"));
  std::ofstream(folder_ + "/evening.stick") << "FAT";
  EXPECT_EQ(Run(check).verdict, Verdict::kFailed) << "with a stick it is tried";
}

TEST_F(Runner, FailsACheckWhoseControlCouldNotBeTried) {
  const Finding finding = Run([](Scene& scene) { return scene.Skip("there is no stick"); });
  EXPECT_EQ(finding.verdict, Verdict::kFailed);
  EXPECT_EQ(finding.said, "the negative control: it could not be tried, since there is no stick");
}

// No machine runs here: as if it had ended in the control.
TEST_F(Runner, FailsACheckWhoseControlFailsSinceTheMachineHasEnded) {
  int runs = 0;
  const auto passes_once = [&](Scene&) {
    return ++runs == 1 ? Result<void>{} : FailInput("no dial has turned");
  };
  const Finding finding = Run({.name = "check",
                               .sentence = "A dial turns",
                               .run = passes_once,
                               .fails_without = "dial-box",
                               .powers = true});
  EXPECT_EQ(runs, 2);
  EXPECT_EQ(finding.verdict, Verdict::kFailed);
  EXPECT_THAT(finding.said,
              HasSubstr("the negative control: it could not be tried: the box answers no more"));
}

// A round that failed in a run of hours can be looked into alone.
TEST_F(Runner, GivesEachRoundItsOwnChanceAndTheFirstOneItsControl) {
  std::vector<std::mt19937::result_type> drawn;
  int controls = 0;
  const auto draws = [&](Scene& scene) {
    drawn.push_back(scene.chance());
    return Result<void>{};
  };
  const auto control = [&](Scene&) {
    ++controls;
    return Result<void>{};
  };
  const Check check{
      .name = "cycles", .sentence = "It starts", .run = draws, .control = control, .powers = true};
  for (const int round : {0, 1, 0}) EXPECT_EQ(Run(check, round).verdict, Verdict::kPassed);
  ASSERT_EQ(drawn.size(), 3U);
  EXPECT_NE(drawn[0], drawn[1]);
  EXPECT_EQ(drawn[0], drawn[2]);
  EXPECT_EQ(controls, 2);
  Check other = check;
  other.name = "cuts";
  EXPECT_EQ(Run(other).verdict, Verdict::kPassed);
  EXPECT_NE(drawn[3], drawn[0]);
}

}  // namespace
}  // namespace kaori::hil
