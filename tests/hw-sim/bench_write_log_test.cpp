// What the bench reads of QEMU's log of a machine's writes.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "hw-sim/hil/write_log.h"

namespace kaori::hil {
namespace {

constexpr std::uint64_t kSector_bytes = 512;

class WriteLogs : public ::testing::Test {
 protected:
  WriteLogs() : folder_(::testing::TempDir() + "write-log-" + std::to_string(::getpid())) {
    std::filesystem::create_directories(folder_);
    AddNumbers({0x6a736677736872, 1, 0, kSector_bytes});
  }
  ~WriteLogs() override { std::filesystem::remove_all(folder_); }

  // A sector of little-endian numbers, as QEMU writes them.
  void AddNumbers(std::initializer_list<std::uint64_t> numbers) {
    std::string sector;
    for (const std::uint64_t number : numbers)
      for (unsigned n = 0; n < 64; n += 8) sector += static_cast<char>(number >> n & 0xFFU);
    log_ += sector + std::string(kSector_bytes - sector.size(), '\0');
  }
  void AddWrite(std::uint64_t sector, const std::string& letters) {
    AddNumbers({sector, letters.size(), 0, letters.size() * kSector_bytes});
    for (const char letter : letters) log_ += std::string(kSector_bytes, letter);
  }
  void AddFlush() { AddNumbers({0, 0, 1, 0}); }
  void AddDiscard() { AddNumbers({0, 3, 4, 3 * kSector_bytes}); }

  Result<WriteLog> Read() const {
    std::ofstream(Log(), std::ios::binary) << log_;
    return WriteLog::Read(Log());
  }
  // A disk of four sectors of dots.
  void NewDisk() const { std::ofstream(Disk(), std::ios::binary) << std::string(4 * kSector_bytes, '.'); }
  // The first letter of each sector; '?' where a sector has two.
  std::string OnDisk() const {
    std::ifstream file(Disk(), std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    std::string letters;
    for (std::size_t at = 0; at < bytes.size(); at += kSector_bytes) {
      const std::string sector = bytes.substr(at, kSector_bytes);
      letters += sector == std::string(kSector_bytes, sector[0]) ? sector[0] : '?';
    }
    return letters;
  }
  std::string Log() const { return folder_ + "/log"; }
  std::string Disk() const { return folder_ + "/disk"; }

  std::string folder_, log_;
};

TEST_F(WriteLogs, AreReadToTheirEndAlthoughTheHeadCountsNothing) {
  AddWrite(1, "ab");
  AddFlush();
  AddDiscard();
  AddWrite(3, "c");
  const auto log = Read();
  ASSERT_TRUE(log);
  ASSERT_EQ(log->entries().size(), 3U);
  EXPECT_EQ(log->entries()[0].at_bytes, kSector_bytes);
  EXPECT_EQ(log->entries()[1].bytes, 0U) << "a flush";
  EXPECT_EQ(log->SectorsOutside({}), 3U);
  NewDisk();
  ASSERT_TRUE(log->Replay(0, 3, Disk()));
  EXPECT_EQ(OnDisk(), ".abc");
}

TEST_F(WriteLogs, OfAMachineThatWasKilledEndBeforeTheTornEntry) {
  AddWrite(0, "a");
  AddWrite(1, "bc");
  log_.resize(log_.size() - 1);
  const auto log = Read();
  ASSERT_TRUE(log);
  EXPECT_EQ(log->entries().size(), 1U);
}

TEST_F(WriteLogs, ThatAreNoneAreRefused) {
  log_[0] = 'x';
  EXPECT_FALSE(Read());
  std::filesystem::remove(Log());
  EXPECT_FALSE(WriteLog::Read(Log()));
}

TEST_F(WriteLogs, OfAMachineThatWasKilledBeforeItsFirstFlushHaveNoHead) {
  log_.clear();
  EXPECT_TRUE(Read().value().entries().empty());
  log_.assign(kSector_bytes, '\0');
  AddWrite(2, "a");
  EXPECT_EQ(Read().value().entries().size(), 1U);
}

TEST_F(WriteLogs, TellWhetherASpanWasWrittenAtAll) {
  AddFlush();
  AddDiscard();
  AddWrite(2, "ab");
  const auto log = Read();
  ASSERT_TRUE(log);
  EXPECT_TRUE(log->WritesInto({2 * kSector_bytes, 2 * kSector_bytes}));
  EXPECT_FALSE(log->WritesInto({0, 2 * kSector_bytes})) << "a flush is no write";
  EXPECT_FALSE(log->WritesInto({3 * kSector_bytes, kSector_bytes})) << "half of a write lies there";
}

TEST_F(WriteLogs, TellWhatLiesBesideTheSpans) {
  AddWrite(0, "ab");
  AddWrite(2, "c");
  const auto log = Read();
  ASSERT_TRUE(log);
  EXPECT_EQ(log->SectorsOutside({{0, 3 * kSector_bytes}}), 0U);
  EXPECT_EQ(log->SectorsOutside({{kSector_bytes, 2 * kSector_bytes}}), 2U) << "half of a write is outside";
  EXPECT_EQ(log->SectorsOutside({{0, 2 * kSector_bytes}, {2 * kSector_bytes, kSector_bytes}}), 0U);
}

// A slot of two sectors, 0 and 1, and sector 3 that decides.
class Decisions : public WriteLogs {
 protected:
  std::string Fault() const {
    return DecisionFault(Read().value().entries(), {{0, 2 * kSector_bytes}},
                         {3 * kSector_bytes, kSector_bytes});
  }
};

TEST_F(Decisions, AreRightOnceAllBeforeThemIsFlushed) {
  AddWrite(0, "ab");
  AddWrite(2, "x");
  AddFlush();
  AddWrite(2, "y");
  AddWrite(3, "c");
  AddWrite(2, "z");
  EXPECT_EQ(Fault(), "");
}

TEST_F(Decisions, AreTooEarlyWhereSomethingIsNotFlushed) {
  AddWrite(0, "a");
  AddFlush();
  AddWrite(1, "b");
  AddWrite(3, "c");
  EXPECT_EQ(Fault(), "1 writes have not been flushed when it decides");
}

TEST_F(Decisions, AreWrongWhereSomethingFollows) {
  AddWrite(3, "c");
  AddWrite(1, "b");
  EXPECT_EQ(Fault(), "it writes on after it has decided");
}

TEST_F(Decisions, AreMadeOnceAndAlone) {
  EXPECT_EQ(Fault(), "nothing decides");
  AddWrite(3, "c");
  EXPECT_EQ(Fault(), "");
  AddWrite(3, "c");
  EXPECT_EQ(Fault(), "what decides is written twice");
  log_.resize(kSector_bytes);
  AddWrite(2, "bc");
  EXPECT_EQ(Fault(), "the write that decides changes something else as well");
}

}  // namespace
}  // namespace kaori::hil
