// Programs that are run to their end.
#include <gtest/gtest.h>

#include "drivers/base/run_program.h"

namespace kaori {
namespace {

TEST(RunProgram, ThatAreMissingOrEndBySignalAreSeen) {
  EXPECT_FALSE(RunProgram({"/sbin/no-such-program"}));
  EXPECT_EQ(RunProgram({"/bin/sh", "-c", "exit 3"}), 3);
  EXPECT_EQ(RunProgram({"/bin/sh", "-c", "kill -9 $$"}), 128 + 9);
}

constexpr std::size_t kMost_bytes = 1000;
constexpr auto kLong = std::chrono::hours(1);

TEST(OutputOf, AProgramIsWhatItWritesToItsStandardOutput) {
  EXPECT_EQ(OutputOf({"/bin/sh", "-c", "echo one; echo two; echo no >/dev/null"}, kMost_bytes, kLong),
            "one\ntwo\n");
  EXPECT_EQ(OutputOf({"/bin/true"}, kMost_bytes, kLong), "");
  EXPECT_FALSE(OutputOf({"/sbin/no-such-program"}, kMost_bytes, kLong));
  EXPECT_EQ(OutputOf({"/bin/sh", "-c", "echo half; exit 3"}, kMost_bytes, kLong).error().message(),
            "/bin/sh ended with status 3");
}

TEST(OutputOf, AProgramThatSaysTooMuchIsItsNewestWholeLines) {
  const auto lines =
      OutputOf({"/bin/sh", "-c", "i=1000; while [ $i -lt 9999 ]; do echo $i; i=$((i+1)); done"}, 24, kLong);
  EXPECT_EQ(lines, "9995\n9996\n9997\n9998\n");
}

TEST(OutputOf, AProgramThatDoesNotEndIsAnErrorAndTheProgramIsEnded) {
  const auto hung = OutputOf({"/bin/sleep", "3600"}, kMost_bytes, std::chrono::milliseconds(200));
  ASSERT_FALSE(hung);
  EXPECT_EQ(hung.error().cause, std::errc::timed_out);
}

}  // namespace
}  // namespace kaori
