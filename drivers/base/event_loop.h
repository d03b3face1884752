// The one loop of a process: file descriptors, periodic work, and a clean stop on SIGINT and SIGTERM.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "drivers/base/clock.h"
#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"

namespace kaori {

// Single-threaded. Call-backs run inside Run(), one at a time, and may call every member.
class EventLoop {
 public:
  using Handler = std::function<void()>;

  // Blocks SIGINT and SIGTERM for the process: from here on they end Run(). Ignores SIGPIPE: a reader of the
  // log that is gone must not end the show.
  static Result<EventLoop> Open();

  // Calls `handler` whenever `fd` is readable or hung up. Borrows fd: Forget it before it closes.
  Result<void> Watch(int fd, Handler handler);
  void Forget(int fd);

  // Calls `handler` every `period`, first after one period; late calls are not made up for.
  Result<void> Every(Duration period, Handler handler);

  // Returns after Stop() or a signal. Blocks in epoll_wait only.
  Result<void> Run();
  void Stop() { running_ = false; }

 private:
  struct Watched {
    int fd;
    Handler handler;
  };
  explicit EventLoop(UniqueFd epoll) : epoll_(std::move(epoll)) {}
  void Dispatch(int fd);

  UniqueFd epoll_;
  std::vector<std::unique_ptr<Watched>> watched_;
  std::vector<std::unique_ptr<Watched>> forgotten_;  // Kept until the handler that runs has returned.
  std::vector<UniqueFd> owned_;                      // Timers and the signal descriptor.
  bool running_ = false;
};

}  // namespace kaori
