// The agent in the guest, over its serial line.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "hw-sim/hil/protocols.h"
#include "hw-sim/hil/stream.h"
#include "hw-sim/hil/waiter.h"

namespace kaori::hil {

// An answer of the agent: "yes" with a result, or "no" with the reason.
struct AgentAnswer {
  // Of the question; 0: the agent was not asked, and cannot work.
  std::uint32_t number = 0;
  // False: the text is the agent's error.
  bool yes = false;
  // The result, or why there is none.
  std::string text;
};

// Removes the first whole answer from `waiting`, and what is before it, which is noise of the line. Nothing:
// it has not come yet. Pure.
std::optional<AgentAnswer> ParseAnswer(std::string& waiting);

// A question is a line: its number, which no other question has, a space and its words. An answer is a byte
// of 2, "OK " or "NO ", the number of its question, a space, the length of the text, both in decimal, the end
// of the line, and the text. The line may be noisy: the guest's kernel writes to it before the agent has it.
// One thread: that of the waiter.
class SerialAgentDriver final : public AgentProtocol {
 public:
  // Calls nobody yet. The waiter outlives the driver.
  SerialAgentDriver(std::string path, Waiter& waiter) : path_(std::move(path)), waiter_(waiter) {}

  // Calls the machine, and asks "hello" until the agent answers, `longest` at most for
  // each. Errors: timed_out, no_such_device.
  Result<void> Find(Duration longest);
  // Forgets the machine: the next Ask fails until another Find.
  void Lose() { stream_.reset(); }

  Result<std::string> Ask(const std::string& question, Duration longest) override;

 private:
  // Of the socket at the machine's serial line.
  std::string path_;
  Waiter& waiter_;
  // None: no machine was found, or it was lost.
  std::optional<Stream> stream_;
  // What has come and is no whole answer yet.
  std::string waiting_;
  // The number of the newest question.
  std::uint32_t asked_ = 0;
};

}  // namespace kaori::hil
