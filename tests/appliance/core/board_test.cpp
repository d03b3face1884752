// The board as a reader and a writer meet it.
#include "appliance/core/board/board.h"

#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <random>
#include <thread>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "appliance/core/board/performance_state.h"
#include "appliance/core/board/snapshot.h"
#include "tests/appliance/core/board_file.h"

namespace kaori::board {
namespace {

using std::chrono::milliseconds;
using ::testing::HasSubstr;

constexpr Time kNoon = Time{} + std::chrono::hours(12);

void Poke(const std::string& path, std::streamoff at, const std::vector<std::uint8_t>& bytes) {
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(at);
  file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

TEST(Board, GivesNeutralValuesFromAbsentSourcesUntilSomebodyWrites) {
  const BoardFile file;
  const Board board = file.Open();
  const Snapshot all = ReadAll(board);
  EXPECT_EQ(all.surface.source, SourceState::kAbsent);
  EXPECT_EQ(all.sticks[1].value.hat, -1);
  EXPECT_EQ(all.lips.value.width, 1.0F);
}

TEST(Board, CarriesAValueItsTimeAndItsSourceToEveryReader) {
  const BoardFile file;
  const Board writing = file.Open();
  const Board reading = Board::Open(file.path()).value();
  auto writer = writing.AcquireWriter<Surface>().value();
  writer.Write({.counts = {1, -2, 3}, .buttons_down = 0x80000001}, kNoon, SourceState::kLive);
  const Stamped<Surface> read = reading.Read<Surface>();
  EXPECT_EQ(read.value.counts[1], -2);
  EXPECT_EQ(read.value.buttons_down, 0x80000001);
  EXPECT_EQ(read.at, kNoon);
  EXPECT_EQ(read.source, SourceState::kLive);
}

TEST(Board, KeepsTheTwoSticksApart) {
  const BoardFile file;
  const Board board = file.Open();
  auto left = board.AcquireWriter<Stick>(0).value();
  auto right = board.AcquireWriter<Stick>(1).value();
  left.Write({.x = -1}, kNoon, SourceState::kLive);
  right.Write({.x = 1}, kNoon, SourceState::kStale);
  const Snapshot all = ReadAll(board);
  EXPECT_EQ(all.sticks[0].value.x, -1.0F);
  EXPECT_EQ(all.sticks[1].value.x, 1.0F);
  EXPECT_EQ(all.sticks[1].source, SourceState::kStale);
}

TEST(Board, RefusesASecondWriterAndNamesTheSectionAndItsWriter) {
  const BoardFile file;
  const Board board = file.Open();
  const auto first = board.AcquireWriter<Keys>();
  ASSERT_TRUE(first);
  const auto second = Board::Open(file.path())->AcquireWriter<Keys>();
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().cause, std::errc::device_or_resource_busy);
  EXPECT_THAT(second.error().message(), HasSubstr("section keys"));
  EXPECT_THAT(second.error().message(), HasSubstr("process " + std::to_string(::getpid())));
  EXPECT_TRUE(board.AcquireWriter<Lips>()) << "other sections are free";
}

TEST(Board, KeepsTheLastValueWhenItsWriterGoesAndTakesTheNext) {
  const BoardFile file;
  const Board board = file.Open();
  {
    auto first = board.AcquireWriter<Lamps>().value();
    first.Write({.lit = 7}, kNoon, SourceState::kLive);
  }
  EXPECT_EQ(board.Read<Lamps>().value.lit, 7U);
  auto second = board.AcquireWriter<Lamps>().value();
  EXPECT_EQ(board.Read<Lamps>().value.lit, 7U);
  second.Write({.lit = 8}, kNoon, SourceState::kLive);
  EXPECT_EQ(board.Read<Lamps>().value.lit, 8U);
}

TEST(Board, TellsWhetherASectionHasAWriter) {
  const BoardFile file;
  const Board board = file.Open(), reading = Board::Open(file.path()).value();
  EXPECT_FALSE(reading.HasWriter<Stick>(1));
  {
    const auto writer = board.AcquireWriter<Stick>(1).value();
    EXPECT_TRUE(reading.HasWriter<Stick>(1));
    EXPECT_TRUE(board.HasWriter<Stick>(1)) << "of the same object, too";
    EXPECT_FALSE(reading.HasWriter<Stick>(0) || reading.HasWriter<Keys>());
  }
  EXPECT_FALSE(reading.HasWriter<Stick>(1));
}

// Its last value stays, and says that the source is there.
TEST(Board, HasNoWriterAnyMoreWhenItsProcessWasKilled) {
  const BoardFile file;
  const Board board = file.Open();
  const pid_t writing = ::fork();
  if (writing == 0) {
    auto writer = Board::Open(file.path())->AcquireWriter<Lamps>().value();
    for (writer.Write({.lit = 7}, kNoon, SourceState::kLive);;) ::pause();
  }
  while (board.Read<Lamps>().value.lit != 7) std::this_thread::yield();
  EXPECT_TRUE(board.HasWriter<Lamps>());
  ::kill(writing, SIGKILL);
  ::waitpid(writing, nullptr, 0);
  EXPECT_FALSE(board.HasWriter<Lamps>());
  EXPECT_EQ(board.Read<Lamps>().source, SourceState::kLive);
}

TEST(Board, PassesOverValuesThatCannotBeAndKeepsTheLastGoodOne) {
  const BoardFile file;
  const Board board = file.Open();
  auto lips = board.AcquireWriter<Lips>().value();
  lips.Write({.height = 0.5F, .quality = 1}, kNoon, SourceState::kLive);
  lips.Write({.height = std::numeric_limits<float>::quiet_NaN()}, kNoon, SourceState::kLive);
  lips.Write({.width = -3}, kNoon, SourceState::kLive);
  EXPECT_EQ(board.Read<Lips>().value.height, 0.5F);
  lips.Write({.quality = std::numeric_limits<float>::infinity()}, kNoon, SourceState::kLive);
  lips.Write({.height = 1}, kNoon, static_cast<SourceState>(77));
  const Stamped<Lips> read = board.Read<Lips>();
  EXPECT_EQ(read.source, SourceState::kAbsent) << "nothing good is left: neutral";
  EXPECT_EQ(read.value.height, 0.0F);
}

TEST(Board, PassesOverATimeThatNobodyCanReckonWith) {
  const BoardFile file;
  const Board board = file.Open();
  auto lamps = board.AcquireWriter<Lamps>().value();
  lamps.Write({.lit = 1}, kNoon, SourceState::kLive);
  lamps.Write({.lit = 2}, Time::min(), SourceState::kLive);
  lamps.Write({.lit = 3}, Time::max(), SourceState::kLive);
  EXPECT_EQ(board.Read<Lamps>().value.lit, 1U);
  lamps.Write({.lit = 4}, Time{} - Duration(1), SourceState::kLive);
  EXPECT_EQ(board.Read<Lamps>().value.lit, 1U);
}

TEST(Board, IsWritableForTheProgramsGroupWhateverTheUmask) {
  const BoardFile file;
  const mode_t before = ::umask(077);
  const Board board = file.Open();
  ::umask(before);
  struct stat status {};
  ASSERT_EQ(::stat(file.path().c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0660U);
}

TEST(Board, ChecksEveryFieldThatCanBeWrong) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(Valid(Stick{.x = -1, .y = 1, .slider = 1, .hat = 7}));
  for (const Stick& bad : {Stick{.x = nan}, Stick{.y = 1.01F}, Stick{.twist = -2}, Stick{.slider = -0.1F},
                           Stick{.hat = 8}, Stick{.hat = -2}, Stick{.centres = {0, nan, 0}}}) {
    EXPECT_FALSE(Valid(bad));
  }
  EXPECT_FALSE(Valid(Surface{.counts_per_turn = 0}));
  EXPECT_FALSE(Valid(Surface{.counts_per_turn = -256}));
  EXPECT_FALSE(Valid(StageStatus{.frame_cpu = -Duration{1}}));
  EXPECT_FALSE(Valid(StageStatus{.frames_per_s = -1}));
  EXPECT_FALSE(Valid(Performance{.bytes = 9000}));
  for (const Voice& bad : {Voice{.level_db = nan}, Voice{.speaking = 2}, Voice{.height = 1.1F},
                           Voice{.width = -0.1F}, Voice{.quality = nan}}) {
    EXPECT_FALSE(Valid(bad));
  }
  EXPECT_FALSE(Valid(Sound{.delay_ms = -1}));
  EXPECT_FALSE(Valid(Sound{.asked_ms = nan}));
  EXPECT_FALSE(Valid(Sound{.drift_ppm = nan}));
  EXPECT_FALSE(Valid(MotionNow{.motion = -2}));
  EXPECT_FALSE(Valid(MotionNow{.at_s = nan}));
  for (const LipsGuide& bad :
       {LipsGuide{.step = 5}, LipsGuide{.taking = 2}, LipsGuide{.progress = nan}, LipsGuide{.seen = 2}})
    EXPECT_FALSE(Valid(bad));
  for (const Desk& bad : {Desk{.code = 1'000'000}, Desk{.valid_s = nan}, Desk{.port = 65536}})
    EXPECT_FALSE(Valid(bad));
}

TEST(Board, ShowsOnlyValidValuesWhateverBytesLieInItsSections) {
  const BoardFile file;
  const Board board = file.Open();
  std::mt19937 random(1993);
  std::vector<std::uint8_t> garbage(kBoardBytes - kHeadWords * sizeof(Word));
  for (int round = 0; round < 100; ++round) {
    for (std::uint8_t& byte : garbage) byte = static_cast<std::uint8_t>(random());
    Poke(file.path(), kHeadWords * sizeof(Word), garbage);
    const Snapshot all = ReadAll(board);
    EXPECT_TRUE(Valid(all.surface.value) && Valid(all.surface.source));
    EXPECT_TRUE(Valid(all.sticks[0].value) && Valid(all.sticks[1].value));
    EXPECT_TRUE(Valid(all.lips.value) && Valid(all.voice.value) && Valid(all.stage_status.value));
    EXPECT_TRUE(Valid(all.lips_guide.value) && Valid(all.desk.value));
    EXPECT_TRUE(Valid(board.Read<Sound>().value) && Valid(board.Read<MotionNow>().value));
    EXPECT_TRUE(Valid(board.Read<Performance>().value));
  }
}

TEST(Board, RefusesAFileThatIsNoBoardInOneLine) {
  const BoardFile file;
  std::ofstream(file.path())
      << "a shopping list, rather long, so that it is as large as a head of a board is";
  const auto board = Board::Open(file.path());
  ASSERT_FALSE(board);
  EXPECT_EQ(board.error().cause, std::errc::invalid_argument);
  EXPECT_THAT(board.error().message(), HasSubstr(file.path() + ": this file is no board"));
  EXPECT_FALSE(Board::Create(file.path())) << "and it is not overwritten";
}

// A board of another build: its head adds up.
void PokeHead(const std::string& path, std::size_t word, std::uint32_t value) {
  std::array<std::uint32_t, kHeadSumAt + 1> head{};
  std::ifstream(path, std::ios::binary).read(reinterpret_cast<char*>(head.data()), sizeof(head));
  head[word] = value;
  head[kHeadSumAt] = HeadSum(std::span(head).first<kHeadSumAt>());
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(head.data());
  Poke(path, 0, {bytes, bytes + sizeof(head)});
}

TEST(Board, RefusesOneOfAnotherVersionOrLayoutAndLeavesItAlone) {
  const BoardFile file;
  const auto refusal = [&] { return Board::Create(file.path()).error().message(); };
  { (void)file.Open(); }
  PokeHead(file.path(), 1, kVersion + 1);
  EXPECT_THAT(refusal(),
              HasSubstr(fmt::format("it has version {}, this program {}", kVersion + 1, kVersion)));
  PokeHead(file.path(), 1, kVersion);
  PokeHead(file.path(), 2, 0);
  EXPECT_THAT(refusal(), HasSubstr("laid out by another build"));
}

TEST(Board, SaysWhenThereIsNone) {
  const BoardFile file;
  EXPECT_EQ(Board::Open(file.path()).error().cause, std::errc::no_such_file_or_directory);
  EXPECT_EQ(Board::Create(file.path() + "/no/folder").error().cause, std::errc::no_such_file_or_directory);
}

TEST(Board, WritesNothingIntoAFileThatTookItsPlace) {
  const BoardFile file;
  const Board old_board = file.Open();
  std::filesystem::remove(file.path());
  const Board new_board = file.Open();
  const auto writer = old_board.AcquireWriter<Lips>();
  ASSERT_FALSE(writer);
  EXPECT_EQ(writer.error().cause, std::errc::no_such_file_or_directory);
}

TEST(Board, IsOneBoardWhenManyProgramsMakeItAtOnce) {
  const BoardFile file;
  std::vector<std::jthread> programs;
  std::array<bool, 8> made{};
  for (bool& ok : made) programs.emplace_back([&] { ok = Board::Create(file.path()).has_value(); });
  programs.clear();
  EXPECT_THAT(made, ::testing::Each(true));
}

struct Walk {
  static constexpr std::uint32_t kLayout = 3;
  double phase = 0;
  std::array<float, 100> weights{};
};

struct LaterWalk : Walk {
  static constexpr std::uint32_t kLayout = 4;
};

TEST(Board, HoldsTheStagesOwnStateOverARestart) {
  const BoardFile file;
  const Board board = file.Open();
  auto writer = board.AcquireWriter<Performance>().value();
  EXPECT_FALSE(Restore<Walk>(board.Read<Performance>().value));
  Walk walk{.phase = 0.75};
  walk.weights[99] = 2;
  writer.Write(Hold(walk), kNoon, SourceState::kLive);
  const auto taken = Restore<Walk>(board.Read<Performance>().value);
  ASSERT_TRUE(taken);
  EXPECT_EQ(taken->phase, 0.75);
  EXPECT_EQ(taken->weights[99], 2.0F);
  EXPECT_FALSE(Restore<LaterWalk>(board.Read<Performance>().value)) << "a newer stage starts afresh";
}

}  // namespace
}  // namespace kaori::board
