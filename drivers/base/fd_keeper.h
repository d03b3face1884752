// Keeps one file descriptor in another process: the program that gave it gets it back after its own end, also
// where the service manager dropped its copy because the program was stopped.
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

// Gives a copy of `fd` to the keeper that listens at `socket`, in place of what it holds;
// does not wait, so that a stage that starts is not delayed by a keeper that hangs. Does
// nothing where `socket` is empty: on a workstation there is no keeper. `fd` stays the
// caller's. Errors: those of ConnectToPeer and SendPacket.
Result<void> GiveToKeeper(int fd, const std::string& socket);

// Returns a copy of what the keeper holds, which goes on holding it; waits 5 s at most for
// its answer. Called before the loop starts. Errors: those of ConnectToPeer;
// no_such_device (no keeper is named, or it holds nothing); timed_out.
Result<UniqueFd> RetrieveFromKeeper(const std::string& socket);

// The keeper's end: what kaori-fdkeeper consists of. A client connects, sends one request
// and is answered and dismissed. One thread, that of the loop, which must outlive it. It
// serves at most 16 clients at once; one more displaces the client that has been silent for
// longest, so that clients that hang cannot lock others out.
class FdKeeper {
 public:
  // `listener` is a listening socket of packets (ListenForPackets, or a socket unit's). `held` is what
  // an earlier keeper held, if any. `received` is called with each descriptor that comes; it borrows it,
  // and stores a copy with the service manager, so that the keeper's own end loses nothing.
  FdKeeper(EventLoop& loop, UniqueFd listener, std::optional<UniqueFd> held,
           std::function<void(int)> received)
      : loop_(loop), listener_(std::move(listener)), held_(std::move(held)), received_(std::move(received)) {}

  // Starts to serve clients from the loop. Errors: those of EventLoop::Watch.
  Result<void> Open();

 private:
  // A failure to accept is not reported: the client sees a refused
  // connection, and it is the client that acts on it.
  void Accept();
  // Reads a client's request, answers it and dismisses the client.
  void Answer(int client);

  // Watches the listener and each client. Outlives the keeper.
  EventLoop& loop_;
  UniqueFd listener_;
  // None: nobody has given a descriptor yet.
  std::optional<UniqueFd> held_;
  // Called before the client's connection ends.
  std::function<void(int)> received_;
  // In the order in which they came. Each is here exactly as long as the loop watches it.
  std::vector<UniqueFd> clients_;
};

}  // namespace kaori::service
