// The board under two processes at full speed, and writers that die at the worst moment.
#include <signal.h>
#include <sys/wait.h>

#include <atomic>
#include <random>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "appliance/core/board/board.h"
#include "tests/appliance/core/board_file.h"

namespace kaori::board {
namespace {

// Every field follows from one number, so that a value made of two is seen.
Surface Pattern(std::uint32_t n) {
  Surface surface;
  for (std::uint32_t i = 0; i < 8; ++i) surface.counts[i] = static_cast<std::int32_t>(n * 31 + i);
  surface.buttons_down = ~n;
  for (std::uint32_t i = 0; i < 32; ++i) surface.pushes[i] = n ^ (i * 0x01010101U);
  return surface;
}

bool IsWhole(const Stamped<Surface>& read) {
  const std::uint32_t n = ~read.value.buttons_down;
  const Surface want = Pattern(n);
  return read.at == Time{} + Duration(n) && read.source == SourceState::kLive &&
         read.value.counts == want.counts && read.value.pushes == want.pushes;
}

void WriteOne(Writer<Surface>& writer, std::uint32_t n) {
  writer.Write(Pattern(n), Time{} + Duration(n), SourceState::kLive);
}

struct Tally {
  std::uint64_t reads = 0;
  std::uint64_t torn = 0;
  std::uint64_t changes = 0;
  std::uint64_t backwards = 0;

  Tally& operator+=(const Tally& more) {
    reads += more.reads;
    torn += more.torn;
    changes += more.changes;
    backwards += more.backwards;
    return *this;
  }
};

constexpr std::uint64_t kMeetings = 100;  // So often at least the writer must have written between two reads.

Tally ReadMany(const Board& board, std::uint64_t reads) {
  Tally tally;
  std::uint32_t last = 0;
  for (; tally.reads < reads; ++tally.reads) {
    const Stamped<Surface> read = board.Read<Surface>();
    const std::uint32_t n = ~read.value.buttons_down;
    tally.torn += IsWhole(read) ? 0 : 1;
    tally.changes += n != last ? 1 : 0;
    tally.backwards += n < last ? 1 : 0;
    last = n;
  }
  return tally;
}

// A process that writes without a pause until it is killed.
class WritingProcess {
 public:
  explicit WritingProcess(const std::string& path, std::uint32_t first) : pid_(::fork()) {
    if (pid_ == 0) WriteForEver(path, first);
  }
  WritingProcess(const WritingProcess&) = delete;
  WritingProcess& operator=(const WritingProcess&) = delete;
  ~WritingProcess() { Kill(); }

  void Kill() {
    if (pid_ <= 0) return;
    ::kill(pid_, SIGKILL);
    ::waitpid(std::exchange(pid_, -1), nullptr, 0);
  }

 private:
  [[noreturn]] static void WriteForEver(const std::string& path, std::uint32_t first) {
    auto writer = Board::Open(path)->AcquireWriter<Surface>();
    if (!writer) ::_exit(1);
    for (std::uint32_t n = first;; ++n) WriteOne(*writer, n);
  }

