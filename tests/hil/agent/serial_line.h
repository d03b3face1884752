// The agent's end of the serial line: questions of one line each come in, answers of any length go out.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"

namespace kaori::agent {

struct Question {
  std::uint32_t number = 0;  // Its answer has the same.
  std::string text;
};

// A line of the bench, which is as hw-sim/hil/serial_agent.h says; none where it was torn. Pure.
std::optional<Question> ParseQuestion(std::string_view line);
// The bytes of an answer, as the same header says. Pure.
std::string AnswerTo(std::uint32_t number, const Result<std::string>& answer);

// One thread.
class SerialLine {
 public:
  // Errors: those of opening and setting it.
  static Result<SerialLine> Open(const std::string& device);

  // The next question; waits for it. A line that is none is passed over: the bench asks again. Nothing: the line is
  // gone.
  std::optional<Question> Next();
  // `number` is that of the question; 0: the agent was not asked, and cannot work.
  void Answer(std::uint32_t number, const Result<std::string>& answer);

 private:
  explicit SerialLine(UniqueFd line) : line_(std::move(line)) {}
  UniqueFd line_;
};

}  // namespace kaori::agent
