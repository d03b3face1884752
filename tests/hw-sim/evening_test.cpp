// Evenings in the whole system: short ones, and the first ten minutes of the long one.
#include "hw-sim/evening/evening.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>

#include <fmt/format.h>

#include "appliance/core/show/pack.h"
#include "hw-sim/evening/log_check.h"

namespace kaori::sim {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

class AnEvening : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { studio_ = stage::Studio::Open(show::LoadPack(KAORI_PACK).value()).value(); }
  static void TearDownTestSuite() { studio_.reset(); }

  static RunningOrder Order(std::string_view text) {
    RunningOrderRead read = ReadRunningOrder(text, studio_->show());
    for (const Problem& problem : read.problems) ADD_FAILURE() << problem.line << ": " << problem.what;
    return std::move(read.order);
  }

  static Verdict Play(const RunningOrder& order, EveningOptions options = {}) {
    options.file = "order";
    options.folder = fs::temp_directory_path() / fmt::format("kaori-evening-test-{}", ::getpid());
    auto verdict = PlayEvening(order, options, *studio_);
    EXPECT_TRUE(verdict) << verdict.error().message();
    return verdict ? std::move(*verdict) : Verdict();
  }
  // Nobody moves but by the order's lines.
  static Verdict PlayLines(std::string_view text) { return Play(Order(text), {.improvised = false}); }

  static inline std::unique_ptr<stage::Studio> studio_;
};

TEST_F(AnEvening, IsAsItMustBeInItsFirstTenMinutes) {
  auto order = LoadRunningOrder(KAORI_PLAYS "/evening.play", studio_->show()).value();
  Shorten(order, 10min);
  const Verdict verdict = Play(order);
  EXPECT_THAT(verdict.wrong, IsEmpty());
  EXPECT_TRUE(IsGood(verdict));
  EXPECT_GE(verdict.cues, 11U);
  EXPECT_GE(verdict.faults, 5U);
  EXPECT_EQ(verdict.go_sent, 8U);
  EXPECT_EQ(verdict.go_refused, 1U) << "the slip of the foot";
  EXPECT_NEAR(static_cast<double>(verdict.frames), 601 * 30, 30);
  EXPECT_NEAR(static_cast<double>(verdict.pictures), 601 * 30 / 120.0, 2) << "each picture is compared";
}

TEST_F(AnEvening, FailsWhereACueIsNotCalledOrComesLate) {
  EXPECT_THAT(PlayLines("at 1s line go tap\nat 1s expect cue 1 within 0.1s\n").wrong, IsEmpty());
  const Verdict missed = PlayLines("at 1s expect cue 1 within 0.1s\n");
  EXPECT_FALSE(IsGood(missed));
  EXPECT_EQ(missed.missed_cues, 1U);
  EXPECT_THAT(missed.wrong, ElementsAre("order:1: cue 1 did not come within 0.10 s; no cue is on"));
  const Verdict late = PlayLines("at 1s expect cue 1 within 0.1s\nat 1.3s line go tap\n");
  EXPECT_EQ(late.missed_cues, 1U);
  const Verdict early = PlayLines("at 0.5s line go tap\nat 1s expect cue 1 within 0.1s\n");
  EXPECT_THAT(early.wrong, ElementsAre("order:2: cue 1 is on before it is called"));
}

TEST_F(AnEvening, FailsWhereAGoIsNeitherPlayedNorRefused) {
  const Verdict verdict = PlayLines("at 1s end input\nat 2s line go tap\nat 3s start input\n");
  EXPECT_FALSE(IsGood(verdict));
  EXPECT_EQ(verdict.missed_cues, 1U) << "the push was over before the program was back";
  EXPECT_THAT(verdict.wrong, ElementsAre("1 GOs were called, 0 played and 0 refused"));
}

TEST_F(AnEvening, FailsWhereAFaultIsNotAnswered) {
  const Verdict verdict = PlayLines(
      "at 1s fault \"the stick stays out\"\nat 1s unplug stick-left\nat 1s expect stick-left stale within "
      "0.5s\n"
      "at 2s expect stick-left live within 0.5s\n"
      "at 3s fault \"nobody looks\"\nat 3s unplug pointer\n");
  EXPECT_FALSE(IsGood(verdict));
  EXPECT_EQ(verdict.faults, 2U);
  EXPECT_EQ(verdict.unanswered_faults, 2U);
  EXPECT_THAT(verdict.wrong, ElementsAre("order:4: stick-left live did not come within 0.50 s",
                                         "order:1: the fault is not answered: the stick stays out",
                                         "order:5: the fault is not answered: nobody looks"));
}

TEST_F(AnEvening, FailsWhereSomethingIsNotKept) {
  EXPECT_THAT(
      PlayLines(
          "at 1s line go tap\nat 1s expect cue 1 within 0.1s\nat 2s line go tap\nat 1.5s keep cue 1 for 1s\n")
          .wrong,
      ElementsAre("order:4: cue 1 was not kept for 1.00 s; cue 2 is on"));
}

TEST_F(AnEvening, LosesThePartOfItsLogThatAFullDiskKeepsNothingOf) {
  const Verdict verdict = PlayLines(
      "at 40s fault \"full\"\nat 40s disk fill\nat 40s expect picture within 0.2s\nat 70s disk free\n"
      "at 70s expect log-grows within 40s\n");
  EXPECT_THAT(verdict.wrong, IsEmpty());
  EXPECT_EQ(verdict.log_parts_lost, 1U);
  EXPECT_TRUE(IsGood(verdict));
  EXPECT_LT(verdict.frames, 90 * 30U) << "half a minute is missing";
}

TEST_F(AnEvening, MissesThePartsOfItsLogWithWhichItBeginsAndEnds) {
  const Verdict first = PlayLines(
      "at 0.1s fault \"full\"\nat 0.1s disk fill\nat 0.1s expect picture within 0.2s\nat 31s disk free\n"
      "at 31s expect log-grows within 40s\n");
  EXPECT_EQ(first.log_parts_lost, 1U) << "the log begins with its second part";
  EXPECT_THAT(first.wrong, IsEmpty());
  const Verdict last = PlayLines(
      "at 40s fault \"full\"\nat 40s disk fill\nat 40s expect picture within 0.2s\nat 65s line go tap\n"
      "at 65s expect cue 1 within 0.1s\n");
  EXPECT_EQ(last.log_parts_lost, 2U) << "half a minute, and what came after it";
  EXPECT_FALSE(IsGood(last)) << "a disk that stays full is no fault that was answered";
}

TEST_F(AnEvening, ComparesNoPictureThatCannotBeRead) {
  const auto fresh = stage::Studio::Open(show::LoadPack(KAORI_PACK).value()).value();
  stage::SmallImage image;
  EXPECT_FALSE(SumOfPicture(*fresh, image)) << "nothing was drawn yet";
}

TEST_F(AnEvening, SaysWhatWasReachedWhereItIsStopped) {
  const auto order = Order(
      "at 1s line go tap\nat 1s expect cue 1 within 0.1s\nat 3s line go tap\nat 3s expect cue 3 within 0.1s\n"
      "at 3s fault \"later\"\nat 4s expect stick-left stale within 1s\n");
  const Verdict verdict = Play(
      order, {.improvised = false, .tell = [](const Verdict& so_far) { return so_far.minutes * 60 < 2; }});
  EXPECT_TRUE(verdict.stopped);
  EXPECT_THAT(verdict.wrong, IsEmpty());
  EXPECT_EQ(verdict.cues, 1U);
  EXPECT_EQ(verdict.faults, 0U);
}

}  // namespace
}  // namespace kaori::sim
