// The agent's end of the serial line: questions of one line each come in, answers of any length go out.
#pragma once

#include <optional>
#include <string>

#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"

namespace kaori::agent {

// One thread. An answer is "\x02" "OK" or "\x02" "NO", a space, the length of what follows in bytes, a line's
// end, and so many bytes.
class SerialLine {
 public:
  // Errors: those of opening and setting it.
  static Result<SerialLine> Open(const std::string& device);

  // The next question; waits for it. Nothing: the line is gone.
  std::optional<std::string> Next();
  void Answer(const Result<std::string>& answer);

 private:
  explicit SerialLine(UniqueFd line) : line_(std::move(line)) {}
  UniqueFd line_;
};

}  // namespace kaori::agent
