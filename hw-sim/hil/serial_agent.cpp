#include "hw-sim/hil/serial_agent.h"

#include <algorithm>
#include <string_view>

#include "drivers/base/number.h"

namespace kaori::hil {
namespace {

// STX, which no log has in it.
constexpr char kBegin = '\x02';
constexpr std::size_t kVerdictBytes = 3;  // "OK " or "NO ".
// Of an answer to no question: the agent cannot work, and says why.
constexpr std::uint32_t kUnasked = 0;
// A guest that boots throws away what it is asked before its agent runs.
constexpr Duration kSerialAgentAskAgain = std::chrono::seconds(2);

}  // namespace

std::optional<AgentAnswer> ParseAnswer(std::string& waiting) {
  for (std::size_t begin = waiting.find(kBegin); begin != std::string::npos;
       begin = waiting.find(kBegin, begin + 1)) {
    const std::size_t line_end = waiting.find('\n', begin);
    if (line_end == std::string::npos) return waiting.erase(0, begin), std::nullopt;
    const std::string_view head = std::string_view(waiting).substr(begin, line_end - begin);
    const std::string_view numbers = head.substr(std::min(1 + kVerdictBytes, head.size()));
    const std::size_t space = std::min(numbers.find(' '), numbers.size());
    const auto number = ParseNumber<std::uint32_t>(numbers.substr(0, space));
    const auto length = ParseNumber<std::size_t>(numbers.substr(std::min(space + 1, numbers.size())));
    // A byte of 2 that begins no answer is noise: looked for behind it.
    if (!number || !length) continue;
    if (waiting.size() - (line_end + 1) < *length) return waiting.erase(0, begin), std::nullopt;
    AgentAnswer answer{*number, head.substr(1).starts_with("OK "), waiting.substr(line_end + 1, *length)};
    waiting.erase(0, line_end + 1 + *length);
    return answer;
  }
  waiting.clear();
  return std::nullopt;
}

Result<void> SerialAgentDriver::Find(Duration longest) {
  auto stream = Stream::Call(path_, waiter_, longest);
  if (!stream) return tl::unexpected(stream.error());
  stream_.emplace(std::move(*stream));
  waiting_.clear();
  for (Duration waited{}; waited < longest; waited += kSerialAgentAskAgain) {
    const auto answer = Ask("hello", kSerialAgentAskAgain);
    if (answer) return {};
    // Its line may have torn the first words.
    if (answer.error().cause == std::errc::no_such_device) return tl::unexpected(answer.error());
  }
  return Fail(std::errc::timed_out, "find the agent in the guest");
}

// Numbers count up over the whole run, so that a late answer is never taken for that of a later question.
Result<std::string> SerialAgentDriver::Ask(const std::string& question, Duration longest) {
  if (!stream_) return Fail(std::errc::no_such_device, "ask " + question);
  const std::uint32_t number = ++asked_;
  if (auto ok = stream_->Say(std::to_string(number) + " " + question + "\n"); !ok)
    return tl::unexpected(ok.error());
  std::optional<AgentAnswer> answer;
  bool there = true;
  const auto answered = [&] {
    there = stream_->Read();
    waiting_ += stream_->waiting();
    // The stream's bytes are gathered here, since an answer may come in many pieces.
    stream_->Drop(stream_->waiting().size());
    // Answers to questions whose time was over come late, and are passed over.
    do answer = ParseAnswer(waiting_);
    while (answer && answer->number != number && answer->number != kUnasked);
    return answer || !there;
  };
  if (!waiter_.Until(answered, longest, stream_->pollable()))
    return Fail(std::errc::timed_out, "ask " + question);
  if (!answer) return Fail(std::errc::no_such_device, "ask " + question);
  // What a check looks for is never said so: a question that cannot be answered is a fault of the bench or of its machine.
  if (!answer->yes) return Fail(std::errc::invalid_argument, answer->text);
  return std::move(answer->text);
}

}  // namespace kaori::hil
