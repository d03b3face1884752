// Keeps one file descriptor in another process: the program that gave it gets it back after its own end, also where
// the service manager dropped its copy because the program was stopped.
//
// One packet is one request: a single byte, with the descriptor beside it (SCM_RIGHTS) where one is passed.
//   'h'   client to keeper, with a descriptor: hold this in place of what is held
//   'g'   client to keeper: give me a copy of what is held
//   'y'   keeper to client, with a descriptor: the answer to 'g'
//   'n'   keeper to client: nothing is held
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "drivers/base/event_loop.h"
#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"

namespace kaori::service {

// Gives a copy of `fd` to the keeper that listens at `socket`, in place of what it holds; does not wait. Does
// nothing where `socket` is empty. Errors: those of ConnectToPeer and SendPacket.
Result<void> GiveToKeeper(int fd, const std::string& socket);

// Returns a copy of what the keeper holds; waits 5 s at most for its answer. Errors: those of ConnectToPeer;
// no_such_device (no keeper is named, or it holds nothing); timed_out.
Result<UniqueFd> RetrieveFromKeeper(const std::string& socket);

// The keeper's end. One thread, that of the loop, which must outlive it. It serves at most 16 clients at once; one
// more displaces the client that has been silent for longest.
class FdKeeper {
 public:
  // `listener` is a listening socket of packets. `held` is what an earlier keeper held, if any. `received` is called
  // with each descriptor that comes; it borrows it.
  FdKeeper(EventLoop& loop, UniqueFd listener, std::optional<UniqueFd> held,
           std::function<void(int)> received)
      : loop_(loop), listener_(std::move(listener)), held_(std::move(held)), received_(std::move(received)) {}

  // Starts to serve clients from the loop. Errors: those of EventLoop::Watch.
  Result<void> Open();

 private:
  void Accept();
  void Answer(int client);

  EventLoop& loop_;
  UniqueFd listener_;
  std::optional<UniqueFd> held_;
  std::function<void(int)> received_;
  std::vector<UniqueFd> clients_;
};

}  // namespace kaori::service
