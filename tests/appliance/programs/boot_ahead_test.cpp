// What is read before anybody asks: a list that may name what is not there.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>

#include "appliance/programs/boot/ahead.h"

namespace kaori::boot {
namespace {

namespace fs = std::filesystem;

class Ahead : public ::testing::Test {
 protected:
  Ahead() : folder_(fs::temp_directory_path() / ("kaori-ahead-" + std::to_string(::getpid()))) {
    fs::create_directory(folder_);
  }
  ~Ahead() override { fs::remove_all(folder_); }

  std::string File(const std::string& name, std::size_t bytes) const {
    std::ofstream(folder_ / name) << std::string(bytes, 'x');
    return (folder_ / name).string();
  }
  std::size_t ReadListOf(const std::string& lines, std::size_t most_bytes = SIZE_MAX) const {
    const fs::path list = folder_ / "list";
    std::ofstream(list) << lines;
    return ReadAhead(list.c_str(), most_bytes);
  }

  fs::path folder_;
};

TEST_F(Ahead, BringsEveryFileToItsLastByte) {
  const std::string small = File("small", 1), large = File("large", (std::size_t{3} << 20U) + 5);
  EXPECT_EQ(ReadListOf(small + "\n" + large + "\n"), (std::size_t{3} << 20U) + 6);
}

TEST_F(Ahead, BringsTheNamedPartOfAFile) {
  const std::string file = File("a file", 10'000);
  EXPECT_EQ(ReadListOf("0 4096 " + file), 4096U);
  EXPECT_EQ(ReadListOf("4096 100 " + file + "\n9000 1 " + file), 101U);
  EXPECT_EQ(ReadListOf("9000 4096 " + file), 1000U) << "no more than there is";
  EXPECT_EQ(ReadListOf("20000 1 " + file), 0U) << "behind its end";
  EXPECT_EQ(ReadListOf("0 4096 " + file, 4095), 0U);
  EXPECT_EQ(ReadListOf("0 4096\n-1 5 " + file + "\n4096 " + file), 0U) << "no part";
}

TEST_F(Ahead, PassesOverWhatIsNotThere) {
  const std::string there = File("there", 4096);
  EXPECT_EQ(ReadListOf(folder_.string() + "/gone\n\n" + folder_.string() + "\n/dev/zero\n" + there), 4096U);
  EXPECT_EQ(ReadListOf(File("empty", 0)), 0U);
  EXPECT_EQ(ReadAhead((folder_ / "no list").c_str(), SIZE_MAX), 0U);
}

TEST_F(Ahead, LeavesMemoryToTheStage) {
  const std::string first = File("first", 1000), large = File("large", 5000), last = File("last", 1000);
  EXPECT_EQ(ReadListOf(first + "\n" + large + "\n" + last, 2000), 2000U)
      << "what is too large is passed over";
  EXPECT_EQ(ReadListOf(first, 999), 0U);
}

}  // namespace
}  // namespace kaori::boot
