// A board that is removed, overwritten or cut short, beneath the programs that play on it.
#include <fcntl.h>
#include <signal.h>
#include <sys/mman.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "appliance/core/board/snapshot.h"
#include "tests/appliance/core/board_file.h"

namespace kaori::board {
namespace {

using std::chrono::milliseconds;
using ::testing::HasSubstr;

constexpr Time kHealNoon = Time{} + std::chrono::hours(12);

struct Harm {
  const char* name;
  void (*harm)(const std::string& path);
  friend void PrintTo(const Harm& h, std::ostream* out) { *out << h.name; }
};

void OverwriteHead(const std::string& path) {
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  file << std::string(64, 'x');
}

const Harm kHarms[] = {
    {"Removed", [](const std::string& path) { std::filesystem::remove(path); }},
    {"HeadOverwritten", OverwriteHead},
    {"CutToNothing", [](const std::string& path) { std::filesystem::resize_file(path, 0); }},
    {"CutToAFewBytes", [](const std::string& path) { std::filesystem::resize_file(path, 10); }},
    {"CutToHalf", [](const std::string& path) { std::filesystem::resize_file(path, kBoardBytes / 2); }},
    {"Replaced",
     [](const std::string& path) {
       std::filesystem::remove(path);
       (void)Board::Create(path);
     }},
};

class ABoard : public ::testing::TestWithParam<Harm> {
 protected:
  void DoHarm() { GetParam().harm(file_.path()); }

