// Checks that a release repeats: their rounds add up, and a run that was cut goes on with the next one.
#include "hw-sim/hil/rounds.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "drivers/base/read_file.h"
#include "hw-sim/hil/kept_report.h"

namespace kaori::hil {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class Rounds : public ::testing::Test {
 protected:
  Rounds() : folder_(::testing::TempDir() + "rounds-" + std::to_string(::getpid())) {
    std::filesystem::create_directories(folder_);
  }
  ~Rounds() override { std::filesystem::remove_all(folder_); }

  // A check of one round, and one of as many as are wanted. `fails`: the round of the second one that does not pass.
  Report RunAll(int effort, bool go_on, int fails = -1) {
    const std::vector<Check> checks{
        {.name = "face", .sentence = "It shows", .run = {}},
        {.name = "cycles", .sentence = "It starts", .run = {}, .most_rounds = 1000}};
    ran_.clear();
    Report report;
    const auto run = [&](const Check& check, int round) {
      ran_.push_back(check.name + " " + std::to_string(round));
      ReportedCheck found{check.name, check.sentence, {.said = "seen", .took_s = 2, .rounds = 1}};
      found.finding.counts["cycles"] = 20;
      found.finding.figures["start_s"] = 10 - round;
      if (round == 0) found.finding.control = "; the control was found wrong";
      if (check.name == "cycles" && round == fails) {
        found.finding.verdict = Verdict::kFailed;
        found.finding.said = "no face";
      }
      return found;
    };
    const auto tell = [&](const ReportedCheck& check, int wanted, bool before) {
      told_ = check.name + " " + std::to_string(check.finding.rounds) + "/" + std::to_string(wanted) +
              (before ? " before" : "");
    };
    EXPECT_TRUE(RunRounds(checks,
                          {.report = folder_,
                           .figures = folder_ + "/figures.json",
                           .trial = "image ab12",
                           .effort = effort,
                           .go_on = go_on},
                          run, tell, report));
    return report;
  }
  std::string folder_;
  std::vector<std::string> ran_;
  std::string told_;
};

TEST_F(Rounds, AreMadeOfTheChecksThatMayHaveSeveral) {
  const Report report = RunAll(3, false);
  EXPECT_THAT(ran_, ElementsAre("face 0", "cycles 0", "cycles 1", "cycles 2"));
  ASSERT_EQ(report.checks.size(), 2U);
  const Finding& cycles = report.checks[1].finding;
  EXPECT_EQ(cycles.rounds, 3);
  EXPECT_EQ(cycles.counts.at("cycles"), 60) << "counts add up";
  EXPECT_EQ(cycles.figures.at("start_s"), 10) << "the greatest";
  EXPECT_EQ(cycles.took_s, 6);
  EXPECT_EQ(cycles.Said(), "3 rounds, and of the last one: seen; the control was found wrong");
  EXPECT_EQ(report.checks[0].finding.Said(), "seen; the control was found wrong");
  EXPECT_EQ(told_, "cycles 3/3");
  EXPECT_THAT(ReadFile(folder_ + "/figures.json").value(), HasSubstr("\"cycles\": 60"));
}

TEST_F(Rounds, KeepThePicturesThatShowDifferentThings) {
  ReportedCheck before{"bad", "It gives way", {}}, round = before;
  before.finding.pictures = {{"bad-0.png", "After a panic"}, {"bad-1.png", "A face"}};
  before.finding.texts = {{"a panic", "no root"}};
  round.finding.pictures = {{"bad-1-0.png", "After a hang"}, {"bad-1-1.png", "A face"}};
  round.finding.texts = {{"a hang", "no frames"}};
  const Finding found = WithRound(before, round).finding;
  ASSERT_EQ(found.pictures.size(), 3U);
  EXPECT_EQ(found.pictures[1].file, "bad-1-1.png");
  EXPECT_EQ(found.pictures[2].file, "bad-0.png");
  EXPECT_EQ(found.texts.size(), 2U);
}

TEST_F(Rounds, AreNoFewerThanTheCheckHas) {
  const std::vector<Check> checks{
      {.name = "bad", .sentence = "", .run = {}, .least_rounds = 3, .most_rounds = 3}};
  for (const int effort : {1, 25}) {
    std::vector<int> rounds;
    const auto run = [&](const Check&, int round) {
      rounds.push_back(round);
      return ReportedCheck{"bad", "", {.rounds = 1}};
    };
    Report report;
    EXPECT_TRUE(RunRounds(
        checks, {.report = folder_, .figures = {}, .trial = "image", .effort = effort}, run,
        [](const ReportedCheck&, int, bool) {}, report));
    EXPECT_THAT(rounds, ElementsAre(0, 1, 2));
  }
}

TEST_F(Rounds, GoOnWithTheNextOne) {
  RunAll(2, false);
  const Report report = RunAll(4, true);
  EXPECT_THAT(ran_, ElementsAre("cycles 2", "cycles 3"));
  EXPECT_EQ(report.checks[1].finding.counts.at("cycles"), 80);
  RunAll(4, true);
  EXPECT_TRUE(ran_.empty());
  EXPECT_EQ(told_, "cycles 4/4 before");
  RunAll(1, false);
  EXPECT_THAT(ran_, ElementsAre("face 0", "cycles 0")) << "who does not go on begins anew";
}

TEST_F(Rounds, EndWithTheFirstThatFailsAndThoseBeforeItNeedNotBeMadeAgain) {
  const Report report = RunAll(5, false, 2);
  EXPECT_THAT(ran_, ElementsAre("face 0", "cycles 0", "cycles 1", "cycles 2"));
  EXPECT_EQ(report.count(Verdict::kFailed), 1);
  EXPECT_EQ(report.checks[1].finding.Said(), "in round 3: no face");
  EXPECT_THAT(ReadFile(folder_ + "/figures.json").value(), Not(HasSubstr("cycles\": 60")));
  RunAll(5, true);
  EXPECT_THAT(ran_, ElementsAre("cycles 2", "cycles 3", "cycles 4"));
}

}  // namespace
}  // namespace kaori::hil
