// The choice among a box's shows, and how a show that ends the stage gives way.
#include <gmock/gmock.h>

#include "appliance/core/store/play_log.h"

namespace kaori::store {
namespace {

using namespace std::chrono_literals;  // NOLINT: tests speak in seconds.
using ::testing::ElementsAre;
using ::testing::IsEmpty;

const std::string kA(64, 'a'), kB(64, 'b');
const std::string kRoot(kRootShow);

TEST(Choice, ComesBackFromItsText) {
  const Choice choice{7, kA, kRoot};
  EXPECT_EQ(ParseChoice(Format(choice)), choice);
}

TEST(Choice, ThatIsTornOrForgedIsNotBelieved) {
  const std::string text = Format(Choice{7, kA, kB});
  for (std::size_t length = 0; length < text.size(); ++length)
    EXPECT_FALSE(ParseChoice(text.substr(0, length))) << length;
  for (std::size_t at = 0; at < text.size(); ++at) {
    std::string bad = text;
    bad[at] ^= 1;
    EXPECT_FALSE(ParseChoice(bad)) << at;
  }
  EXPECT_FALSE(ParseChoice(Format(Choice{7, "../../etc/passwd", kB}))) << "only ids become parts of a path";
}

TEST(Choice, OfTheHigherGenerationCountsAndAnOlderOneWhereThatIsTorn) {
  const std::string older = Format(Choice{3, kA, kRoot}), newer = Format(Choice{4, kB, kA});
  EXPECT_EQ(Newer(older, newer).current, kB);
  EXPECT_EQ(Newer(newer, older).current, kB);
  EXPECT_EQ(Newer(older, newer.substr(0, 20)).current, kA);
  EXPECT_EQ(Newer("", ""), Choice());
}

// What a stage was told of, and the disk has lost, is passed too: else the stage would wait for ever.
TEST(Choice, GetsAGenerationAboveAllThatWasToldAndNeverTheNewerFile) {
  EXPECT_EQ(NextGeneration({}, 0), 1U);
  EXPECT_EQ(NextGeneration({.generation = 4}, 4), 5U);
  EXPECT_EQ(NextGeneration({}, 7), 8U);
  EXPECT_EQ(NextGeneration({.generation = 5}, 6), 8U) << "7 would be written over 5";
  EXPECT_EQ(NextGeneration({.generation = 5}, 2), 6U);
}

TEST(Choice, IsFollowedByWhatPlayedBeforeAndByTheRootsShow) {
  EXPECT_THAT(InOrder({2, kA, kB}), ElementsAre(kA, kB, kRoot));
  EXPECT_THAT(InOrder({1, kA, kRoot}), ElementsAre(kA, kRoot));
  EXPECT_THAT(InOrder({}), ElementsAre(kRoot));
  EXPECT_EQ(PackOf(kA, "/shows", "/root.kaori"), "/shows/" + kA + ".kaori");
  EXPECT_EQ(PackOf(kRoot, "/shows", "/root.kaori"), "/root.kaori");
}

class PlayLogTest : public ::testing::Test {
 protected:
  // A stage starts, plays the first show that is left, and ends after `plays`, not of its own will.
  std::string PlayAndCrash(Duration plays) {
    log_ = Started(log_, choice_, now_);
    log_.playing = log_.last = ToTry(log_, choice_).front();
    log_.settled = plays >= kSettlesAfter;
    now_ += plays;
    return log_.playing;
  }

