// A factory reset is asked for by hand, and by nothing else.
#include <gtest/gtest.h>

#include "appliance/programs/data/reset_request.h"

namespace kaori::data {
namespace {

using namespace std::chrono_literals;  // NOLINT: tests speak in seconds.
using Verdict = ResetRequest::Verdict;

class ResetRequestTest : public ::testing::Test {
 protected:
  // Holds both for so long, looked at ten times a second as the program does; gives the last verdict.
  Verdict See(bool key, bool go, Duration span) {
    Verdict verdict = Verdict::kWaiting;
    for (const Time until = now_ + span; now_ < until; now_ += 100ms) verdict = request_.See(key, go, now_);
    return verdict;
  }
  Time now_ = Time{} + 100s;
  ResetRequest request_{now_};
};

TEST_F(ResetRequestTest, IsMadeByTenSecondsOfGoWithTheKeyOnAndByLettingGo) {
  EXPECT_EQ(See(true, false, 5s), Verdict::kWaiting);
  EXPECT_EQ(See(true, true, 9900ms), Verdict::kWaiting);
  EXPECT_EQ(See(true, true, 1s), Verdict::kLetGo);
  EXPECT_EQ(See(true, false, 100ms), Verdict::kAsked);
  EXPECT_EQ(See(false, false, 10min), Verdict::kAsked);
}

TEST_F(ResetRequestTest, IsNotMadeByAShortPushNorWithoutTheKey) {
  EXPECT_EQ(See(true, true, 9s), Verdict::kWaiting);
  EXPECT_EQ(See(true, false, 1s), Verdict::kWaiting);
  EXPECT_EQ(See(true, true, 9s), Verdict::kWaiting);
  EXPECT_EQ(See(false, true, 15s), Verdict::kWaiting);
  EXPECT_EQ(See(false, false, 30s), Verdict::kOver);
}

// A case stands on the foot switch, or its cable is shorted.
TEST_F(ResetRequestTest, IsNotMadeByALineThatIsNeverReleasedNorReleasedLate) {
  EXPECT_EQ(See(true, true, 20s), Verdict::kLetGo);
  EXPECT_EQ(See(true, true, 15s), Verdict::kWaiting);
  EXPECT_EQ(See(true, false, 1s), Verdict::kWaiting);
  EXPECT_EQ(See(true, true, 24s), Verdict::kLetGo) << "it was tried anew, within the first minute";
  EXPECT_EQ(See(true, true, 6h), Verdict::kOver);
}

TEST_F(ResetRequestTest, IsTakenBackByTheKey) {
  EXPECT_EQ(See(true, true, 12s), Verdict::kLetGo);
  EXPECT_EQ(See(false, true, 1s), Verdict::kWaiting);
  EXPECT_EQ(See(false, false, 1s), Verdict::kWaiting);
}

TEST_F(ResetRequestTest, IsNotHeardInAShow) {
  EXPECT_EQ(See(true, false, 61s), Verdict::kOver);
  EXPECT_EQ(See(true, true, 12s), Verdict::kOver);
}

}  // namespace
}  // namespace kaori::data
