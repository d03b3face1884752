// The thread that writes to the disk.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "drivers/base/background_writer.h"

namespace kaori {
namespace {

using namespace std::chrono_literals;

TEST(BackgroundWriter, WritesWhatItIsAskedForAndIsIdleThen) {
  std::atomic<int> writes = 0;
  BackgroundWriter writer(0ms, [&] { return ++writes > 0; });
  EXPECT_FALSE(writer.busy());
  for (int n = 1; n <= 100; ++n) {
    writer.Ask();
    writer.Finish();
    EXPECT_FALSE(writer.busy());
    EXPECT_EQ(writes, n);
  }
}

TEST(BackgroundWriter, WaitsBetweenTwoWritesUnlessItIsUrgent) {
  std::atomic<int> writes = 0;
  BackgroundWriter writer(1h, [&] { return ++writes > 0; });
  writer.Ask();
  while (writer.busy()) std::this_thread::yield();
  writer.Ask();
  EXPECT_TRUE(writer.busy());
  EXPECT_EQ(writes, 1);
  writer.Ask(/*at_once=*/true);
  while (writer.busy()) std::this_thread::yield();
  EXPECT_EQ(writes, 2);
}

TEST(BackgroundWriter, TriesAgainUntilNothingIsLeft) {
  std::atomic<int> writes = 0;
  BackgroundWriter writer(1ms, [&] { return ++writes == 3; });
  writer.Ask();
  while (writer.busy()) std::this_thread::yield();
  EXPECT_EQ(writes, 3);
}

TEST(BackgroundWriter, TriesWhatIsLeftOnceMoreBeforeItEnds) {
  std::atomic<int> writes = 0;
  int tried = 0;
  {
    BackgroundWriter writer(1h, [&] { return ++writes > 100; });
    writer.Ask();
    writer.Finish();
    EXPECT_TRUE(writer.busy());
    tried = writes;
  }
  EXPECT_EQ(writes, tried + 1);
}

}  // namespace
}  // namespace kaori