  const BoardFile file_;
};
INSTANTIATE_TEST_SUITE_P(ThatWas, ABoard, ::testing::ValuesIn(kHarms),
                         [](const auto& of) { return of.param.name; });

TEST_P(ABoard, IsOneGoodBoardAgainForAllItsProgramsAndCarriesWhatTheyWrote) {
  Board input = file_.Open(), stage = file_.Open();
  auto keys = input.AcquireWriter<Keys>().value();
  auto surface = input.AcquireWriter<Surface>().value();
  auto performance = stage.AcquireWriter<Performance>().value();
  keys.Write({.down = {5}}, kHealNoon, SourceState::kLive);
  performance.Write({.layout = 7}, kHealNoon, SourceState::kLive);
  DoHarm();
  EXPECT_TRUE(stage.Heal().value());
  EXPECT_TRUE(input.Heal().value());
  EXPECT_FALSE(stage.Heal().value()) << "it is healed once";
  EXPECT_EQ(stage.Read<Keys>().value.down[0], 5U) << "a key that is held is held";
  EXPECT_EQ(input.Read<Performance>().value.layout, 7U);
  EXPECT_EQ(stage.Read<Surface>().source, SourceState::kAbsent) << "what nobody wrote nobody reads";
  keys.Write({}, kHealNoon, SourceState::kLive);
  EXPECT_EQ(stage.Read<Keys>().value.down[0], 0U);
  EXPECT_EQ(Board::Open(file_.path())->AcquireWriter<Surface>().error().cause,
            std::errc::device_or_resource_busy)
      << "and each section has its writer";
}

TEST_P(ABoard, EndsNobodyWhoReadsOrWritesBeforeItIsHealed) {
  Board board = file_.Open();
  auto status = board.AcquireWriter<StageStatus>().value();
  DoHarm();
  status.Write({.frames = 3}, kHealNoon, SourceState::kLive);
  ReadAll(board);
  ASSERT_TRUE(board.Heal());
  EXPECT_EQ(board.Read<StageStatus>().value.frames, 3U);
}

TEST_P(ABoard, LeavesThePictureAsItIsUntilItsProgramsHaveMoved) {
  Board input = file_.Open(), stage = file_.Open();
  auto left = input.AcquireWriter<Stick>(0).value();
  left.Write({.x = 0.5F}, kHealNoon, SourceState::kLive);
  auto right = std::optional(input.AcquireWriter<Stick>(1).value());
  right->Write({.x = 0.25F}, kHealNoon, SourceState::kLive);
  SnapshotReader reader(stage);
  ASSERT_EQ(reader.Read(kHealNoon).sticks[0].value.x, 0.5F);
  DoHarm();
  EXPECT_EQ(reader.Read(kHealNoon).sticks[0].value.x, 0.5F);
  ASSERT_TRUE(stage.Heal());
  EXPECT_EQ(reader.Read(kHealNoon + milliseconds(100)).sticks[0].source, SourceState::kLive);
  EXPECT_TRUE(reader.settling());
  right.reset();  // Its program ended: it does not come back.
  ASSERT_TRUE(input.Heal());
  EXPECT_EQ(reader.Read(kHealNoon + milliseconds(900)).sticks[1].value.x, 0.25F);
  const Snapshot& settled = reader.Read(kHealNoon + milliseconds(1200));
  EXPECT_FALSE(reader.settling());
  EXPECT_EQ(settled.sticks[0].value.x, 0.5F);
  EXPECT_EQ(settled.sticks[1].source, SourceState::kAbsent);
}

TEST_P(ABoard, IsThereForAProgramThatStartsAnew) {
  Board stage = file_.Open();
  DoHarm();
  ASSERT_TRUE(Board::Create(file_.path()));
  ASSERT_TRUE(stage.Heal());
  auto writer = Board::Create(file_.path())->AcquireWriter<Lamps>().value();
  writer.Write({.lit = 3}, kHealNoon, SourceState::kLive);
  EXPECT_EQ(stage.Read<Lamps>().value.lit, 3U);
}

TEST(Healing, ReplacesNoFileThatNeverWasABoard) {
  const BoardFile file;
  Board board = file.Open();
  const std::string list = "a shopping list, rather long, so that it is as large as a head of a board is";
  std::filesystem::remove(file.path());
  std::ofstream(file.path()) << list;
  const auto healed = board.Heal();
  ASSERT_FALSE(healed);
  EXPECT_THAT(healed.error().message(), HasSubstr("this file is no board"));
  EXPECT_EQ(std::filesystem::file_size(file.path()), list.size());
  EXPECT_EQ(board.Read<Lips>().value.width, 1.0F) << "and what is mapped is still read";
}

TEST(Healing, WaitsForASectionThatAnotherProgramWritesMeanwhile) {
  const BoardFile file;
  Board board = file.Open();
  auto lamps = board.AcquireWriter<Lamps>().value();
  lamps.Write({.lit = 1}, kHealNoon, SourceState::kLive);
  std::filesystem::remove(file.path());
  {
    const auto other = Board::Create(file.path())->AcquireWriter<Lamps>();
    ASSERT_TRUE(other);
    EXPECT_EQ(board.Heal().error().cause, std::errc::device_or_resource_busy);
    lamps.Write({.lit = 2}, kHealNoon, SourceState::kLive);
    EXPECT_EQ(board.Read<Lamps>().source, SourceState::kAbsent);
  }
  ASSERT_TRUE(board.Heal());
  EXPECT_EQ(board.Read<Lamps>().value.lit, 2U);
}

TEST(Healing, LeavesOtherFaultsOfTheBusToOthers) {
  const BoardFile file;
  { (void)file.Open(); }
  const std::string other = (file.folder() / "other").string();
  EXPECT_EXIT(
      {
        std::ofstream(other) << "x";
        const UniqueFd fd(::open(other.c_str(), O_RDWR));
        auto mapping = Mapping::Map(fd.get(), /*writable=*/false, other);  // Installs the handler.
        void* elsewhere = ::mmap(nullptr, 4096, PROT_READ, MAP_SHARED, fd.get(), 0);
        std::filesystem::resize_file(other, 0);
        [[maybe_unused]] const char touched = *static_cast<volatile const char*>(elsewhere);
        ::_exit(0);
      },
      ::testing::KilledBySignal(SIGBUS), "");
}

}  // namespace
}  // namespace kaori::board
