// The one loop of a process: file descriptors, periodic work, and a clean stop on SIGINT and SIGTERM.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "drivers/base/clock.h"
#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"

namespace kaori {

// The one place in which a process waits. Everything else does not block, so that one slow device delays
// no other. One thread. Handlers run inside Run(), one at a time, and may call every member, Forget of
// their own descriptor included; what such a handler captured stays alive until it has returned.
class EventLoop {
 public:
  // Runs in the thread of the loop and must not block: all other descriptors wait for it.
  using Handler = std::function<void()>;

  // Blocks SIGINT and SIGTERM for this thread and those it starts later: from here on they end Run(). Ignores
  // SIGPIPE: a reader of the log that is gone must not end the show. Errors: those of epoll_create1(2) and
  // signalfd(2).
  static Result<EventLoop> Open();

  // Calls `handler` whenever `fd` is readable or hung up. Borrows `fd`, which must be forgotten before it
  // closes. Errors: those of epoll_ctl(2): file_exists (it is watched already), operation_not_permitted (a
  // regular file).
  Result<void> Watch(int fd, Handler handler);
  // Does nothing where `fd` is not watched.
  void Forget(int fd);

  // Calls `handler` every `period`, first after one period, for as long as the loop lives. Periods that
  // passed while another handler ran are left out rather than made up for: one call follows, not
  // several. The phase does not drift. Errors: those of timerfd_create(2) and of Watch.
  Result<void> Every(Duration period, Handler handler);

  // Returns after Stop() or a signal, once the handler that runs has returned; handlers that were due
  // with it are left out. Blocks in epoll_wait only. May be called again. Errors: those of epoll_wait(2).
  Result<void> Run();
  // Called by a handler: ends Run(). Called before Run() it has no effect.
  void Stop() { running_ = false; }

  // Every, then Run; does not run where the timer cannot be made. Errors: those of both.
  Result<void> RunEvery(Duration period, Handler handler);

 private:
  // What is watched. A handler that is null stands for the signals, which stop the loop.
  struct Watched {
    int fd;
    Handler handler;
  };
  explicit EventLoop(UniqueFd epoll) : epoll_(std::move(epoll)) {}
  // Calls the handler of a descriptor, if it is still watched.
  void Dispatch(int fd);

  UniqueFd epoll_;
  // The address of a Watched stays the same while the vector grows: a handler that runs may add others.
  std::vector<std::unique_ptr<Watched>> watched_;
  // Kept until the handler that runs has returned, since it may be the one that was forgotten.
  std::vector<std::unique_ptr<Watched>> forgotten_;
  std::vector<UniqueFd> owned_;  // Timers and the signal descriptor.
  bool running_ = false;
};

}  // namespace kaori
