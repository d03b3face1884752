// The board's pages in this process's memory, and what happens when the file beneath them is cut short.
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
  // Maps kBoardBytes of `fd`, which may be closed afterwards; `path` is for messages. Any thread. Errors:
  // those of mmap(2) and sigaction(2); too_many_files_open where a process maps more than 256 boards at once.
  static Result<Mapping> Map(int fd, bool writable, const std::string& path);
  // Moving keeps the addresses: whoever holds words() may go on.
  Mapping(Mapping&& other) noexcept : words_(std::exchange(other.words_, nullptr)) {}
  Mapping& operator=(Mapping&& other) noexcept {
    std::swap(words_, other.words_);
    return *this;
  }
  ~Mapping();
  // The first word of the file, from which SectionPlace::at_word counts. A mapping that is not writable ends
  // the process by SIGSEGV when it is written to: that is a bug of ours and is meant to be seen.
  Word* words() const { return words_; }

 private:
  explicit Mapping(Word* words) : words_(words) {}
  Word* words_ = nullptr;
};

}  // namespace kaori::board
