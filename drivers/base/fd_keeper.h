// A descriptor in other hands: who gives it away gets it back after its end, also where the service manager
// forgot it because it was stopped.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "drivers/base/event_loop.h"
#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"

namespace kaori::service {

// Gives a copy of `fd` to the holder that listens at `socket`, in place of what it holds; does not wait. Does
// nothing where `socket` is empty. Errors: those of ConnectToPeer and SendPacket.
Result<void> GiveToKeeper(int fd, const std::string& socket);

// A copy of what the holder holds; waits for its answer, 5 s at most. Errors: those of ConnectToPeer;
// no_such_device (there is no holder, or it holds nothing); timed_out.
Result<UniqueFd> RetrieveFromKeeper(const std::string& socket);

// The holder's end: takes and gives one descriptor. One thread, that of the loop, which must outlive it.
class FdKeeper {
 public:
  // `listener` is a socket of packets. `held` is what an earlier holder held, if any. `taken` is told of each
  // descriptor that comes.
  FdKeeper(EventLoop& loop, UniqueFd listener, std::optional<UniqueFd> held, std::function<void(int)> taken)
      : loop_(loop), listener_(std::move(listener)), held_(std::move(held)), taken_(std::move(taken)) {}

  // From now on the loop answers who calls. Errors: those of the loop.
  Result<void> Open();

 private:
  void Accept();
  void Answer(int caller);

  EventLoop& loop_;
  UniqueFd listener_;
  std::optional<UniqueFd> held_;
  std::function<void(int)> taken_;
  std::vector<UniqueFd> callers_;
};

}  // namespace kaori::service
