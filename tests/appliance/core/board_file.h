// A board in a folder of its own, gone after the test.
#pragma once

#include <stdlib.h>

#include <filesystem>
#include <string>

#include "appliance/core/board/board.h"

namespace kaori::board {

class BoardFile {
 public:
  BoardFile() {
    std::string name = (std::filesystem::temp_directory_path() / "kaori-board-XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
  }
  BoardFile(const BoardFile&) = delete;
  BoardFile& operator=(const BoardFile&) = delete;
  ~BoardFile() { std::filesystem::remove_all(folder_); }

  const std::filesystem::path& folder() const { return folder_; }
  std::string path() const { return (folder_ / "board").string(); }
  Board Open() const { return Board::Create(path()).value(); }

 private:
  std::filesystem::path folder_;
};

}  // namespace kaori::board
