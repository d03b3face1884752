// A folder, a cast and work of chance, for tests of what the handles keep.
#pragma once

#include <gmock/gmock.h>

#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "appliance/programs/editor/work_writer.h"
#include "tests/appliance/core/board_file.h"
#include "tests/appliance/core/small_disk.h"
#include "tests/render/synthetic_cast.h"

namespace kaori::tests {

using editor::Change;
using editor::Journal;
using editor::Outcome;
using editor::Work;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

inline constexpr std::uint64_t kCast = 77;  // Some fingerprint.

class HandleKeeping : public ::testing::Test {
 protected:
  Work Some(const std::string& name, int slot, unsigned seed = 1) const {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> part(-0.02F, 0.02F);
    Work work{.lids = {0.25F, 0.5F}, .name = name, .slot = slot};
    for (std::size_t i = 0; i < points_.size(); ++i)
      work.pulls_m.push_back({part(random), part(random), part(random)});
    return work;
  }

  std::filesystem::path journal() const { return folder_.folder() / "needles.journal"; }
  std::filesystem::path own() const { return folder_.folder() / "own"; }
  Journal::Opened Open(std::uint64_t cast = kCast) const {
    return std::move(Journal::Open(journal(), cast).value());
  }
  void Append(const std::vector<editor::Record>& records) const {
    auto opened = Open();
    std::vector<std::uint8_t> bytes;
    for (const auto& record : records) editor::Encode(record, bytes);
    ASSERT_TRUE(opened.journal.Append(bytes));
  }
  void Put(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories(own());
    std::ofstream(own() / name) << text;
  }
  std::vector<std::string> FilesOf(const std::filesystem::path& folder) const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      names.push_back(entry.path().filename());
    std::ranges::sort(names);
    return names;
  }
  editor::Stored Read() const { return editor::ReadStore(own(), points_, cast_); }

  board::BoardFile folder_;
  face::Cast cast_ = MakeSyntheticCast({.columns = 16, .rows = 12});
  editor::Points points_ = editor::PointsOf(cast_.net);
};

}  // namespace kaori::tests
