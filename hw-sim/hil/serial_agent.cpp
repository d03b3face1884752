#include "hw-sim/hil/serial_agent.h"

#include <charconv>

namespace kaori::hil {
namespace {

// STX, which no log has in it.
constexpr char kBegin = '\x02';
constexpr std::size_t kVerdictBytes = 3;  // "OK " or "NO ".
// A guest that boots throws away what it is asked before its agent runs.
constexpr Duration kSerialAgentAskAgain = std::chrono::seconds(2);

}  // namespace

std::optional<AgentAnswer> ParseAnswer(std::string& waiting) {
  const std::size_t begin = waiting.find(kBegin);
  if (begin == std::string::npos) return waiting.clear(), std::nullopt;
  waiting.erase(0, begin);
  const std::size_t line_end = waiting.find('\n');
  if (line_end == std::string::npos) return std::nullopt;
  std::size_t length = 0;
  const char* const end = waiting.data() + line_end;
  const char* const number = waiting.data() + std::min(1 + kVerdictBytes, line_end);
  // A byte of 2 that begins no answer is noise: looked for behind it.
  if (std::from_chars(number, end, length).ptr != end) return waiting.erase(0, 1), ParseAnswer(waiting);
  if (waiting.size() < line_end + 1 + length) return std::nullopt;
  AgentAnswer answer{waiting.compare(1, kVerdictBytes, "OK ") == 0, waiting.substr(line_end + 1, length)};
  waiting.erase(0, line_end + 1 + length);
  return answer;
}

Result<void> SerialAgentDriver::Find(Duration longest) {
  auto stream = Stream::Call(path_, waiter_, longest);
  if (!stream) return tl::unexpected(stream.error());
  stream_.emplace(std::move(*stream));
  waiting_.clear();
  for (Duration waited{}; waited < longest; waited += kSerialAgentAskAgain) {
    const auto answer = Ask("hello", kSerialAgentAskAgain);
    if (answer) {
      // A hello that was asked twice is answered twice.
      waiter_.For(std::chrono::milliseconds(500));  // Answers to earlier calls may be on their way.
      stream_->Read();
      stream_->Drop(stream_->waiting().size());
      waiting_.clear();
      return {};
    }
    // Its line may have torn the first words.
    if (answer.error().cause == std::errc::no_such_device) return tl::unexpected(answer.error());
  }
  return Fail(std::errc::timed_out, "find the agent in the guest");
}

Result<std::string> SerialAgentDriver::Ask(const std::string& question, Duration longest) {
  if (!stream_) return Fail(std::errc::no_such_device, "ask " + question);
  if (auto ok = stream_->Say(question + "\n"); !ok) return tl::unexpected(ok.error());
  std::optional<AgentAnswer> answer;
  bool there = true;
  const auto answered = [&] {
    there = stream_->Read();
    waiting_ += stream_->waiting();
    // The stream's bytes are gathered here, since an answer may come in many pieces.
    stream_->Drop(stream_->waiting().size());
    answer = ParseAnswer(waiting_);
    return answer || !there;
  };
  if (!waiter_.Until(answered, longest, stream_->pollable()))
    return Fail(std::errc::timed_out, "ask " + question);
  if (!answer) return Fail(std::errc::no_such_device, "ask " + question);
  if (!answer->yes) return FailInput(answer->text);
  return std::move(answer->text);
}

}  // namespace kaori::hil