  Choice choice_{5, kA, kB};
  PlayLog log_;
  Time now_ = Time{} + 1000s;
};

TEST_F(PlayLogTest, AShowThatEndsTheStageThreeTimesInAMinuteGivesWayToTheOneBeforeAndThenToTheRoots) {
  for (int i = 0; i < 3; ++i) EXPECT_EQ(PlayAndCrash(2s), kA) << i;
  for (int i = 0; i < 3; ++i) EXPECT_EQ(PlayAndCrash(2s), kB) << i;
  for (int i = 0; i < 5; ++i) EXPECT_EQ(PlayAndCrash(2s), kRoot) << "there is no other one";
}

TEST_F(PlayLogTest, TheRootsShowIsFollowedByItsCopyAlone) {
  EXPECT_THAT(ToTry(log_, {}), ElementsAre(kRoot, std::string(kCopiedShow)));
  EXPECT_EQ(PackOf(kCopiedShow, "/shows", "/root.kaori"), "/shows/root.copy");
}

TEST_F(PlayLogTest, AShowThatHasEndedTheStageTwiceIsDoubted) {
  const auto is_doubted = [this] { return IsDoubted(Started(log_, choice_, now_), kA, now_); };
  PlayAndCrash(2s);
  EXPECT_FALSE(is_doubted());
  PlayAndCrash(2s);
  EXPECT_TRUE(is_doubted());
  PlayAndCrash(10min);
  PlayAndCrash(61s);
  EXPECT_FALSE(is_doubted()) << "it has been seen for long";
}

TEST_F(PlayLogTest, AShowThatEndsTwiceBeforeItIsSeenIsDoubtedHoweverLongThatTakes) {
  for (int i = 0; i < 2; ++i) {
    PlayAndCrash(125s);
    log_.settled = false;
  }
  EXPECT_TRUE(IsDoubted(Started(log_, choice_, now_), kA, now_));
}

TEST_F(PlayLogTest, AShowThatEndsTheStageSeldomGoesOn) {
  for (int i = 0; i < 20; ++i) EXPECT_EQ(PlayAndCrash(61s), kA) << i;
}

TEST_F(PlayLogTest, AShowThatEndsSlowlyGivesWayToo) {
  for (int i = 0; i < 3; ++i) EXPECT_EQ(PlayAndCrash(45s), kA) << i;
  EXPECT_EQ(PlayAndCrash(45s), kB);
}

// The service manager's watchdog ends it after two minutes, in which nothing was seen.
TEST_F(PlayLogTest, AShowThatHangsBeforeItIsSeenGivesWayToo) {
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(PlayAndCrash(125s), kA) << i;
    log_.settled = false;
  }
  EXPECT_EQ(PlayAndCrash(2s), kB);
}

TEST_F(PlayLogTest, OneThatWasSeenForLongBetweenTwoEndsGoesOn) {
  for (int i = 0; i < 6; ++i) {
    EXPECT_EQ(PlayAndCrash(45s), kA) << i;
    EXPECT_EQ(PlayAndCrash(10min), kA) << i;
  }
}

TEST_F(PlayLogTest, AStageThatEndsInOrderBlamesNobody) {
  for (int i = 0; i < 10; ++i) {
    EXPECT_EQ(PlayAndCrash(1s), kA) << i;
    log_.playing.clear();
  }
}

TEST_F(PlayLogTest, AChoiceThatIsMadeAnewIsAnotherTrial) {
  for (int i = 0; i < 4; ++i) PlayAndCrash(2s);
  choice_.generation = 6;
  EXPECT_EQ(PlayAndCrash(2s), kA);
}

TEST_F(PlayLogTest, ComesBackFromItsTextAndIsEmptyWhereThatIsUnsound) {
  for (int i = 0; i < 5; ++i) PlayAndCrash(2s);
  log_.settled = true;
  EXPECT_GT(log_.unsettled, 0);
  EXPECT_EQ(ParsePlayLog(Format(log_)), log_);
  log_.playing = log_.last = kCopiedShow;
  EXPECT_EQ(ParsePlayLog(Format(log_)), log_);
  EXPECT_EQ(ParsePlayLog(Format(log_) + "gave_way ../x\n"), PlayLog());
  EXPECT_EQ(ParsePlayLog("nonsense"), PlayLog());
  EXPECT_THAT(ParsePlayLog("").ends, IsEmpty());
}

}  // namespace
}  // namespace kaori::store