  pid_t pid_;
};

bool AwaitChange(const Board& board) {
  const std::uint32_t first = board.Read<Surface>().value.buttons_down;
  const Time deadline = SteadyClock().now() + std::chrono::seconds(5);
  while (SteadyClock().now() < deadline) {
    if (board.Read<Surface>().value.buttons_down != first) return true;
    std::this_thread::yield();
  }
  return false;
}

TEST(BoardUnderFire, TearsNoneOfTenMillionReadsBetweenTwoProcesses) {
  const BoardFile file;
  const Board board = file.Open();
  {
    auto writer = board.AcquireWriter<Surface>().value();
    WriteOne(writer, 1);
  }
  const WritingProcess writing(file.path(), 2);
  ASSERT_TRUE(AwaitChange(board));
  Tally tally = ReadMany(board, 10'000'000);
  // On a busy machine the two take turns, and meet only where one is stopped in the middle: then longer.
  const Time deadline = SteadyClock().now() + std::chrono::seconds(20);
  while (tally.changes < kMeetings && SteadyClock().now() < deadline) tally += ReadMany(board, 100'000);
  EXPECT_EQ(tally.torn, 0U);
  EXPECT_EQ(tally.backwards, 0U);
  EXPECT_GE(tally.changes, kMeetings) << "the writer hardly ran beside the reader";
  RecordProperty("changes_seen", std::to_string(tally.changes));
}

TEST(BoardUnderFire, TearsNothingBetweenThreads) {
  const BoardFile file;
  const Board board = file.Open();
  auto writer = board.AcquireWriter<Surface>().value();
  WriteOne(writer, 1);
  std::atomic<int> reading = 2;
  std::array<Tally, 2> tallies;
  std::vector<std::jthread> readers;
  for (Tally& tally : tallies) {
    readers.emplace_back([&] {
      tally = ReadMany(board, 50'000);
      --reading;
    });
  }
  for (std::uint32_t n = 2; reading > 0; ++n) WriteOne(writer, n);
  readers.clear();
  for (const Tally& tally : tallies) {
    EXPECT_EQ(tally.torn, 0U);
    EXPECT_EQ(tally.backwards, 0U);
  }
}

TEST(BoardUnderFire, OutlivesAWriterThatIsKilledAtAnyMoment) {
  const BoardFile file;
  const Board board = file.Open();
  {
    auto writer = board.AcquireWriter<Surface>().value();
    WriteOne(writer, 1);
  }
  std::mt19937 random(7);
  for (std::uint32_t round = 1; round <= 50; ++round) {
    WritingProcess writing(file.path(), round * 100'000'000U / 2);
    ASSERT_TRUE(AwaitChange(board));
    ReadMany(board, random() % 2000);
    writing.Kill();
    EXPECT_TRUE(IsWhole(board.Read<Surface>()));
    auto next = board.AcquireWriter<Surface>();
    ASSERT_TRUE(next) << next.error().message();
    WriteOne(*next, round);
    EXPECT_EQ(board.Read<Surface>().at, Time{} + Duration(round));
  }
}

TEST(BoardUnderFire, TellsTheProcessThatHoldsASection) {
  const BoardFile file;
  const Board board = file.Open();
  const auto mine = board.AcquireWriter<Lips>().value();
  const pid_t child = ::fork();
  if (child == 0) {
    const auto second = Board::Open(file.path())->AcquireWriter<Lips>();
    const bool refused = !second && second.error().cause == std::errc::device_or_resource_busy;
    ::_exit(refused ? 0 : 1);
  }
  int status = -1;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(status, 0) << "another process got the writer too";
}

class Slots : public ::testing::Test {
 protected:
  static constexpr std::size_t kWords = 3;
  using Value = std::array<std::uint32_t, kWords>;
  std::array<Word, SectionWords(kWords)> section_{};

  Word& Newest() { return section_[0]; }
  Word& Mark(std::uint32_t generation) {
    return section_[kSectionHeadWords + (generation % kSlots) * SlotWords(kWords)];
  }
};

TEST_F(Slots, KeepTheLastValueOfAWriterThatDiedOverTheNext) {
  Publish(section_.data(), Value{1, 2, 3});
  Mark(2) = 0;  // The next write began and never ended.
  Value value{};
  ASSERT_TRUE(Fetch(section_.data(), 0, value));
  EXPECT_EQ(value, (Value{1, 2, 3}));
  Publish(section_.data(), Value{4, 5, 6});
  ASSERT_TRUE(Fetch(section_.data(), 0, value));
  EXPECT_EQ(value, (Value{4, 5, 6}));
}

TEST_F(Slots, GiveUpAfterAFewTriesInsteadOfWaitingForADeadWriter) {
  Publish(section_.data(), Value{1, 2, 3});
  Mark(1) = 0;  // Spoilt on purpose: no writer of ours leaves the newest slot so.
  Value value{};
  EXPECT_FALSE(Fetch(section_.data(), 0, value));
}

TEST_F(Slots, ShowOlderValuesByTheirAge) {
  for (std::uint32_t n = 1; n <= 6; ++n) Publish(section_.data(), Value{n, n, n});
  Value value{};
  for (std::uint32_t age = 0; age < kSlots; ++age) {
    ASSERT_TRUE(Fetch(section_.data(), age, value));
    EXPECT_EQ(value[0], 6 - age);
  }
}

TEST_F(Slots, GiveNoLaterValueThanTheOneThatIsNewest) {
  for (std::uint32_t n = 1; n <= 1 + kSlots; ++n) Publish(section_.data(), Value{n, n, n});
  // The writer has written over generation 1 but the reader does not yet know: what it takes now must not be
  // ahead of what it takes next.
  Newest() = 1;
  Value value{};
  EXPECT_FALSE(Fetch(section_.data(), 0, value));
}

TEST_F(Slots, GoOnWhenTheGenerationWrapsRound) {
  Newest() = 0xFFFFFFFDU;
  Value value{};
  for (std::uint32_t n = 1; n <= 6; ++n) {
    Publish(section_.data(), Value{n, n, n});
    ASSERT_TRUE(Fetch(section_.data(), 0, value));
    EXPECT_EQ(value[0], n);
  }
}

}  // namespace
}  // namespace kaori::board
