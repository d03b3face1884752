// The board's pages in this process's memory.
#pragma once

#include <string>
#include <utility>

#include "appliance/core/board/slots.h"
#include "drivers/base/result.h"

namespace kaori::board {

// Shared pages of the board's file, kBoardBytes of them; unmapped when the owner goes.
//
// Pages whose file was cut short do not end the process: at the first touch SIGBUS is caught, and the whole
// mapping becomes memory of this process alone, all zeros, in which every section is absent and what is
// written is lost. The handler is installed with the first mapping and passes on what is not the board's.
class Mapping {
 public:
  // Any thread. Errors: those of mmap(2); too_many_files_open where a process maps more than 256 boards at
  // once.
  static Result<Mapping> Map(int fd, bool writable, const std::string& path);
  Mapping(Mapping&& other) noexcept : words_(std::exchange(other.words_, nullptr)) {}
  Mapping& operator=(Mapping&& other) noexcept {
    std::swap(words_, other.words_);
    return *this;
  }
  ~Mapping();
  Word* words() const { return words_; }

 private:
  explicit Mapping(Word* words) : words_(words) {}
  Word* words_ = nullptr;
};

}  // namespace kaori::board
