// The agent in the guest, over its serial line.
#pragma once

#include <optional>
#include <string>

#include "hw-sim/hil/protocols.h"
#include "hw-sim/hil/stream.h"
#include "hw-sim/hil/waiter.h"

namespace kaori::hil {

// Removes the first whole answer from `waiting`, and what is before it, which is noise of the line.
// Nothing: it has not come yet.
struct AgentAnswer {
  bool yes = false;
  std::string text;
};
std::optional<AgentAnswer> ParseAnswer(std::string& waiting);

class SerialAgentDriver final : public AgentProtocol {
 public:
  // The waiter outlives the driver.
  SerialAgentDriver(std::string path, Waiter& waiter) : path_(std::move(path)), waiter_(waiter) {}

  // Calls the machine, and asks until the agent answers. Errors: timed_out, no_such_device.
  Result<void> Find(Duration longest);
  void Lose() { stream_.reset(); }

  Result<std::string> Ask(const std::string& question, Duration longest) override;

 private:
  std::string path_;
  Waiter& waiter_;
  std::optional<Stream> stream_;
  std::string waiting_;
};

}  // namespace kaori::hil
